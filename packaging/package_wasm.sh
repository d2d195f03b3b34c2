#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Makes the package for the web: the output of bindings/web with its licences, plus header, checksums and archive.
#   packaging/package_wasm.sh OUT
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
out=${1:?which folder}
if [ ! -x bindings/web/build.sh ]; then
    echo "SKIPPED: wasm: this tree has no bindings/web"
    exit 0
fi
version=$(sed -n 's/^project(langevin_rigid VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
name=langevin_rigid-$version-wasm
stage=$PWD/build/packaging/wasm/stage
bindings/web/build.sh
rm -rf "$stage"
mkdir -p "$stage"
cp -R build/web/package "$stage/$name"
for file in langevin_rigid.wasm langevin_rigid.mjs package.json; do
    [ -s "$stage/$name/$file" ] || { echo "bindings/web/build.sh made no build/web/package/$file" >&2; exit 1; }
done
cp LICENSE include/langevin_rigid.h include/langevin_rigid_research.h bindings/web/sample.mjs "$stage/$name/"
mkdir -p "$stage/$name/docs/guide" "$stage/$name/docs/images"
cp docs/guide/languages.md "$stage/$name/docs/guide/"
cp docs/images/{web,blender}_storm.png "$stage/$name/docs/images/"
# The page with its leaves, for any static file server. The package for this machine bakes them.
native=$PWD/build/packaging/linux-x64/stage/langevin_rigid-$version-linux-x64
if [ -x "$native/bin/lr_bake" ]; then
    bindings/web/site.sh "$native" >/dev/null
    cp -R build/web/site "$stage/$name/site"
else
    echo "SKIPPED: the page in the package: no lr_bake; scripts/package.sh linux-x64 wasm makes both"
fi
packaging/write_archive.sh "$stage" "$name" "$out/$name.tar.xz"
