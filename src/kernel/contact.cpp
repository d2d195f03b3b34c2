// Bodies that touch colliders, compiled once for each instruction set. Method and formulas: docs/maintainers/contact.md.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/contact.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

// Vectors one by one: two side by side spill so much here that they gain nothing, in twice the code.
#ifndef LR_NO_PAIRS
#define LR_NO_PAIRS
#endif

#include "kernel/contact.h"

#include "hwy/highway.h"
#include "kernel/contact_ground-inl.h"
#include "kernel/contact_near-inl.h"
#include "kernel/contact_resolve-inl.h"
#include "kernel/crowd-inl.h"

#if HWY_ONCE
#include "kernel/built_targets.h"

namespace lr {

const ContactTarget& contact_target(int32_t simd) {
#define LR_TARGET(simd, target)                                                                                        \
    {simd, &N_##target::near_colliders, &N_##target::touch_ground, &N_##target::resolve_contacts},
    static constexpr ContactTarget targets[] = {LR_FOR_BUILT_TARGETS(LR_TARGET)};
#undef LR_TARGET
    for (const ContactTarget& t : targets)
        if (t.simd == simd) return t;
    return targets[sizeof targets / sizeof targets[0] - 1];
}

const CrowdTarget& crowd_target(int32_t simd) {
#define LR_TARGET(simd, target)                                                                                        \
    {simd,                                                                                                             \
     &N_##target::crowd_begin,                                                                                         \
     &N_##target::crowd_way,                                                                                           \
     &N_##target::crowd_sweep,                                                                                         \
     &N_##target::crowd_follow,                                                                                        \
     &N_##target::crowd_roll,                                                                                          \
     &N_##target::crowd_move,                                                                                          \
     &N_##target::crowd_touch,                                                                                         \
     &N_##target::crowd_velocity,                                                                                      \
     &N_##target::crowd_restrain,                                                                                      \
     &N_##target::crowd_finish},
    static constexpr CrowdTarget targets[] = {LR_FOR_BUILT_TARGETS(LR_TARGET)};
#undef LR_TARGET
    for (const CrowdTarget& t : targets)
        if (t.simd == simd) return t;
    return targets[sizeof targets / sizeof targets[0] - 1];
}

} // namespace lr
#endif
