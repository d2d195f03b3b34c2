#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# A library of the next version, in which every struct that callers size has grown, and programs of all versions with it: they must
# run as ever. Some 5 minutes of two cores, so by hand: docs/maintainers/releases.md
#   tests/abi/grown_library.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/compiler_cache.sh
tree=build/abi/grown
rm -rf "$tree/include" "$tree/src"
mkdir -p "$tree"
cp -r CMakeLists.txt cmake include src packaging LICENSE "$tree/"
tests/abi/grow.py "$tree"
# With debug information, so that the gate reads the types of the library itself; of the kernel one target is enough.
cmake -S "$tree" -B "$tree/out" -G Ninja -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_FLAGS_DEBUG=-O0 -g -Wno-maybe-uninitialized" -DLR_BUILD_BAKER=OFF \
    -DLR_BUILD_TESTS=OFF "-DLR_DISABLED_TARGETS=HWY_AVX2;HWY_AVX3" >"$tree/configure.log" || { cat "$tree/configure.log"; exit 1; }
cmake --build "$tree/out" -j "${LR_JOBS:-$(nproc)}" --target langevin_rigid >"$tree/build.log" || { tail -n 40 "$tree/build.log"; exit 1; }
library=$tree/out/src/liblangevin_rigid.so
tests/abi/check.py "$library" --header "$tree/include/langevin_rigid.h" | tee "$tree/gate.txt"
grep -q "field grown is new" "$tree/gate.txt"
for program in tests/abi/*/program.c; do
    folder=$(dirname "$program")
    "${CC:-cc}" -std=c99 -O1 "$program" "$library" "-Wl,-rpath,$PWD/$tree/out/src" -lm -o "$tree/program"
    "$tree/program" "$folder/leaf.lrb"
done

echo "a grown library: programs of all versions run with it"
