#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Packages for people who build nothing: library, header, baker, bindings, assets and licences in one archive for each platform.
#   scripts/package.sh [linux-x64|windows-x64|linux-arm64|wasm|all ...] [--out DIR]     default: linux-x64, into build/packages
# What it needs is installed by scripts/setup.sh package [windows] [arm64]; sources of dependencies are fetched once, from Debian.
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

# Of the last commit, not of the clock: it is in the archives.
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || echo 0)} TZ=UTC LC_ALL=C
umask 022

say() { printf '[%d:%02d] %s\n' $((SECONDS / 60)) $((SECONDS % 60)) "$*"; }
for name in "${wanted[@]}"; do
    start=$SECONDS
    if [ "$name" = wasm ]; then
        say "$name: library for WebAssembly (the first time some 3 minutes)"
        packaging/package_wasm.sh "$out"
    else
        select_platform "$name"
        say "$name: the libraries that it carries (the first time some 4 minutes of two cores)"
        packaging/build_dependencies.sh "$name"
        say "$name: library and lr_bake (some 6)"
        packaging/build_library.sh "$name"
        say "$name: bindings, assets, licences, archive"
        packaging/make_bundle.sh "$name" "$out"
    fi
    echo "$name: $((SECONDS - start)) s"
done
