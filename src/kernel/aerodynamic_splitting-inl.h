// The splitting scheme's substep with quasi-steady loads: drag and weight, spin drag, lift, free motion, and back
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
// The same by backward Euler over half of it: an estimate of the middle.
HWY_INLINE VF relax_half(VF y, VF x, VF tau_f) {
    return hn::Div(mul_add(constant(0.5f), tau_f, y), mul_add(x, constant(0.5f), constant(1.0f)));
}
HWY_INLINE Vec3 each(VF (*f)(VF, VF, VF), Vec3 y, Vec3 x, Vec3 tau_f) {
    return {f(y.x, x.x, tau_f.x), f(y.y, x.y, tau_f.y), f(y.z, x.z, tau_f.z)};
}

// Drag opposes the velocity with one factor in all directions, so that the modes of the mobility P M^-1 P^T decay on
// their own, each towards its terminal velocity.
template <bool kFull, class C>
HWY_INLINE void drag_half(const StepInput& in, const C& c, const Held& held, VF nu, Twist applied, Body& b) {
    const auto& a = c.aerodynamics;
    const VF tau = constant(0.5f * in.h);
    if constexpr (!kFull) {
        const Vec3 rate = broadcast(c.inverse_mass);
        const Vec3 pull = scale(tau, times(rate, applied.v));
        const Vec3 x = scale(hn::Mul(tau, drag_rate(a, held.inverse_length, nu, b.t.v)), rate);
        const Vec3 middle = each(relax_half, b.t.v, x, pull);
        b.t.v =
            each(relax_second, b.t.v, scale(hn::Mul(tau, drag_rate(a, held.inverse_length, nu, middle)), rate), pull);
    } else {
        const Twist pull = scale(tau, acceleration<true>(c, applied));
        const Vec3 v = centre_velocity<true>(a, b.t), rate = broadcast(a.rate);
        const Vec3 y = columns(a.modes, v), push = columns(a.modes, centre_velocity<true>(a, pull));
        const Vec3 x = scale(hn::Mul(tau, drag_rate(a, held.inverse_length, nu, v)), rate);
        const Vec3 middle = rows(a.modes, each(relax_half, y, x, push));
        const Vec3 after =
            each(relax_second, y, scale(hn::Mul(tau, drag_rate(a, held.inverse_length, nu, middle)), rate), push);
        b.t = add(b.t, add(pull, rows6(a.from_modes, sub(sub(after, y), push))));
    }
}

// (1 + X)^-1 r with X = tau N D, D diagonal: the columns of N scaled.
template <class T> HWY_INLINE Vec3 solve_damped(const T* n, Vec3 x, VF quadratic, Vec3 r) {
    // Columns of N, scaled by tau times the rate of each axis.
    const Columns m{scale(x.x, Vec3{constant(n[0]), constant(n[1]), constant(n[2])}),
                    scale(x.y, Vec3{constant(n[1]), constant(n[3]), constant(n[4])}),
                    scale(x.z, Vec3{constant(n[2]), constant(n[4]), constant(n[5])})};
    // 1 + X + quadratic X^2, column by column.
    const auto column = [&](Vec3 e, Vec3 xe) HWY_ATTR {
        const Vec3 square = add(scale(xe.x, m.x), add(scale(xe.y, m.y), scale(xe.z, m.z)));
        return add(e, add_scaled(xe, quadratic, square));
    };
    const VF one = constant(1.0f), zero = hn::Zero(DF());
    return solve({column({one, zero, zero}, m.x), column({zero, one, zero}, m.y), column({zero, zero, one}, m.z)}, r);
}

HWY_INLINE Vec3 smaller(Vec3 a, Vec3 b) {
    return {hn::Min(a.x, b.x), hn::Min(a.y, b.y), hn::Min(a.z, b.z)};
}
// A couple that makes the rim faster than this many times the stream within half a substep acts longer than it does in
// truth: the body would have turned away.
HWY_INLINE Vec3 bounded_push(Vec3 push, VF s) {
    const VF most = hn::Mul(constant(8.0f), s), least = hn::Neg(most);
    const auto one = [&](VF x) HWY_ATTR { return hn::Max(hn::Min(x, most), least); };
    return {one(push.x), one(push.y), one(push.z)};
}

template <bool kFull, class C>
HWY_INLINE void spin_drag_half(const StepInput& in, const C& c, const Held& held, VF nu, Twist applied, Body& b) {
    const auto& a = c.aerodynamics;
    const VF tau = constant(0.5f * in.h);
    const Vec3 v = centre_velocity<kFull>(a, b.t), u = load_spin<kFull>(a, b.t);
    const VF s = hn::Sqrt(speed_squared(v));
    const Vec3 couple = scale(tau, lift_moment(a, held.inverse_length, v));
    const Vec3 first = scale(tau, spin_drag_rate(a, held.inverse_length, nu, s, u));
    if constexpr (!kFull) {
        const Vec3 rate = broadcast(c.inverse_spin_mass),
                   push = add_scaled(bounded_push(times(rate, couple), s), tau, times(rate, applied.u));
        const Vec3 middle = each(relax_half, u, times(rate, first), push);
        const Vec3 x = scale(tau, spin_drag_rate(a, held.inverse_length, nu, s, middle));
        b.t.u = each(relax_second, u, times(rate, x), push);
    } else {
        // The square of what is solved must stay finite.
        const auto bounded = [&](Vec3 x) HWY_ATTR { return smaller(x, broadcast(a.spin_limit)); };
        const VF half = constant(0.5f);
        const Vec3 middle = solve_damped(a.spin_mobility, scale(half, bounded(first)), hn::Zero(DF()),
                                         add_scaled(u, half, bounded_push(symmetric3(a.spin_mobility, couple), s)));
        // A couple moves a centre that lies off the centre of mass.
        const Vec3 v_middle = centre_velocity<true>(a, add(b.t, rows6(a.spin_response, sub(middle, u))));
        const VF s_middle = hn::Sqrt(speed_squared(v_middle));
        const Vec3 push = bounded_push(
            symmetric3(a.spin_mobility, scale(tau, lift_moment(a, held.inverse_length, v_middle))), s_middle);
        const Vec3 x = bounded(scale(tau, spin_drag_rate(a, held.inverse_length, nu, s_middle, middle)));
        // u1 = (1 + X + X^2/2)^-1 (u0 + (1 + X/2) push)
        const Vec3 more = symmetric3(a.spin_mobility, times(x, push));
        const Vec3 after = solve_damped(a.spin_mobility, x, half, add(u, add_scaled(push, half, more)));
        b.t = add(b.t, rows6(a.spin_response, sub(after, u)));
    }
}

// Lift does no work, whatever the circulation: with f = g x (v + N f/2), the implicit midpoint keeps the energy at any
// step. The circulation is that of an explicit estimate of the middle.
template <bool kFull, class C>
HWY_INLINE void lift_half(const StepInput& in, const C& c, const Held& held, VF nu, Body& b) {
    const auto& a = c.aerodynamics;
    const VF tau = constant(0.5f * in.h), half = constant(0.5f);
    const auto moved = [&](Vec3 f) HWY_ATTR {
        if constexpr (kFull) return symmetric3(a.mobility, f);
        return scaled_by(c.inverse_mass, f);
    };
    const Vec3 v = centre_velocity<kFull>(a, b.t), u = load_spin<kFull>(a, b.t);
    // Beyond this the velocity turns through more than can be resolved.
    const auto bounded = [&](Vec3 g) HWY_ATTR {
        const VF most = constant(1e4f), least = constant(-1e4f);
        return Vec3{hn::Max(hn::Min(g.x, most), least), hn::Max(hn::Min(g.y, most), least),
                    hn::Max(hn::Min(g.z, most), least)};
    };
    const Vec3 start = bounded(scale(tau, circulation(a, held.inverse_length, nu, v, u)));
    Vec3 v_middle, u_middle = u;
    if constexpr (kFull) {
        const Twist middle = add(b.t, rows6(a.response, scale(half, cross(start, v))));
        v_middle = centre_velocity<true>(a, middle);
        u_middle = load_spin<true>(a, middle);
    } else {
        v_middle = add_scaled(v, half, moved(cross(start, v)));
    }
    const Vec3 g = bounded(scale(tau, circulation(a, held.inverse_length, nu, v_middle, u_middle)));
    const Vec3 k = scale(half, g);
    const Vec3 r = cross(g, v);
    const VF one = constant(1.0f), zero = hn::Zero(DF());
    if constexpr (!kFull) {
        // 1 - [k]x N with N diagonal.
        const VF nx = constant(c.inverse_mass[0]), ny = constant(c.inverse_mass[1]), nz = constant(c.inverse_mass[2]);
        const Columns m{{one, hn::Neg(hn::Mul(k.z, nx)), hn::Mul(k.y, nx)},
                        {hn::Mul(k.z, ny), one, hn::Neg(hn::Mul(k.x, ny))},
                        {hn::Neg(hn::Mul(k.y, nz)), hn::Mul(k.x, nz), one}};
        b.t.v = add(v, moved(solve(m, r)));
    } else {
        const auto* const n = a.mobility;
        const auto column = [&](Vec3 e, Vec3 ne) HWY_ATTR { return sub(e, cross(k, ne)); };
        const Columns m{column({one, zero, zero}, {constant(n[0]), constant(n[1]), constant(n[2])}),
                        column({zero, one, zero}, {constant(n[1]), constant(n[3]), constant(n[4])}),
                        column({zero, zero, one}, {constant(n[2]), constant(n[4]), constant(n[5])})};
        b.t = add(b.t, rows6(a.response, solve(m, r)));
    }
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

template <bool kFull, class C>
HWY_INLINE void aerodynamic_splitting_substep(const StepInput& in, const C& c, const Held& held, Body& b) {
    const VF nu = hn::Mul(constant(c.aerodynamics.viscosity), held.inverse_length);
    const Twist before = applied_loads<kFull>(c, held, b.q);
    // Loads are those of the spin through the fluid.
    if (held.sheared) b.t.u = sub(b.t.u, to_body(b.q, held.fluid_spin));
    drag_half<kFull>(in, c, held, nu, before, b);
    spin_drag_half<kFull>(in, c, held, nu, before, b);
    lift_half<kFull>(in, c, held, nu, b);
    if (held.sheared) b.t.u = add(b.t.u, to_body(b.q, held.fluid_spin));
    free_step<kFull>(in, c, held, b);
    const Twist after = applied_loads<kFull>(c, held, b.q);
    if (held.sheared) b.t.u = sub(b.t.u, to_body(b.q, held.fluid_spin));
    lift_half<kFull>(in, c, held, nu, b);
    spin_drag_half<kFull>(in, c, held, nu, after, b);
    drag_half<kFull>(in, c, held, nu, after, b);
    if (held.sheared) b.t.u = add(b.t.u, to_body(b.q, held.fluid_spin));
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
