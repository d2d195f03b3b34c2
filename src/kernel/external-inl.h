// Forces from outside, from SI units to those of the kernel (constants.h).
#if defined(LR_KERNEL_EXTERNAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_EXTERNAL_INL_H_
#undef LR_KERNEL_EXTERNAL_INL_H_
#else
#define LR_KERNEL_EXTERNAL_INL_H_
#endif

#include "kernel/batch_arrays.h"
#include "kernel/motion-inl.h"
#include "kernel/step.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// What acts on one vector of bodies over a step; those of bodies are taken, and zeros left for the next step.
template <class C>
static HWY_NOINLINE External take_external(const ExternalInput& in, const C& c, VF body_scale, size_t at) {
    const DF d;
    VF sum[force_components];
    for (size_t i = 0; i < force_components; ++i) {
        sum[i] = constant(in.batch[i]);
        if ((in.used >> i / 3 & 1u) == 0) continue;
        float* const own = in.bodies + i * in.stride + at;
        sum[i] = hn::Add(sum[i], hn::Load(d, own));
        if (in.clear) hn::Store(hn::Zero(d), d, own);
    }
    const VF length = hn::Mul(body_scale, constant(c.length));
    const VF cube = hn::Mul(hn::Mul(body_scale, body_scale), body_scale);
    const VF per_mass = hn::Div(constant(1.0f), hn::Mul(cube, constant(c.unit_mass)));
    const VF per_moment = hn::Div(per_mass, length);
    const auto vector = [&](size_t frame, size_t kind, VF unit) LR_LAMBDA {
        const VF* const v = sum + force_component(frame, kind);
        return Vec3{hn::Mul(v[0], unit), hn::Mul(v[1], unit), hn::Mul(v[2], unit)};
    };
    External out;
    for (size_t frame = 0; frame < 2; ++frame) {
        out.force[frame] = {vector(frame, force_newton, per_mass), vector(frame, force_torque, per_moment)};
        out.rate[frame] = {vector(frame, force_acceleration, constant(1.0f)), vector(frame, force_spin, length)};
    }
    return out;
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
