// The kernel's functions of each instruction set that is built, and the choice between them.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/targets.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "kernel/step.h"

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// kernel/step.cpp
void step_range(const StepInput& in, const BatchArrays& a, size_t begin, size_t end);
void step_range_rk4(const StepInput& in, const BatchArrays& a, size_t begin, size_t end); // LR_REFERENCE_TARGET alone
// kernel/ended.cpp
bool ended_range(const lr_batch_rules& rules, const BatchArrays& a, size_t begin, size_t end, uint32_t* cause);
// kernel/wind.cpp
void predict(const BatchArrays& a, size_t begin, size_t end, float h, FieldBlock& out);
void evaluate(const FieldInstant& instant, size_t count, FieldBlock& block);
void combine(float h, size_t count, const FieldBlock& block, FluidSample& out);
void settle(const BodyConstants& c, float h, const FieldBlock& block, const FluidSample& sample, const BatchArrays& a,
            size_t begin, size_t end, uint32_t* faults);
// kernel/surface.cpp
void near_surface(const SurfaceInstant& plane, float highest, const WaterBody& w, float dt, float gravity,
                  const BatchArrays& a, size_t begin, size_t end, uint32_t* near);
void ahead_of(const BatchArrays& a, size_t count, float h, SurfaceBlock& out);
void evaluate_surface(const SurfaceInstant& plane, size_t count, SurfaceBlock& b);
void step_wet(const StepInput& in, const WetSubstep& s, const BatchArrays& a, size_t count);
void settle_wet(const StepInput& in, const WetSubstep& s, const BatchArrays& a, size_t count);

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "hwy/targets.h"
#include "kernel/built_targets.h"

namespace lr {

const KernelTarget* built_targets(size_t& count) {
// clang-format off
#define LR_TARGET(simd, target)                                                                                        \
    {simd, HWY_##target, &N_##target::step_range, &LR_REFERENCE_NAMESPACE::step_range_rk4, &N_##target::ended_range, &N_##target::predict, &N_##target::evaluate,                \
     &N_##target::combine, &N_##target::settle,                                                                        \
     {&N_##target::near_surface, &N_##target::ahead_of, &N_##target::evaluate_surface, &N_##target::step_wet,          \
      &N_##target::settle_wet}},
    static constexpr KernelTarget targets[] = {
        LR_FOR_BUILT_TARGETS(LR_TARGET)
    };
    // clang-format on
#undef LR_TARGET
    count = sizeof(targets) / sizeof(targets[0]);
    return targets;
}

const KernelTarget* find_target(int32_t simd) {
    const int64_t supported = HWY_SUPPORTED_TARGETS; // needs Highway's library only where there is a choice
    size_t count = 0;
    const KernelTarget* const targets = built_targets(count);
    for (size_t i = 0; i < count; ++i) {
        // Plain C++ runs anywhere, whatever the processor reports.
        const bool runs = (targets[i].hwy & supported) != 0 || targets[i].simd == LR_SIMD_PLAIN;
        if (runs && (simd == LR_SIMD_AUTO || simd == targets[i].simd)) return &targets[i];
    }
    return nullptr;
}

} // namespace lr
#endif
