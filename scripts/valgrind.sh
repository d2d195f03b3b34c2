#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Valgrind over the tests of the API, against the library as it ships: what is read before it is written, which AddressSanitizer does
# not see, and what is lost. It knows no AVX-512: the library takes AVX2 there.
#   scripts/valgrind.sh [BUILD]      default: build/release
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:-build/release}
command -v valgrind >/dev/null || { echo "SKIPPED: valgrind, for want of it: scripts/setup.sh test"; exit 0; }

log=$(mktemp -d)
trap 'rm -rf "$log"' EXIT
check() { # which half of the files
    local file files=() n=0
    for file in tests/api/test_*.cpp; do
        case $file in *faults* | *divergence* | *hostile_numbers* | *thread_checks* | *threads* | *long_runs*) continue ;; esac
        [ $((n++ % 2)) -ne "$1" ] || files+=("*/$(basename "$file")")
    done
    # The kernels are long without a jump, longer than it translates at once.
    valgrind -q --error-exitcode=9 --leak-check=full --errors-for-leak-kinds=definite,possible --vex-guest-max-insns=20 \
        "$build/tests/tests_api" --no-colors \
        --source-file="$(IFS=, && echo "${files[*]}")" --test-suite-exclude=long,exact,long-exact,native >"$log/$1" 2>&1
}
check 0 &
first=$!
good=true
check 1 || good=false
wait "$first" || good=false
$good || cat "$log/0" "$log/1"
grep -ah 'test cases:' "$log/0" "$log/1" | sed 's/^\[doctest\] /valgrind: /'
$good
