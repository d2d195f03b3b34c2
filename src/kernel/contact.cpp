// Bodies that touch colliders, compiled once for each instruction set. Method and formulas: docs/contact.md.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/contact.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "kernel/contact.h"

#include "hwy/highway.h"
#include "kernel/contact_ground-inl.h"
#include "kernel/contact_near-inl.h"
#include "kernel/contact_resolve-inl.h"
#include "kernel/crowd-inl.h"

#if HWY_ONCE
#include "langevin_rigid.h"

namespace lr {

const ContactTarget& contact_target(int32_t simd) {
#define LR_TARGET(simd, target)                                                                                        \
    { simd, &N_##target::near_colliders, &N_##target::touch_ground, &N_##target::resolve_contacts }
    static constexpr ContactTarget targets[] = {
#if HWY_TARGETS & HWY_AVX3
        LR_TARGET(LR_SIMD_AVX512, AVX3),
#endif
#if HWY_TARGETS & HWY_AVX2
        LR_TARGET(LR_SIMD_AVX2, AVX2),
#endif
#if HWY_TARGETS & HWY_SSE4
        LR_TARGET(LR_SIMD_SSE4, SSE4),
#endif
#if HWY_TARGETS & HWY_SSSE3
        LR_TARGET(LR_SIMD_SSSE3, SSSE3),
#endif
#if HWY_TARGETS & HWY_NEON
        LR_TARGET(LR_SIMD_NEON, NEON),
#endif
#if HWY_TARGETS & HWY_WASM
        LR_TARGET(LR_SIMD_WASM, WASM),
#endif
#if HWY_TARGETS & HWY_EMU128
        LR_TARGET(LR_SIMD_EMULATED, EMU128),
#endif
#if HWY_TARGETS & HWY_SCALAR
        LR_TARGET(LR_SIMD_EMULATED, SCALAR),
#endif
    };
#undef LR_TARGET
    for (const ContactTarget& t : targets)
        if (t.simd == simd) return t;
    return targets[sizeof targets / sizeof targets[0] - 1];
}

const CrowdTarget& crowd_target(int32_t simd) {
#define LR_TARGET(simd, target)                                                                                        \
    {                                                                                                                  \
        simd, &N_##target::crowd_begin, &N_##target::crowd_way, &N_##target::crowd_sweep, &N_##target::crowd_follow, &N_##target::crowd_roll,     \
            &N_##target::crowd_move, &N_##target::crowd_touch, &N_##target::crowd_velocity, &N_##target::crowd_finish  \
    }
    static constexpr CrowdTarget targets[] = {
#if HWY_TARGETS & HWY_AVX3
        LR_TARGET(LR_SIMD_AVX512, AVX3),
#endif
#if HWY_TARGETS & HWY_AVX2
        LR_TARGET(LR_SIMD_AVX2, AVX2),
#endif
#if HWY_TARGETS & HWY_SSE4
        LR_TARGET(LR_SIMD_SSE4, SSE4),
#endif
#if HWY_TARGETS & HWY_SSSE3
        LR_TARGET(LR_SIMD_SSSE3, SSSE3),
#endif
#if HWY_TARGETS & HWY_NEON
        LR_TARGET(LR_SIMD_NEON, NEON),
#endif
#if HWY_TARGETS & HWY_WASM
        LR_TARGET(LR_SIMD_WASM, WASM),
#endif
#if HWY_TARGETS & HWY_EMU128
        LR_TARGET(LR_SIMD_EMULATED, EMU128),
#endif
#if HWY_TARGETS & HWY_SCALAR
        LR_TARGET(LR_SIMD_EMULATED, SCALAR),
#endif
    };
#undef LR_TARGET
    for (const CrowdTarget& t : targets)
        if (t.simd == simd) return t;
    return targets[sizeof targets / sizeof targets[0] - 1];
}

} // namespace lr
#endif
