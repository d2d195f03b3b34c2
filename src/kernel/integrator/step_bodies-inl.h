// Steps bodies through the substeps of a step, a vector at a time.
#if defined(LR_KERNEL_INTEGRATOR_STEP_BODIES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_INTEGRATOR_STEP_BODIES_INL_H_
#undef LR_KERNEL_INTEGRATOR_STEP_BODIES_INL_H_
#else
#define LR_KERNEL_INTEGRATOR_STEP_BODIES_INL_H_
#endif

#include "hwy/cache_control.h"
#include "kernel/integrator/equations_of_motion-inl.h"
#include "kernel/integrator/step.h"
#include "kernel/integrator/substep-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// In sample_wind.cpp: before and after a substep in a wind field, for the bodies from `first` on.
void enter_wind(const StepInput&, const WindAlong&, uint32_t substep, size_t first, size_t lanes, BodiesInWind& bodies);
void leave_wind(const StepInput&, const WindAlong&, size_t first, size_t lanes, BodiesInWind& bodies);
} // namespace lr::HWY_NAMESPACE
namespace lr::LR_KERNEL_NAMESPACE {

constexpr size_t line = 64 / sizeof(float);

// Prefetches the next bodies: a large world has too many arrays for the hardware prefetcher. `at` may be past the last body.
template <bool kAerodynamic> HWY_INLINE void prefetch(const BatchArrays& a, size_t at, size_t count) {
    constexpr size_t fields = kAerodynamic ? field_count : size_t{field_gust_x};
    for (size_t i = 0; i < count; i += line) {
        for (size_t f = 0; f < fields; ++f) hwy::Prefetch(a.field[f] + at + i);
        hwy::Prefetch(a.noise_seed + at + i);
    }
}

// Into a sheet's frame with its load centre, and back.
template <class C> HWY_INLINE void enter_frame(const C& c, Quaternion frame, Body& b) {
    b.q = product(b.q, frame);
    b.t.u = rows(c.aerodynamics.axes, b.t.u);
    b.t.v = rows(c.aerodynamics.axes, b.t.v) + arm_velocity(c, b.t.u);
}
template <class C> HWY_INLINE void leave_frame(const C& c, Quaternion frame, Body& b) {
    b.q = product(b.q, {-frame.x, -frame.y, -frame.z, frame.w});
    b.t = {columns(c.aerodynamics.axes, b.t.v - arm_velocity(c, b.t.u)), columns(c.aerodynamics.axes, b.t.u)};
}

// AERODYNAMIC loads without kFull: a sheet, in its own frame.
template <bool kFull, bool kAerodynamic, Integrator kIntegrator, bool kUsual = false>
HWY_NOINLINE void step_bodies(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) {
    constexpr bool kSheet = kAerodynamic && !kFull;
    const BodyConstantsOf<float>* constants = &in.body;
    if constexpr (kSheet) constants = &in.sheet;
    const BodyConstantsOf<float>& c = *constants;
    const WindAlong* const wind = a.wind;
    BodiesInWind moving;
    const Vec3 gravity = broadcast(in.gravity);
    const Vec3 weight = constant(c.weight) * gravity;
    Quaternion frame;
    if constexpr (kSheet)
        frame = {constant(in.sheet.turn[0]), constant(in.sheet.turn[1]), constant(in.sheet.turn[2]),
                 constant(in.sheet.turn[3])};
    for (size_t at = begin; at < end; at += hn::Lanes(DF())) {
        const size_t together = HWY_MAX(hn::Lanes(DF()), line);
        if (at % together == 0) prefetch<kAerodynamic>(a, at + together, together);
        Body b = load_body<kAerodynamic>(a, at);
        const VF length = load1(a, field_scale, at) * constant(c.length);
        Held held;
        held.inverse_length = constant(1.0f) / length;
        held.alpha = held.beta = held.shed = hn::Zero(DF());
        held.wind = broadcast(in.wind);
        held.gravity = gravity;
        held.weight = weight;
        held.fluid_spin = zero3();
        held.sheared = false;
        held.uniform = true;
        // In uniform wind the velocity relative to the wind is stepped, as in fluid at rest.
        b.t = {load3(a, field_vx, at), length * load3(a, field_wx, at)};
        if (!wind) b.t.v -= to_body(b.q, broadcast(in.wind_begin));
        External external;
        if (in.external.any) {
            external = take_external(in.external, c, load1(a, field_scale, at), at);
            held.external = &external;
        }
        const VU noise_seed = load1(a.noise_seed, at);
        if constexpr (kAerodynamic) vary(in, noise_seed, held);
        store1(moving.length, 0, length);
        const VF beta_unit = constant(c.speed_beta) * held.inverse_length;

        const uint32_t motions = motions_of<kAerodynamic, kIntegrator>(in);
        const size_t first = wind && wind->known ? at - begin : 0;
        for (uint32_t i = 0; i < in.substeps; ++i) {
            if (in.wind_changes) held.wind = wind_of_substep(in, i);
            if (wind) {
                // Rounded as if stored and loaded, so that results do not depend on how a step is divided into calls.
                if (i != 0) b.t.u = length * without_dust(held.inverse_length * b.t.u);
                store3(moving.x, 0, b.x);
                store4(moving.q, 0, b.q);
                store3(moving.v, 0, b.t.v);
                enter_wind(in, *wind, i, first, hn::Lanes(DF()), moving);
                held.wind = load3(moving.wind, 0);
                held.weight = load3(moving.weight, 0);
                if constexpr (kFull || kSheet) held.gravity = load3(moving.gravity, 0);
                held.uniform = wind->everywhere;
                held.sheared = !held.uniform;
                if (held.sheared) held.fluid_spin = load3(moving.spin, 0);
                b.t.v = load3(moving.v, 0);
            }
            if constexpr (kSheet) enter_frame(c, frame, b);
            for (uint32_t motion = 0; motion < motions; ++motion)
                one_motion<kFull, kAerodynamic, kIntegrator, kUsual>(in, c, held, noise_seed, i, motion, beta_unit, b);
            if constexpr (kSheet)
                leave_frame(c, frame, b); // in each substep: results must not depend on how a step is divided
            if (wind) {
                store4(moving.q, 0, b.q);
                store3(moving.v, 0, b.t.v);
                store3(moving.u, 0, b.t.u);
                leave_wind(in, *wind, first, hn::Lanes(DF()), moving);
                b.t = {load3(moving.v, 0), load3(moving.u, 0)};
            }
        }

        if (!wind) b.t.v += to_body(b.q, broadcast(in.wind));
        store_body<kAerodynamic>(a, at, b, b.t.v, held.inverse_length * b.t.u, in.h * static_cast<float>(in.substeps),
                                 in.faults);
    }
}
} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
