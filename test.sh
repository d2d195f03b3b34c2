#!/usr/bin/env bash
# What anyone runs: on two cores at most 15 minutes the first time, 5 afterwards. All other tests: scripts/verify.sh.
#   ./test.sh [STEP...]     format release plain asan samples bindings; initially all
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source scripts/steps.sh
scripts/setup.sh test
source scripts/compiler_cache.sh
prefix=$PWD/build/release/samples-prefix

step_format() {
    find include src samples tests bindings packaging \( -name '*.c' -o -name '*.h' -o -name '*.cpp' -o -name '*.hpp' \) -print0 |
        xargs -0 clang-format --dry-run -Werror
}
step_release() { # held hashes on every instruction set of this processor among its tests
    configure build/release --preset release
    cmake --build build/release
    run_ctest build/release -LE "$left_to_verify"
}
step_plain() {
    configure build/plain --preset release -DLR_PLAIN_KERNEL=ON -DLR_BUILD_BAKER=OFF
    cmake --build build/plain --target tests_determinism
    run_ctest build/plain -R '^tests_determinism: ?(held hashes|every instruction set is named)'
}
step_asan() { # the baker, and long tests: scripts/verify.sh asan
    configure build/asan --preset asan -DLR_BUILD_BAKER=OFF
    cmake --build build/asan
    run_ctest build/asan -LE "$left_to_verify|exact"
}
step_samples() { # as outside users build and run them: against the installed package
    cmake --install build/release --prefix "$prefix" >/dev/null
    configure build/samples -S samples -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix"
    cmake --build build/samples
    build/samples/hello
    build/samples/job_system
    python3 tests/samples/check_assets.py .
    "$prefix/bin/lr_bake" mesh assets/leaf.obj -o build/samples/leaf.lrb --density 350 --quiet
    build/samples/import_mesh assets/leaf.obj build/samples/imported.lrb 2>/dev/null
    cmp build/samples/leaf.lrb build/samples/imported.lrb # in process and by the tool
    python3 tests/samples/check_leaf_storm.py build/samples/leaf_storm build/samples/leaf.lrb assets/leaf.obj
    python3 tests/samples/check_viewer.py build/samples .
    python3 tests/samples/check_paper_figures.py build/samples/paper_figures "$prefix/bin/lr_bake" . build/samples
}
binding() { # its name, prefix: what its tests printed, as a whole
    local log=$results/binding-$1.txt start=$SECONDS good=true
    "bindings/$1/test.sh" "$2" >"$log" 2>&1 || good=false
    echo "   $1 ($((SECONDS - start)) s)"
    cat "$log"
    $good
}
step_bindings() { # with the check that what is generated is what the header gives
    cmake --install build/release --prefix "$prefix" >/dev/null
    /usr/bin/python3 bindings/generator/test_api_model.py
    export -f binding
    export results
    printf '%s\n' bindings/*/test.sh | cut -d/ -f2 | xargs -P "$jobs" -I{} bash -c 'binding "$@"' - {} "$prefix"
}

declare -A titles=(
    [format]="Formatting" [release]="Release build and its tests" [plain]="Held hashes in plain C++"
    [asan]="AddressSanitizer and UndefinedBehaviorSanitizer on the runtime" [samples]="Samples" [bindings]="Bindings")
wanted=("$@")
[ $# -gt 0 ] || wanted=(format release plain asan samples bindings)
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
