#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Builds the library and lr_bake for one platform in build/package-PLATFORM. They need only its C library.
#   packaging/build_library.sh PLATFORM [--tests]      --tests: also builds the tests (packaging/test_windows.sh)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/platforms.sh

select_platform "${1:?which platform}"
folder=$(platform_folder "$platform")
build=$(platform_build "$platform")
dependencies=$folder/dependencies
targets=(langevin_rigid langevin_rigid_static lr_bake lr_drop lr_replay)
tests=OFF
if [ "${2:-}" = --tests ]; then
    targets+=(tests_core tests_api tests_determinism snapshot_file)
    tests=ON
fi
# assimp's CMake package names some libraries without a folder. Tests for Windows must also run without the compiler's DLLs.
link="-L$dependencies/lib"
[ "$platform" != windows-x64 ] || link+=" -static"
mkdir -p "$folder"
export PKG_CONFIG_LIBDIR=$dependencies/lib/pkgconfig PKG_CONFIG_PATH= WINEDEBUG=${WINEDEBUG:--all}
if ! cmake -S . -B "$build" -G Ninja "${toolchain[@]}" -DCMAKE_BUILD_TYPE=Release -DLR_SELF_CONTAINED=ON \
    -DLR_BUILD_TESTS=$tests "-DCMAKE_PREFIX_PATH=$dependencies" "-DCMAKE_FIND_ROOT_PATH=$dependencies" \
    "-DHWY_DIR=$dependencies/lib/cmake/hwy" "-DFlatBuffers_DIR=$dependencies/lib/cmake/FlatBuffers" \
    "-DCMAKE_EXE_LINKER_FLAGS=$link" \
    -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF -DBoost_NO_BOOST_CMAKE=ON -DCMAKE_INSTALL_LIBDIR=lib \
    "-DCMAKE_RUNTIME_OUTPUT_DIRECTORY=$build/bin" >"$folder/configure.log" 2>&1; then
    tail -n 40 "$folder/configure.log" >&2
    exit 1
fi
if ! cmake --build "$build" -j "${LR_JOBS:-$(nproc)}" --target "${targets[@]}" >"$folder/build.log" 2>&1; then
    grep -E -A12 'FAILED|error' "$folder/build.log" | head -n 80 >&2
    exit 1
fi
