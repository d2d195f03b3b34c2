#!/usr/bin/env bash
# Runs dieharder (Debian package `dieharder`) on the bits of the noise and prints one line per test: docs/maintainers/numerics.md.
#   scripts/noise_battery.sh PATH_OF_NOISE_BITS [order ...]      orders: gaussians bodies substeps seeds (all)
# About ten minutes of processor time per order.
set -euo pipefail

noise_bits=${1:?usage: scripts/noise_battery.sh PATH_OF_NOISE_BITS [order ...]}
shift
orders=("$@")
[ ${#orders[@]} -gt 0 ] || orders=(gaussians bodies substeps seeds)
command -v dieharder >/dev/null || { echo "noise_battery: dieharder is not installed: scripts/setup.sh battery" >&2; exit 1; }

# All tests that dieharder rates as good, with several tuple lengths or lags if the test has them.
tests=("0" "1" "3" "4" "8" "9" "10" "11" "12" "13" "15" "16" "17" "100" "101" "102"
    "200 -n 3" "200 -n 6" "201 -n 2" "201 -n 3" "201 -n 5" "202 -n 3" "202 -n 5" "203 -n 1" "203 -n 3" "203 -n 6" "204" "205"
    "206" "207" "208" "209" "2")

failed=0
for order in "${orders[@]}"; do
    for test in "${tests[@]}"; do
        # -D: one line per result, with the test's name, tuple, samples, p value and assessment.
        # shellcheck disable=SC2086
        lines=$("$noise_bits" "$order" | dieharder -g 200 -d $test -D test_name -D ntuple -D tsamples -D psamples -D pvalues -D assessment -c ' ' |
            grep -E 'PASSED|WEAK|FAILED') || true
        [ -n "$lines" ] || lines="test $test gave nothing: FAILED"
        while read -r line; do
            echo "$order $line"
            case $line in *FAILED*) failed=1 ;; esac
        done <<<"$lines"
    done
done
exit $failed
