#!/usr/bin/env bash
# Counts instructions per body and substep by callgrind under AVX2 (callgrind lacks AVX-512). Builds nothing.
#   scripts/count_instructions.sh [BUILD [OUT.csv]]     default: build/release, build/release/bench/instructions.csv
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=${1:-build/release}
out=${2:-build/release/bench/instructions.csv}
bench=$build/tests/bench/lr_bench/lr_bench
bodies=1024
[ -x "$bench" ] || { echo "instructions: no $bench: build lr_bench first" >&2; exit 1; }
command -v valgrind >/dev/null || { echo "instructions: valgrind is not installed: scripts/setup.sh bench" >&2; exit 1; }

mkdir -p "$(dirname "$out")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

count() { # row, function, steps: prints the instructions inside the function; leaves the profile in $work/profile
    valgrind --tool=callgrind --callgrind-out-file="$work/profile" --toggle-collect="$2" \
        "$bench" --one "$1" --steps "$3" >/dev/null 2>"$work/log" || { cat "$work/log" >&2; exit 1; }
    awk '/Collected :/ {print $4}' "$work/log"
}

echo "row,function,instructions" >"$out"
profile() { # row, function, substeps
    local few many
    few=$(count "$1" "$2" 2)
    many=$(count "$1" "$2" 6)
    # The difference excludes set-up and the first steps.
    callgrind_annotate --auto=no --threshold=99.9 "$work/profile" 2>/dev/null |
        awk -v row="$1" -v total="$many" -v each="$(((many - few)))" -v steps=$((4 * bodies * $3)) '
            function emit(name, share) { printf "%s,\"%s\",%.2f\n", row, name, share * each / steps }
            BEGIN { emit("all", 1) }
            /\[.*\]$/ && /%\)/ {
                ir = $1
                gsub(",", "", ir)
                name = $0
                sub(/^[^)]*\) */, "", name)   # count and share
                sub(/^[^:]*:/, "", name)      # file
                sub(/ \[[^]]*\]$/, "", name)  # object
                sub(/^void /, "", name)
                gsub(/\(anonymous namespace\)::|lr_bench::/, "", name)
                if (name ~ /std::/) sub(/<.*>/, "", name)
                if (name ~ />\(/) sub(/>\(.*$/, ">", name)
                else sub(/\(.*$/, "", name)
                if (ir / total >= 0.001) emit(name, ir / total)
            }' >>"$out"
    echo "$1: $(((many - few) / (4 * bodies * $3)))"
}

for model in none langevin-speed aerodynamic; do
    for path in diagonal full; do
        profile "langevin_rigid/$model/default/$path/avx2/0/$bodies/4" lr_world_step 4
    done
done
profile "langevin_rigid/langevin-speed/default/diagonal/avx2/0/$bodies/1" lr_world_step 1
profile "langevin_rigid/langevin-speed/rk4/diagonal/avx2/0/$bodies/4" lr_world_step 4
profile "sketch/langevin-speed/rk4/diagonal/x86-64-v3/0/$bodies/4" 'lr_bench::sketch_step_avx2*' 4
profile "scalar/langevin-speed/rk4/diagonal/compiler/0/$bodies/1" '*Scalar::step*' 1
