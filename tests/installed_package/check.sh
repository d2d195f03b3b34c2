#!/bin/sh
# check.sh PREFIX WORK: builds and runs outside programs against the package installed in PREFIX, by CMake and by
# pkg-config, then again with the package moved elsewhere. WORK is emptied.
set -eu
prefix=$1
work=$2
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
mkdir -p "$work"

check() {
    at=$1
    name=$2
    baker=OFF
    [ ! -e "$at/include/langevin_rigid_baker.hpp" ] || baker=ON
    cmake -G Ninja -S "$here" -B "$work/$name" -DCMAKE_PREFIX_PATH="$at" -DWITH_BAKER=$baker > "$work/$name.log" 2>&1 || { cat "$work/$name.log"; return 1; }
    cmake --build "$work/$name" >> "$work/$name.log" 2>&1 || { cat "$work/$name.log"; return 1; }
    grep -q "langevin_rigid_DIR:PATH=$at" "$work/$name/CMakeCache.txt" || { echo "another package was found"; return 1; }
    in_c=$("$work/$name/in_c")
    in_cpp=$("$work/$name/in_cpp")
    [ $baker = OFF ] || "$work/$name/importer"
    config=$(dirname "$(find "$at" -name langevin_rigid.pc)")
    # $flags is intentionally a list of words.
    flags=$(PKG_CONFIG_PATH="$config" pkg-config --cflags --libs langevin_rigid)
    library=$(PKG_CONFIG_PATH="$config" pkg-config --variable=libdir langevin_rigid)
    ${CC:-cc} -std=c99 -Wall -Wextra -pedantic -Werror "$here/falls.c" -o "$work/$name/by_pkg_config" $flags
    by_pkg_config=$(LD_LIBRARY_PATH="$library" "$work/$name/by_pkg_config")
    echo "$name: $in_c $in_cpp $by_pkg_config"
    [ "$in_c" = "$in_cpp" ] && [ "$in_c" = "$by_pkg_config" ]
}

check "$prefix" installed
cp -R "$prefix" "$work/elsewhere"
check "$work/elsewhere" moved
