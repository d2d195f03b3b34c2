// Quasi-steady loads for one vector of bodies: docs/maintainers/physics.md, "AERODYNAMIC". Kernel units and constants: body_constants.h.
// `b`: 1/(d s). `nu`: viscosity over d s, a velocity. v: of the load centre, along the load axes.
#if defined(LR_KERNEL_LOADS_AERODYNAMIC_LOADS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_LOADS_AERODYNAMIC_LOADS_INL_H_
#undef LR_KERNEL_LOADS_AERODYNAMIC_LOADS_INL_H_
#else
#define LR_KERNEL_LOADS_AERODYNAMIC_LOADS_INL_H_
#endif

#include "kernel/integrator/equations_of_motion-inl.h"
#include "kernel/integrator/splitting_scheme-inl.h"
#include "kernel/integrator/step.h"
#include "kernel/math/gaussian_noise-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::LR_KERNEL_NAMESPACE {

template <class T> HWY_INLINE Twist rows6(const T* m, Vec3 a) {
    return {rows(m, a), rows(m + 9, a)};
}

// Above zero, so that directions exist; far below any visible speed.
HWY_INLINE VF speed_squared(Vec3 v) {
    return dot(v, v) + constant(1e-20f);
}

// Drag is -drag_rate v, per mass unit.
template <class A> HWY_INLINE VF drag_rate(const A& c, VF b, VF nu, Vec3 v) {
    const VF s2 = speed_squared(v), s = hn::Sqrt(s2);
    const Vec3 part = constant(1.0f) / s2 * times(v, v);
    const VF separated = s / (constant(8710.0f) * nu + s); // Re/(Re + 8710)
    const VF form = separated * weighted(c.drag_blunt, part) + weighted(c.drag, part);
    const VF layer = hn::Sqrt(s * nu) * weighted(c.drag_layer, part);
    return b * (s * form + (nu * weighted(c.drag_stokes, part) + layer));
}

// sin^2 of the angle of attack for a sheet: 0 edge on.
template <class A> HWY_INLINE VF stall(const A& c, VF inverse_s2, Vec3 v) {
    return weighted(c.broadside, times(v, v)) * inverse_s2;
}

// Lift is circulation x v, per mass unit: by translation, by rotation, and by the sideways part of uneven viscous drag.
template <class A> HWY_INLINE Vec3 circulation(const A& c, VF b, VF nu, Vec3 v, Vec3 u) {
    const VF s2 = speed_squared(v), s = hn::Sqrt(s2);
    const VF inverse_s2 = constant(1.0f) / s2, inverse = b * inverse_s2;
    const VF root = hn::Sqrt(s * nu);
    const VF attached = constant(1.0f) - constant(c.lift_stall) * stall(c, inverse_s2, v);
    const VF full = s * attached;
    const auto along = [&](int k, VF vi, VF vj, VF uk) LR_LAMBDA {
        const VF sum =
            constant(c.lift[k]) * full + (constant(c.lift_layer[k]) * root + constant(c.lift_stokes[k]) * nu);
        return b * constant(c.spin_lift[k]) * uk - inverse * (vi * vj) * sum;
    };
    return {along(0, v.y, v.z, u.x), along(1, v.z, v.x, u.y), along(2, v.x, v.y, u.z)};
}

// Spin drag is -rate u along each axis.
template <class A> HWY_INLINE Vec3 spin_drag_rate(const A& c, VF b, VF nu, VF s, Vec3 u) {
    const VF spin = hn::Sqrt(weighted(c.spin_weight, times(u, u)));
    const auto along = [&](int k) LR_LAMBDA {
        return b * (constant(c.spin_drag[k]) * spin +
                    (constant(c.spin_drag_stream[k]) * s + constant(c.spin_drag_stokes[k]) * nu));
    };
    return {along(0), along(1), along(2)};
}

// Roll damping is -rate (axis . u) axis.
struct Roll {
    Vec3 axis;
    VF rate;
};
template <class A> HWY_INLINE Roll roll_damping(const A& c, VF b, VF s, Vec3 v) {
    return {times(broadcast(c.roll), v), b / s};
}

template <class A> HWY_INLINE Vec3 lift_moment(const A& c, VF b, Vec3 v) {
    const VF sigma = stall(c, constant(1.0f) / speed_squared(v), v);
    const auto along = [&](int k, VF vi, VF vj) LR_LAMBDA {
        return b * (vi * vj) * (constant(c.lift_moment_stalled[k]) * sigma + constant(c.lift_moment[k]));
    };
    return {along(0, v.y, v.z), along(1, v.z, v.x), along(2, v.x, v.y)};
}

template <bool kFull, class A> HWY_INLINE Vec3 centre_velocity(const A& c, Twist t) {
    if constexpr (!kFull) return t.v;
    return rows(c.axes, t.v + cross(t.u, broadcast(c.arm)));
}
template <bool kFull, class A> HWY_INLINE Vec3 load_spin(const A& c, Twist t) {
    if constexpr (!kFull) return t.u;
    return rows(c.axes, t.u);
}

// Real leaves differ. Thickness multiplies all loads, as they are per mass; curl the lift. Both factors are uniform with the same deviation, from a
// hash of the noise seed (finalizer of MurmurHash3).
HWY_INLINE void vary(const StepInput& in, VU noise_seed, Held& held) {
    held.drag = held.lift = held.inverse_length;
    if (in.variation == 0.0f) return;
    const DU du;
    VU x = hn::Xor(noise_seed, hn::Set(du, static_cast<uint32_t>(in.seed ^ in.seed >> 32)));
    x = hn::Xor(x, hn::ShiftRight<16>(x)) * hn::Set(du, 0x85ebca6bu);
    x = hn::Xor(x, hn::ShiftRight<13>(x)) * hn::Set(du, 0xc2b2ae35u);
    x = hn::Xor(x, hn::ShiftRight<16>(x));
    const float most = in.variation * 1.7320508f; // of a uniform distribution
    const auto factor = [&](VU bits) LR_LAMBDA {
        return from_signed(bits) * constant(most / 32768.0f) + constant(1.0f - most * (65535.0f / 65536.0f));
    };
    held.drag = held.inverse_length * factor(hn::ShiftRight<16>(x));
    held.lift = held.drag * factor(hn::And(x, hn::Set(du, 0xffffu)));
}

// The sum of all loads as force and torque about the centre of mass, body axes.
template <bool kFull, class A> HWY_INLINE Twist aerodynamic_loads(const A& c, const Held& held, Twist t) {
    const VF nu = constant(c.viscosity) * held.inverse_length;
    const Vec3 v = centre_velocity<kFull>(c, t), u = load_spin<kFull>(c, t);
    const Vec3 force = cross(circulation(c, held.lift, nu, v, u), v) - drag_rate(c, held.drag, nu, v) * v;
    const VF s = hn::Sqrt(speed_squared(v));
    const Roll roll = roll_damping(c, held.drag, s, v);
    const Vec3 resisted = times(spin_drag_rate(c, held.drag, nu, s, u), u) + roll.rate * dot(roll.axis, u) * roll.axis;
    const Vec3 torque = lift_moment(c, held.lift, v) - resisted;
    if constexpr (!kFull) return {force, torque};
    const Vec3 f = columns(c.axes, force);
    return {f, columns(c.axes, torque) + cross(broadcast(c.arm), f)};
}

// The gust after a substep (world frame): an Ornstein-Uhlenbeck process whose rate and variance, alpha and beta^2/(2 alpha), are fixed over it.
HWY_INLINE Vec3 next_gust(Vec3 gust, VF alpha, VF variance, float h, const VF gauss[3]) {
    // exp(-x), to 1e-6 for x below 1, and towards zero beyond.
    const VF x = hn::Min(alpha * constant(0.125f * h), constant(8.0f));
    VF e = constant(1.0f) / polynomial({1.0f / 24.0f, 1.0f / 6.0f, 0.5f, 1.0f, 1.0f}, x);
    e *= e;
    e *= e;
    e *= e;
    const VF kick = hn::Sqrt(variance * hn::Max(constant(1.0f) - e * e, constant(0.0f)));
    return e * gust + kick * broadcast(gauss);
}

// The substep with quasi-steady loads: free motion, drag and weight, spin drag, lift, and back (docs/maintainers/numerics.md, "AERODYNAMIC loads").

// y' = f - x/tau y over tau, given tau f: exp(-x) = 1/D and (1 - exp(-x))/x = C/D with D = 1 + x C, C = 1 + x/2.
HWY_INLINE VF relax_second(VF y, VF x, VF tau_f) {
    x = hn::Min(x, constant(1e15f));
    const VF c = x * constant(0.5f) + constant(1.0f);
    return (tau_f * c + y) / (x * c + constant(1.0f));
}
// Its middle: m = r/(1 + e), r = y plus half of tau f, as if the rate grew with y: with x/tau the rate at r, m (1 + x m/(2 r)) = r. The rate at y
// instead would leave y unchanged for large x, and a body at rest there for long.
HWY_INLINE VF eased(VF x) {
    return x / (constant(1.0f) + hn::Sqrt(constant(2.0f) * x + constant(1.0f)));
}
HWY_INLINE VF over_one_and(VF r, VF e) {
    return r / (constant(1.0f) + e);
}
// relax_middle(r, x) is r/(1 + eased(x)) with one division.
HWY_INLINE VF relax_middle(VF r, VF x) {
    return (r + r) / (constant(1.0f) + hn::Sqrt(constant(2.0f) * x + constant(1.0f)));
}

// Twist of the body about the load centre, in load axes, for both halves of the loads.
struct Pull {
    Twist t;    // gain by weight, buoyancy and external forces in half a substep
    Vec3 modes; // its velocity along the modes of the mobility
};
// Rates in the middle of one half. The other half starts from them to find its own middle: second order, with the same equilibrium.
struct Rates {
    VF drag;
    Vec3 spin;
};

// Drag opposes the velocity with one factor in all directions, so the modes of the mobility P M^-1 P^T decay independently, each towards its terminal
// velocity. On the diagonal path they are the axes.
template <bool kFull, class C>
HWY_INLINE void drag_along_modes(const StepInput& in, const C& c, const Held& held, VF nu, const Pull& pull,
                                 bool before_lift, Rates& rates, Twist& t) {
    const auto& a = c.aerodynamics;
    const auto from_modes = [&](Vec3 y) LR_LAMBDA {
        if constexpr (!kFull) return y;
        return rows(a.modes, y);
    };
    const VF tau = constant(0.5f * in.h), half = constant(0.5f);
    const Vec3 rate = tau * broadcast(kFull ? a.rate : c.inverse_mass), y = kFull ? columns(a.modes, t.v) : t.v;
    const Vec3 r = y + half * pull.modes;
    Vec3 middle;
    if (before_lift)
        middle = each_axis(relax_middle, r, drag_rate(a, held.drag, nu, t.v + half * pull.t.v) * rate);
    else
        middle = each_axis(over_one_and, r, half * rates.drag * rate);
    rates.drag = drag_rate(a, held.drag, nu, from_modes(middle));
    const Vec3 after = each_axis(relax_second, y, rates.drag * rate, pull.modes);
    if constexpr (!kFull) {
        t.v = after;
        return;
    }
    const Vec3 lost = rows(a.modes, after - y - pull.modes);
    t += pull.t + Twist{lost, rows(a.spin_of_force, lost)};
}
// Not inlined: the full path has each half twice, and a substep would exceed the instruction cache.
template <class C>
static HWY_NOINLINE void drag_half_full(const StepInput& in, const C& c, const Held& held, VF nu, const Pull& pull,
                                        bool before_lift, Rates& rates, Twist& t) {
    drag_along_modes<true>(in, c, held, nu, pull, before_lift, rates, t);
}
template <bool kFull, bool kBeforeLift, class C>
HWY_INLINE void drag_half(const StepInput& in, const C& c, const Held& held, VF nu, const Pull& pull, Rates& rates,
                          Twist& t) {
    if constexpr (kFull)
        drag_half_full(in, c, held, nu, pull, kBeforeLift, rates, t);
    else
        drag_along_modes<false>(in, c, held, nu, pull, kBeforeLift, rates, t);
}

// N a, N the mobility of the spin.
template <bool kFull, class C> HWY_INLINE Vec3 spin_mobility(const C& c, Vec3 a) {
    if constexpr (kFull) return symmetric3(c.aerodynamics.spin_mobility, a);
    return scaled_by(c.inverse_spin_mass, a);
}
// Its diagonal.
template <bool kFull, class C> HWY_INLINE Vec3 spin_mobility(const C& c) {
    const auto* const n = c.aerodynamics.spin_mobility;
    if constexpr (kFull) return {constant(n[0]), constant(n[3]), constant(n[5])};
    return broadcast(c.inverse_spin_mass);
}

// Roll damping of half a substep: exact but for exp(-x), as relax_second.
template <bool kFull, class C> HWY_INLINE Vec3 rolled_half(const C& c, const Roll& roll, VF tau, Vec3 u) {
    const Vec3 response = spin_mobility<kFull>(c, roll.axis);
    const VF rate = tau * roll.rate;
    const VF x = hn::Min(rate * dot(roll.axis, response), constant(1e15f));
    const VF p = x * constant(0.5f) + constant(1.0f);
    const VF lost = rate * dot(roll.axis, u) * p / (x * p + constant(1.0f));
    return u - lost * response;
}

// The lift's couple acts at four moments, h/4 each: at the ends of the substep and on both sides of its middle. Of all loads it turns most with the
// body, and a single attitude for it was the largest error of the splitting.
inline constexpr float couple_share = 0.25f;
// Bound of the rim's speed by a couple, over the stream's: in truth the body would have turned away. At a substep's ends no spin drag acts.
inline constexpr float most_rim = 8.0f, most_rim_at_end = 1.0f;
HWY_INLINE Vec3 bounded(Vec3 v, VF most, VF least) {
    return each_axis([&](VF x) LR_LAMBDA { return hn::Max(hn::Min(x, most), least); }, v);
}
HWY_INLINE Vec3 bounded_push(Vec3 push, VF s, float times_stream) {
    const VF most = constant(times_stream) * s;
    return bounded(push, most, -most);
}

template <bool kFull, class C>
HWY_INLINE void couple_at_end(const StepInput& in, const C& c, const Held& held, Body& b) {
    const auto& a = c.aerodynamics;
    Twist t = b.t;
    if (kFull && held.sheared) t.u -= to_body(b.q, held.fluid_spin);
    const Vec3 v = centre_velocity<kFull>(a, t);
    const VF s = hn::Sqrt(speed_squared(v));
    const Vec3 couple = constant(couple_share * in.h) * lift_moment(a, held.lift, v);
    const Vec3 push = bounded_push(spin_mobility<kFull>(c, couple), s, most_rim_at_end);
    if constexpr (kFull)
        b.t += rows6(a.spin_response, push);
    else
        b.t.u += push;
}

// Spin along one axis under couple and drag along it; all spin answers by N e, here over e.N e. Axis after axis, in reverse order in the other half,
// is of second order, contracts in the norm of N^-1, and rests at any step if couple and drag agree along every axis.
template <int kAxis, class T> HWY_INLINE Vec3 answering(const T* n, VF change, Vec3 u) {
    if constexpr (kAxis == 0) return {u.x + change, constant(n[0]) * change + u.y, constant(n[1]) * change + u.z};
    if constexpr (kAxis == 1) return {constant(n[2]) * change + u.x, u.y + change, constant(n[3]) * change + u.z};
    return {constant(n[4]) * change + u.x, constant(n[5]) * change + u.y, u.z + change};
}
template <int kAxis, class T> HWY_INLINE Vec3 relax_axis(const T* n, VF x, VF push, Vec3 u) {
    const VF y = kAxis == 0 ? u.x : kAxis == 1 ? u.y : u.z;
    x = hn::Min(x, constant(1e15f));
    const VF p = x * constant(0.5f) + constant(1.0f);
    return answering<kAxis>(n, (push - x * y) * (p / (x * p + constant(1.0f))), u);
}

template <class C>
static HWY_NOINLINE void spin_drag_half_full(const StepInput& in, const C& c, const Held& held, VF nu, bool before_lift,
                                             Rates& rates, Twist& t) {
    const auto& a = c.aerodynamics;
    const auto* const n = a.spin_answer;
    const VF tau = constant(0.5f * in.h), half = constant(0.5f);
    const Vec3 own = spin_mobility<true>(c), share = constant(couple_share * in.h) * own, rate = tau * own;
    const auto push_in = [&](Vec3 v, VF s) LR_LAMBDA {
        return bounded_push(times(share, lift_moment(a, held.lift, v)), s, most_rim);
    };
    const VF s = hn::Sqrt(speed_squared(t.v));
    const Vec3 first = half * push_in(t.v, s);
    const Vec3 r = answering<2>(n, first.z, answering<1>(n, first.y, answering<0>(n, first.x, t.u)));
    Vec3 e = half * times(rate, rates.spin);
    if (before_lift) e = each_axis(eased, times(rate, spin_drag_rate(a, held.drag, nu, s, r)));
    const auto lost = [&](VF y, VF by) LR_LAMBDA { return -over_one_and(y * by, by); };
    Vec3 middle = answering<0>(n, lost(r.x, e.x), r);
    middle = answering<1>(n, lost(middle.y, e.y), middle);
    middle = answering<2>(n, lost(middle.z, e.z), middle);
    // A couple moves a load centre that lies off the centre of mass.
    const Vec3 v = t.v + rows(a.velocity_of_couple, middle - t.u);
    const VF speed = hn::Sqrt(speed_squared(v));
    const Vec3 push = push_in(v, speed);
    const Roll roll = roll_damping(a, held.drag, speed, v);
    rates.spin = spin_drag_rate(a, held.drag, nu, speed, middle);
    const Vec3 x = times(rate, rates.spin);
    Vec3 u = t.u;
    if (before_lift) {
        u = relax_axis<0>(n, x.x, push.x, u);
        u = relax_axis<1>(n, x.y, push.y, u);
        u = relax_axis<2>(n, x.z, push.z, u);
        u = rolled_half<true>(c, roll, tau, u);
    } else {
        u = rolled_half<true>(c, roll, tau, u);
        u = relax_axis<2>(n, x.z, push.z, u);
        u = relax_axis<1>(n, x.y, push.y, u);
        u = relax_axis<0>(n, x.x, push.x, u);
    }
    t.v += rows(a.velocity_of_couple, u - t.u);
    t.u = u;
}

// Roll damping is a separate part, next to the lift on both sides.
template <bool kFull, bool kBeforeLift, class C>
HWY_INLINE void spin_drag_half(const StepInput& in, const C& c, const Held& held, VF nu, const Pull& pull, Rates& rates,
                               Twist& t) {
    if constexpr (kFull) {
        spin_drag_half_full(in, c, held, nu, kBeforeLift, rates, t);
    } else {
        const auto& a = c.aerodynamics;
        const VF tau = constant(0.5f * in.h), half = constant(0.5f), share = constant(couple_share * in.h);
        const VF s = hn::Sqrt(speed_squared(t.v));
        const Vec3 couple = share * lift_moment(a, held.lift, t.v);
        const Roll roll = roll_damping(a, held.drag, s, t.v);
        const Vec3 u = kBeforeLift ? t.u : rolled_half<false>(c, roll, tau, t.u);
        const Vec3 rate = spin_mobility<false>(c), push = bounded_push(times(rate, couple), s, most_rim) + pull.t.u;
        const Vec3 r = u + half * push;
        Vec3 middle;
        if constexpr (kBeforeLift)
            middle = each_axis(relax_middle, r, times(rate, tau * spin_drag_rate(a, held.drag, nu, s, r)));
        else
            middle = each_axis(over_one_and, r, times(rate, half * tau * rates.spin));
        rates.spin = spin_drag_rate(a, held.drag, nu, s, middle);
        t.u = each_axis(relax_second, u, times(rate, tau * rates.spin), push);
        if constexpr (kBeforeLift) t.u = rolled_half<false>(c, roll, tau, t.u);
    }
}

// The middle of the implicit midpoint for v' = N (2 k) x v: (1 - N [k]x)^-1 v = (v + N (k x v) + (k.a v) k)/(1 + k.a k),
// a the adjugate of N; a rotation if N is the unit matrix.
template <bool kFull, class C> HWY_INLINE Vec3 lifted_middle(const C& c, Vec3 k, Vec3 v) {
    const auto& a = c.aerodynamics;
    const Vec3 kv = cross(k, v);
    Vec3 ak, moved;
    if constexpr (kFull) {
        ak = symmetric3(a.mobility_adjugate, k);
        moved = symmetric3(a.mobility, kv);
    } else {
        ak = {constant(c.inverse_mass[1]) * constant(c.inverse_mass[2]) * k.x,
              constant(c.inverse_mass[2]) * constant(c.inverse_mass[0]) * k.y,
              constant(c.inverse_mass[0]) * constant(c.inverse_mass[1]) * k.z};
        moved = scaled_by(c.inverse_mass, kv);
    }
    const VF inverse = constant(1.0f) / (constant(1.0f) + dot(ak, k));
    return inverse * (v + moved + dot(ak, v) * k);
}

// Lift does no work: the force g x v_middle of the implicit midpoint keeps the energy at any step, whatever the circulation g. That is taken at the
// middle which the circulation at the start leads to.
template <bool kFull, class C>
HWY_INLINE void lift_step(const StepInput& in, const C& c, const Held& held, VF nu, Twist& t) {
    const auto& a = c.aerodynamics;
    const VF half = constant(0.5f * in.h);
    const Vec3 v = t.v, u = t.u;
    // Beyond this the velocity turns too far in a step to be resolved.
    const VF most = constant(5e3f), least = constant(-5e3f);
    const Vec3 start = bounded(half * circulation(a, held.lift, nu, v, u), most, least);
    const Vec3 v_start = lifted_middle<kFull>(c, start, v);
    Vec3 u_middle = u;
    if constexpr (kFull) u_middle = u + rows(a.spin_response_to_force, cross(start, v_start));
    const Vec3 k = bounded(half * circulation(a, held.lift, nu, v_start, u_middle), most, least);
    const Vec3 half_impulse = cross(k, lifted_middle<kFull>(c, k, v));
    const Vec3 impulse = half_impulse + half_impulse;
    if constexpr (kFull)
        t += Twist{symmetric3(a.mobility, impulse), rows(a.spin_response_to_force, impulse)};
    else
        t.v += scaled_by(c.inverse_mass, impulse);
}

// The gain by weight, buoyancy and external forces. A torque acts with the drag (full path: it moves the load centre) or the spin drag (diagonal).
template <bool kFull, class C>
HWY_INLINE Pull pull_of(const StepInput& in, const C& c, const Held& held, Quaternion q) {
    const VF tau = constant(0.5f * in.h);
    if constexpr (!kFull) {
        Twist f{to_body(q, held.weight), zero3()};
        if (held.external) f += external_force<false>(c, *held.external, q);
        const Twist t = tau * acceleration<false>(c, f);
        return {t, t.v};
    }
    const auto& a = c.aerodynamics;
    const auto answer = [&](const Twist& f) LR_LAMBDA {
        const Twist t = acceleration<true>(c, f);
        return Twist{centre_velocity<true>(a, t), load_spin<true>(a, t)};
    };
    const Vec3 gravity = to_body(q, held.gravity);
    Twist t;
    if (held.uniform) {
        t = {rows(a.fall, gravity), rows(a.fall + 9, gravity)};
        if (held.external) t += answer(external_force<true>(c, *held.external, q));
    } else {
        Twist f{to_body(q, held.weight), cross(broadcast(c.buoyancy), gravity)};
        if (held.external) f += external_force<true>(c, *held.external, q);
        t = answer(f);
    }
    t = tau * t;
    return {t, columns(a.modes, t.v)};
}

template <bool kFull, class C>
HWY_INLINE void loads_in_middle(const StepInput& in, const C& c, const Held& held, VF nu, Body& b) {
    const Pull pull = pull_of<kFull>(in, c, held, b.q);
    // Loads act on the spin relative to the fluid.
    if (held.sheared) b.t.u -= to_body(b.q, held.fluid_spin);
    const auto& a = c.aerodynamics;
    const Twist before{centre_velocity<kFull>(a, b.t), load_spin<kFull>(a, b.t)};
    Twist t = before;
    Rates rates{hn::Zero(DF()), zero3()};
    drag_half<kFull, true>(in, c, held, nu, pull, rates, t);
    spin_drag_half<kFull, true>(in, c, held, nu, pull, rates, t);
    lift_step<kFull>(in, c, held, nu, t);
    spin_drag_half<kFull, false>(in, c, held, nu, pull, rates, t);
    drag_half<kFull, false>(in, c, held, nu, pull, rates, t);
    if constexpr (kFull) {
        // Only the change: a round trip through the load axes would round the whole.
        const Vec3 u = columns(a.axes, t.u - before.u);
        b.t += Twist{columns(a.axes, t.v - before.v) - cross(u, broadcast(a.arm)), u};
    } else {
        b.t = t;
    }
    if (held.sheared) b.t.u += to_body(b.q, held.fluid_spin);
}

// Free motion has the largest error, growing with the square of its step: it takes the two outer places, the loads the middle.
template <bool kFull, class C>
HWY_INLINE void aerodynamic_splitting_substep(const StepInput& in, const C& c, const Held& held, Body& b) {
    const VF nu = constant(c.aerodynamics.viscosity) * held.inverse_length;
    couple_at_end<kFull>(in, c, held, b);
    free_step<kFull, true>(0.5f * in.h, c, held, b);
    loads_in_middle<kFull>(in, c, held, nu, b);
    free_step<kFull, true>(0.5f * in.h, c, held, b);
    couple_at_end<kFull>(in, c, held, b);
}
} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
