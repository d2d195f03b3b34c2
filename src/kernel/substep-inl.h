// One substep of one vector of bodies, whatever their loads and scheme.
#if defined(LR_KERNEL_SUBSTEP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_SUBSTEP_INL_H_
#undef LR_KERNEL_SUBSTEP_INL_H_
#else
#define LR_KERNEL_SUBSTEP_INL_H_
#endif

#include "kernel/aerodynamic_splitting-inl.h"
#include "kernel/batch_arrays.h"
#include "kernel/noise-inl.h"
#include "kernel/rk4-inl.h"
#include "kernel/splitting-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

HWY_INLINE Vec3 load3(const BatchArrays& a, size_t field, size_t at) {
    const DF d;
    return {hn::Load(d, a.field[field] + at), hn::Load(d, a.field[field + 1] + at),
            hn::Load(d, a.field[field + 2] + at)};
}
HWY_INLINE void store3(const BatchArrays& a, size_t field, size_t at, Vec3 v) {
    const DF d;
    hn::Store(v.x, d, a.field[field] + at);
    hn::Store(v.y, d, a.field[field + 1] + at);
    hn::Store(v.z, d, a.field[field + 2] + at);
}

// The uniform wind in the middle of a substep.
HWY_INLINE Vec3 wind_of_substep(const StepInput& in, uint32_t i) {
    const float part = (static_cast<float>(i) + 0.5f) / static_cast<float>(in.substeps);
    float wind[3];
    for (int k = 0; k < 3; ++k) wind[k] = in.wind_begin[k] + part * (in.wind[k] - in.wind_begin[k]);
    return broadcast(wind);
}

HWY_INLINE Vec3 without_dust(Vec3 v) {
    return {without_dust(v.x), without_dust(v.y), without_dust(v.z)};
}

// The product of a batch's constants is rounded once, before it is spread over the lanes.
HWY_INLINE VF laminar_product(const AerodynamicConstants& a) {
    return constant(a.wake_reynolds * a.viscosity);
}
HWY_INLINE VF laminar_product(const AerodynamicConstantsOf<VF>& a) {
    return hn::Mul(a.wake_reynolds, a.viscosity);
}

// A body in its own patch of moving air: quasi-steady motion through it, then the patch's next velocity, which the body
// meets with the world velocity it has.
template <bool kFull, Integrator kIntegrator, class C>
HWY_INLINE void aerodynamic_substep(const StepInput& in, const C& c, Held& held, VU key, uint32_t substep, Body& b) {
    b.t.v = sub(b.t.v, to_body(b.q, b.gust));
    const VF speed = hn::Sqrt(speed_squared(b.t.v));
    VF alpha, variance;
    if (HWY_LIKELY(in.clock == Clock::speed)) {
        alpha = hn::Mul(hn::Mul(constant(c.aerodynamics.rate_of_gusts), held.inverse_length), speed);
        const VF laminar = hn::Mul(laminar_product(c.aerodynamics), held.inverse_length);
        const VF turbulent = hn::Div(hn::Mul(speed, speed), hn::Add(speed, laminar));
        variance = hn::Mul(constant(c.aerodynamics.variance_of_gusts), hn::Mul(turbulent, turbulent));
    } else {
        VF beta_squared;
        sample_table(in.table, mul_add(constant(0.5f), constant(in.h), b.age), alpha, beta_squared);
        variance = hn::Div(hn::Mul(constant(c.aerodynamics.gust_gain), beta_squared),
                           hn::Add(hn::Add(alpha, alpha), constant(1e-20f)));
    }
    b.x = add(b.x, scale(constant(in.h), b.gust));
    VF gauss[6];
    if constexpr (kIntegrator == Integrator::splitting) {
        aerodynamic_splitting_substep<kFull>(in, c, held, b);
        b.x = add(b.x, scale(constant(in.h), held.wind));
        grow_older(b, constant(in.h));
    } else {
        rk4_substep<kFull, true>(in, c, held, hn::Zero(DF()), gauss, b);
    }
    three_gaussians(key, in.first_substep + substep, in.seed, gauss);
    b.t.v = add(b.t.v, to_body(b.q, b.gust));
    b.gust = without_dust(next_gust(b.gust, alpha, variance, in.h, gauss));
}

template <bool kFull, bool kAerodynamic, Integrator kIntegrator, class C>
HWY_INLINE void one_substep(const StepInput& in, const C& c, Held& held, VU key, uint32_t substep, VF beta_unit,
                            Body& b) {
    if constexpr (kAerodynamic) {
        aerodynamic_substep<kFull, kIntegrator>(in, c, held, key, substep, b);
        return;
    }
    VF gauss[6];
    if (HWY_LIKELY(in.loads != Loads::none))
        six_gaussians(key, in.first_substep + substep, in.seed, gauss);
    else
        for (VF& g : gauss) g = hn::Zero(DF());
    if constexpr (kIntegrator == Integrator::splitting)
        splitting_substep<kFull>(in, c, held, beta_unit, gauss, b);
    else
        rk4_substep<kFull, false>(in, c, held, beta_unit, gauss, b);
}

// Calls f<kFull, kAerodynamic>() for the batch's. Bodies without loads go the way of LANGEVIN loads.
template <class F> HWY_INLINE void for_variant(const StepInput& in, const F& f) {
    const bool aerodynamic = in.loads == Loads::aerodynamic;
    if (in.body.diagonal)
        aerodynamic ? f.template operator()<false, true>() : f.template operator()<false, false>();
    else
        aerodynamic ? f.template operator()<true, true>() : f.template operator()<true, false>();
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
