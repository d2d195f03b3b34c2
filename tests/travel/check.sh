#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Snapshots between processes: saved on each instruction set that the processor has, byte for byte what is held in this folder, and
# what is held there restored on each, with the held hashes then and after more steps. So any two processors that pass restore each
# other's. Held files of older versions must be refused.
#   tests/travel/check.sh PROGRAM [EMULATOR...]       PROGRAM: snapshot_file
#   LR_UPDATE_GOLDEN=1 tests/travel/check.sh PROGRAM  holds a new version: src/world/snapshot_format.h
set -euo pipefail
held=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$1 emulator=("${@:2}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
run() { "${emulator[@]}" "$program" "$@" | tr -d '\r'; }
fail() { echo "snapshots: $*" >&2; exit 1; }

version=$(sed -n 's/.*snapshot_version = \([0-9]*\);.*/\1/p' "$held/../../src/world/snapshot_format.h")
[ -n "$version" ] || fail "no version in snapshot_format.h"
present=$held/version_$version.snapshot
if [ -n "${LR_UPDATE_GOLDEN:-}" ]; then
    run save "$work/saved" >"$held/hashes.txt"
    cp "$work/saved" "$present"
    echo "held: $present"
fi
[ -e "$present" ] || fail "none of version $version is held: see the head of this file"
hashes=$(cat "$held/hashes.txt")
targets=$(run targets)
[ -n "$targets" ] || fail "no instruction sets"
for target in $targets; do
    [ "$(run save "$work/saved" "$target")" = "$hashes" ] || fail "other hashes on instruction set $target"
    cmp "$work/saved" "$present" || fail "other bytes on instruction set $target"
    [ "$(run resume "$present" "$target")" = "$hashes" ] || fail "restored, instruction set $target has other hashes"
done
for old in "$held"/version_*.snapshot; do
    [ "$old" != "$present" ] || continue
    ! why=$(run resume "$old" 2>&1) || fail "$old is of another version, but was restored"
    [[ $why == *"of another version"* ]] || fail "$old: $why"
done
echo "snapshots of version $version: the held bytes and hashes on instruction sets" $targets
