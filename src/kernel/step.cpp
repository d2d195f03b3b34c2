// Blocks of bodies through the substeps of a step, compiled once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/step.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "kernel/step.h"

#include "hwy/highway.h"
#include "kernel/aerodynamic_splitting-inl.h"
#include "kernel/ended-inl.h"
#include "kernel/external-inl.h"
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

// Magnitudes under 1e-15 become zero: their squares would be denormal, which is slow, and nothing can be seen of them.
HWY_INLINE VF without_dust(VF v) {
    return hn::IfThenElseZero(hn::Ge(hn::Abs(v), constant(1e-15f)), v);
}
HWY_INLINE Vec3 without_dust(Vec3 v) {
    return {without_dust(v.x), without_dust(v.y), without_dust(v.z)};
}

// A body in its own patch of moving air: quasi-steady motion through it, then the patch's next velocity, which the body
// meets with the world velocity it has.
template <bool kFull, Loads kLoads, Integrator kIntegrator>
HWY_INLINE void aerodynamic_substep(const StepInput& in, const BodyConstants& c, Held& held, Vec3 weight, Vec3 gravity,
                                    VU key, uint32_t substep, Body& b) {
    b.t.v = sub(b.t.v, to_body(b.q, b.gust));
    const VF speed = hn::Sqrt(speed_squared(b.t.v));
    VF alpha, variance;
    if constexpr (kLoads == Loads::aerodynamic_speed) {
        alpha = hn::Mul(hn::Mul(constant(c.aerodynamics.rate_of_gusts), held.inverse_length), speed);
        const VF laminar =
            hn::Mul(constant(c.aerodynamics.wake_reynolds * c.aerodynamics.viscosity), held.inverse_length);
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
        aerodynamic_splitting_substep<kFull>(in, c, held, weight, gravity, b);
        b.x = add(b.x, scale(constant(in.h), broadcast(in.wind)));
        grow_older(b, constant(in.h));
    } else {
        rk4_substep<kFull, kLoads>(in, c, held, weight, gravity, hn::Zero(DF()), gauss, b);
    }
    three_gaussians(key, in.first_substep + substep, in.seed, gauss);
    b.t.v = add(b.t.v, to_body(b.q, b.gust));
    b.gust = without_dust(next_gust(b.gust, alpha, variance, in.h, gauss));
}

template <bool kFull, Loads kLoads, Integrator kIntegrator>
HWY_NOINLINE void step_bodies(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) {
    const DF d;
    const DU du;
    const BodyConstants& c = in.body;
    const Vec3 gravity = broadcast(in.gravity);
    const Vec3 weight = scale(constant(c.weight), gravity);
    for (size_t at = begin; at < end; at += hn::Lanes(d)) {
        Body b;
        b.x = load3(a, field_x, at);
        b.q = {hn::Load(d, a.field[field_qx] + at), hn::Load(d, a.field[field_qy] + at),
               hn::Load(d, a.field[field_qz] + at), hn::Load(d, a.field[field_qw] + at)};
        b.age = hn::Load(d, a.field[field_age] + at);
        b.age_rest = hn::Load(d, a.field[field_age_rest] + at);
        const VF length = hn::Mul(hn::Load(d, a.field[field_scale] + at), constant(c.length));
        Held held;
        held.inverse_length = hn::Div(constant(1.0f), length);
        held.alpha = held.beta = hn::Zero(d);
        // In a uniform wind the body moves through the fluid as if that were still: work with the relative velocity.
        if constexpr (is_aerodynamic(kLoads)) b.gust = load3(a, field_gust_x, at);
        b.t.v = sub(load3(a, field_vx, at), to_body(b.q, broadcast(in.wind)));
        b.t.u = scale(length, load3(a, field_wx, at));
        External external;
        if (in.external.any) {
            external = take_external(in.external, c, hn::Load(d, a.field[field_scale] + at), at);
            held.external = &external;
        }
        const VU key = hn::Load(du, a.key + at);
        const VF beta_unit = hn::Mul(constant(c.speed_beta), held.inverse_length);

        for (uint32_t i = 0; i < in.substeps; ++i) {
            if constexpr (is_aerodynamic(kLoads)) {
                aerodynamic_substep<kFull, kLoads, kIntegrator>(in, c, held, weight, gravity, key, i, b);
                continue;
            }
            VF gauss[6];
            if constexpr (kLoads != Loads::none) six_gaussians(key, in.first_substep + i, in.seed, gauss);
            if constexpr (kIntegrator == Integrator::splitting)
                splitting_substep<kFull, kLoads>(in, c, held, weight, gravity, beta_unit, gauss, b);
            else
                rk4_substep<kFull, kLoads>(in, c, held, weight, gravity, beta_unit, gauss, b);
        }

        if constexpr (is_aerodynamic(kLoads)) store3(a, field_gust_x, at, b.gust);
        const Vec3 v = add(b.t.v, to_body(b.q, broadcast(in.wind)));
        const Vec3 w = scale(held.inverse_length, b.t.u);
        store3(a, field_x, at, b.x);
        hn::Store(b.q.x, d, a.field[field_qx] + at);
        hn::Store(b.q.y, d, a.field[field_qy] + at);
        hn::Store(b.q.z, d, a.field[field_qz] + at);
        hn::Store(b.q.w, d, a.field[field_qw] + at);
        store3(a, field_vx, at, without_dust(v));
        store3(a, field_wx, at, without_dust(w));
        hn::Store(b.age, d, a.field[field_age] + at);
        hn::Store(b.age_rest, d, a.field[field_age_rest] + at);
    }
}

template <bool kFull, Loads kLoads>
void choose_integrator(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) {
    if (in.integrator == Integrator::splitting)
        step_bodies<kFull, kLoads, Integrator::splitting>(in, a, begin, end);
    else
        step_bodies<kFull, kLoads, Integrator::rk4>(in, a, begin, end);
}

template <bool kFull> void choose_loads(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) {
    switch (in.loads) {
    case Loads::none:
        return choose_integrator<kFull, Loads::none>(in, a, begin, end);
    case Loads::langevin_speed:
        return choose_integrator<kFull, Loads::langevin_speed>(in, a, begin, end);
    case Loads::langevin_age:
        return choose_integrator<kFull, Loads::langevin_age>(in, a, begin, end);
    case Loads::aerodynamic_speed:
        return choose_integrator<kFull, Loads::aerodynamic_speed>(in, a, begin, end);
    case Loads::aerodynamic_age:
        return choose_integrator<kFull, Loads::aerodynamic_age>(in, a, begin, end);
    }
}

void step_range(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) {
    if (in.body.diagonal)
        choose_loads<false>(in, a, begin, end);
    else
        choose_loads<true>(in, a, begin, end);
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "hwy/targets.h"
#include "langevin_rigid.h"

namespace lr {

const KernelTarget* built_targets(size_t& count) {
    static constexpr KernelTarget targets[] = {
#if HWY_TARGETS & HWY_AVX3
        {LR_SIMD_AVX512, HWY_AVX3, &N_AVX3::step_range, &N_AVX3::ended_range},
#endif
#if HWY_TARGETS & HWY_AVX2
        {LR_SIMD_AVX2, HWY_AVX2, &N_AVX2::step_range, &N_AVX2::ended_range},
#endif
#if HWY_TARGETS & HWY_SSE4
        {LR_SIMD_SSE4, HWY_SSE4, &N_SSE4::step_range, &N_SSE4::ended_range},
#endif
#if HWY_TARGETS & HWY_SSSE3
        {LR_SIMD_SSSE3, HWY_SSSE3, &N_SSSE3::step_range, &N_SSSE3::ended_range},
#endif
#if HWY_TARGETS & HWY_NEON
        {LR_SIMD_NEON, HWY_NEON, &N_NEON::step_range, &N_NEON::ended_range},
#endif
#if HWY_TARGETS & HWY_WASM
        {LR_SIMD_WASM, HWY_WASM, &N_WASM::step_range, &N_WASM::ended_range},
#endif
#if HWY_TARGETS & HWY_EMU128
        {LR_SIMD_EMULATED, HWY_EMU128, &N_EMU128::step_range, &N_EMU128::ended_range},
#endif
#if HWY_TARGETS & HWY_SCALAR
        {LR_SIMD_EMULATED, HWY_SCALAR, &N_SCALAR::step_range, &N_SCALAR::ended_range},
#endif
    };
    count = sizeof(targets) / sizeof(targets[0]);
    return targets;
}

const KernelTarget* find_target(int32_t simd) {
    const int64_t supported = hwy::SupportedTargets();
    size_t count = 0;
    const KernelTarget* const targets = built_targets(count);
    for (size_t i = 0; i < count; ++i) {
        // The emulated target is plain C++ and runs anywhere, whatever the processor reports.
        const bool runs = (targets[i].hwy & supported) != 0 || targets[i].simd == LR_SIMD_EMULATED;
        if (runs && (simd == LR_SIMD_AUTO || simd == targets[i].simd)) return &targets[i];
    }
    return nullptr;
}

} // namespace lr
#endif
