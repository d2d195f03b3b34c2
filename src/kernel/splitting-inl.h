// The default scheme: half a step of damping, weight and noise, exactly; a step of Kirchhoff's equations without loads,
// by a linearly implicit midpoint that keeps their energy; the other half (docs/maintainers/numerics.md). Stable whatever the step:
// the first part contracts towards its own equilibrium, the second neither gains nor loses.
#if defined(LR_KERNEL_SPLITTING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_SPLITTING_INL_H_
#undef LR_KERNEL_SPLITTING_INL_H_
#else
#define LR_KERNEL_SPLITTING_INL_H_
#endif

#include "kernel/free_motion-inl.h"
#include "kernel/motion-inl.h"
#include "kernel/step.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

HWY_INLINE Vec3 mul(Vec3 a, Vec3 b) {
    return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)};
}
HWY_INLINE Twist mul(Twist a, Twist b) {
    return {mul(a.v, b.v), mul(a.u, b.u)};
}
HWY_INLINE Twist scale(VF s, Twist a) {
    return {scale(s, a.v), scale(s, a.u)};
}
template <class T> HWY_INLINE Twist broadcast6(const T* v) {
    return {broadcast(v), broadcast(v + 3)};
}

// m t or m^T t for a full 6x6 matrix.
template <bool kTransposed, class T> HWY_INLINE Twist general6(const T* m, Twist t) {
    const VF in[6] = {t.v.x, t.v.y, t.v.z, t.u.x, t.u.y, t.u.z};
    VF out[6];
    for (int i = 0; i < 6; ++i) {
        VF sum = hn::Mul(constant(m[kTransposed ? i : 6 * i]), in[0]);
        for (int j = 1; j < 6; ++j) sum = mul_add(constant(m[kTransposed ? 6 * j + i : 6 * i + j]), in[j], sum);
        out[i] = sum;
    }
    return {{out[0], out[1], out[2]}, {out[3], out[4], out[5]}};
}

// Modes in which mass is the unit matrix and damping diagonal.
template <class C> HWY_INLINE Twist to_modes(const C& c, Twist t) {
    return general6<false>(c.to_modes, t);
}
template <class C> HWY_INLINE Twist from_modes(const C& c, Twist y) {
    return general6<false>(c.from_modes, y);
}
template <class C> HWY_INLINE Twist force_to_modes(const C& c, Twist f) {
    return general6<true>(c.from_modes, f);
}

// 1 + x + x^2/2 + x^3/6 and (1 + x/2 + x^2/6): exp(-x) = 1/D and (1 - exp(-x))/x = C/D to third order, both with the
// right limits as x grows, so that a stiff body settles at its terminal velocity instead of ringing.
struct Relaxation {
    VF c, d;
};
HWY_INLINE Relaxation relaxation(VF x) {
    x = hn::Min(x, constant(1e10f)); // D stays finite
    const VF sixth = hn::Mul(x, constant(1.0f / 6.0f));
    const VF c = mul_add(x, hn::Add(constant(0.5f), sixth), constant(1.0f));
    return {c, mul_add(x, c, constant(1.0f))};
}

// Of the noise that leaves a mode's stationary variance exact, over h/4: over the whole step exp(-2x) = 1/D^2; variance
// (1 - 1/D^4)/(4x) without the cancellation, as D - 1 = x C.
HWY_INLINE VF quadruple_variance(const Relaxation& r, VF inverse) {
    const VF one = constant(1.0f);
    return hn::Mul(hn::Mul(r.c, inverse), hn::Mul(hn::Add(one, inverse), mul_add(inverse, inverse, one)));
}

// One mode: y' = -x/tau y + f over tau, and the noise that leaves its stationary variance exact. `kick` is the noise
// force times sqrt(2 tau).
template <bool kNoise> HWY_INLINE VF relax(VF y, VF x, VF tau_f, VF kick) {
    const Relaxation r = relaxation(x);
    const VF inverse = hn::Div(constant(1.0f), r.d);
    const VF still = hn::Mul(mul_add(tau_f, r.c, y), inverse);
    if constexpr (!kNoise) return still;
    return mul_add(kick, hn::Sqrt(hn::Mul(constant(0.25f), quadruple_variance(r, inverse))), still);
}

// A body whose axes are its modes. gauss is read only with noise.
template <bool kNoise, class C>
HWY_INLINE void load_half_diagonal(const StepInput& in, const C& c, const Held& held, VF beta_unit, const VF gauss[6],
                                   Body& b) {
    const VF one = constant(1.0f), half = constant(0.5f), tau = constant(0.5f * in.h);
    const Vec3 mobility = scale(tau, broadcast(c.inverse_mass)),
               spin_mobility = scale(tau, broadcast(c.inverse_spin_mass));
    Vec3 pull = mul(mobility, to_body(b.q, held.weight)), couple{};
    if (held.external) {
        const Twist f = external_force<false>(c, *held.external, b.q);
        pull = add(pull, mul(mobility, f.v));
        couple = mul(spin_mobility, f.u);
    }
    if (HWY_UNLIKELY(in.loads == Loads::none)) {
        b.t.v = add(b.t.v, pull);
        if (held.external) b.t.u = add(b.t.u, couple);
        return;
    }
    // Damping is towards the fluid's own rotation: relax the spin through the fluid.
    Vec3 fluid_spin{};
    if (held.sheared) {
        fluid_spin = to_body(b.q, held.fluid_spin);
        b.t.u = sub(b.t.u, fluid_spin);
    }
    const Vec3 rate = broadcast(c.rate), spin_rate = broadcast(c.rate + 3);
    VF share, beta = held.beta; // alpha tau
    if (HWY_LIKELY(in.clock == Clock::speed)) {
        // Speed in the middle of the half step, estimated implicitly: it makes the damping of second order.
        const VF unit = hn::Mul(hn::Mul(constant(c.speed_alpha), held.inverse_length), tau);
        const VF guess = hn::Mul(hn::Mul(unit, half), hn::Sqrt(dot(b.t.v, b.t.v)));
        const auto middle = [&](VF v, VF push, VF lambda)
                                LR_LAMBDA { return hn::Div(mul_add(half, push, v), mul_add(guess, lambda, one)); };
        const Vec3 m{middle(b.t.v.x, pull.x, rate.x), middle(b.t.v.y, pull.y, rate.y), middle(b.t.v.z, pull.z, rate.z)};
        const VF s2 = dot(m, m), s = hn::Sqrt(s2);
        share = hn::Mul(unit, s);
        if constexpr (kNoise) beta = hn::Sqrt(hn::Mul(beta_unit, hn::Mul(s2, s)));
    } else {
        share = hn::Mul(held.alpha, tau);
    }
    const Relaxation v[3] = {relaxation(hn::Mul(share, rate.x)), relaxation(hn::Mul(share, rate.y)),
                             relaxation(hn::Mul(share, rate.z))},
                     u[3] = {relaxation(hn::Mul(share, spin_rate.x)), relaxation(hn::Mul(share, spin_rate.y)),
                             relaxation(hn::Mul(share, spin_rate.z))};
    const Vec3 pulled{mul_add(pull.x, v[0].c, b.t.v.x), mul_add(pull.y, v[1].c, b.t.v.y),
                      mul_add(pull.z, v[2].c, b.t.v.z)};
    Vec3 turned = b.t.u;
    if (held.external) turned = add(turned, mul(couple, {u[0].c, u[1].c, u[2].c}));
    if constexpr (!kNoise) {
        b.t.v = {hn::Div(pulled.x, v[0].d), hn::Div(pulled.y, v[1].d), hn::Div(pulled.z, v[2].d)};
        b.t.u = {hn::Div(turned.x, u[0].d), hn::Div(turned.y, u[1].d), hn::Div(turned.z, u[2].d)};
    } else {
        beta = hn::Mul(beta, constant(0.5f * in.sqrt_h));
        const VF spin_beta = hn::Mul(beta, constant(c.noise_spin));
        const auto settled = [&](VF y, const Relaxation& x, VF kick) LR_LAMBDA {
            const VF inverse = hn::Div(one, x.d);
            return mul_add(kick, hn::Sqrt(quadruple_variance(x, inverse)), hn::Mul(y, inverse));
        };
        const auto kick = [&](VF strength, VF lambda, VF g) LR_LAMBDA { return hn::Mul(strength, hn::Mul(lambda, g)); };
        b.t.v = {settled(pulled.x, v[0], kick(beta, rate.x, gauss[0])),
                 settled(pulled.y, v[1], kick(beta, rate.y, gauss[1])),
                 settled(pulled.z, v[2], kick(beta, rate.z, gauss[2]))};
        b.t.u = {settled(turned.x, u[0], kick(spin_beta, spin_rate.x, gauss[3])),
                 settled(turned.y, u[1], kick(spin_beta, spin_rate.y, gauss[4])),
                 settled(turned.z, u[2], kick(spin_beta, spin_rate.z, gauss[5]))};
    }
    if (held.sheared) b.t.u = add(b.t.u, fluid_spin);
}

// Weight, buoyancy and what acts from outside, along the modes.
template <class C> HWY_INLINE Twist applied_to_modes(const C& c, const Held& held, Quaternion q) {
    const Vec3 gravity = to_body(q, held.gravity);
    if (held.uniform) {
        const Twist f{rows(c.modes_of_gravity, gravity), rows(c.modes_of_gravity + 9, gravity)};
        return held.external ? add(f, force_to_modes(c, external_force<true>(c, *held.external, q))) : f;
    }
    Twist f{to_body(q, held.weight), cross(broadcast(c.buoyancy), gravity)};
    if (held.external) f = add(f, external_force<true>(c, *held.external, q));
    return force_to_modes(c, f);
}

// Damping, weight, and at the end of a step noise, for half a substep; orientation held.
template <bool kNoise, class C>
HWY_INLINE void load_half_full(const StepInput& in, const C& c, const Held& held, VF beta_unit, const VF gauss[6],
                               Body& b) {
    const VF tau = constant(0.5f * in.h);
    // Damping is towards the fluid's own rotation: relax the spin through the fluid.
    const bool sheared = in.loads != Loads::none && held.sheared;
    const auto fluid_spin = [&]() LR_LAMBDA { return to_body(b.q, held.fluid_spin); };
    if (sheared) b.t.u = sub(b.t.u, fluid_spin());
    const Twist tau_f = scale(tau, applied_to_modes(c, held, b.q));
    const Twist y = to_modes(c, b.t);
    if (HWY_UNLIKELY(in.loads == Loads::none)) {
        b.t = add(b.t, from_modes(c, tau_f));
        return;
    }
    const Twist rate = broadcast6(c.rate);
    VF alpha = held.alpha;
    VF beta = held.beta;
    if (HWY_LIKELY(in.clock == Clock::speed)) {
        // Speed in the middle of the half step, estimated implicitly: it makes the damping of second order.
        const VF unit = hn::Mul(constant(c.speed_alpha), held.inverse_length);
        const VF half_tau = constant(0.25f * in.h);
        const VF guess = hn::Mul(hn::Mul(unit, hn::Sqrt(dot(b.t.v, b.t.v))), half_tau);
        const auto middle = [&](VF value, VF kick, VF lambda) LR_LAMBDA {
            return hn::Div(mul_add(constant(0.5f), kick, value), mul_add(guess, lambda, constant(1.0f)));
        };
        const Twist m = from_modes(c, {{middle(y.v.x, tau_f.v.x, rate.v.x), middle(y.v.y, tau_f.v.y, rate.v.y),
                                        middle(y.v.z, tau_f.v.z, rate.v.z)},
                                       {middle(y.u.x, tau_f.u.x, rate.u.x), middle(y.u.y, tau_f.u.y, rate.u.y),
                                        middle(y.u.z, tau_f.u.z, rate.u.z)}});
        const VF s2 = dot(m.v, m.v), s = hn::Sqrt(s2);
        alpha = hn::Mul(unit, s);
        if constexpr (kNoise) beta = hn::Sqrt(hn::Mul(beta_unit, hn::Mul(s2, s)));
    }
    const Twist x = scale(hn::Mul(alpha, tau), rate);
    Twist kick = x;
    if constexpr (kNoise) {
        beta = hn::Mul(beta, constant(in.sqrt_h));
        kick = scale(
            beta, general6<false>(c.modes_of_noise, {{gauss[0], gauss[1], gauss[2]}, {gauss[3], gauss[4], gauss[5]}}));
    }
    const Twist relaxed{
        {relax<kNoise>(y.v.x, x.v.x, tau_f.v.x, kick.v.x), relax<kNoise>(y.v.y, x.v.y, tau_f.v.y, kick.v.y),
         relax<kNoise>(y.v.z, x.v.z, tau_f.v.z, kick.v.z)},
        {relax<kNoise>(y.u.x, x.u.x, tau_f.u.x, kick.u.x), relax<kNoise>(y.u.y, x.u.y, tau_f.u.y, kick.u.y),
         relax<kNoise>(y.u.z, x.u.z, tau_f.u.z, kick.u.z)}};
    // The change only: to modes and back costs a rounding each time.
    b.t = add(b.t, from_modes(c, {sub(relaxed.v, y.v), sub(relaxed.u, y.u)}));
    if (sheared) b.t.u = add(b.t.u, fluid_spin());
}

// A step of Kirchhoff's equations without loads. Stretched: with the error of the turning made good, and along the velocities
// at the ends: the middle one is the chord of an arc, too short by (w h)^2/8.
template <bool kFull, bool kStretched = false, class C>
HWY_INLINE void free_step(float h, const C& c, const Held& held, Body& b) {
    VF g = hn::Mul(constant(0.5f * h), held.inverse_length);
    if constexpr (kStretched) g = stretched(b.t.u, g);
    Motion m;
    if constexpr (kFull)
        m = free_motion_full(c, b.t, g);
    else
        m = free_motion(c, b.t, g);
    // Orientation by Cayley's map of h w, on the group; half of it is the middle orientation.
    const Quaternion q1 = normalised(turn(b.q, b.q, constant(1.0f), scale(m.g, m.middle.u)));
    if constexpr (kStretched) {
        b.x = add_scaled(b.x, constant(0.5f * h), add(to_world(b.q, b.t.v), to_world(q1, m.end.v)));
    } else {
        const Quaternion middle{hn::Add(b.q.x, q1.x), hn::Add(b.q.y, q1.y), hn::Add(b.q.z, q1.z), hn::Add(b.q.w, q1.w)};
        b.x = add_scaled(b.x, constant(h), to_world_scaled(middle, m.middle.v));
    }
    b.q = q1;
    b.t = m.end;
}

// Loads::none or langevin.
template <bool kFull, class C>
HWY_INLINE void splitting_substep(const StepInput& in, const C& c, Held& held, VF beta_unit, const VF gauss[6],
                                  Body& b) {
    const VF half = constant(0.5f * in.h);
    if (HWY_UNLIKELY(in.loads == Loads::langevin && in.clock == Clock::age)) {
        VF beta_squared;
        sample_table(in.table, hn::Add(b.age, half), held.alpha, beta_squared);
        held.beta = hn::Sqrt(beta_squared);
    }
    if constexpr (kFull)
        load_half_full<false>(in, c, held, beta_unit, gauss, b);
    else
        load_half_diagonal<false>(in, c, held, beta_unit, gauss, b);
    free_step<kFull>(in.h, c, held, b);
    if constexpr (kFull)
        load_half_full<true>(in, c, held, beta_unit, gauss, b);
    else
        load_half_diagonal<true>(in, c, held, beta_unit, gauss, b);
    b.x = add(b.x, scale(constant(in.h), held.wind));
    grow_older(b, constant(in.h));
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
