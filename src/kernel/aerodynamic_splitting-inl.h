// The splitting scheme's substep with quasi-steady loads: free motion, drag and weight, spin drag, lift, and back
// (docs/maintainers/numerics.md, "AERODYNAMIC loads").
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
// In its middle, m = r/(1 + e), where r is y and half of tau f: as if the rate grew with y, x/tau being that at r,
// m (1 + x m/(2 r)) = r. An x taken at y instead would leave y as it is where x is large, and a body at rest there for long.
HWY_INLINE VF eased(VF x) {
    return hn::Div(x, hn::Add(constant(1.0f), hn::Sqrt(mul_add(constant(2.0f), x, constant(1.0f)))));
}
HWY_INLINE Vec3 eased(Vec3 x) {
    return {eased(x.x), eased(x.y), eased(x.z)};
}
HWY_INLINE VF over_one_and(VF r, VF e) {
    return hn::Div(r, hn::Add(constant(1.0f), e));
}
HWY_INLINE Vec3 over_one_and(Vec3 r, Vec3 e) {
    return {over_one_and(r.x, e.x), over_one_and(r.y, e.y), over_one_and(r.z, e.z)};
}
// relax_middle(r, x) is r/(1 + eased(x)) with one division.
HWY_INLINE VF relax_middle(VF r, VF x) {
    return hn::Div(hn::Add(r, r), hn::Add(constant(1.0f), hn::Sqrt(mul_add(constant(2.0f), x, constant(1.0f)))));
}
HWY_INLINE Vec3 relax_middle(Vec3 r, Vec3 x) {
    return {relax_middle(r.x, x.x), relax_middle(r.y, x.y), relax_middle(r.z, x.z)};
}
HWY_INLINE Vec3 each(VF (*f)(VF, VF, VF), Vec3 y, Vec3 x, Vec3 tau_f) {
    return {f(y.x, x.x, tau_f.x), f(y.y, x.y, tau_f.y), f(y.z, x.z, tau_f.z)};
}

// Twist of the body about the centre of the loads, along their axes; of both halves of the loads.
struct Pull {
    Twist t;    // what weight, buoyancy and external forces give in half a substep
    Vec3 modes; // full path: its velocity along the modes of the mobility
};
// Rates in the middle of a half. The other half finds its own middle with them: of second order, and at rest where these are.
struct Rates {
    VF drag;
    Vec3 spin;
};

// Drag opposes the velocity with one factor in all directions, so that the modes of the mobility P M^-1 P^T decay on
// their own, each towards its terminal velocity.
// The full path's halves are not inlined: each is there twice, and a substep would not fit into the instruction cache.
template <class C>
static HWY_NOINLINE void drag_half_full(const StepInput& in, const C& c, const Held& held, VF nu, const Pull& pull,
                                        bool before_lift, Rates& rates, Twist& t) {
    const auto& a = c.aerodynamics;
    const VF tau = constant(0.5f * in.h), half = constant(0.5f);
    const Vec3 rate = scale(tau, broadcast(a.rate)), y = columns(a.modes, t.v);
    const Vec3 r = add_scaled(y, half, pull.modes);
    Vec3 middle;
    if (before_lift) {
        const VF at_r = drag_rate(a, held.inverse_length, nu, add_scaled(t.v, half, pull.t.v));
        middle = relax_middle(r, scale(at_r, rate));
    } else {
        middle = over_one_and(r, scale(hn::Mul(half, rates.drag), rate));
    }
    rates.drag = drag_rate(a, held.inverse_length, nu, rows(a.modes, middle));
    const Vec3 after = each(relax_second, y, scale(rates.drag, rate), pull.modes);
    const Vec3 lost = rows(a.modes, sub(sub(after, y), pull.modes));
    t = add(t, add(pull.t, {lost, rows(a.spin_of_force, lost)}));
}
template <bool kFull, bool kBeforeLift, class C>
HWY_INLINE void drag_half(const StepInput& in, const C& c, const Held& held, VF nu, const Pull& pull, Rates& rates,
                          Twist& t) {
    if constexpr (!kFull) {
        const VF tau = constant(0.5f * in.h), half = constant(0.5f);
        const Vec3 rate = scale(tau, broadcast(c.inverse_mass));
        const Vec3 r = add_scaled(t.v, half, pull.t.v);
        Vec3 middle;
        if constexpr (kBeforeLift)
            middle = relax_middle(r, scale(drag_rate(c.aerodynamics, held.inverse_length, nu, r), rate));
        else
            middle = over_one_and(r, scale(hn::Mul(half, rates.drag), rate));
        rates.drag = drag_rate(c.aerodynamics, held.inverse_length, nu, middle);
        t.v = each(relax_second, t.v, scale(rates.drag, rate), pull.t.v);
    } else {
        drag_half_full(in, c, held, nu, pull, kBeforeLift, rates, t);
    }
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
    const VF rate = hn::Mul(tau, roll.rate);
    const VF x = hn::Min(hn::Mul(rate, dot(roll.axis, response)), constant(1e15f));
    const VF p = mul_add(x, constant(0.5f), constant(1.0f));
    const VF lost = hn::Div(hn::Mul(hn::Mul(rate, dot(roll.axis, u)), p), mul_add(x, p, constant(1.0f)));
    return sub(u, scale(lost, response));
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
    const Vec3 push = bounded_push(spin_mobility<kFull>(c, couple), s, most_rim_at_end);
    if constexpr (kFull)
        b.t = add(b.t, rows6(a.spin_response, push));
    else
        b.t.u = add(b.t.u, push);
}

// Spin along one axis under the couple and the drag along it, to which all spin answers: N e of it, here over e.N e. One
// axis after the other, and backwards in the other half, is of second order, contracts in the norm of N^-1, and rests where couple
// and drag agree along every axis, whatever the step.
template <int kAxis, class T> HWY_INLINE Vec3 answering(const T* n, VF change, Vec3 u) {
    if constexpr (kAxis == 0)
        return {hn::Add(u.x, change), mul_add(constant(n[0]), change, u.y), mul_add(constant(n[1]), change, u.z)};
    if constexpr (kAxis == 1)
        return {mul_add(constant(n[2]), change, u.x), hn::Add(u.y, change), mul_add(constant(n[3]), change, u.z)};
    return {mul_add(constant(n[4]), change, u.x), mul_add(constant(n[5]), change, u.y), hn::Add(u.z, change)};
}
template <int kAxis, class T> HWY_INLINE Vec3 relax_axis(const T* n, VF x, VF push, Vec3 u) {
    const VF y = kAxis == 0 ? u.x : kAxis == 1 ? u.y : u.z;
    x = hn::Min(x, constant(1e15f));
    const VF p = mul_add(x, constant(0.5f), constant(1.0f));
    return answering<kAxis>(n, hn::Mul(neg_mul_add(x, y, push), hn::Div(p, mul_add(x, p, constant(1.0f)))), u);
}

template <class C>
static HWY_NOINLINE void spin_drag_half_full(const StepInput& in, const C& c, const Held& held, VF nu, bool before_lift,
                                             Rates& rates, Twist& t) {
    const auto& a = c.aerodynamics;
    const auto* const n = a.spin_answer;
    const VF tau = constant(0.5f * in.h), half = constant(0.5f);
    const Vec3 own = spin_mobility<true>(c), share = scale(constant(couple_share * in.h), own), rate = scale(tau, own);
    const auto push_in = [&](Vec3 v, VF s) LR_LAMBDA {
        return bounded_push(times(share, lift_moment(a, held.inverse_length, v)), s, most_rim);
    };
    const VF s = hn::Sqrt(speed_squared(t.v));
    const Vec3 first = scale(half, push_in(t.v, s));
    const Vec3 r = answering<2>(n, first.z, answering<1>(n, first.y, answering<0>(n, first.x, t.u)));
    Vec3 e = scale(half, times(rate, rates.spin));
    if (before_lift) e = eased(times(rate, spin_drag_rate(a, held.inverse_length, nu, s, r)));
    const auto lost = [&](VF y, VF by) LR_LAMBDA { return hn::Neg(over_one_and(hn::Mul(y, by), by)); };
    Vec3 middle = answering<0>(n, lost(r.x, e.x), r);
    middle = answering<1>(n, lost(middle.y, e.y), middle);
    middle = answering<2>(n, lost(middle.z, e.z), middle);
    // A couple moves a centre that lies off the centre of mass.
    const Vec3 v = add(t.v, rows(a.velocity_of_couple, sub(middle, t.u)));
    const VF speed = hn::Sqrt(speed_squared(v));
    const Vec3 push = push_in(v, speed);
    const Roll roll = roll_damping(a, held.inverse_length, speed, v);
    rates.spin = spin_drag_rate(a, held.inverse_length, nu, speed, middle);
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
    t.v = add(t.v, rows(a.velocity_of_couple, sub(u, t.u)));
    t.u = u;
}

// Roll damping is a part of its own, next to the lift on both sides.
template <bool kFull, bool kBeforeLift, class C>
HWY_INLINE void spin_drag_half(const StepInput& in, const C& c, const Held& held, VF nu, const Pull& pull, Rates& rates,
                               Twist& t) {
    if constexpr (kFull) {
        spin_drag_half_full(in, c, held, nu, kBeforeLift, rates, t);
    } else {
        const auto& a = c.aerodynamics;
        const VF tau = constant(0.5f * in.h), half = constant(0.5f), share = constant(couple_share * in.h);
        const VF s = hn::Sqrt(speed_squared(t.v));
        const Vec3 couple = scale(share, lift_moment(a, held.inverse_length, t.v));
        const Roll roll = roll_damping(a, held.inverse_length, s, t.v);
        const Vec3 u = kBeforeLift ? t.u : rolled_half<false>(c, roll, tau, t.u);
        const Vec3 rate = spin_mobility<false>(c), push = add(bounded_push(times(rate, couple), s, most_rim), pull.t.u);
        const Vec3 r = add_scaled(u, half, push);
        Vec3 middle;
        if constexpr (kBeforeLift)
            middle = relax_middle(r, times(rate, scale(tau, spin_drag_rate(a, held.inverse_length, nu, s, r))));
        else
            middle = over_one_and(r, times(rate, scale(hn::Mul(half, tau), rates.spin)));
        rates.spin = spin_drag_rate(a, held.inverse_length, nu, s, middle);
        t.u = each(relax_second, u, times(rate, scale(tau, rates.spin)), push);
        if constexpr (kBeforeLift) t.u = rolled_half<false>(c, roll, tau, t.u);
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
HWY_INLINE void lift_step(const StepInput& in, const C& c, const Held& held, VF nu, Twist& t) {
    const auto& a = c.aerodynamics;
    const VF half = constant(0.5f * in.h);
    const Vec3 v = t.v, u = t.u;
    // Beyond this the velocity turns through more than can be resolved.
    const auto bounded = [&](Vec3 g) LR_LAMBDA {
        const VF most = constant(5e3f), least = constant(-5e3f);
        return Vec3{hn::Max(hn::Min(g.x, most), least), hn::Max(hn::Min(g.y, most), least),
                    hn::Max(hn::Min(g.z, most), least)};
    };
    const Vec3 start = bounded(scale(half, circulation(a, held.inverse_length, nu, v, u)));
    const Vec3 v_start = lifted_middle<kFull>(c, start, v);
    Vec3 u_middle = u;
    if constexpr (kFull) u_middle = add(u, rows(a.spin_response_to_force, cross(start, v_start)));
    const Vec3 k = bounded(scale(half, circulation(a, held.inverse_length, nu, v_start, u_middle)));
    const Vec3 half_impulse = cross(k, lifted_middle<kFull>(c, k, v));
    const Vec3 impulse = add(half_impulse, half_impulse);
    if constexpr (kFull)
        t = add(t, {symmetric3(a.mobility, impulse), rows(a.spin_response_to_force, impulse)});
    else
        t.v = add(t.v, scaled_by(c.inverse_mass, impulse));
}

// What weight, buoyancy and what acts from outside give. A torque acts with the drag on the full path, where it moves the
// centre of the loads, and with the spin drag on the diagonal one.
template <bool kFull, class C>
HWY_INLINE Pull pull_of(const StepInput& in, const C& c, const Held& held, Quaternion q) {
    const VF zero = hn::Zero(DF()), tau = constant(0.5f * in.h);
    if constexpr (!kFull) {
        Twist f{to_body(q, held.weight), {zero, zero, zero}};
        if (held.external) f = add(f, external_force<false>(c, *held.external, q));
        const Twist t = scale(tau, acceleration<false>(c, f));
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
        if (held.external) t = add(t, answer(external_force<true>(c, *held.external, q)));
    } else {
        Twist f{to_body(q, held.weight), cross(broadcast(c.buoyancy), gravity)};
        if (held.external) f = add(f, external_force<true>(c, *held.external, q));
        t = answer(f);
    }
    t = scale(tau, t);
    return {t, columns(a.modes, t.v)};
}

template <bool kFull, class C>
HWY_INLINE void loads_in_middle(const StepInput& in, const C& c, const Held& held, VF nu, Body& b) {
    const Pull pull = pull_of<kFull>(in, c, held, b.q);
    // Loads are those of the spin through the fluid.
    if (held.sheared) b.t.u = sub(b.t.u, to_body(b.q, held.fluid_spin));
    const auto& a = c.aerodynamics;
    const Twist before{centre_velocity<kFull>(a, b.t), load_spin<kFull>(a, b.t)};
    Twist t = before;
    const VF zero = hn::Zero(DF());
    Rates rates{zero, {zero, zero, zero}};
    drag_half<kFull, true>(in, c, held, nu, pull, rates, t);
    spin_drag_half<kFull, true>(in, c, held, nu, pull, rates, t);
    lift_step<kFull>(in, c, held, nu, t);
    spin_drag_half<kFull, false>(in, c, held, nu, pull, rates, t);
    drag_half<kFull, false>(in, c, held, nu, pull, rates, t);
    if constexpr (kFull) {
        // The change only: a frame and back costs a rounding each time.
        const Vec3 u = columns(a.axes, sub(t.u, before.u));
        b.t = add(b.t, {sub(columns(a.axes, sub(t.v, before.v)), cross(u, broadcast(a.arm))), u});
    } else {
        b.t = t;
    }
    if (held.sheared) b.t.u = add(b.t.u, to_body(b.q, held.fluid_spin));
}

// Free motion errs most, and its error grows with the square of its step: it takes the two outer places, the loads the
// middle one.
template <bool kFull, class C>
HWY_INLINE void aerodynamic_splitting_substep(const StepInput& in, const C& c, const Held& held, Body& b) {
    const VF nu = hn::Mul(constant(c.aerodynamics.viscosity), held.inverse_length);
    couple_at_end<kFull>(in, c, held, b);
    free_step<kFull, true>(0.5f * in.h, c, held, b);
    loads_in_middle<kFull>(in, c, held, nu, b);
    free_step<kFull, true>(0.5f * in.h, c, held, b);
    couple_at_end<kFull>(in, c, held, b);
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
