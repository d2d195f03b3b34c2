#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Makes the source kit: the runtime's sources with those of the libraries that it contains, and packaging/source_kit. A folder of files with one
# CMakeLists.txt, not one amalgamated file: the kernels include themselves once per instruction set, and names of single files are not unique.
#   packaging/make_source_kit.sh OUT [--folder]     --folder: only build/packaging/source/stage
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
out=${1:?which folder}
scripts/debian_source.sh build/sources highway >/dev/null
version=$(sed -n 's/^project(langevin_rigid VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
description=$(sed -n 's/^ *DESCRIPTION "\(.*\)")/\1/p' CMakeLists.txt)
name=langevin_rigid-$version-source
stage=$PWD/build/packaging/source/stage/$name
rm -rf "${stage%/*}"
mkdir -p "$stage"/{src,samples,cmake,third_party/hwy/ops}

(cd packaging/source_kit && find . -type f) | while read -r file; do
    mkdir -p "$stage/$(dirname "$file")"
    sed -e "s|@VERSION@|$version|g; s|@DESCRIPTION@|$description|g" "packaging/source_kit/$file" >"$stage/$file"
done
cp LICENSE "$stage/"
# With their times, so that a build of the folder is continued.
cp -pR include "$stage/"
rm "$stage/include/langevin_rigid_baker.hpp"
cp samples/hello.c "$stage/samples/"
cp cmake/{install.cmake,langevin_rigid-config.cmake.in,langevin_rigid.pc.in} "$stage/cmake/"
(cd src && find {api,asset,base,body_contact,collision,environment,kernel,recording,world} \( -name '*.cpp' -o -name '*.h' -o -name '*.inc' \) \
    -exec cp -p --parents -t "$stage/src" {} +)
flatc --cpp --scoped-enums --cpp-std c++17 -o "$stage/src" src/asset/asset.fbs

hwy=build/sources/highway/hwy
cp -p $hwy/{base,cache_control,detect_compiler_arch,detect_targets,foreach_target,highway,highway_export,per_target,targets}.h $hwy/targets.cc "$stage/third_party/hwy/"
cp -p $hwy/ops/*.h "$stage/third_party/hwy/ops/"
cp -pR /usr/include/flatbuffers "$stage/third_party/"
(cd "$stage/third_party/flatbuffers" && ls | grep -vxE '(allocator|array|base|buffer|buffer_ref|default_allocator|detached_buffer|flatbuffer_builder|flatbuffers|stl_emulation|string|struct|table|vector|vector_downward|verifier)\.h' | xargs rm -r)
python3 packaging/third_party.py --platform source --sources build/sources --out "$stage/third_party"
[ "${2:-}" = --folder ] || packaging/write_archive.sh "${stage%/*}" "$name" "$out/$name.tar.xz"
