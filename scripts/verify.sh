#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# All tests that ./test.sh omits: other architectures and compilers, the other sanitizers, fuzzing, packages, long tests.
#   scripts/verify.sh [STEP...]         these steps; default: all
#   scripts/verify.sh --minutes N       steps that fit into N minutes by the estimates: bindings and short ones first, then long ones, rotated by the day
#   scripts/verify.sh --list            lists the steps with their minutes on two cores
# A step without its tools is skipped and names the command that installs them: scripts/setup.sh test package arm64 windows.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/steps.sh
source scripts/compiler_cache.sh
library=build/release/src/liblangevin_rigid.so

steps=( # name, minutes on two cores, title
    "tidy          5 clang-tidy on the runtime"
    "abi           1 ABI of the library; refused targets"
    "security      1 Hardening, imports and system calls of the library"
    "site          1 Documentation site with the API reference, without warnings"
    "bench         2 lr_bench: its columns, and equal hashes"
    "unreal        3 Unreal plugin, against stand-ins for the engine"
    "web           4 WebAssembly package: held hashes, wrapper, types; the page in a browser"
    "long          8 Long tests, and load"
    "scorecard     6 Scorecard: every row; the figures of the paper"
    "valgrind      6 Valgrind over the API's tests"
    "tsan         16 ThreadSanitizer"
    "asan         15 AddressSanitizer and UndefinedBehaviorSanitizer: long and exact tests, and the baker"
    "corpus       45 Models that Debian packages: how many bake"
    "fuzz         12 Fuzzers: assets 20 s, API, meshes and cards 60 s each"
    "clang         7 Held hashes: clang"
    "levels       15 Held hashes: GCC and clang at -O1, -O2 and -O3"
    "arm64         8 Held hashes: 64-bit ARM, emulated"
    "windows      10 Held hashes: 64-bit Windows, by Wine"
    "kit           8 Source kit: unpacked alone, GCC, clang, Emscripten, without a system, Microsoft's rules"
    "package      15 Packages for Linux, engines, Python, Blender and the web, as a new user uses them"
    "dist         60 All packages and the site, each unpacked in a bare place and used as its page says"
    "reproducible 10 The library built twice in different folders: equal bytes"
)

release() { # builds the present sources
    configure build/release --preset release
    cmake --build build/release >"$results/build-release.txt" || { tail -n 60 "$results/build-release.txt"; return 1; }
}
need() { # program, arguments of scripts/setup.sh
    command -v "$1" >/dev/null || skip "$1 is not installed: scripts/setup.sh ${*:2}"
}

step_tidy() {
    need clang-tidy test
    configure build/release --preset release
    cmake --build build/release --target lr_assets >/dev/null # writes a header
    # Only files that are compiled once: clang-tidy rejects Highway's macros, and would read a file once for each target. Without options that clang
    # takes for errors (src/CMakeLists.txt, pair_hull.cpp).
    mkdir -p build/tidy
    sed -E 's/ (-fno-ipa-modref|--param=[^ "]*)//g' build/release/compile_commands.json >build/tidy/compile_commands.json
    find src -name '*.cpp' -not -path 'src/baker/*' -not -path 'src/tools/*' |
        xargs grep -L 'HWY_TARGET_INCLUDE\|foreach_target' |
        xargs -P "$jobs" -n 6 clang-tidy -p build/tidy --quiet 2>/dev/null
}
step_abi() {
    release
    tests/abi/test_check.py
    tests/abi/check.py $library
    tests/refused_platforms/check_refused.sh
}
step_security() {
    release
    build/release/src/tools/lr_bake/lr_bake mesh assets/leaf.obj -o "$results/leaf.lrb" --density 350 --quiet
    tests/security/check_hardening.sh $library build/release/src/tools/lr_bake/lr_bake build/release/src/tools/lr_drop/lr_drop
    tests/security/check_imports.sh $library tests/security/imports-linux.txt
    tests/security/test_hardening.sh
    tests/security/check_syscalls.sh build/release/src "$results/leaf.lrb"
}
step_site() { need mkdocs test; scripts/site.py; }
binding() { # name
    release
    install_release
    "bindings/$1/test.sh" "$installed"
}
step_unreal() { binding unreal; }
step_web() { binding web; }
step_bench() { release; run_ctest build/release -L bench; }
step_long() { release; run_ctest build/release -L 'long|load'; }
step_scorecard() {
    release
    run_ctest build/release -L scorecard
    install_release
    configure_samples
    cmake --build build/samples --target paper_figures
    python3 tests/samples/check_paper_figures.py build/samples/paper_figures "$installed/bin/lr_bake" . build/samples
}
step_valgrind() {
    need valgrind test
    release
    # libhwy executes rdtscp when it is loaded if the processor has it, and Debian's valgrind lacks that instruction.
    valgrind -q build/release/tests/tests_api --version >/dev/null 2>&1 || skip "valgrind cannot load libhwy on this processor"
    scripts/valgrind.sh
}
step_tsan() {  # only test files that involve threads
    configure build/tsan --preset tsan -DLR_BUILD_BAKER=OFF
    cmake --build build/tsan
    run_ctest build/tsan -LE 'long|exact'
}
step_asan() { # the part that ./test.sh omits
    configure build/asan --preset asan -DLR_BUILD_BAKER=ON -DLR_DISABLED_TARGETS=HWY_AVX3
    cmake --build build/asan
    run_ctest build/asan -L 'long|corpus' -LE exact
    run_ctest build/asan -R '^tests_(baker|core|contact|determinism|drop)|lr_replay' -LE 'long|exact'
    run_ctest build/asan -R '^tests_api' -L exact -LE long
}
step_corpus() { # needs the package mirrors once
    release
    nice scripts/bake_corpus.py --most 60 --seconds 60
}
step_fuzz() {
    need clang++-14 test
    configure build/fuzz --preset fuzz
    cmake --build build/fuzz --target fuzz_asset fuzz_api fuzz_mesh fuzz_card
    local run target good=true
    local -A running
    for run in asset:20 api:60 mesh:60 card:60; do
        target=${run%:*}
        mkdir -p "build/fuzz/corpus-$target"
        # assimp leaks memory on some damaged files; our code cannot free it.
        ASAN_OPTIONS=detect_leaks=$([ "$target" = mesh ] && echo 0 || echo 1) \
            "build/fuzz/tests/fuzz/fuzz_$target" -max_total_time="${run#*:}" -max_len=40000 -verbosity=0 -print_final_stats=1 \
            -artifact_prefix="build/fuzz/$target-" \
            "build/fuzz/corpus-$target" "tests/fuzz/corpus/$target" >"build/fuzz/$target.log" 2>&1 &
        running[$target]=$!
    done
    for target in "${!running[@]}"; do
        wait "${running[$target]}" || good=false
        echo "$target: $(grep -E 'number_of_executed_units|DEFECT|runtime error|terminate|ERROR|SUMMARY|Base64' "build/fuzz/$target.log" || true)"
    done
    $good
}
step_clang() { need clang++-14 test; scripts/check_determinism.sh clang-O2; }
step_levels() { need clang++-14 test; scripts/check_determinism.sh; }
step_arm64() {
    need aarch64-linux-gnu-g++ test arm64
    need qemu-aarch64-static test arm64
    scripts/check_determinism.sh arm64
}
on_platform() ( # whether its tools are installed
    source packaging/platforms.sh
    select_platform "$1"
)
step_windows() {
    on_platform windows-x64 || skip "the tools above are not installed"
    scripts/check_determinism.sh windows
}
step_kit() {
    [ -d /usr/x86_64-w64-mingw32/include ] || skip "MinGW's headers are not installed: scripts/setup.sh test windows"
    scripts/package.sh source
    packaging/check_source_kit.sh build/packages/langevin_rigid-*-source.tar.xz
    packaging/check_msvc_rules.sh
}
step_package() {
    on_platform linux-x64 || skip "the tools above are not installed"
    scripts/package.sh linux-x64 engines wasm
    packaging/check_dist.sh build/packages
}
step_dist() {
    scripts/package.sh all || { [ $? -ne 3 ] || skip "the tools above are not installed"; return 1; }
    packaging/check_dist.sh
}
step_reproducible() { scripts/check_reproducible.sh; }

minutes= names=() left=()
case ${1:-} in
--list) printf '%s\n' "${steps[@]}"; exit ;;
--minutes) minutes=${2:?minutes} ;;
*) names=("$@") ;;
esac
declare -A estimate title
all=()
for entry in "${steps[@]}"; do
    read -r name number text <<<"$entry"
    all+=("$name") estimate[$name]=$number title[$name]=$text
done
for name in "${names[@]}"; do [ -n "${title[$name]:-}" ] || { echo "verify: unknown step $name; steps: ${all[*]}" >&2; exit 2; }; done
[ ${#names[@]} -gt 0 ] || names=("${all[@]}")
if [ -n "$minutes" ]; then # bindings and short steps, then long ones, starting at a different one each day
    names=(unreal web) long=()
    for name in "${all[@]}"; do
        case $name in unreal | web) continue ;; esac
        if [ "${estimate[$name]}" -le 2 ]; then names+=("$name"); else long+=("$name"); fi
    done
    first=$((10#$(date +%j) % ${#long[@]}))
    names+=("${long[@]:first}" "${long[@]:0:first}")
fi

rm -f "$results"/verify-*.log
start_clock build/release
bad=()
for name in "${names[@]}"; do
    if [ -n "$minutes" ] && [ $((SECONDS + 60 * estimate[$name])) -gt $((60 * minutes)) ]; then
        left+=("$name (${estimate[$name]} min)")
        echo "-- $name: skipped (left out)" >"$results/verify-$name.log"
        continue
    fi
    run_step verify "$name" "${title[$name]}"
    [ $outcome != failed ] || bad+=("$name")
done
echo
[ ${#left[@]} -eq 0 ] || echo "Omitted for lack of time: ${left[*]}. To run them: scripts/verify.sh STEP..."
[ ${#bad[@]} -eq 0 ] || echo "Failed: ${bad[*]}; logs: $results/verify-*.log"
closing_line "$results"/verify-*.log
