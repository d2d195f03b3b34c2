#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Runs the API's tests under Valgrind against the shipped library. Finds uninitialised reads, which AddressSanitizer misses, and leaks.
# Valgrind lacks AVX-512, so the library uses AVX2.
#   scripts/valgrind.sh [BUILD]      default: build/release
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:-build/release}
command -v valgrind >/dev/null || { echo "SKIPPED: valgrind is not installed: scripts/setup.sh test"; exit 0; }

log=$(mktemp -d)
trap 'rm -rf "$log"' EXIT
check() { # half of the files, 0 or 1
    local file files=() n=0
    for file in tests/api/test_*.cpp; do
        case $file in *faults* | *divergence* | *hostile_numbers* | *thread_checks* | *threads* | *long_runs*) continue ;; esac
        [ $((n++ % 2)) -ne "$1" ] || files+=("*/$(basename "$file")")
    done
    # The kernels have longer runs without a jump than Valgrind translates by default.
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
