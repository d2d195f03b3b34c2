#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Runs the tree's tests, built by MinGW, under Wine: unit tests, API tests against the DLL, determinism tests with the held hashes on
# each instruction set of this processor, and the held snapshot. Takes longer than CI's step.
#   packaging/test_windows.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/platforms.sh
if ! (select_platform windows-x64); then
    echo "SKIPPED: windows-x64: the tools above are not installed"
    exit 0
fi
select_platform windows-x64
export WINEDEBUG=${WINEDEBUG:--all}
packaging/build_dependencies.sh windows-x64
packaging/build_library.sh windows-x64 --tests
bin=$(platform_build windows-x64)/bin
passed=0 failed=0
run() { # program, arguments of doctest
    local log=$bin/$1.log start=$SECONDS
    if "${runner[@]}" "$bin/$1.exe" "${@:2}" >"$log" 2>&1; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
    printf '%s: %s, %d s\n' "$1" "$(grep -a 'test cases:' "$log" | sed 's/\x1b\[[0-9;]*m//g; s/^\[doctest\] //' | tr -d '\r')" $((SECONDS - start))
    grep -a -E -A6 'ERROR|FATAL' "$log" | head -n 60 || true
}
run tests_core --no-colors
run tests_determinism --no-colors
run tests_api --no-colors
if tests/snapshot_travel/check.sh "$bin/snapshot_file.exe" "${runner[@]}"; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
echo "windows tests: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
