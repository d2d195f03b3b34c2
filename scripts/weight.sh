#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Compares the size of this tree with its goals; ! marks a missed goal. Builds the library if no build has it.
#   scripts/weight.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
library=
for build in build/release build/demo; do [ -n "$library" ] || [ ! -e $build/src/liblangevin_rigid.so ] || library=$build/src/liblangevin_rigid.so; done
if [ -z "$library" ]; then
    source scripts/steps.sh
    source scripts/compiler_cache.sh
    configure build/demo --preset release -DLR_BUILD_TESTS=OFF
    cmake --build build/demo --target langevin_rigid >&2
    library=build/demo/src/liblangevin_rigid.so
fi
stripped=$(mktemp)
trap 'rm -f "$stripped"' EXIT
strip -o "$stripped" "$library"

row() { # name, number, unit, goal (-: none)
    local goal=
    [ "$4" = - ] || goal="at most $4"
    [ "$4" = - ] || [ "$2" = - ] || ! awk "BEGIN { exit !($2 > $4) }" || goal+=' !'
    printf '%-58s %9s %-3s %s\n' "$1" "$2" "$3" "$goal"
}
lines() { # folder, other arguments of find
    find "$@" \( -name '*.c' -o -name '*.h' -o -name '*.cpp' -o -name '*.hpp' -o -name '*.fbs' -o -name '*.inc' -o -name '*.map' \) -print0 |
        xargs -0 cat | wc -l
}
last() { # script, cold or warm, 4 (minutes) or 5 (minutes of processor time)
    [ ! -e build/times.txt ] || awk -v what="$1" -v kind="$2" -v column="$3" '
        $2 == what && $3 == kind && $6 <= 2 { t = sprintf("%.1f", $column / 60) }
        END { print t == "" ? "-" : t }' build/times.txt
    [ -e build/times.txt ] || echo -
}

row "shared library, stripped" "$(awk -v n="$(stat -c %s "$stripped")" 'BEGIN { printf "%.2f", n / 1e6 }')" MB 3
row "step functions in it" "$(nm -C "$library" | grep -cE ' [tTwW] .*step_(wet_)?bodies<' || true)" "" 48
row "exported functions" "$(nm -D --defined-only "$library" | grep -c ' T lr_' || true)" "" -
row "lines of the runtime (src without baker and tools)" "$(lines src -not -path 'src/baker/*' -not -path 'src/tools/*')" "" 27000
row "lines of src" "$(lines src)" "" -
row "lines of tests" "$(git ls-files tests | grep -E '\.(c|h|cpp|py|sh)$' | xargs cat | wc -l)" "" -
row "lines of bindings" "$(git ls-files bindings | grep -E '\.(c|h|cpp|cs|py|m?js|m?ts|gd|sh)$' | xargs cat | wc -l)" "" -
row "pages in docs" "$(find docs -name '*.md' | wc -l)" "" 20
row "./demo.sh, cold, after set-up" "$(last demo.sh cold 4)" min 4
row "./test.sh, cold" "$(last test.sh cold 4)" min 15
row "./test.sh, cold, processor time" "$(last test.sh cold 5)" min 30
row "./test.sh, warm" "$(last test.sh warm 4)" min 5
echo "places by hand for a new lr_batch_set_...: counted in review"
