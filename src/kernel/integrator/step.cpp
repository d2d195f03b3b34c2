// Steps blocks of bodies, finds bodies that end, and the loads on one body. Compiled once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/integrator/step.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "kernel/integrator/step.h"

#include "hwy/highway.h"
#include "kernel/integrator/step_bodies-inl.h"
#include "kernel/loads/station_loads-inl.h"
#include "langevin_rigid_research.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// Without loads, or with LANGEVIN loads.
void step_range(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) {
    constexpr Integrator splitting = Integrator::splitting;
    if (!in.body.diagonal) return step_bodies<true, false, splitting>(in, a, begin, end);
    if (in.loads == Loads::langevin && in.clock == Clock::speed)
        return step_bodies<false, false, splitting, true>(in, a, begin, end);
    step_bodies<false, false, splitting>(in, a, begin, end);
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

// Finds bodies that end by the batch's rules.
bool ended_range(const lr_batch_rules& rules, const BatchArrays& a, size_t begin, size_t end, uint32_t* cause) {
    const DU du;
    const VF zero = hn::Zero(DF());
    VU any = hn::Zero(DU());
    for (size_t at = begin; at < end; at += hn::Lanes(DF())) {
        const Vec3 x = load3(a, field_x, at);
        // Causes are written from last to first, so that the first one counts.
        VU out = hn::Zero(DU());
        const auto put = [&](hn::Mask<DF> where, uint32_t code)
                             LR_LAMBDA { out = hn::IfThenElse(hn::RebindMask(du, where), hn::Set(du, code), out); };
        for (uint32_t k = rules.volume_count; k-- > 0;) {
            const auto in = inside(rules.volumes[k], x);
            put(rules.volumes[k].side == LR_KILL_OUTSIDE ? hn::Not(in) : in, cause_volume + k);
        }
        if (rules.max_age > 0.0f) put(load1(a, field_age, at) >= constant(rules.max_age), cause_age);
        // x - x is 0 only if x is finite.
        const Vec3 nothing = x - x;
        const VF sum = nothing.x + (nothing.y + nothing.z);
        put(hn::Not(hn::Eq(sum, zero)), cause_not_finite);
        store1(cause, at, out);
        any = hn::Or(any, out);
    }
    return !hn::AllTrue(du, hn::Eq(any, hn::Zero(DU())));
}

// Defined in step_aerodynamic.cpp, sample_wind.cpp, water_loads.cpp, write_transforms.cpp, collider_contact.cpp and gjk_pairs.cpp.
StepFunction step_aerodynamic;
PredictFunction predict;
EvaluateFunction evaluate;
NearFunction near_surface;
SurfaceFunction evaluate_surface;
WetFunction step_wet, settle_wet;
TransformFunction write_transforms;
extern const ContactTarget contact_functions;
extern const BodyContactTarget body_contact_functions;
PairSearch search_pairs;
NearBoxes near_boxes;

constexpr KernelTarget functions(int32_t simd) {
    return {simd,
            HWY_TARGET,
            &step_range,
            &step_aerodynamic,
            &ended_range,
            &predict,
            &evaluate,
            {&near_surface, &evaluate_surface, &step_wet, &settle_wet},
            &write_transforms,
            &contact_functions,
            &body_contact_functions,
            &search_pairs,
            &near_boxes};
}

#if HWY_ONCE
void step_range_rk4(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) {
    for_variant(in, [&]<bool kFull, bool kAerodynamic>()
                        HWY_ATTR { step_bodies<kFull, kAerodynamic, Integrator::rk4>(in, a, begin, end); });
}
// Next to Runge-Kutta, whose functions it shares.
void loads_of_body(const StepInput& in, const BodyConstants& c, const BatchArrays& arrays, const float (&fluid)[3],
                   lr_body_loads& out) {
    const auto& a = c.aerodynamics;
    const auto put = [](Vec3 v, float* to) LR_LAMBDA { // all lanes are equal
        to[0] = least_lane(v.x), to[1] = least_lane(v.y), to[2] = least_lane(v.z);
    };
    const Body b = load_body<true>(arrays, 0);
    const VF scale = load1(arrays, field_scale, 0), length = scale * constant(c.length);
    const VF mass = scale * scale * scale * constant(c.unit_mass);
    Held held;
    held.inverse_length = constant(1.0f) / length;
    vary(in, load1(arrays.noise_seed, 0), held);
    const VF nu = constant(a.viscosity) * held.inverse_length;
    const Vec3 stream = broadcast(fluid) + b.gust - to_world(b.q, load3(arrays, field_vx, 0));
    const Twist t{zero3() - to_body(b.q, stream), length * load3(arrays, field_wx, 0)};

    const auto add = [&](const float* place, Vec3 force) LR_LAMBDA {
        put(b.x + length * to_world(b.q, broadcast(place)), out.station_position + 3 * out.station_count);
        put(mass * to_world(b.q, force), out.station_force + 3 * out.station_count);
        ++out.station_count;
    };
    Twist sum;
    out.station_count = 0;
    if (c.stations.count == 0) {
        VF shed;
        sum = aerodynamic_loads(a, held, b, t, shed);
        const Twist none{zero3(), zero3()};
        sum += push_of_shed(held.inverse_length, none - moving_momentum<true, true>(c, shed, none, t), t);
        add(a.arm, sum.v);
    } else {
        sum = {zero3(), columns(a.axes, shedding_couple(a, held, b.shedding, centre_velocity<true>(a, t)))};
        for (uint32_t i = 0; i < c.stations.count; ++i) {
            StationSet one;
            one.station[0] = c.stations.station[i];
            one.count = 1;
            const Resistance k = station_resistance(one, a, held, nu, b.lag, t);
            const Twist f = resisted(k, t) + push_of_shed(held.inverse_length, k.lost, t);
            add(one.station[0].place, f.v);
            sum += f;
        }
    }
    put(stream, out.stream);
    put(zero3() - to_world(b.q, columns(a.axes, b.lag)), out.wake);
    put(to_world(b.q, columns(a.axes, Vec3{b.shedding[0], b.shedding[1], hn::Zero(DF())})), out.shedding);
    put(mass * to_world(b.q, sum.v), out.force);
    put(mass * length * to_world(b.q, sum.u), out.torque);
}
#endif
} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "hwy/targets.h"

namespace lr {

void step_rk4(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) {
    HWY_STATIC_DISPATCH(step_range_rk4)(in, a, begin, end);
}
void loads_on_body(const StepInput& in, const BodyConstants& body, const BatchArrays& a, const float (&fluid)[3],
                   lr_body_loads& out) {
    HWY_STATIC_DISPATCH(loads_of_body)(in, body, a, fluid, out);
}

const KernelTarget* built_targets(size_t& count) {
    static constexpr KernelTarget targets[] = {
#if HWY_TARGETS & HWY_AVX3
        N_AVX3::functions(LR_SIMD_AVX512),
#endif
#if HWY_TARGETS & HWY_AVX2
        N_AVX2::functions(LR_SIMD_AVX2),
#endif
#if HWY_TARGETS & HWY_SSE4
        N_SSE4::functions(LR_SIMD_SSE4),
#endif
#if HWY_TARGETS & HWY_NEON
        N_NEON::functions(LR_SIMD_NEON),
#endif
#if HWY_TARGETS & HWY_WASM
        N_WASM::functions(LR_SIMD_WASM),
#endif
// Plain C++, for tests alone (langevin_rigid_plain): the compiler decides which of the two Highway offers.
#if HWY_TARGETS & HWY_EMU128
        N_EMU128::functions(LR_SIMD_PLAIN),
#elif HWY_TARGETS & HWY_SCALAR
        N_SCALAR::functions(LR_SIMD_PLAIN),
#endif
    };
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
