#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the WebAssembly package: build/web/package, with everything that a page or a node program needs.
#   bindings/web/build.sh [--tests]     --tests: also the determinism tests as a program for node
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
wasm=$root/build/web/wasm package=$root/build/web/package
targets=(langevin_rigid_wasm)
[ "${1:-}" != --tests ] || targets+=(tests_determinism snapshot_file)

mkdir -p "$wasm"
cmake -S "$root" -B "$wasm" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$root/cmake/wasm32-wasi.cmake" -DCMAKE_BUILD_TYPE=Release \
    -DLR_BUILD_BAKER=OFF >"$wasm/configure.log" 2>&1 || { cat "$wasm/configure.log"; exit 1; }
cmake --build "$wasm" -j "${LR_JOBS:-2}" --target "${targets[@]}" >"$wasm/build.log" 2>&1 || { tail -n 60 "$wasm/build.log"; exit 1; }

rm -rf "$package"
mkdir -p "$package/src/generated" "$package/licenses"
cd "$root/bindings/web"
cp langevin_rigid.mjs langevin_rigid.d.mts langevin_rigid.d.ts package.json README.md "$package"
cp src/*.mjs "$package/src"
cp -R examples "$package"
cp src/generated/* "$package/src/generated"
cp "$wasm/bindings/web/native/langevin_rigid.wasm" "$package"
# Licenses of linked code.
cp "$root/LICENSE" "$package/licenses/langevin_rigid"
for library in libhwy-dev libflatbuffers-dev wasi-libc libc++-14-dev-wasm32; do
    [ ! -e "/usr/share/doc/$library/copyright" ] || cp "/usr/share/doc/$library/copyright" "$package/licenses/$library"
done
echo "package: $package ($(stat -c %s "$package/langevin_rigid.wasm") bytes, $(gzip -9c "$package/langevin_rigid.wasm" | wc -c) gzipped)"
