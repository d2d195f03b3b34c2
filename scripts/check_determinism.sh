#!/usr/bin/env bash
# Builds the runtime with several compilers, optimisation levels, instruction sets and chunk sizes. All builds must give the
# hashes in tests/determinism/golden.txt, and save and restore the snapshot in tests/snapshot_travel with equal bytes.
# docs/maintainers/numerics.md has the results.
#   scripts/check_determinism.sh             GCC and clang at -O1, -O2 and -O3
#   scripts/check_determinism.sh clang-O2    the named builds
#   scripts/check_determinism.sh arm64       64-bit ARM, run by qemu (scripts/setup.sh arm64)
#   scripts/check_determinism.sh windows     64-bit Windows, run by Wine (scripts/setup.sh package windows)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Name, -O, chunk (0: default), omitted instruction sets. Builds without SSSE3 and SSE4 include plain C++, which has one lane with
# GCC 12 and four with clang. Every other instruction set is in at least two of the six builds.
builds=(
    "gcc-O1   1 64   HWY_SSE4;HWY_AVX3"
    "gcc-O2   2 256  HWY_SSSE3;HWY_AVX2"
    "gcc-O3   3 4096 HWY_SSSE3;HWY_AVX3"
    "clang-O1 1 256  HWY_SSSE3;HWY_AVX2"
    "clang-O2 2 64   HWY_SSSE3;HWY_SSE4;HWY_AVX2"
    "clang-O3 3 4096 HWY_SSE4;HWY_AVX3"
    "arm64    2 64   HWY_SVE;HWY_SVE2;HWY_SVE_256;HWY_SVE2_128"
    "windows  2 256  HWY_SSSE3;HWY_SSE4"
)
wanted=("$@")
[ ${#wanted[@]} -gt 0 ] || wanted=(gcc-O1 gcc-O2 gcc-O3 clang-O1 clang-O2 clang-O3)

find_program() { # candidates
    local candidate
    for candidate; do command -v "$candidate" && return; done
    echo "none of these is installed: $*" >&2
    return 1
}
# Prints the names of the build's instruction sets.
targets() { # directory, emulator
    "${@:2}" "$1/tests/tests_determinism$exe" --test-case="every instruction set is named" --success | tr -d '\r' |
        sed -n 's/.*instruction sets: //p'
}

failed=()
for name in "${wanted[@]}"; do
    entry=
    for candidate in "${builds[@]}"; do [ "${candidate%% *}" != "$name" ] || entry=$candidate; done
    [ -n "$entry" ] || { echo "unknown build: $name" >&2; exit 2; }
    read -r name level chunk disabled <<<"$entry"
    dir=build/determinism/$name
    emulator=() exe=
    case $name in
    gcc-*) compilers=(-DCMAKE_C_COMPILER="$(find_program gcc)" -DCMAKE_CXX_COMPILER="$(find_program g++)") ;;
    clang-*) compilers=(-DCMAKE_C_COMPILER="$(find_program clang-14 clang)" -DCMAKE_CXX_COMPILER="$(find_program clang++-14 clang++)") ;;
    arm64)
        compilers=(-DCMAKE_TOOLCHAIN_FILE="$PWD/cmake/aarch64-linux-gnu.cmake")
        emulator=(timeout 1800 qemu-aarch64-static -L /usr/aarch64-linux-gnu)
        ;;
    windows)
        source packaging/platforms.sh
        select_platform windows-x64
        packaging/build_dependencies.sh windows-x64 --runtime >/dev/null
        others=$(platform_folder windows-x64)/runtime-dependencies
        compilers=("${toolchain[@]}" -DLR_SELF_CONTAINED=ON "-DCMAKE_PREFIX_PATH=$others" "-DCMAKE_FIND_ROOT_PATH=$others"
            "-DHWY_DIR=$others/lib/cmake/hwy" "-DFlatBuffers_DIR=$others/lib/cmake/FlatBuffers" -DCMAKE_EXE_LINKER_FLAGS=-static
            "-DCMAKE_RUNTIME_OUTPUT_DIRECTORY=$PWD/$dir/tests")
        export WINEDEBUG=${WINEDEBUG:--all}
        exe=.exe
        emulator=(timeout 1800 "${runner[@]}")
        ;;
    esac
    mkdir -p "$dir"
    start=$SECONDS
    cmake -S . -B "$dir" -G Ninja "${compilers[@]}" -DCMAKE_BUILD_TYPE=Release "-DCMAKE_C_FLAGS_RELEASE=-O$level -DNDEBUG" \
        "-DCMAKE_CXX_FLAGS_RELEASE=-O$level -DNDEBUG" -DLR_BUILD_BAKER=OFF -DLR_CHUNK_BODIES="$chunk" \
        "-DLR_DISABLED_TARGETS=$disabled" >"$dir/configure.log" 2>&1 || { cat "$dir/configure.log"; exit 1; }
    cmake --build "$dir" --target tests_determinism snapshot_file >"$dir/build.log" 2>&1 || { tail -n 60 "$dir/build.log"; exit 1; }
    # An emulator is slow: run all scenes once, and the tests that depend on the processor.
    cases=()
    [ ${#emulator[@]} -eq 0 ] || cases=(--test-case="held hashes,every instruction set is named,*rounding*,*flushed*,*sees*")
    built=$((SECONDS - start))
    result=equal
    "${emulator[@]}" "$dir/tests/tests_determinism$exe" "${cases[@]}" >"$dir/tests.log" 2>&1 || { result=DIFFERENT; failed+=("$name"); }
    tests/snapshot_travel/check.sh "$dir/tests/snapshot_file$exe" "${emulator[@]}" >>"$dir/tests.log" 2>&1 || { result=DIFFERENT; failed+=("$name"); }
    printf '%-9s %-9s chunks of %-5s built in %3d s, run in %3d s: %s\n' "$name" "$result" "$chunk" "$built" \
        $((SECONDS - start - built)) "$(targets "$dir" "${emulator[@]}")"
    [ "$result" = equal ] || grep -E -A3 'ERROR|scene|^snapshots:' "$dir/tests.log" | head -n 40
done
[ ${#failed[@]} -eq 0 ] || { echo "not the held hashes: ${failed[*]}" >&2; exit 1; }
