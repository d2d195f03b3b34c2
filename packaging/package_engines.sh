#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Makes the packages for Godot, Unity and Unreal from the platforms' packages that are there: each holds the libraries of all of them.
#   packaging/package_engines.sh OUT
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/platforms.sh
out=${1:?which folder}
version=$(sed -n 's/^project(langevin_rigid VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
folder=$PWD/build/packaging/engines
stage=$folder/stage
addon=$stage/godot/addons/langevin_rigid
rm -rf "$stage"
mkdir -p "$addon"

# Godot's extension, by CMake, for the library in PREFIX.
extension() { # name, prefix, cmake's options
    { cmake -S bindings/godot -B "$folder/godot-$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DLR_SELF_CONTAINED=ON "-DCMAKE_PREFIX_PATH=$2" \
        "-DCMAKE_FIND_ROOT_PATH=$2" "-DCMAKE_C_FLAGS=-ffile-prefix-map=$PWD=." "-DLANGEVIN_GODOT_OUTPUT=$addon" "${@:3}" &&
        cmake --build "$folder/godot-$1"; } >"$folder/godot-$1.log" 2>&1 || { cat "$folder/godot-$1.log" >&2; exit 1; }
}
natives=()
for name in linux-x64 linux-arm64 windows-x64; do
    prefix=$(platform_folder $name)/stage/langevin_rigid-$version-$name
    [ -d "$prefix" ] || { echo "engines: without $name: scripts/package.sh $name engines"; continue; }
    select_platform $name
    natives+=(--native "$prefix")
    extension $name "$prefix" "${toolchain[@]}"
    find "$addon/bin" -path "*${name%%-*}*" -type f -exec "$strip" --strip-unneeded {} + 2>/dev/null || true
done
[ ${#natives[@]} -gt 0 ] || { echo "engines need a platform: scripts/package.sh linux-x64 engines" >&2; exit 3; }
macos=$(platform_folder macos)
if [ -d "$macos/arm64/prefix" ]; then
    export ZIG_GLOBAL_CACHE_DIR=$PWD/build/zig/cache ZIG_LOCAL_CACHE_DIR=$PWD/build/zig/cache
    for processor in x86_64 arm64; do
        extension macos-$processor "$macos/$processor/prefix" "-DCMAKE_TOOLCHAIN_FILE=$PWD/cmake/zig-macos.cmake" -DLR_MACOS_PROCESSOR=$processor -DCMAKE_SHARED_LINKER_FLAGS=-s # stripped afterwards, its signature would be wrong
    done
    mkdir "$addon/bin/macos"
    llvm-lipo-14 -create "$addon"/bin/macos_*/langevin_rigid_godot.dylib -output "$addon/bin/macos/langevin_rigid_godot.dylib"
    rm -r "$addon"/bin/macos_*
    mac=(--native "$macos/stage/langevin_rigid-$version-macos")
else
    echo "engines: without macos: scripts/package.sh macos engines"
    mac=()
fi

# Godot: the Asset Library's layout, all in addons/. Libraries that are not there are not named, as a missing file may stop the editor.
while read -r file; do
    [ -e "$addon/$file" ] || sed -i "\\|/langevin_rigid/$file\"|d" "$addon/langevin_rigid.gdextension"
done < <(sed -n 's|.*res://addons/langevin_rigid/\(bin/.*\)"$|\1|p' "$addon/langevin_rigid.gdextension")
first=${natives[1]}
cp "$first"/assets/leaf{,_maple}.{lrb,obj} "$addon/demo/"
python3 packaging/third_party.py --platform engines --sources build/sources --out "$addon"
if [ ${#mac[@]} -gt 0 ]; then
    cp "${mac[1]}"/licences/{libcxx,zig}.txt "$addon/licences/"
    tail -n 1 "${mac[1]}/THIRD_PARTY.md" >>"$addon/THIRD_PARTY.md"
fi
packaging/write_archive.sh "$stage/godot" addons "$out/langevin_rigid-$version-godot.zip" addons/langevin_rigid

python3 bindings/unity/package.py "${natives[@]}" "${mac[@]}" --out "$stage/unity" --tgz >"$folder/unity.log"
mv "$stage"/unity/com.langevin.rigid-*.tgz "$out/langevin_rigid-$version-unity.tgz"
python3 bindings/unreal/package.py "${natives[@]}" --out "$stage/unreal" >"$folder/unreal.log"
packaging/write_archive.sh "$stage/unreal" LangevinRigid "$out/langevin_rigid-$version-unreal.zip"
