#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Makes the package for the web, a tarball of npm's layout, and the folder `web`, a page to publish.
#   packaging/package_wasm.sh OUT
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
out=${1:?which folder}
version=$(sed -n 's/^project(langevin_rigid VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
stage=$PWD/build/packaging/wasm
bindings/web/build.sh
rm -rf "$stage"
mkdir -p "$stage"
cp -R build/web/package "$stage/package"
packaging/addresses.py "$stage/package/package.json"
packaging/write_archive.sh "$stage" package "$out/langevin-rigid-$version.tgz"
# The package for this machine bakes the page's leaves.
native=$PWD/build/packaging/linux-x64/stage/langevin_rigid-$version-linux-x64
if [ -x "$native/bin/lr_bake" ]; then
    bindings/web/site.sh "$native" >/dev/null
    rm -rf "$out/web"
    cp -R build/web/site "$out/web"
else
    echo "SKIPPED: the page: no lr_bake; scripts/package.sh linux-x64 wasm makes both"
fi
