// Bodies between two fluids, compiled once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/surface.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

// Vectors one by one: two side by side spill so much here that they are slower, in twice the code.
#ifndef LR_NO_PAIRS
#define LR_NO_PAIRS
#endif

#include "hwy/highway.h"
#include "kernel/external-inl.h"
#include "kernel/faults-inl.h"
#include "kernel/rows-inl.h"
#include "kernel/substep-inl.h"
#include "kernel/surface-inl.h"
#include "kernel/surface_constants-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

HWY_INLINE Quaternion load_orientation(const BatchArrays& a, size_t at) {
    const DF d;
    return {hn::Load(d, a.field[field_qx] + at), hn::Load(d, a.field[field_qy] + at),
            hn::Load(d, a.field[field_qz] + at), hn::Load(d, a.field[field_qw] + at)};
}

void near_surface(const SurfaceInstant& plane, float highest, const WaterBody& w, float dt, float gravity,
                  const BatchArrays& a, size_t begin, size_t end, uint32_t* near) {
    const DF d;
    const DU du;
    const VF fall = constant(highest + gravity * dt * dt), travel = constant(1.5f * dt);
    for (size_t at = begin; at < end; at += hn::Lanes(d)) {
        const Vec3 v = load3(a, field_vx, at);
        const VF radius = hn::Mul(constant(w.radius), hn::Load(d, a.field[field_scale] + at));
        const VF reach = mul_add(travel, hn::Sqrt(dot(v, v)), hn::Add(radius, fall));
        const VF above = dot(broadcast(plane.up), sub(load3(a, field_x, at), broadcast(plane.point)));
        const auto is_near = hn::RebindMask(du, hn::Le(above, reach)); // false for NaN
        hn::Store(hn::IfThenElseZero(is_near, hn::Set(du, 1)), du, near + (at - begin));
    }
}

void ahead_of(const BatchArrays& a, size_t count, float h, SurfaceBlock& out) {
    const DF d;
    const VF most = constant(1e12f);
    const auto within = [&](VF x) HWY_ATTR { return hn::IfThenElseZero(hn::Le(hn::Abs(x), most), x); };
    for (size_t at = 0; at < count; at += hn::Lanes(d)) {
        const Vec3 v = to_world(load_orientation(a, at), load3(a, field_vx, at));
        const Vec3 x = add_scaled(load3(a, field_x, at), constant(h), v);
        store3(out.position, at, {within(x.x), within(x.y), within(x.z)});
    }
}

void evaluate_surface(const SurfaceInstant& plane, size_t count, SurfaceBlock& b) {
    const DF d;
    for (size_t at = 0; at < count; at += hn::Lanes(d)) {
        const SurfaceSample s = sample_surface(plane, load3(b.position, at));
        hn::Store(s.height, d, b.height + at);
        store3(b.normal, at, s.normal);
        store3(b.velocity, at, s.velocity);
        store3(b.rate, at, s.rate);
    }
}

HWY_INLINE float blur_of(const StepInput& in, const WetSubstep& s) {
    const float* const g = s.gravity;
    const float squared = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    return std::sqrt(squared) * (in.h * in.h);
}

HWY_NOINLINE Immersion immersed_at(const StepInput& in, const WetSubstep& s, const SurfaceBlock& b, size_t at,
                                   VF body_scale, Quaternion q, Vec3 x) {
    const DF d;
    return immersed(*s.body, *s.plane, body_scale, q, x, hn::Load(d, b.height + at), load3(b.normal, at),
                    blur_of(in, s));
}

// Fluid that the body begins to move has to be set in motion: momentum is kept. Fluid that it leaves behind keeps its
// own, and the body its velocity. Neither gains energy. v, u: relative to the lower fluid.
template <bool kFull> HWY_INLINE Twist struck(const WaterBody& w, VF before, VF after, Twist t) {
    const VF one = constant(1.0f);
    const auto ratio = [&](int i) HWY_ATTR {
        const VF lambda = constant(w.lambda[i]);
        return hn::Min(hn::Div(mul_add(before, lambda, one), mul_add(after, lambda, one)), one);
    };
    if constexpr (!kFull)
        return {{hn::Mul(t.v.x, ratio(0)), hn::Mul(t.v.y, ratio(1)), hn::Mul(t.v.z, ratio(2))},
                {hn::Mul(t.u.x, ratio(3)), hn::Mul(t.u.y, ratio(4)), hn::Mul(t.u.z, ratio(5))}};
    // The change alone: one that is zero must leave every bit.
    const Twist y = general6<false>(w.to, t);
    const auto change = [&](VF value, int i) HWY_ATTR { return hn::Mul(value, hn::Sub(ratio(i), one)); };
    return add(t, general6<false>(w.from, Twist{{change(y.v.x, 0), change(y.v.y, 1), change(y.v.z, 2)},
                                                {change(y.u.x, 3), change(y.u.y, 4), change(y.u.z, 5)}}));
}

// Weight and buoyancy of a body between the fluids, over the mass unit. Where they pull back towards floating they are
// weakened by 1 + h^2/4 times their steepest rate: with it the scheme, position Verlet, is stable for any substep.
struct Floating {
    Vec3 force;  // world
    Vec3 torque; // body frame, over d s
};
HWY_NOINLINE Floating floating(const StepInput& in, const WetSubstep& s, const LaneConstants& c, const Immersion& at,
                               VF body_scale, VF inverse_length, Quaternion q, Vec3 normal, Vec3 rate, VF wet) {
    const WaterBody& w = *s.body;
    const VF one = constant(1.0f), zero = hn::Zero(DF()), f = at.fraction, dry = hn::Sub(one, f);
    const VF per_unit = hn::Div(one, c.unit_mass);
    const VF air = hn::Mul(per_unit, constant(w.air_mass)), water = hn::Mul(per_unit, constant(w.water_mass));
    const Vec3 gravity = broadcast(s.gravity), lower = sub(gravity, rate);
    Floating out;
    out.force = scale(hn::Mul(per_unit, constant(w.mass)), sub(gravity, scale(wet, rate)));
    out.force = sub(out.force, add(scale(hn::Mul(water, f), lower), scale(hn::Mul(air, dry), gravity)));
    const Vec3 middle = scale(body_scale, broadcast(w.center));
    const Vec3 from_water = cross(scale(hn::Neg(water), at.center), to_body(q, lower));
    const Vec3 from_air = cross(scale(hn::Neg(air), sub(middle, at.center)), to_body(q, gravity));
    out.torque = scale(inverse_length, add(from_water, from_air));

    const auto between = hn::And(hn::Gt(f, zero), hn::Lt(f, one));
    const VF quarter = hn::IfThenElseZero(between, constant(0.25f * in.h * in.h));
    const VF pull = hn::Mul(hn::Mul(water, hn::Sqrt(dot(gravity, gravity))), quarter);
    const VF stiff = hn::Div(pull, at.half_height);
    const Vec3 n = at.normal, mobile = broadcast(c.inverse_mass);
    const VF heave = hn::Mul(hn::Mul(stiff, constant(0.75f)), dot(n, times(mobile, n)));
    const VF less = hn::Sub(hn::Div(one, hn::Add(one, heave)), one);
    out.force = add_scaled(out.force, hn::Mul(less, dot(normal, out.force)), normal);

    // About each axis of the ellipsoid.
    const VF area = hn::Mul(body_scale, body_scale), gyration = hn::Mul(inverse_length, inverse_length);
    const VF arm = hn::Mul(pull, hn::Sqrt(dot(middle, middle)));
    const Vec3 spin = broadcast(c.inverse_spin_mass);
    const auto weaker = [&](int i, VF torque) HWY_ATTR {
        const float gap = w.semi_axes_squared[(i + 1) % 3] - w.semi_axes_squared[(i + 2) % 3];
        const VF steep = mul_add(hn::Mul(stiff, at.second), hn::Mul(area, constant(gap < 0.0f ? -gap : gap)), arm);
        const Vec3 e = broadcast(w.axes + 3 * i);
        const VF roll = hn::Mul(hn::Mul(steep, gyration), dot(e, times(spin, e)));
        return hn::Div(torque, hn::Add(one, roll));
    };
    const Vec3 torque = rows(w.axes, out.torque);
    out.torque = columns(w.axes, Vec3{weaker(0, torque.x), weaker(1, torque.y), weaker(2, torque.z)});
    return out;
}

HWY_INLINE void store_velocities(const BatchArrays& a, size_t at, VF inverse_length, Twist t) {
    store3(a, field_vx, at, without_dust(t.v));
    store3(a, field_wx, at, without_dust(scale(inverse_length, t.u)));
}

// By the splitting scheme, whatever the batch has in the air.
template <bool kFull, bool kAerodynamic>
HWY_NOINLINE void step_wet_bodies(const StepInput& in, const WetSubstep& s, const BatchArrays& a, size_t count) {
    const DF d;
    const DU du;
    const WaterBody& w = *s.body;
    const VF zero = hn::Zero(d), half = constant(0.5f * in.h);
    const Vec3 none{zero, zero, zero};
    for (size_t at = 0; at < count; at += hn::Lanes(d)) {
        Body b;
        b.x = load3(a, field_x, at);
        b.q = load_orientation(a, at);
        b.age = hn::Load(d, a.field[field_age] + at);
        b.age_rest = hn::Load(d, a.field[field_age_rest] + at);
        if constexpr (kAerodynamic) b.gust = load3(a, field_gust_x, at);
        const VF body_scale = hn::Load(d, a.field[field_scale] + at);
        const VF length = hn::Mul(body_scale, constant(in.body.length));
        const VF inverse_length = hn::Div(constant(1.0f), length);
        const Vec3 spin = load3(a, field_wx, at);
        Twist world{load3(a, field_vx, at), scale(length, spin)}; // of the body, body axes

        const Quaternion q = normalised(turn(b.q, b.q, constant(0.25f * in.h), spin));
        const Immersion begin = immersed_at(in, s, *s.begin, at, body_scale, b.q, b.x);
        const Immersion middle = immersed_at(in, s, *s.middle, at, body_scale, q, load3(s.middle->position, at));
        const VF f = middle.fraction;
        hn::Store(f, d, s.fraction + at);

        const Vec3 lower = load3(s.middle->velocity, at), upper = load3(s.wind, at), rate = load3(s.middle->rate, at);
        const Vec3 stream = to_body(b.q, lower);
        world = struck<kFull>(w, begin.fraction, f, {sub(world.v, stream), world.u});
        world.v = add(world.v, stream);

        LaneConstants c;
        VF unit;
        blend<kFull, kAerodynamic>(in.loads == Loads::langevin, in.body, w, f, c, unit);
        const VF wet = water_share(w, f);
        Held held;
        held.inverse_length = inverse_length;
        held.alpha = held.beta = zero;
        held.wind = add_scaled(upper, wet, sub(lower, upper));
        held.gravity = held.fluid_spin = none;
        held.sheared = false;
        held.uniform = false;
        const Floating loads =
            floating(in, s, c, middle, body_scale, inverse_length, q, load3(s.middle->normal, at), rate, wet);
        held.weight = loads.force;
        External external{};
        for (Twist* t : {external.force, external.force + 1, external.rate, external.rate + 1}) *t = {none, none};
        if (in.external.any) external = take_external(in.external, c, body_scale, at);
        // In the body's frame: held in the world's, a step that turns the body otherwise than foreseen would bring it to bear
        // on an axis about which there is neither torque nor inertia.
        external.force[1].u = add(external.force[1].u, loads.torque);
        held.external = &external;

        // The fluid's acceleration is the frame's.
        const Vec3 half_change = scale(hn::Mul(half, wet), rate);
        b.t = {sub(world.v, to_body(b.q, sub(held.wind, half_change))), world.u};
        const VU key = hn::Load(du, a.key + at);
        const VF beta_unit = hn::Mul(c.speed_beta, inverse_length);
        one_substep<kFull, kAerodynamic, Integrator::splitting>(in, c, held, key, 0, beta_unit, b);

        b.t.v = add(b.t.v, to_body(b.q, add(held.wind, half_change)));
        const auto motion = sane_motion(b.t.v, scale(inverse_length, b.t.u));
        auto sane = hn::And(hn::And(sane_pose(b.x, b.q), motion), not_held(a, at));
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
        store_velocities(a, at, inverse_length, b.t);
        hn::Store(b.age, d, a.field[field_age] + at);
        hn::Store(b.age_rest, d, a.field[field_age_rest] + at);
        if (HWY_UNLIKELY(!all_sane)) before.hold(a, at, hn::Lanes(d), in.h, kAerodynamic, in.faults);
    }
}

void step_wet(const StepInput& in, const WetSubstep& s, const BatchArrays& a, size_t count) {
    for_variant(in, [&]<bool kFull, bool kAerodynamic>()
                        HWY_ATTR { step_wet_bodies<kFull, kAerodynamic>(in, s, a, count); });
}

template <bool kFull>
HWY_NOINLINE void settle_bodies(const StepInput& in, const WetSubstep& s, const BatchArrays& a, size_t count) {
    const DF d;
    for (size_t at = 0; at < count; at += hn::Lanes(d)) {
        const Quaternion q = load_orientation(a, at);
        const VF body_scale = hn::Load(d, a.field[field_scale] + at);
        const VF length = hn::Mul(body_scale, constant(in.body.length));
        const Immersion end = immersed_at(in, s, *s.end, at, body_scale, q, load3(a, field_x, at));
        const Vec3 stream = to_body(q, load3(s.end->velocity, at));
        const Twist t{sub(load3(a, field_vx, at), stream), scale(length, load3(a, field_wx, at))};
        Twist after = struck<kFull>(*s.body, hn::Load(d, s.fraction + at), end.fraction, t);
        after.v = add(after.v, stream);
        const VF inverse_length = hn::Div(constant(1.0f), length);
        const auto sane = hn::And(sane_motion(after.v, scale(inverse_length, after.u)), not_held(a, at));
        const bool all_sane = hn::AllTrue(d, sane);
        BodiesBefore before;
        if (HWY_UNLIKELY(!all_sane)) before.take(a, at, hn::Lanes(d));
        store_velocities(a, at, inverse_length, after);
        if (HWY_UNLIKELY(!all_sane)) before.hold(a, at, hn::Lanes(d), 0.0f, false, in.faults);
    }
}

void settle_wet(const StepInput& in, const WetSubstep& s, const BatchArrays& a, size_t count) {
    if (in.body.diagonal)
        settle_bodies<false>(in, s, a, count);
    else
        settle_bodies<true>(in, s, a, count);
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
