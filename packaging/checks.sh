# SPDX-License-Identifier: MIT
#
# Counts checks of a package; sourced. Needs $work, a folder. A check that fails prints the beginning of its output.
passed=0 failed=0
check() { # name, command
    if "${@:2}" >"$work/check.log" 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $1"
        head -n 20 "$work/check.log" | sed 's/^/    /'
    fi
}
