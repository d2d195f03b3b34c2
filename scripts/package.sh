#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Makes binary packages: library, header, baker, bindings, assets and licences in one archive per platform.
#   scripts/package.sh [linux-x64|windows-x64|linux-arm64|macos|engines|wasm|source ...] [--out DIR]     default: linux-x64, into build/packages
#                                          engines: Godot, Unity and Unreal, for the platforms that were made before
#   scripts/package.sh all [--out DIR]     all of them, into dist, with the documentation and a page that lists them
# scripts/setup.sh package [windows] [arm64] [macos] installs the tools and fetches the sources of dependencies once, from Debian.
# The same commit gives the same bytes. docs/maintainers/releases.md
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/platforms.sh

out=
wanted=() all=false
while [ $# -gt 0 ]; do
    case $1 in
    --out) out=${2:?--out DIR}; shift ;;
    all) wanted=(source linux-x64 windows-x64 linux-arm64 macos engines wasm) all=true ;;
    -h | --help) sed -n '4,11s/^# \{0,1\}//p' "scripts/package.sh"; exit 0 ;;
    *) wanted+=("$1") ;;
    esac
    shift
done
[ ${#wanted[@]} -gt 0 ] || wanted=(linux-x64)
[ -n "$out" ] || { $all && out=dist || out=build/packages; }
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
    elif [ "$name" = source ]; then
        packaging/make_source_kit.sh "$out"
    elif [ "$name" = macos ]; then
        say "$name: library for both processors (about 6 minutes)"
        packaging/package_macos.sh "$out"
    elif [ "$name" = engines ]; then
        packaging/package_engines.sh "$out"
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
if $all; then
    scripts/site.py "$out/docs"
    python3 packaging/list_packages.py "$out"
fi
