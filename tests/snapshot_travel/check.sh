#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Snapshots between processes. Each instruction set of the processor saves exactly the stored file of this folder, and restores it
# with the stored hashes, then and after more steps. So any two processors that pass this test restore each other's
# snapshots.
#   tests/snapshot_travel/check.sh PROGRAM [EMULATOR...]       PROGRAM: snapshot_file
#   LR_UPDATE_GOLDEN=1 tests/snapshot_travel/check.sh PROGRAM  holds new ones: after a change of src/world/snapshot/snapshot_format.h or the scene
set -euo pipefail
held=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$1 emulator=("${@:2}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
run() { "${emulator[@]}" "$program" "$@" | tr -d '\r'; }
fail() { echo "snapshots: $*" >&2; exit 1; }

present=$held/held.snapshot
if [ -n "${LR_UPDATE_GOLDEN:-}" ]; then
    run save "$work/saved" >"$held/hashes.txt"
    cp "$work/saved" "$present"
    echo "held: $present"
fi
hashes=$(cat "$held/hashes.txt")
targets=$(run targets)
[ -n "$targets" ] || fail "no instruction sets"
for target in $targets; do
    [ "$(run save "$work/saved" "$target")" = "$hashes" ] || fail "other hashes on instruction set $target"
    cmp "$work/saved" "$present" || fail "other bytes on instruction set $target"
    [ "$(run resume "$present" "$target")" = "$hashes" ] || fail "restored, instruction set $target has other hashes"
done
echo "snapshots: the held bytes and hashes on instruction sets" $targets
