// Blocks of bodies through the substeps of a step, compiled once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/step.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "kernel/step.h"

#include "hwy/cache_control.h"
#include "hwy/highway.h"
#include "kernel/built_targets.h"
#include "kernel/external-inl.h"
#include "kernel/faults-inl.h"
#include "kernel/substep-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// In a wind field. The body's velocity through the fluid obeys the equations of still fluid with the force
//   (m - rho V) g + rho V a_f - m a_b,   m = (1 + weight)/2 and rho V = (1 - weight)/2 in mass units,
// a_f the fluid's acceleration, a_b that of the wind that the body meets on its way (docs/reference/wind_and_water.md).
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
    held.uniform = false;
}

constexpr size_t line = 64 / sizeof(float);

// The lines of the next bodies are on their way while these are stepped: in worlds larger than the caches, from too many
// arrays for the processor to see it by itself. `at` may lie behind the last body: nothing is read.
template <bool kAerodynamic> HWY_INLINE void prefetch(const BatchArrays& a, size_t at, size_t count) {
    constexpr size_t fields = kAerodynamic ? field_count : size_t{field_gust_x};
    for (size_t i = 0; i < count; i += line) {
        for (size_t f = 0; f < fields; ++f) hwy::Prefetch(a.field[f] + at + i);
        hwy::Prefetch(a.key + at + i);
    }
}

template <bool kFull, bool kAerodynamic, Integrator kIntegrator>
HWY_NOINLINE void step_bodies(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) {
    const DF d;
    const DU du;
    const BodyConstants& c = in.body;
    const FluidSample* const fluid = a.fluid;
    const Vec3 gravity = broadcast(in.gravity);
    const Vec3 weight = scale(constant(c.weight), gravity);
    for (size_t at = begin; at < end; at += hn::Lanes(d)) {
        const size_t together = HWY_MAX(hn::Lanes(d), line);
        if (at % together == 0) prefetch<kAerodynamic>(a, at + together, together);
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
        held.uniform = true;
        // In a uniform wind the body moves through the fluid as if that were still: work with the relative velocity.
        if constexpr (kAerodynamic) b.gust = load3(a, field_gust_x, at);
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
            one_substep<kFull, kAerodynamic, kIntegrator>(in, c, held, key, i, beta_unit, b);
        }

        const Vec3 v = add(b.t.v, to_body(b.q, end_wind));
        const Vec3 w = scale(held.inverse_length, b.t.u);
        auto sane = hn::And(hn::And(sane_pose(b.x, b.q), sane_motion(v, w)), not_held(a, at));
        if constexpr (kAerodynamic) sane = hn::And(sane, sane_gust(b.gust));
        const bool all_sane = hn::AllTrue(d, sane);
        BodiesBefore before;
        if (HWY_UNLIKELY(!all_sane)) before.take(a, at, hn::Lanes(d));
        if constexpr (kAerodynamic) store3(a, field_gust_x, at, b.gust);
        store3(a, field_x, at, b.x);
        hn::Store(b.q.x, d, a.field[field_qx] + at);
        hn::Store(b.q.y, d, a.field[field_qy] + at);
        hn::Store(b.q.z, d, a.field[field_qz] + at);
        hn::Store(b.q.w, d, a.field[field_qw] + at);
        store3(a, field_vx, at, without_dust(v));
        store3(a, field_wx, at, without_dust(w));
        hn::Store(b.age, d, a.field[field_age] + at);
        hn::Store(b.age_rest, d, a.field[field_age_rest] + at);
        if (HWY_UNLIKELY(!all_sane))
            before.hold(a, at, hn::Lanes(d), in.h * static_cast<float>(in.substeps), kAerodynamic, in.faults);
    }
}

void step_range(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) {
    for_variant(in, [&]<bool kFull, bool kAerodynamic>()
                        HWY_ATTR { step_bodies<kFull, kAerodynamic, Integrator::splitting>(in, a, begin, end); });
}

// A reference, which need not be fast: compiled for one instruction set, used by all. The bits are the same.
#if HWY_TARGET == LR_REFERENCE_TARGET
void step_range_rk4(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) {
    for_variant(in, [&]<bool kFull, bool kAerodynamic>()
                        HWY_ATTR { step_bodies<kFull, kAerodynamic, Integrator::rk4>(in, a, begin, end); });
}
#endif

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
