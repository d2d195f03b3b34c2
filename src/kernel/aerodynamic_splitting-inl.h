// The splitting scheme's substep with quasi-steady loads: free motion, drag and weight, spin drag, lift, and back
// (docs/numerics.md, "AERODYNAMIC loads").
#if defined(LR_KERNEL_AERODYNAMIC_SPLITTING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_AERODYNAMIC_SPLITTING_INL_H_
#undef LR_KERNEL_AERODYNAMIC_SPLITTING_INL_H_
#else
#define LR_KERNEL_AERODYNAMIC_SPLITTING_INL_H_
#endif

#include "kernel/aerodynamic-inl.h"
#include "kernel/splitting-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// y' = f - x/tau y over tau, given tau f: exp(-x) = 1/D and (1 - exp(-x))/x = C/D with D = 1 + x C, C = 1 + x/2.
HWY_INLINE VF relax_second(VF y, VF x, VF tau_f) {
    x = hn::Min(x, constant(1e15f));
    const VF c = mul_add(x, constant(0.5f), constant(1.0f));
    return hn::Div(mul_add(tau_f, c, y), mul_add(x, c, constant(1.0f)));
}
// The same in its middle, as if the rate grew with y: m (1 + x m/(2 r)) = r, where r is y and half of tau f, and x/tau the
// rate at r. An x taken at y instead would leave y as it is where x is large, and a body at rest there for long.
HWY_INLINE VF relax_middle(VF r, VF x) {
    return hn::Div(hn::Add(r, r), hn::Add(constant(1.0f), hn::Sqrt(mul_add(constant(2.0f), x, constant(1.0f)))));
}
HWY_INLINE Vec3 relax_middle(Vec3 r, Vec3 x) {
    return {relax_middle(r.x, x.x), relax_middle(r.y, x.y), relax_middle(r.z, x.z)};
}
HWY_INLINE Vec3 each(VF (*f)(VF, VF, VF), Vec3 y, Vec3 x, Vec3 tau_f) {
    return {f(y.x, x.x, tau_f.x), f(y.y, x.y, tau_f.y), f(y.z, x.z, tau_f.z)};
}

// Drag opposes the velocity with one factor in all directions, so that the modes of the mobility P M^-1 P^T decay on
// their own, each towards its terminal velocity.
// The full path's halves are not inlined: each is there twice, and a substep would not fit into the instruction cache.
template <class C>
HWY_NOINLINE void drag_half_full(const StepInput& in, const C& c, const Held& held, VF nu, const Twist& applied,
                                 Body& b) {
    const auto& a = c.aerodynamics;
    const VF tau = constant(0.5f * in.h), half = constant(0.5f);
    const Twist pull = scale(tau, acceleration<true>(c, applied));
    const Vec3 v = centre_velocity<true>(a, b.t), rate = broadcast(a.rate);
    const Vec3 y = columns(a.modes, v), push = columns(a.modes, centre_velocity<true>(a, pull));
    const Vec3 r = add_scaled(y, half, push);
    const Vec3 x = scale(hn::Mul(tau, drag_rate(a, held.inverse_length, nu, rows(a.modes, r))), rate);
    const Vec3 middle = rows(a.modes, relax_middle(r, x));
    const Vec3 after =
        each(relax_second, y, scale(hn::Mul(tau, drag_rate(a, held.inverse_length, nu, middle)), rate), push);
    b.t = add(b.t, add(pull, rows6(a.from_modes, sub(sub(after, y), push))));
}
template <bool kFull, class C>
HWY_INLINE void drag_half(const StepInput& in, const C& c, const Held& held, VF nu, const Twist& applied, Body& b) {
    if constexpr (!kFull) {
        const auto& a = c.aerodynamics;
        const VF tau = constant(0.5f * in.h), half = constant(0.5f);
        const Vec3 rate = broadcast(c.inverse_mass);
        const Vec3 pull = scale(tau, times(rate, applied.v));
        const Vec3 r = add_scaled(b.t.v, half, pull);
        const Vec3 middle = relax_middle(r, scale(hn::Mul(tau, drag_rate(a, held.inverse_length, nu, r)), rate));
        b.t.v =
            each(relax_second, b.t.v, scale(hn::Mul(tau, drag_rate(a, held.inverse_length, nu, middle)), rate), pull);
    } else {
        drag_half_full(in, c, held, nu, applied, b);
    }
}

// A spin's resistance over a time: x along each axis, and `share` of the product of `axis` with itself.
struct Resistance {
    Vec3 x;
    Vec3 axis;
    VF share;
};
HWY_INLINE Vec3 resisted(const Resistance& d, Vec3 u) {
    return add_scaled(times(d.x, u), hn::Mul(d.share, dot(d.axis, u)), d.axis);
}

// (1 + X + quadratic X^2)^-1 r with X = N D.
template <class T> HWY_INLINE Vec3 solve_damped(const T* n, const Resistance& d, VF quadratic, Vec3 r) {
    // Columns of N D: those of N scaled, and N axis by the axis' entries.
    const Vec3 rolled = scale(d.share, symmetric3(n, d.axis));
    const Columns m{add_scaled(scale(d.x.x, Vec3{constant(n[0]), constant(n[1]), constant(n[2])}), d.axis.x, rolled),
                    add_scaled(scale(d.x.y, Vec3{constant(n[1]), constant(n[3]), constant(n[4])}), d.axis.y, rolled),
                    add_scaled(scale(d.x.z, Vec3{constant(n[2]), constant(n[4]), constant(n[5])}), d.axis.z, rolled)};
    const auto column = [&](Vec3 e, Vec3 xe) LR_LAMBDA {
        const Vec3 square = add(scale(xe.x, m.x), add(scale(xe.y, m.y), scale(xe.z, m.z)));
        return add(e, add_scaled(xe, quadratic, square));
    };
    const VF one = constant(1.0f), zero = hn::Zero(DF());
    return solve({column({one, zero, zero}, m.x), column({zero, one, zero}, m.y), column({zero, zero, one}, m.z)}, r);
}

// Roll damping of half a substep where the loads act at the centre of mass: exact but for exp(-x), as relax_second.
template <class C> HWY_INLINE Vec3 rolled_half(const C& c, const Roll& roll, VF tau, Vec3 u) {
    const Vec3 response = scaled_by(c.inverse_spin_mass, roll.axis);
    const VF rate = hn::Mul(tau, roll.rate);
    const VF x = hn::Min(hn::Mul(rate, dot(roll.axis, response)), constant(1e15f));
    const VF p = mul_add(x, constant(0.5f), constant(1.0f));
    const VF lost = hn::Div(hn::Mul(hn::Mul(rate, dot(roll.axis, u)), p), mul_add(x, p, constant(1.0f)));
    return sub(u, scale(lost, response));
}

HWY_INLINE Vec3 smaller(Vec3 a, Vec3 b) {
    return {hn::Min(a.x, b.x), hn::Min(a.y, b.y), hn::Min(a.z, b.z)};
}
// The couple of the lift acts at four moments, h/4 each: at the ends of the substep and on both sides of its middle. It is the
// load that turns most with the body, and one attitude for all of it was the largest error of the splitting.
inline constexpr float couple_share = 0.25f;
// A couple that makes the rim faster than this many times the stream acts longer than it does in truth: the body would have
// turned away. At the ends of a substep no spin drag acts against it.
inline constexpr float most_rim = 8.0f, most_rim_at_end = 1.0f;
HWY_INLINE Vec3 bounded_push(Vec3 push, VF s, float times_stream) {
    const VF most = hn::Mul(constant(times_stream), s), least = hn::Neg(most);
    const auto one = [&](VF x) LR_LAMBDA { return hn::Max(hn::Min(x, most), least); };
    return {one(push.x), one(push.y), one(push.z)};
}

template <bool kFull, class C>
HWY_INLINE void couple_at_end(const StepInput& in, const C& c, const Held& held, Body& b) {
    const auto& a = c.aerodynamics;
    Twist t = b.t;
    if (kFull && held.sheared) t.u = sub(t.u, to_body(b.q, held.fluid_spin));
    const Vec3 v = centre_velocity<kFull>(a, t);
    const VF s = hn::Sqrt(speed_squared(v));
    const Vec3 couple = scale(constant(couple_share * in.h), lift_moment(a, held.inverse_length, v));
    if constexpr (kFull)
        b.t = add(b.t, rows6(a.spin_response, bounded_push(symmetric3(a.spin_mobility, couple), s, most_rim_at_end)));
    else
        b.t.u = add(b.t.u, bounded_push(times(broadcast(c.inverse_spin_mass), couple), s, most_rim_at_end));
}

template <class C>
HWY_NOINLINE void spin_drag_half_full(const StepInput& in, const C& c, const Held& held, VF nu, Body& b) {
    const auto& a = c.aerodynamics;
    const VF tau = constant(0.5f * in.h), half = constant(0.5f), share = constant(couple_share * in.h);
    const Vec3 v = centre_velocity<true>(a, b.t);
    const VF s = hn::Sqrt(speed_squared(v));
    const Vec3 couple = scale(share, lift_moment(a, held.inverse_length, v));
    const Vec3 u = load_spin<true>(a, b.t);
    const auto* const n = a.spin_mobility;
    // The square of what is solved must stay finite.
    const auto resistance = [&](VF stream, Vec3 v_at, Vec3 u_at) LR_LAMBDA {
        const Roll roll = roll_damping(a, held.inverse_length, stream, v_at);
        const VF most = hn::Div(constant(1e4f), hn::Add(dot(roll.axis, symmetric3(n, roll.axis)), constant(1e-20f)));
        return Resistance{
            smaller(scale(tau, spin_drag_rate(a, held.inverse_length, nu, stream, u_at)), broadcast(a.spin_limit)),
            roll.axis, hn::Min(hn::Mul(tau, roll.rate), most)};
    };
    const Vec3 r = add_scaled(u, half, bounded_push(symmetric3(n, couple), s, most_rim));
    const Resistance first = resistance(s, v, r);
    // Half the rate in the middle, as in relax_middle; a rate on each axis as if that were a mode.
    const Vec3 eased = relax_middle(first.x, times(Vec3{constant(n[0]), constant(n[3]), constant(n[5])}, first.x));
    const Vec3 middle =
        solve_damped(n, {scale(half, eased), first.axis, hn::Mul(half, first.share)}, hn::Zero(DF()), r);
    // A couple moves a centre that lies off the centre of mass.
    const Vec3 v_middle = centre_velocity<true>(a, add(b.t, rows6(a.spin_response, sub(middle, u))));
    const VF s_middle = hn::Sqrt(speed_squared(v_middle));
    const Vec3 push =
        bounded_push(symmetric3(n, scale(share, lift_moment(a, held.inverse_length, v_middle))), s_middle, most_rim);
    const Resistance x = resistance(s_middle, v_middle, middle);
    // u1 = (1 + X + X^2/2)^-1 (u0 + (1 + X/2) push)
    const Vec3 more = symmetric3(n, resisted(x, push));
    const Vec3 after = solve_damped(n, x, half, add(u, add_scaled(push, half, more)));
    b.t = add(b.t, rows6(a.spin_response, sub(after, u)));
}

// On the diagonal path roll damping is a part of its own, next to the lift on both sides.
template <bool kFull, bool kBeforeLift, class C>
HWY_INLINE void spin_drag_half(const StepInput& in, const C& c, const Held& held, VF nu, const Twist& applied,
                               Body& b) {
    if constexpr (kFull) {
        spin_drag_half_full(in, c, held, nu, b);
    } else {
        const auto& a = c.aerodynamics;
        const VF tau = constant(0.5f * in.h), half = constant(0.5f), share = constant(couple_share * in.h);
        const Vec3 v = centre_velocity<false>(a, b.t);
        const VF s = hn::Sqrt(speed_squared(v));
        const Vec3 couple = scale(share, lift_moment(a, held.inverse_length, v));
        const Roll roll = roll_damping(a, held.inverse_length, s, v);
        const Vec3 u = kBeforeLift ? b.t.u : rolled_half(c, roll, tau, b.t.u);
        const Vec3 rate = broadcast(c.inverse_spin_mass),
                   push = add_scaled(bounded_push(times(rate, couple), s, most_rim), tau, times(rate, applied.u));
        const Vec3 r = add_scaled(u, half, push);
        const Vec3 first = scale(tau, spin_drag_rate(a, held.inverse_length, nu, s, r));
        const Vec3 middle = relax_middle(r, times(rate, first));
        const Vec3 x = scale(tau, spin_drag_rate(a, held.inverse_length, nu, s, middle));
        b.t.u = each(relax_second, u, times(rate, x), push);
        if constexpr (kBeforeLift) b.t.u = rolled_half(c, roll, tau, b.t.u);
    }
}

// The middle of the implicit midpoint for v' = N (2 k) x v: (1 - N [k]x)^-1 v = (v + N (k x v) + (k.a v) k)/(1 + k.a k),
// a the adjugate of N; a rotation where N is the unit matrix.
template <bool kFull, class C> HWY_INLINE Vec3 lifted_middle(const C& c, Vec3 k, Vec3 v) {
    const auto& a = c.aerodynamics;
    const Vec3 kv = cross(k, v);
    Vec3 ak, moved;
    if constexpr (kFull) {
        ak = symmetric3(a.mobility_adjugate, k);
        moved = symmetric3(a.mobility, kv);
    } else {
        ak = {hn::Mul(hn::Mul(constant(c.inverse_mass[1]), constant(c.inverse_mass[2])), k.x),
              hn::Mul(hn::Mul(constant(c.inverse_mass[2]), constant(c.inverse_mass[0])), k.y),
              hn::Mul(hn::Mul(constant(c.inverse_mass[0]), constant(c.inverse_mass[1])), k.z)};
        moved = scaled_by(c.inverse_mass, kv);
    }
    const VF inverse = hn::Div(constant(1.0f), hn::Add(constant(1.0f), dot(ak, k)));
    return scale(inverse, add_scaled(add(v, moved), dot(ak, v), k));
}

// Lift does no work, whatever the circulation: force g x v_middle of the implicit midpoint keeps the energy at any step.
// The circulation is that of the middle to which the one at the start leads.
template <bool kFull, class C>
HWY_INLINE void lift_step(const StepInput& in, const C& c, const Held& held, VF nu, Body& b) {
    const auto& a = c.aerodynamics;
    const VF half = constant(0.5f * in.h);
    const Vec3 v = centre_velocity<kFull>(a, b.t), u = load_spin<kFull>(a, b.t);
    // Beyond this the velocity turns through more than can be resolved.
    const auto bounded = [&](Vec3 g) LR_LAMBDA {
        const VF most = constant(5e3f), least = constant(-5e3f);
        return Vec3{hn::Max(hn::Min(g.x, most), least), hn::Max(hn::Min(g.y, most), least),
                    hn::Max(hn::Min(g.z, most), least)};
    };
    const Vec3 start = bounded(scale(half, circulation(a, held.inverse_length, nu, v, u)));
    const Vec3 v_start = lifted_middle<kFull>(c, start, v);
    Vec3 u_middle = u;
    if constexpr (kFull) u_middle = add(u, rows(a.axes, rows(a.response + 9, cross(start, v_start))));
    const Vec3 k = bounded(scale(half, circulation(a, held.inverse_length, nu, v_start, u_middle)));
    const Vec3 half_impulse = cross(k, lifted_middle<kFull>(c, k, v));
    const Vec3 impulse = add(half_impulse, half_impulse);
    if constexpr (kFull)
        b.t = add(b.t, rows6(a.response, impulse));
    else
        b.t.v = add(b.t.v, scaled_by(c.inverse_mass, impulse));
}

// Weight, buoyancy and what acts from outside, in the body frame. A torque acts with the drag on the full path, where it
// moves the centre of the loads, and with the spin drag on the diagonal one.
template <bool kFull, class C> HWY_INLINE Twist applied_loads(const C& c, const Held& held, Quaternion q) {
    const VF zero = hn::Zero(DF());
    Twist f{to_body(q, held.weight), {zero, zero, zero}};
    if constexpr (kFull) f.u = cross(broadcast(c.buoyancy), to_body(q, held.gravity));
    if (held.external) f = add(f, external_force<kFull>(c, *held.external, q));
    return f;
}

// Free motion errs most, and its error grows with the square of its step: it takes the two outer places, the loads the
// middle one.
template <bool kFull, class C>
HWY_INLINE void aerodynamic_splitting_substep(const StepInput& in, const C& c, const Held& held, Body& b) {
    const VF nu = hn::Mul(constant(c.aerodynamics.viscosity), held.inverse_length);
    couple_at_end<kFull>(in, c, held, b);
    free_step<kFull, true>(0.5f * in.h, c, held, b);
    const Twist applied = applied_loads<kFull>(c, held, b.q);
    // Loads are those of the spin through the fluid.
    if (held.sheared) b.t.u = sub(b.t.u, to_body(b.q, held.fluid_spin));
    drag_half<kFull>(in, c, held, nu, applied, b);
    spin_drag_half<kFull, true>(in, c, held, nu, applied, b);
    lift_step<kFull>(in, c, held, nu, b);
    spin_drag_half<kFull, kFull>(in, c, held, nu, applied, b);
    drag_half<kFull>(in, c, held, nu, applied, b);
    if (held.sheared) b.t.u = add(b.t.u, to_body(b.q, held.fluid_spin));
    free_step<kFull, true>(0.5f * in.h, c, held, b);
    couple_at_end<kFull>(in, c, held, b);
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
