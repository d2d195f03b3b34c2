// Steps bodies with AERODYNAMIC loads by the splitting scheme. Compiled once for each instruction set. One vector at a time, since two side by side
// need too many registers (docs/maintainers/performance.md).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/integrator/step_aerodynamic.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#ifndef LR_NO_PAIRS
#define LR_NO_PAIRS
#endif
#include "hwy/highway.h"
#include "kernel/integrator/step_bodies-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

void step_aerodynamic(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) {
    if (in.sheet.present)
        step_bodies<false, true, Integrator::splitting>(in, a, begin, end);
    else
        step_bodies<true, true, Integrator::splitting>(in, a, begin, end);
}
} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
