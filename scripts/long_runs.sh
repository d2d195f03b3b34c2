#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Full-length load tests: 24 simulated hours of a storm, 4 million bodies, 1,000 worlds, 64 threads. docs/maintainers/testing.md
# scripts/long_runs.sh [HOURS]: writes logs, the table of the storm (soak.csv) and its plot (soak.png) into build/load.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
hours=${1:-24}
source scripts/compiler_cache.sh
mkdir -p build/load
cmake --preset release -B build/release >build/load/configure.log
cmake --build build/release --target lr_load
lr_load=build/release/tests/lr_load
good=true
run() { # name, arguments
    local name=$1
    shift
    printf '\n== %s\n' "$name"
    "$lr_load" "$@" | tee "build/load/$name.txt" || good=false
}
run bodies bodies 4000000
run worlds worlds 1000
run threads threads 64
run soak soak "$hours" build/load/soak.csv
/usr/bin/python3 tests/load/plot_soak.py build/load/soak.csv build/load/soak.png
$good
