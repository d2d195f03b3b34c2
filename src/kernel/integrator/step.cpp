// Steps blocks of bodies through the substeps of a step, and finds bodies that end, compiled once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/integrator/step.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "kernel/integrator/step.h"

#include "hwy/cache_control.h"
#include "hwy/highway.h"
#include "kernel/integrator/equations_of_motion-inl.h"
#include "kernel/integrator/substep-inl.h"
#include "langevin_rigid.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// In a wind field, the body's velocity through the fluid obeys the equations of still fluid with the force
//   (m - rho V) g + rho V a_f - m a_b,   m = (1 + weight)/2 and rho V = (1 - weight)/2 in mass units,
// a_f the fluid's acceleration, a_b that of the wind along the body's path (docs/reference/wind_and_water.md).
HWY_INLINE void hold_field(const FluidSample& f, size_t at, float weight, VF length, Vec3 gravity, Held& held,
                           Vec3& begin_wind, Vec3& end_wind) {
    held.wind = load3(f.wind, at);
    const Vec3 half_change = load3(f.half_change, at), mean = load3(f.mean, at), difference = load3(f.difference, at);
    begin_wind = held.wind - half_change;
    end_wind = held.wind + half_change;
    held.weight = constant(weight) * (gravity - mean) + difference;
    held.gravity = gravity - (mean + difference);
    held.fluid_spin = length * load3(f.spin, at);
    held.sheared = true;
    held.uniform = false;
}

constexpr size_t line = 64 / sizeof(float);

// Prefetches the next bodies: large worlds have too many arrays for the hardware prefetcher. `at` can be past the last body.
template <bool kAerodynamic> HWY_INLINE void prefetch(const BatchArrays& a, size_t at, size_t count) {
    constexpr size_t fields = kAerodynamic ? field_count : size_t{field_gust_x};
    for (size_t i = 0; i < count; i += line) {
        for (size_t f = 0; f < fields; ++f) hwy::Prefetch(a.field[f] + at + i);
        hwy::Prefetch(a.noise_seed + at + i);
    }
}

template <bool kFull, bool kAerodynamic, Integrator kIntegrator, bool kUsual = false>
HWY_NOINLINE void step_bodies(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) {
    const BodyConstants& c = in.body;
    const FluidSample* const fluid = a.fluid;
    const Vec3 gravity = broadcast(in.gravity);
    const Vec3 weight = constant(c.weight) * gravity;
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
        // In a uniform wind, step the velocity relative to the wind, as if the fluid were still.
        Vec3 begin_wind = broadcast(in.wind_begin), end_wind = held.wind;
        if (fluid) hold_field(*fluid, at - begin, c.weight, length, gravity, held, begin_wind, end_wind);
        b.t.v = load3(a, field_vx, at) - to_body(b.q, begin_wind);
        b.t.u = length * load3(a, field_wx, at);
        External external;
        if (in.external.any) {
            external = take_external(in.external, c, load1(a, field_scale, at), at);
            held.external = &external;
        }
        const VU noise_seed = load1(a.noise_seed, at);
        if constexpr (kAerodynamic) vary(in, noise_seed, held);
        const VF beta_unit = constant(c.speed_beta) * held.inverse_length;

        const uint32_t motions = motions_of<kAerodynamic, kIntegrator>(in);
        for (uint32_t i = 0, motion = 0; i < in.substeps;) { // one loop: a second inside costs a third
            if (in.wind_changes && !fluid) held.wind = wind_of_substep(in, i);
            one_motion<kFull, kAerodynamic, kIntegrator, kUsual>(in, c, held, noise_seed, i, motion, beta_unit, b);
            if (++motion == motions) motion = 0, ++i;
        }

        store_body<kAerodynamic>(a, at, b, b.t.v + to_body(b.q, end_wind), held.inverse_length * b.t.u,
                                 in.h * static_cast<float>(in.substeps), in.faults);
    }
}

void step_range(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) {
    for_variant(in, [&]<bool kFull, bool kAerodynamic>() HWY_ATTR {
        constexpr Integrator splitting = Integrator::splitting;
        if constexpr (!kFull && !kAerodynamic)
            if (in.loads == Loads::langevin && in.clock == Clock::speed)
                return step_bodies<false, false, splitting, true>(in, a, begin, end);
        step_bodies<kFull, kAerodynamic, splitting>(in, a, begin, end);
    });
}

HWY_INLINE hn::Mask<DF> inside(const lr_kill_volume& volume, Vec3 x) {
    const Vec3 r = x - broadcast(volume.center);
    const auto within = [&](VF at, size_t axis) LR_LAMBDA { return hn::Abs(at) <= constant(volume.size[axis]); };
    switch (volume.shape) {
    case LR_VOLUME_PLANE:
        return dot(broadcast(volume.size), r) < hn::Zero(DF());
    case LR_VOLUME_BOX:
        return hn::And(within(r.x, 0), hn::And(within(r.y, 1), within(r.z, 2)));
    default:
        return dot(r, r) <= constant(volume.size[0] * volume.size[0]);
    }
}

// Marks bodies that end by a batch's rules.
bool ended_range(const lr_batch_rules& rules, const BatchArrays& a, size_t begin, size_t end, uint32_t* cause) {
    const DU du;
    const VF zero = hn::Zero(DF());
    VU any = hn::Zero(DU());
    for (size_t at = begin; at < end; at += hn::Lanes(DF())) {
        const Vec3 x = load3(a, field_x, at);
        // The first cause counts: they are written in reverse order.
        VU out = hn::Zero(DU());
        const auto put = [&](hn::Mask<DF> where, uint32_t code)
                             LR_LAMBDA { out = hn::IfThenElse(hn::RebindMask(du, where), hn::Set(du, code), out); };
        for (uint32_t k = rules.volume_count; k-- > 0;) {
            const auto in = inside(rules.volumes[k], x);
            put(rules.volumes[k].side == LR_KILL_OUTSIDE ? hn::Not(in) : in, cause_volume + k);
        }
        if (rules.max_age > 0.0f) put(load1(a, field_age, at) >= constant(rules.max_age), cause_age);
        // 0 for finite x only.
        const Vec3 nothing = x - x;
        const VF sum = nothing.x + (nothing.y + nothing.z);
        put(hn::Not(hn::Eq(sum, zero)), cause_not_finite);
        store1(cause, at, out);
        any = hn::Or(any, out);
    }
    return !hn::AllTrue(du, hn::Eq(any, hn::Zero(DU())));
}

// Defined in sample_wind.cpp, water_loads.cpp, collider_contact.cpp and gjk_pairs.cpp.
PredictFunction predict;
EvaluateFunction evaluate;
CombineFunction combine;
SettleFunction settle;
NearFunction near_surface;
AheadFunction ahead_of;
SurfaceFunction evaluate_surface;
WetFunction step_wet, settle_wet;
extern const ContactTarget contact_functions;
extern const BodyContactTarget body_contact_functions;
PairSearch search_pairs;

constexpr KernelTarget functions(int32_t simd) {
    return {simd,
            HWY_TARGET,
            &step_range,
            &ended_range,
            &predict,
            &evaluate,
            &combine,
            &settle,
            {&near_surface, &ahead_of, &evaluate_surface, &step_wet, &settle_wet},
            &contact_functions,
            &body_contact_functions,
            &search_pairs};
}

#if HWY_ONCE
void step_range_rk4(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) {
    for_variant(in, [&]<bool kFull, bool kAerodynamic>()
                        HWY_ATTR { step_bodies<kFull, kAerodynamic, Integrator::rk4>(in, a, begin, end); });
}
#endif
} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "hwy/targets.h"
#include "kernel/instruction_sets.h"

namespace lr {

void step_rk4(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) {
    HWY_STATIC_DISPATCH(step_range_rk4)(in, a, begin, end);
}

static_assert(most_kill_volumes == LR_MAX_KILL_VOLUMES);

const KernelTarget* built_targets(size_t& count) {
#define LR_TARGET(simd, target) N_##target::functions(simd),
    static constexpr KernelTarget targets[] = {LR_FOR_BUILT_TARGETS(LR_TARGET)};
#undef LR_TARGET
    count = sizeof(targets) / sizeof(targets[0]);
    return targets;
}

const KernelTarget* find_target(int32_t simd) {
    const int64_t supported = HWY_SUPPORTED_TARGETS; // links Highway's library only if there is a choice
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
