#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Makes the packages that users download, with their checksums and a page that lists them.
#   scripts/package.sh [NAME...] [--out DIR]     default: linux-x64, into build/packages
#       linux-x64 windows-x64 linux-arm64   library, headers, tools, assets, licences in one archive; Python's wheel and Blender's zip
#       macos source wasm                   library for macOS; sources for consoles and phones; npm's tarball and a page
#       engines                             for Unity, Unreal and Godot, with the libraries of the platforms made before
#   scripts/package.sh all [--out DIR]           all of them and the documentation, into dist, as it can be published
# LR_HOME and LR_REPOSITORY, addresses of the published folder and of the sources, go into the packages that have a field for them.
# scripts/setup.sh test package windows arm64 macos installs the tools and fetches the sources of dependencies once.
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
    -h | --help) sed -n '4,12s/^# \{0,1\}//p' "scripts/package.sh"; exit 0 ;;
    *) wanted+=("$1") ;;
    esac
    shift
done
[ ${#wanted[@]} -gt 0 ] || wanted=(linux-x64)
clean=false
[ -n "$out" ] || { $all && out=dist clean=true || out=build/packages; }

# Archives contain this time: the last commit's, for equal bytes.
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || echo 0)} TZ=UTC LC_ALL=C
umask 022

# Reports all that is missing before anything is built.
missing=()
for name in "${wanted[@]}"; do
    case $name in
    linux-* | windows-*) (select_platform "$name") || missing+=("$name") ;;
    macos) [ -d build/zig/node_modules ] || { echo "macos needs Zig: scripts/setup.sh package macos" >&2; missing+=(macos); } ;;
    source | wasm | engines) ;;
    *) echo "unknown package: $name; scripts/package.sh --help lists them" >&2; exit 2 ;;
    esac
done
! $all || command -v mkdocs >/dev/null || { echo "the documentation needs mkdocs: scripts/setup.sh test" >&2; missing+=(docs); }
[ ${#missing[@]} -eq 0 ] || exit 3
! $clean || rm -rf "$out"
mkdir -p "$out"
out=$(realpath "$out")

step() { # name, command: prints its time
    local start=$SECONDS
    "${@:2}"
    printf '%-12s %4d s\n' "$1" $((SECONDS - start)) | tee -a "$times"
}
platform() { # its dependencies, its library, its archive: 4, 6 and 1 minutes the first time on two cores
    select_platform "$1"
    packaging/build_dependencies.sh "$1"
    packaging/build_library.sh "$1"
    packaging/make_bundle.sh "$1" "$out"
    LR_BAKED=${LR_BAKED:-$(echo "$(platform_folder "$1")"/stage/*/assets)}
    export LR_BAKED
}
times=$(mktemp)
trap 'rm -f "$times"' EXIT
for name in "${wanted[@]}"; do
    case $name in
    source) step source packaging/make_source_kit.sh "$out" ;;
    macos | wasm | engines) step "$name" "packaging/package_$name.sh" "$out" ;;
    *) step "$name" platform "$name" ;;
    esac
done
! $all || step docs scripts/site.py "$out/docs"
python3 packaging/list_packages.py "$out"
cat "$times"
