#!/usr/bin/env bash
# Set-up, build and every test. --quick leaves out the sanitizer builds.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
jobs=$(nproc)

step() { printf '\n== %s (%d:%02d)\n' "$*" $((SECONDS / 60)) $((SECONDS % 60)); }
configure() { # directory, arguments
    local dir=$1
    shift
    mkdir -p build
    cmake "$@" -B "$dir" >"build/configure.log" 2>&1 || { cat build/configure.log; exit 1; }
}

step "Set-up"
scripts/setup.sh test package ${CI:+arm64 windows browser}
source scripts/compiler_cache.sh

step "Formatting"
find include src samples tests bindings packaging \( -name '*.c' -o -name '*.h' -o -name '*.cpp' -o -name '*.hpp' \) -print0 |
    xargs -0 clang-format --dry-run -Werror
echo "clean"

step "Release build"
configure build/release --preset release
cmake --build build/release
step "clang-tidy on the runtime"
# Not on what is compiled for each target: Highway's macros are not written for it, and each would be read again.
ls src/api/*.cpp src/world/*.cpp src/asset/*.cpp src/contact/*.cpp src/field/*.cpp src/format/*.cpp src/record/*.cpp src/shape/*.cpp \
    src/kernel/aerodynamics.cpp src/kernel/constants.cpp src/kernel/modes.cpp src/kernel/water_body.cpp |
    xargs -P "$jobs" -n 6 clang-tidy -p build/release --quiet 2>/dev/null
echo "clean"

step "Release tests"
ctest --test-dir build/release -j "$jobs" --output-on-failure

step "ABI, security, and valgrind over the API"
library=build/release/src/liblangevin_rigid.so
xargs -P "$jobs" -I{} bash -c {} <<CHECKS
scripts/valgrind.sh
scripts/check_reproducible.sh quick
tests/abi/test_check.py
tests/abi/check.py $library
tests/security/check_hardening.sh $library build/release/src/tools/bake/lr_bake
tests/security/check_imports.sh $library tests/security/imports-linux.txt
tests/security/test_hardening.sh
tests/security/check_syscalls.sh build/release/src build/release/tests/fixtures/leaf.lrb
tests/targets/check_refused.sh
CHECKS

step "Samples, built and run as outside users would: against the installed package"
prefix=$PWD/build/release/samples-prefix
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

step "Bindings, each against the installed package"
/usr/bin/python3 bindings/generator/test_api_model.py
binding() { # its name: what it printed, as a whole
    local log=build/binding-$1.log start=$SECONDS good=true
    "bindings/$1/test.sh" "$2" >"$log" 2>&1 || good=false
    echo "-- $1 ($((SECONDS - start)) s)"
    cat "$log"
    $good
}
export -f binding
printf '%s\n' bindings/*/test.sh | cut -d/ -f2 | xargs -P "$jobs" -I{} bash -c 'binding "$@"' - {} "$prefix"

step "Package for Linux, used as a new user would"
scripts/package.sh linux-x64
packaging/check_package.sh build/packages/langevin_rigid-*-linux-x64.tar.xz

step "API reference: Doxygen without a warning"
scripts/api_reference.sh

if [ "${1:-}" != --quick ]; then
    step "Determinism: the same bits from clang; and on 64-bit ARM and Windows, which are emulated, beside what follows"
    others=() others_run=
    trap '[ -z "$others_run" ] || kill "$others_run" 2>/dev/null || true' EXIT
    if command -v aarch64-linux-gnu-g++ >/dev/null && command -v qemu-aarch64-static >/dev/null; then
        others+=(arm64)
    else
        echo "SKIPPED: 64-bit ARM, for want of a cross compiler and qemu: scripts/setup.sh test arm64"
    fi
    if (source packaging/platforms.sh && select_platform windows-x64) 2>/dev/null; then
        others+=(windows)
    else
        echo "SKIPPED: 64-bit Windows, for want of MinGW and Wine: scripts/setup.sh test package windows"
    fi
    if [ ${#others[@]} -gt 0 ]; then
        scripts/check_determinism.sh "${others[@]}" >build/others.log 2>&1 &
        others_run=$!
    fi
    scripts/check_determinism.sh clang-O2

    step "AddressSanitizer and UndefinedBehaviorSanitizer"
    configure build/asan --preset asan
    cmake --build build/asan
    if [ -n "$others_run" ]; then
        finished=$others_run equal=true
        others_run=
        wait "$finished" || equal=false
        cat build/others.log
        $equal
    fi
    # Without the long ones that say how exact a result is, or that it is the same as another, of code that others run through as well.
    ctest --test-dir build/asan -j "$jobs" --output-on-failure \
        -E 'RK4 converges|20,480 triangles|hardly depends on the grid|do not depend on the grid|a block in the stream|published values at 2,000|integral length of turbulence|an age lasts|sheds vortices becomes|makes its own turbulence|several bakes at once|input hash: without baking|extreme parameters give|fast added mass: same bits|bits with any job system|an open sheet bakes alike|held hashes|scenes differ|in any order of bodies|in scenes (with|of)|a rollback allocates nothing'

    step "ThreadSanitizer"
    configure build/tsan --preset tsan -DLR_BUILD_BAKER=OFF
    cmake --build build/tsan
    # Of the files of tests only those that say something of threads are built, without the long tests in them that have one.
    ctest --test-dir build/tsan -j "$jobs" --output-on-failure \
        -E 'RK4 converges|bits on every instruction set|in any order of bodies|scenes differ|held hashes'

    step "Fuzzers: the loader 20 s; the API, the baker's readers and checks of meshes and cards 60 s each"
    configure build/fuzz --preset fuzz
    cmake --build build/fuzz --target fuzz_asset fuzz_api fuzz_mesh fuzz_card
    declare -A running
    for run in asset:20 api:60 mesh:60 card:60; do
        target=${run%:*}
        mkdir -p "build/fuzz/corpus-$target"
        # assimp loses memory on some damaged files; nothing of ours can give it back.
        ASAN_OPTIONS=detect_leaks=$([ "$target" = mesh ] && echo 0 || echo 1) \
            "build/fuzz/tests/fuzz/fuzz_$target" -max_total_time="${run#*:}" -max_len=40000 -verbosity=0 -print_final_stats=1 \
            "build/fuzz/corpus-$target" "tests/fuzz/corpus/$target" >"build/fuzz/$target.log" 2>&1 &
        running[$target]=$!
    done
    good=true
    for target in "${!running[@]}"; do
        wait "${running[$target]}" || good=false
        echo "$target: $(grep -E 'number_of_executed_units|ERROR|SUMMARY' "build/fuzz/$target.log" || true)"
    done
    $good
fi

step "All tests passed"
