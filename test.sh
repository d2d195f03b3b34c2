#!/usr/bin/env bash
# The tests for every change: on two cores at most 15 minutes the first time, 5 afterwards. All other tests: scripts/verify.sh.
#   ./test.sh [STEP...]     format release plain asan outside; default: all
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source scripts/steps.sh
scripts/setup.sh test
source scripts/compiler_cache.sh

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
sanitized() { # the release build's tests of the API with the library of build/asan: 25 cases from number $1 on
    local log=$results/asan-$1.txt status=0
    # The tests count allocations with an operator delete of their own, which frees memory of the sanitizer's operator new.
    ASAN_OPTIONS=alloc_dealloc_mismatch=0 LR_TEST_QUICK=1 LD_PRELOAD=$(gcc -print-file-name=libasan.so) LD_LIBRARY_PATH=$PWD/build/asan/src \
        timeout 900 build/release/tests/tests_api $api_cases --first="$1" --last=$(($1 + 24)) >"$log" 2>&1 || status=$?
    # doctest counts cases out of the range as passed. A process that died has no summary: all of its cases failed.
    local count=$((cases - $1 + 1)) failed
    ((count < 25)) || count=25
    failed=$(sed -n 's/.*test cases: .* passed | *\([0-9]*\) failed.*/\1/p' "$log")
    failed=${failed:-$count}
    if ((status != 0)); then
        cat "$log"
        ((failed > 0)) || failed=1 # a leak, found after the summary
    fi
    echo "asan: $((count - failed)) passed, $failed failed"
}
step_asan() { # the API on one instruction set; scripts/verify.sh asan tests units, the baker, AVX2 and long tests, and has checks in the tests too
    configure build/asan --preset asan -DLR_BUILD_BAKER=OFF -DLR_DISABLED_TARGETS="HWY_AVX2;HWY_AVX3"
    cmake --build build/asan --target langevin_rigid tests_replay
    # After the above, during which the step `outside` installs this build.
    configure build/release --preset release
    cmake --build build/release --target tests_api
    run_ctest build/asan -R '^tests_replay' -LE "$left_to_verify|exact"
    api_cases=--test-suite-exclude=long,exact,long-exact
    cases=$(build/release/tests/tests_api $api_cases --count | sed -n 's/.*filters: *//p')
    export -f sanitized
    export results api_cases cases
    seq 1 25 "$cases" | xargs -P "$jobs" -I{} bash -c 'sanitized "$@"' - {} | tee "$results/asan.txt"
    ! grep -qv ', 0 failed' "$results/asan.txt"
}
samples() {
    configure_samples
    cmake --build build/samples
    build/samples/hello
    build/samples/job_system
    python3 tests/samples/check_small.py build/samples . "$installed"
    python3 tests/samples/check_assets.py .
    "$installed/bin/lr_bake" mesh assets/leaf.obj -o build/samples/leaf.lrb --density 350 --quiet
    build/samples/import_mesh assets/leaf.obj build/samples/imported.lrb 2>/dev/null
    cmp build/samples/leaf.lrb build/samples/imported.lrb # the baker library and lr_bake give equal files
    python3 tests/samples/check_leaf_storm.py build/samples/leaf_storm build/samples/leaf.lrb assets/leaf.obj
    python3 tests/samples/check_viewer.py build/samples .
}
apart() { # samples or a binding: prints the output of its tests as one block
    local log=$results/outside-$1.txt start=$SECONDS good=true
    if [ "$1" = samples ]; then
        (set -e; samples) >"$log" 2>&1 & # in the background, because `set -e` has no effect in a condition
        wait $! || good=false
    else
        "bindings/$1/test.sh" "$installed" >"$log" 2>&1 || good=false
    fi
    echo "   $1 ($((SECONDS - start)) s)"
    cat "$log"
    $good
}
step_outside() { # samples and bindings; the costly ones, Unreal and the web, are steps of scripts/verify.sh
    install_release
    /usr/bin/python3 bindings/generator/test_api_model.py
    export -f apart samples configure configure_samples
    export results installed
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
outside=
for name in "${wanted[@]}"; do
    if [ "$name" = outside ] && [ -n "$outside" ]; then
        wait "$outside" || outcome=failed
        cat "$results/outside.txt"
    else
        # The samples wait for windows and engines, so they run beside the sanitizers.
        if [[ $name = asan && " ${wanted[*]} " = *" outside "* ]]; then
            (run_step test outside "${titles[outside]}"; [ $outcome != failed ]) >"$results/outside.txt" 2>&1 &
            outside=$!
        fi
        run_step test "$name" "${titles[$name]}"
    fi
    [ $outcome != failed ] || break
done
wait
read_cpu
[ $# -gt 0 ] || [ $outcome = failed ] || note_time test.sh $SECONDS "$cpu"
echo
closing_line "$results"/test-*.log
