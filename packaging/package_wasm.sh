#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# The package for the web is what bindings/web builds; here it gets its licences, checksums and archive.
#   packaging/package_wasm.sh OUT
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
out=${1:?which folder}
if [ ! -f bindings/web/package.py ] && [ ! -x bindings/web/build.sh ]; then
    echo "SKIPPED: wasm, for want of bindings/web in this tree"
    exit 0
fi
version=$(sed -n 's/^project(langevin_rigid VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
name=langevin_rigid-$version-wasm
stage=$PWD/build/packaging/wasm/stage
rm -rf "$stage"
mkdir -p "$stage/$name"
if [ -f bindings/web/package.py ]; then
    python3 bindings/web/package.py --out "$stage/$name"
else
    bindings/web/build.sh "$stage/$name"
fi
[ -s "$stage/$name/langevin_rigid.wasm" ] || { echo "bindings/web made no langevin_rigid.wasm in $stage/$name" >&2; exit 1; }
cp LICENSE "$stage/$name/"
cp include/langevin_rigid.h "$stage/$name/"
packaging/fetch_sources.sh >/dev/null
python3 packaging/third_party.py --platform wasm --sources build/packaging/sources --out "$stage/$name"
packaging/write_archive.sh "$stage" "$name" "$out/$name.tar.xz"
