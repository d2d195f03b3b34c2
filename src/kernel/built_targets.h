// The instruction sets that are built, best first: LR_FOR_BUILT_TARGETS(X) is X(LR_SIMD_*, Highway's name) for each. To be included
// after hwy/highway.h. LR_REFERENCE_TARGET is the one that also has what is compiled once: on x86 SSE4, which all of its processors run.
#pragma once

#include "hwy/detect_targets.h"
#include "langevin_rigid.h"

#if HWY_TARGETS & HWY_AVX3
#define LR_IF_AVX3(X) X(LR_SIMD_AVX512, AVX3)
#define LR_REFERENCE_NAME AVX3
#else
#define LR_IF_AVX3(X)
#endif
#if HWY_TARGETS & HWY_AVX2
#define LR_IF_AVX2(X) X(LR_SIMD_AVX2, AVX2)
#undef LR_REFERENCE_NAME
#define LR_REFERENCE_NAME AVX2
#else
#define LR_IF_AVX2(X)
#endif
#if HWY_TARGETS & HWY_SSE4
#define LR_IF_SSE4(X) X(LR_SIMD_SSE4, SSE4)
#undef LR_REFERENCE_NAME
#define LR_REFERENCE_NAME SSE4
#else
#define LR_IF_SSE4(X)
#endif
#if HWY_TARGETS & HWY_NEON
#define LR_IF_NEON(X) X(LR_SIMD_NEON, NEON)
#define LR_REFERENCE_NAME NEON
#else
#define LR_IF_NEON(X)
#endif
#if HWY_TARGETS & HWY_WASM
#define LR_IF_WASM(X) X(LR_SIMD_WASM, WASM)
#define LR_REFERENCE_NAME WASM
#else
#define LR_IF_WASM(X)
#endif
// Plain C++, in builds for tests (LR_PLAIN_KERNEL) alone: Highway has one or the other by compiler.
#if HWY_TARGETS & (HWY_EMU128 | HWY_SCALAR)
#undef LR_REFERENCE_NAME
#endif
#if HWY_TARGETS & HWY_EMU128
#define LR_IF_PLAIN(X) X(LR_SIMD_PLAIN, EMU128)
#define LR_REFERENCE_NAME EMU128
#elif HWY_TARGETS & HWY_SCALAR
#define LR_IF_PLAIN(X) X(LR_SIMD_PLAIN, SCALAR)
#define LR_REFERENCE_NAME SCALAR
#else
#define LR_IF_PLAIN(X)
#endif

#define LR_FOR_BUILT_TARGETS(X)                                                                                        \
    LR_IF_AVX3(X)                                                                                                      \
    LR_IF_AVX2(X) LR_IF_SSE4(X) LR_IF_NEON(X) LR_IF_WASM(X) LR_IF_PLAIN(X)

#define LR_JOIN(a, b) a##b
#define LR_JOINED(a, b) LR_JOIN(a, b)
#define LR_REFERENCE_TARGET LR_JOINED(HWY_, LR_REFERENCE_NAME)
#define LR_REFERENCE_NAMESPACE LR_JOINED(N_, LR_REFERENCE_NAME)
