#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Makes the packages for Unity, Unreal and Godot, each with the libraries of all platforms that packaging/make_bundle.sh has made.
#   packaging/package_engines.sh OUT
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/platforms.sh
out=${1:?which folder}
version=$(sed -n 's/^project(langevin_rigid VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
work=$PWD/build/packaging/engines
godot=$work/godot/langevin_rigid-$version-godot
rm -rf "$work"
mkdir -p "$work/prefix" "$godot/.godot"
silent() { "$@" >"$work/log" 2>&1 || { cat "$work/log" >&2; echo "package_engines.sh: $1 failed" >&2; exit 1; }; }

native=()
for name in linux-x64 windows-x64 linux-arm64; do
    stage=$(platform_folder $name)/stage/langevin_rigid-$version-$name prefix=$work/prefix/$name
    [ -d "$stage" ] || continue
    select_platform $name
    cp -Rl "$stage" "$prefix"
    mkdir -p "$prefix/share/doc/langevin_rigid" # where an installation has them, and each package looks for them
    for licence in "$stage"/licences/*.txt; do cp "$licence" "$prefix/share/doc/langevin_rigid/LICENSE.$(basename "$licence" .txt)"; done
    native+=(--native "$prefix")
    # A cross compiler looks for packages in CMAKE_FIND_ROOT_PATH alone.
    silent cmake -S bindings/godot -B "$work/$name" -G Ninja "${toolchain[@]}" -DCMAKE_BUILD_TYPE=Release "-DCMAKE_PREFIX_PATH=$prefix" \
        "-DCMAKE_FIND_ROOT_PATH=$prefix" "-DCMAKE_C_FLAGS=-ffile-prefix-map=$PWD=." -DCMAKE_MODULE_LINKER_FLAGS=-s \
        "-DLANGEVIN_GODOT_OUTPUT=$godot/addons/langevin_rigid"
    silent cmake --build "$work/$name"
done
[ ${#native[@]} -gt 0 ] || { echo "engines need a platform's library: scripts/package.sh linux-x64 engines" >&2; exit 3; }

silent python3 bindings/unity/package.py "${native[@]}" --out "$work/unity" --tgz
mv "$work"/unity/*.tgz "$out/"
silent python3 bindings/unreal/package.py "${native[@]}" --out "$work/unreal"
packaging/write_archive.sh "$work/unreal" LangevinRigid "$out/langevin_rigid-$version-unreal.zip"
# A project to open, with the addon. bindings/godot/demo.sh explains extension_list.cfg.
git ls-files -z bindings/godot/demo | xargs -0 cp -t "$godot"
cp "${native[1]}"/assets/leaf{,_maple}.{lrb,obj} LICENSE "$godot/"
echo "res://addons/langevin_rigid/langevin_rigid.gdextension" >"$godot/.godot/extension_list.cfg"
packaging/write_archive.sh "$work/godot" "${godot##*/}" "$out/${godot##*/}.zip"
