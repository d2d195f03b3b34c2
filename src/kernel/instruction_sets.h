// The instruction sets in this build, best first: LR_FOR_BUILT_TARGETS(X) is X(LR_SIMD_*, Highway's name) for each. Include hwy/highway.h first.
#pragma once

#include "hwy/detect_targets.h"
#include "langevin_rigid.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>

#if HWY_TARGETS & HWY_AVX3
#define LR_IF_AVX3(X) X(LR_SIMD_AVX512, AVX3)
#else
#define LR_IF_AVX3(X)
#endif
#if HWY_TARGETS & HWY_AVX2
#define LR_IF_AVX2(X) X(LR_SIMD_AVX2, AVX2)
#else
#define LR_IF_AVX2(X)
#endif
#if HWY_TARGETS & HWY_SSE4
#define LR_IF_SSE4(X) X(LR_SIMD_SSE4, SSE4)
#else
#define LR_IF_SSE4(X)
#endif
#if HWY_TARGETS & HWY_NEON
#define LR_IF_NEON(X) X(LR_SIMD_NEON, NEON)
#else
#define LR_IF_NEON(X)
#endif
#if HWY_TARGETS & HWY_WASM
#define LR_IF_WASM(X) X(LR_SIMD_WASM, WASM)
#else
#define LR_IF_WASM(X)
#endif
// Plain C++, for tests alone (langevin_rigid_plain): the compiler decides which of the two Highway offers.
#if HWY_TARGETS & HWY_EMU128
#define LR_IF_PLAIN(X) X(LR_SIMD_PLAIN, EMU128)
#elif HWY_TARGETS & HWY_SCALAR
#define LR_IF_PLAIN(X) X(LR_SIMD_PLAIN, SCALAR)
#else
#define LR_IF_PLAIN(X)
#endif

#define LR_FOR_BUILT_TARGETS(X)                                                                                        \
    LR_IF_AVX3(X)                                                                                                      \
    LR_IF_AVX2(X) LR_IF_SSE4(X) LR_IF_NEON(X) LR_IF_WASM(X) LR_IF_PLAIN(X)

namespace lr {

// The entry of an instruction set; the last entry runs anywhere.
template <class T, size_t N> const T& of_target(const T (&targets)[N], int32_t simd) {
    return *std::find_if(std::begin(targets), std::end(targets) - 1, [simd](const T& t) { return t.simd == simd; });
}
} // namespace lr
