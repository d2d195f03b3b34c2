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

// kernel/wind.cpp
void predict(const BatchArrays& a, size_t begin, size_t end, float h, FieldBlock& out);
void evaluate(const FieldInstant& instant, size_t count, FieldBlock& block);
void combine(float h, size_t count, const FieldBlock& block, FluidSample& out);
void settle(const BodyConstants& c, float h, const FieldBlock& block, const FluidSample& sample, const BatchArrays& a,
            size_t begin, size_t end);

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

// In a wind field. The body's velocity through the fluid obeys the equations of still fluid with the force
//   (m - rho V) g + rho V a_f - m a_b,   m = (1 + weight)/2 and rho V = (1 - weight)/2 in mass units,
// a_f the fluid's acceleration, a_b that of the wind that the body meets on its way (docs/wind.md).
HWY_INLINE void hold_field(const FluidSample& f, size_t at, float weight, VF length, Vec3 gravity, Held& held,
                           Vec3& begin_wind, Vec3& end_wind) {
    const DF d;
    const auto load = [&](const float(&from)[3][field_block]) HWY_ATTR {
        return Vec3{hn::Load(d, from[0] + at), hn::Load(d, from[1] + at), hn::Load(d, from[2] + at)};
    };
    held.wind = load(f.wind);
    const Vec3 half_change = load(f.half_change), mean = load(f.mean), difference = load(f.difference);
    begin_wind = sub(held.wind, half_change);
    end_wind = add(held.wind, half_change);
    held.weight = add(scale(constant(weight), sub(gravity, mean)), difference);
    held.gravity = sub(gravity, add(mean, difference));
    held.fluid_spin = scale(length, load(f.spin));
    held.sheared = true;
}
HWY_INLINE Vec3 without_dust(Vec3 v) {
    return {without_dust(v.x), without_dust(v.y), without_dust(v.z)};
}

// A body in its own patch of moving air: quasi-steady motion through it, then the patch's next velocity, which the body
// meets with the world velocity it has.
template <bool kFull, Loads kLoads, Integrator kIntegrator>
HWY_INLINE void aerodynamic_substep(const StepInput& in, const BodyConstants& c, Held& held, VU key, uint32_t substep,
                                    Body& b) {
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
        aerodynamic_splitting_substep<kFull>(in, c, held, b);
        b.x = add(b.x, scale(constant(in.h), held.wind));
        grow_older(b, constant(in.h));
    } else {
        rk4_substep<kFull, kLoads>(in, c, held, hn::Zero(DF()), gauss, b);
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
    const FluidSample* const fluid = a.fluid;
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
        held.wind = broadcast(in.wind);
        held.gravity = gravity;
        held.weight = weight;
        held.fluid_spin = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
        held.sheared = false;
        // In a uniform wind the body moves through the fluid as if that were still: work with the relative velocity.
        if constexpr (is_aerodynamic(kLoads)) b.gust = load3(a, field_gust_x, at);
        Vec3 begin_wind = broadcast(in.wind_begin), end_wind = held.wind;
        if (fluid) hold_field(*fluid, at - begin, c.weight, length, gravity, held, begin_wind, end_wind);
        b.t.v = sub(load3(a, field_vx, at), to_body(b.q, begin_wind));
        b.t.u = scale(length, load3(a, field_wx, at));
        External external;
        if (in.external.any) {
            external = take_external(in.external, c, hn::Load(d, a.field[field_scale] + at), at);
            held.external = &external;
        }
        const VU key = hn::Load(du, a.key + at);
        const VF beta_unit = hn::Mul(constant(c.speed_beta), held.inverse_length);

        for (uint32_t i = 0; i < in.substeps; ++i) {
            if (in.wind_changes && !fluid) held.wind = wind_of_substep(in, i);
            if constexpr (is_aerodynamic(kLoads)) {
                aerodynamic_substep<kFull, kLoads, kIntegrator>(in, c, held, key, i, b);
                continue;
            }
            VF gauss[6];
            if constexpr (kLoads != Loads::none) six_gaussians(key, in.first_substep + i, in.seed, gauss);
            if constexpr (kIntegrator == Integrator::splitting)
                splitting_substep<kFull, kLoads>(in, c, held, beta_unit, gauss, b);
            else
                rk4_substep<kFull, kLoads>(in, c, held, beta_unit, gauss, b);
        }

        if constexpr (is_aerodynamic(kLoads)) store3(a, field_gust_x, at, b.gust);
        const Vec3 v = add(b.t.v, to_body(b.q, end_wind));
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
// clang-format off
#define LR_TARGET(simd, target)                                                                                        \
    {simd, HWY_##target, &N_##target::step_range, &N_##target::ended_range, &N_##target::predict, &N_##target::evaluate,                \
     &N_##target::combine, &N_##target::settle}
    // clang-format on
    static constexpr KernelTarget targets[] = {
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
