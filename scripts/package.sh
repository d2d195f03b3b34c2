#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Makes binary packages: library, header, baker, bindings, assets and licences in one archive per platform.
#   scripts/package.sh [linux-x64|windows-x64|linux-arm64|wasm|all ...] [--out DIR]     default: linux-x64, into build/packages
# scripts/setup.sh package [windows] [arm64] installs the tools and fetches the sources of dependencies once, from Debian.
# The same commit gives the same bytes. docs/maintainers/releases.md
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/platforms.sh

out=build/packages
wanted=()
while [ $# -gt 0 ]; do
    case $1 in
    --out) out=${2:?--out DIR}; shift ;;
    all) wanted=(linux-x64 windows-x64 linux-arm64 wasm) ;;
    -h | --help) sed -n '4,9s/^# \{0,1\}//p' "scripts/package.sh"; exit 0 ;;
    *) wanted+=("$1") ;;
    esac
    shift
done
[ ${#wanted[@]} -gt 0 ] || wanted=(linux-x64)
mkdir -p "$out"
out=$(realpath "$out")

# Archives contain this time: the last commit's, for equal bytes.
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || echo 0)} TZ=UTC LC_ALL=C
umask 022

say() { printf '[%d:%02d] %s\n' $((SECONDS / 60)) $((SECONDS % 60)) "$*"; }
for name in "${wanted[@]}"; do
    start=$SECONDS
    if [ "$name" = wasm ]; then
        say "$name: library for WebAssembly (about 3 minutes the first time)"
        packaging/package_wasm.sh "$out"
    else
        select_platform "$name"
        say "$name: bundled libraries (about 4 minutes the first time on two cores)"
        packaging/build_dependencies.sh "$name"
        say "$name: library and lr_bake (about 6 minutes)"
        packaging/build_library.sh "$name"
        say "$name: bindings, assets, licences, archive"
        packaging/make_bundle.sh "$name" "$out"
    fi
    echo "$name: $((SECONDS - start)) s"
done
