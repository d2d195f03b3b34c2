#!/usr/bin/env bash
# Measures, and writes docs/maintainers/performance.md and docs/maintainers/performance.png. Needs a built lr_bench; builds nothing.
#   scripts/performance.sh [--quick] [BUILD [DOCS]]     default: build/release, docs/maintainers
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

quick=()
if [ "${1:-}" = --quick ]; then
    quick=(--quick)
    shift
fi
build=${1:-build/release}
docs=${2:-docs/maintainers}
folder=$build/bench
bench=$build/tests/bench/lr_bench/lr_bench
scene=$build/tests/bench/lr_bench/bench_scene
heap=$build/tests/bench/bench_heap
[ -x "$bench" ] && [ -x "$scene" ] && [ -x "$heap" ] ||
    { echo "performance: no $bench, $scene or $heap: cmake --build $build --target lr_bench bench_scene bench_heap" >&2; exit 1; }

mkdir -p "$folder" "$docs"
rm -f "$folder"/*.csv
"$bench" --csv "$folder/rows.csv" "${quick[@]}"
if [ ${#quick[@]} -eq 0 ]; then
    "$scene" --csv "$folder/scenes.csv" --seconds 60
    "$heap" --csv "$folder/heaps.csv"
    # Both are optional, because not every machine supports them.
    scripts/port_bound.py "$build" "$folder" || true
    scripts/count_instructions.sh "$build" "$folder/instructions.csv" || true
fi
/usr/bin/python3 scripts/performance.py "$folder" "$docs"
