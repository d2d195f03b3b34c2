#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Unsupported platforms are refused by the configuration, and without CMake by the compiler, each time with a sentence that says why.
# Clang knows these targets without their headers; no program is built.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
clang=$(command -v clang-14 || command -v clang) || { echo "SKIPPED: refused targets, for want of clang"; exit 0; }
good=true

configure() { # target, processor
    cat >"$work/$1.cmake" <<CMAKE
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR $2)
set(CMAKE_C_COMPILER $clang)
set(CMAKE_CXX_COMPILER ${clang/clang/clang++})
set(CMAKE_C_COMPILER_TARGET $1)
set(CMAKE_CXX_COMPILER_TARGET $1)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
CMAKE
    cmake -S "$root" -B "$work/$1" -G Ninja "-DCMAKE_TOOLCHAIN_FILE=$work/$1.cmake" -DLR_BUILD_BAKER=OFF -DLR_BUILD_TESTS=OFF 2>&1
}
refused() { # target, processor, why
    local said
    if said=$(configure "$1" "$2"); then
        echo "FAILED: CMake configures for $1"; good=false
    elif ! tr -s ' \n' ' ' <<<"$said" | grep "Langevin Rigid $3" >/dev/null; then
        echo "FAILED: CMake for $1 does not say \"$3\":"; tail -n 8 <<<"$said"; good=false
    fi
    # The header uses only UINTPTR_MAX of its include.
    echo '#define UINTPTR_MAX __UINTPTR_MAX__
#define UINT64_MAX __UINT64_MAX__' >"$work/cstdint"
    if said=$("$clang" --target="$1" -x c++ -std=c++20 -nostdinc -I "$work" -I "$root/src" -fsyntax-only "$root/src/base/supported_platform.h" 2>&1); then
        echo "FAILED: the compiler takes $1"; good=false
    elif ! grep -q "Langevin Rigid $3" <<<"$said"; then
        echo "FAILED: the compiler for $1 says: $said"; good=false
    fi
}
accepted() { # the header's input
    "$clang" --target="$1" -x c++ -std=c++20 -nostdinc -I "$work" -I "$root/src" -fsyntax-only -w "$root/src/base/supported_platform.h" ||
        { echo "FAILED: the compiler refuses $1"; good=false; }
}
refused i686-linux-gnu i686 "is tested on 64-bit targets and on wasm32 alone"
refused armv7-linux-gnueabihf armv7l "is tested on 64-bit targets and on wasm32 alone"
refused powerpc64-linux-gnu ppc64 "needs a little-endian target"
refused s390x-linux-gnu s390x "needs a little-endian target"
for target in x86_64-linux-gnu aarch64-linux-gnu x86_64-pc-windows-msvc wasm32; do accepted "$target"; done
for source in api/check_arguments.h asset/asset_file.cpp; do
    grep -q '#include "base/supported_platform.h"' "$root/src/$source" || { echo "FAILED: $source does without base/supported_platform.h"; good=false; }
done
$good && echo "targets: 32-bit and big-endian ones are refused, by CMake and by the compiler"
