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
    config=$(dirname "$(find "$at" -name langevin_rigid.pc)")
    baker=OFF
    [ ! -e "$at/include/langevin_rigid_baker.hpp" ] || baker=ON
    static=OFF
    [ ! -e "$config/langevin_rigid_static.pc" ] || static=ON
    cmake -G Ninja -S "$here" -B "$work/$name" -DCMAKE_PREFIX_PATH="$at" -DWITH_BAKER=$baker -DWITH_STATIC=$static > "$work/$name.log" 2>&1 || { cat "$work/$name.log"; return 1; }
    cmake --build "$work/$name" >> "$work/$name.log" 2>&1 || { cat "$work/$name.log"; return 1; }
    grep -q "langevin_rigid_DIR:PATH=$at" "$work/$name/CMakeCache.txt" || { echo "another package was found"; return 1; }
    in_c=$("$work/$name/in_c")
    in_cpp=$("$work/$name/in_cpp")
    library=$(PKG_CONFIG_PATH="$config" pkg-config --variable=libdir langevin_rigid)
    by_pkg_config "$name/by_pkg_config" "$here/falls.c" langevin_rigid
    linked=$(LD_LIBRARY_PATH="$library" "$work/$name/by_pkg_config")
    echo "$name: $in_c $in_cpp $linked"
    [ "$in_c" = "$in_cpp" ] && [ "$in_c" = "$linked" ]
    if [ $static = ON ]; then
        [ "$in_c" = "$("$work/$name/in_static")" ]
        by_pkg_config "$name/hello" "$here/../../samples/hello.c" langevin_rigid_static
        "$work/$name/hello" | grep -Fxf "$here/../../packaging/hello.hash"
        by_pkg_config "$name/out_of_memory" "$here/out_of_memory.c" langevin_rigid_static
        truncate -s 900M "$work/large"
        (ulimit -v 300000 && "$work/$name/out_of_memory" "$work/large")
        alien=langevin # and the C++ runtime, which the library contains unless its users must link it
        grep -q stdc++ "$config/langevin_rigid_static.pc" || alien='langevin|stdc'
        for program in hello in_static; do
            if readelf -d "$work/$name/$program" | grep -E "NEEDED.*($alien)"; then return 1; fi
        done
    fi
    if [ $baker = OFF ]; then # says why
        mkdir -p "$work/none"
        printf 'cmake_minimum_required(VERSION 3.16)\nproject(none C)\nfind_package(langevin_rigid CONFIG REQUIRED COMPONENTS baker)\n' > "$work/none/CMakeLists.txt"
        if cmake -S "$work/none" -B "$work/none/build" -DCMAKE_PREFIX_PATH="$at" > "$work/none.log" 2>&1; then return 1; fi
        tr -s ' \n' ' ' < "$work/none.log" | grep -q 'only component is `baker`, and it is not here' || { cat "$work/none.log"; return 1; }
    fi
    if [ $baker = ON ]; then
        "$work/$name/importer"
        by_pkg_config "$name/importer_by_pkg_config" "$here/importer.cpp" langevin_rigid_baker langevin_rigid
        LD_LIBRARY_PATH="$library" "$work/$name/importer_by_pkg_config"
    fi
}
by_pkg_config() { # program, source, packages
    program=$1 source=$2
    shift 2
    # $flags is intentionally a list of words.
    flags=$(PKG_CONFIG_PATH="$config" pkg-config --cflags --libs "$@")
    case $source in
    *.c) ${CC:-cc} -std=c99 -Wall -Wextra -pedantic -Werror "$source" -o "$work/$program" $flags ;;
    *) ${CXX:-c++} -std=c++17 -Wall -Wextra -pedantic -Werror "$source" -o "$work/$program" $flags ;;
    esac
}

check "$prefix" installed
cp -R "$prefix" "$work/elsewhere"
check "$work/elsewhere" moved
