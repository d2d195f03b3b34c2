#!/usr/bin/env bash
# The tests for every change: on two cores at most 15 minutes the first time, 5 afterwards. All other tests: scripts/verify.sh.
#   ./test.sh [STEP...]     format release plain asan outside; default: all
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source scripts/steps.sh
scripts/setup.sh test
source scripts/compiler_cache.sh
prefix=$PWD/build/release/samples-prefix

step_format() {
    /usr/bin/python3 bindings/generator/all.py --check
    find include src samples tests bindings packaging \( -name '*.c' -o -name '*.h' -o -name '*.cpp' -o -name '*.hpp' \) -print0 |
        xargs -0 clang-format --dry-run -Werror
}
step_release() { # includes the held hashes on every instruction set of this processor
    configure build/release --preset release
    cmake --build build/release
    run_ctest build/release -LE "$left_to_verify"
}
step_plain() { # the same library with a kernel in plain C++
    configure build/release --preset release
    cmake --build build/release --target langevin_rigid_plain tests_determinism
    LD_LIBRARY_PATH=$PWD/build/release/src/plain build/release/tests/tests_determinism -tc="held hashes,every instruction set is named" |
        tee "$results/plain.txt"
    grep -q 'instruction sets: plain$' "$results/plain.txt"
}
step_asan() { # the API on one instruction set; scripts/verify.sh asan tests units, the baker, AVX2 and long tests
    configure build/asan --preset asan -DLR_BUILD_BAKER=OFF -DLR_DISABLED_TARGETS="HWY_AVX2;HWY_AVX3"
    cmake --build build/asan --target tests_api tests_replay
    run_ctest build/asan -R '^tests_(api|replay)' -LE "$left_to_verify|exact"
}
samples() { # built against the installed package, as users do
    configure build/samples -S samples -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix"
    cmake --build build/samples
    build/samples/hello
    build/samples/job_system
    python3 tests/samples/check_small.py build/samples . "$prefix"
    python3 tests/samples/check_assets.py .
    "$prefix/bin/lr_bake" mesh assets/leaf.obj -o build/samples/leaf.lrb --density 350 --quiet
    build/samples/import_mesh assets/leaf.obj build/samples/imported.lrb 2>/dev/null
    cmp build/samples/leaf.lrb build/samples/imported.lrb # the baker library and lr_bake give equal files
    python3 tests/samples/check_leaf_storm.py build/samples/leaf_storm build/samples/leaf.lrb assets/leaf.obj
    python3 tests/samples/check_viewer.py build/samples .
    python3 tests/samples/check_paper_figures.py build/samples/paper_figures "$prefix/bin/lr_bake" . build/samples
}
apart() { # samples or a binding: prints the output of its tests as one block
    local log=$results/outside-$1.txt start=$SECONDS good=true
    if [ "$1" = samples ]; then
        (set -e; samples) >"$log" 2>&1 & # in the background, because `set -e` has no effect in a condition
        wait $! || good=false
    else
        "bindings/$1/test.sh" "$prefix" >"$log" 2>&1 || good=false
    fi
    echo "   $1 ($((SECONDS - start)) s)"
    cat "$log"
    $good
}
step_outside() { # samples and bindings; the costly ones, Unreal and the web, are steps of scripts/verify.sh
    cmake --install build/release --prefix "$prefix" >/dev/null
    /usr/bin/python3 bindings/generator/test_api_model.py
    export -f apart samples configure
    export results prefix
    # Longest first.
    printf '%s\n' /samples/ bindings/{csharp,python,godot,unity}/test.sh | cut -d/ -f2 |
        xargs -P "$jobs" -I{} bash -c 'apart "$@"' - {}
}

declare -A titles=(
    [format]="Formatting, and generated files up to date" [release]="Release build and its tests" [plain]="Held hashes in plain C++"
    [asan]="AddressSanitizer and UndefinedBehaviorSanitizer on the runtime" [outside]="Samples and bindings")
wanted=("$@")
[ $# -gt 0 ] || wanted=(format release plain asan outside)
for name in "${wanted[@]}"; do [ -n "${titles[$name]:-}" ] || { sed -n 's/^#   //p' test.sh >&2; exit 2; }; done

rm -f "$results"/test-*.log
start_clock build/release
for name in "${wanted[@]}"; do
    run_step test "$name" "${titles[$name]}"
    [ $outcome != failed ] || break
done
read_cpu
[ $# -gt 0 ] || [ $outcome = failed ] || note_time test.sh $SECONDS "$cpu"
echo
closing_line "$results"/test-*.log
