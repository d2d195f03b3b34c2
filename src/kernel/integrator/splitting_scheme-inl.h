// The default integrator: half a step of damping, weight and noise, a step of free motion, the other half. docs/maintainers/numerics.md. Stable at
// any step, since the loads contract towards their equilibrium and free motion conserves energy.
#if defined(LR_KERNEL_INTEGRATOR_SPLITTING_SCHEME_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_INTEGRATOR_SPLITTING_SCHEME_INL_H_
#undef LR_KERNEL_INTEGRATOR_SPLITTING_SCHEME_INL_H_
#else
#define LR_KERNEL_INTEGRATOR_SPLITTING_SCHEME_INL_H_
#endif

#include "kernel/integrator/free_motion-inl.h"
#include "kernel/integrator/step.h"

HWY_BEFORE_NAMESPACE();
namespace lr::LR_KERNEL_NAMESPACE {

// To modes, in which the mass matrix is 1 and damping diagonal.
template <class C> HWY_INLINE Twist to_modes(const C& c, Twist t) {
    return general6<false>(c.to_modes, t);
}
template <class C> HWY_INLINE Twist from_modes(const C& c, Twist y) {
    return general6<false>(c.from_modes, y);
}
template <class C> HWY_INLINE Twist force_to_modes(const C& c, Twist f) {
    return general6<true>(c.from_modes, f);
}

// D = 1 + x + x^2/2 + x^3/6 and C = 1 + x/2 + x^2/6. To third order exp(-x) = 1/D and (1 - exp(-x))/x = C/D. Both have the right limits for large x,
// so a stiff body settles at its terminal velocity instead of ringing.
struct Relaxation {
    VF c, d;
};
HWY_INLINE Relaxation relaxation(VF x) {
    x = hn::Min(x, constant(1e10f)); // D stays finite
    const VF sixth = x * constant(1.0f / 6.0f);
    const VF c = x * (constant(0.5f) + sixth) + constant(1.0f);
    return {c, x * c + constant(1.0f)};
}

// Variance of the noise over h/4 that keeps a mode's stationary variance: (1 - 1/D^4)/(4 x), as exp(-2 x) = 1/D^2. D - 1 = x C avoids cancellation.
HWY_INLINE VF quadruple_variance(const Relaxation& r, VF inverse) {
    const VF one = constant(1.0f);
    return r.c * inverse * ((one + inverse) * (inverse * inverse + one));
}

// Relaxation of a mode, y' = -x/tau y + f over tau, with noise that keeps its stationary variance. kick: noise force times sqrt(2 tau).
template <bool kNoise> HWY_INLINE VF relax(VF y, VF x, VF tau_f, VF kick) {
    const Relaxation r = relaxation(x);
    const VF inverse = constant(1.0f) / r.d;
    const VF still = (tau_f * r.c + y) * inverse;
    if constexpr (!kNoise) return still;
    return kick * hn::Sqrt(constant(0.25f) * quadruple_variance(r, inverse)) + still;
}

// kUsual: LANGEVIN loads with the SPEED clock, at compile time.
template <bool kUsual> HWY_INLINE bool without_loads(const StepInput& in) {
    return !kUsual && in.loads == Loads::none;
}
template <bool kUsual> HWY_INLINE bool by_speed(const StepInput& in) {
    return kUsual || in.clock == Clock::speed;
}

// For a body whose axes are its modes. gauss: read only if kNoise.
template <bool kNoise, bool kUsual, class C>
HWY_INLINE void load_half_diagonal(const StepInput& in, const C& c, const Held& held, VF beta_unit, const VF gauss[6],
                                   Body& b) {
    const VF one = constant(1.0f), half = constant(0.5f), tau = constant(0.5f * in.h);
    const Vec3 mobility = tau * broadcast(c.inverse_mass), spin_mobility = tau * broadcast(c.inverse_spin_mass);
    Vec3 pull = times(mobility, to_body(b.q, held.weight)), couple{};
    if (held.external) {
        const Twist f = external_force<false>(c, *held.external, b.q);
        pull += times(mobility, f.v);
        couple = times(spin_mobility, f.u);
    }
    if (HWY_UNLIKELY(without_loads<kUsual>(in))) {
        b.t.v += pull;
        if (held.external) b.t.u += couple;
        return;
    }
    // Damping is towards the fluid's rotation, so the relative spin relaxes.
    Vec3 fluid_spin{};
    if (held.sheared) {
        fluid_spin = to_body(b.q, held.fluid_spin);
        b.t.u -= fluid_spin;
    }
    const Vec3 rate = broadcast(c.rate), spin_rate = broadcast(c.rate + 3);
    VF share, beta = held.beta; // alpha tau
    if (HWY_LIKELY(by_speed<kUsual>(in))) {
        // The speed in the middle of the half step, from an implicit estimate, gives damping of second order.
        const VF unit = constant(c.speed_alpha) * held.inverse_length * tau;
        const VF guess = unit * half * hn::Sqrt(dot(b.t.v, b.t.v));
        const auto middle = [&](VF v, VF push, VF lambda)
                                LR_LAMBDA { return (half * push + v) / (guess * lambda + one); };
        const Vec3 m = each_axis(middle, b.t.v, pull, rate);
        const VF s2 = dot(m, m), s = hn::Sqrt(s2);
        share = unit * s;
        if constexpr (kNoise) beta = hn::Sqrt(beta_unit * (s2 * s));
    } else {
        share = held.alpha * tau;
    }
    struct Relaxations {
        Relaxation x, y, z;
    };
    const auto relaxations = [&](Vec3 by) LR_LAMBDA {
        return Relaxations{relaxation(share * by.x), relaxation(share * by.y), relaxation(share * by.z)};
    };
    const Relaxations v = relaxations(rate), u = relaxations(spin_rate);
    const auto pushed = [&](VF y, VF push, const Relaxation& x) LR_LAMBDA { return push * x.c + y; };
    const Vec3 pulled = each_axis(pushed, b.t.v, pull, v);
    Vec3 turned = b.t.u;
    if (held.external) turned += times(couple, {u.x.c, u.y.c, u.z.c});
    if constexpr (!kNoise) {
        const auto settled = [](VF y, const Relaxation& x) LR_LAMBDA { return y / x.d; };
        b.t.v = each_axis(settled, pulled, v);
        b.t.u = each_axis(settled, turned, u);
    } else {
        beta *= constant(0.5f * in.sqrt_h);
        const VF spin_beta = beta * constant(c.noise_spin);
        const auto settled = [&](VF y, const Relaxation& x, VF kick) LR_LAMBDA {
            const VF inverse = one / x.d;
            return kick * hn::Sqrt(quadruple_variance(x, inverse)) + y * inverse;
        };
        const Twist g = broadcast6(gauss);
        b.t.v = each_axis(settled, pulled, v, beta * times(rate, g.v));
        b.t.u = each_axis(settled, turned, u, spin_beta * times(spin_rate, g.u));
    }
    if (held.sheared) b.t.u += fluid_spin;
}

// Weight, buoyancy and external forces along the modes.
template <class C> HWY_INLINE Twist applied_to_modes(const C& c, const Held& held, Quaternion q) {
    const Vec3 gravity = to_body(q, held.gravity);
    if (held.uniform) {
        const Twist f{rows(c.modes_of_gravity, gravity), rows(c.modes_of_gravity + 9, gravity)};
        return held.external ? f + force_to_modes(c, external_force<true>(c, *held.external, q)) : f;
    }
    Twist f{to_body(q, held.weight), cross(broadcast(c.buoyancy), gravity)};
    if (held.external) f += external_force<true>(c, *held.external, q);
    return force_to_modes(c, f);
}

// Half a substep of damping and weight at a fixed orientation, with noise at the end of a step.
template <bool kNoise, bool kUsual, class C>
HWY_INLINE void load_half_full(const StepInput& in, const C& c, const Held& held, VF beta_unit, const VF gauss[6],
                               Body& b) {
    const VF tau = constant(0.5f * in.h);
    // Damping is towards the fluid's rotation, so the relative spin relaxes.
    const bool sheared = !without_loads<kUsual>(in) && held.sheared;
    const auto fluid_spin = [&]() LR_LAMBDA { return to_body(b.q, held.fluid_spin); };
    if (sheared) b.t.u -= fluid_spin();
    const Twist tau_f = tau * applied_to_modes(c, held, b.q);
    const Twist y = to_modes(c, b.t);
    if (HWY_UNLIKELY(without_loads<kUsual>(in))) {
        b.t += from_modes(c, tau_f);
        return;
    }
    const Twist rate = broadcast6(c.rate);
    VF alpha = held.alpha;
    VF beta = held.beta;
    if (HWY_LIKELY(by_speed<kUsual>(in))) {
        // The speed in the middle of the half step, from an implicit estimate, gives damping of second order.
        const VF unit = constant(c.speed_alpha) * held.inverse_length;
        const VF half_tau = constant(0.25f * in.h);
        const VF guess = unit * hn::Sqrt(dot(b.t.v, b.t.v)) * half_tau;
        const auto middle = [&](VF value, VF kick, VF lambda) LR_LAMBDA {
            return (constant(0.5f) * kick + value) / (guess * lambda + constant(1.0f));
        };
        const Twist m = from_modes(c, each_axis6(middle, y, tau_f, rate));
        const VF s2 = dot(m.v, m.v), s = hn::Sqrt(s2);
        alpha = unit * s;
        if constexpr (kNoise) beta = hn::Sqrt(beta_unit * (s2 * s));
    }
    const Twist x = alpha * tau * rate;
    Twist kick = x;
    if constexpr (kNoise) {
        beta *= constant(in.sqrt_h);
        kick = beta * general6<false>(c.modes_of_noise, broadcast6(gauss));
    }
    const auto relax_mode = [&](VF value, VF decay, VF push, VF by)
                                LR_LAMBDA { return relax<kNoise>(value, decay, push, by); };
    const Twist relaxed = each_axis6(relax_mode, y, x, tau_f, kick);
    // Adds the change alone: to modes and back would round the whole.
    b.t += from_modes(c, {relaxed.v - y.v, relaxed.u - y.u});
    if (sheared) b.t.u += fluid_spin();
}

// Velocity of a sheet's load centre, in its plane, by spin about its centre of mass.
template <class C> HWY_INLINE Vec3 arm_velocity(const C& c, Vec3 u) {
    const VF x = constant(c.aerodynamics.arm[0]), y = constant(c.aerodynamics.arm[1]);
    return {-(u.z * y), u.z * x, u.x * y - u.y * x};
}

// A step of free motion. kStretched (AERODYNAMIC loads): the turn is corrected. The body moves by the mean of its end velocities: the way along the middle
// velocity is too short by (w h)^2/8, a tenth for a coin that turns by one radian.
template <bool kFull, bool kStretched = false, class C>
HWY_INLINE void free_step(float h, const C& c, const Held& held, Body& b) {
    VF g = constant(0.5f * h) * held.inverse_length;
    if constexpr (kStretched) g = stretched(b.t.u, g);
    Motion m;
    if constexpr (kFull || kStretched)
        m = free_motion_full<kStretched, !kFull>(c, held.shed, b.t, g);
    else
        m = free_motion(c, held.shed, b.t, g);
    // Orientation by Cayley's map of h w, which stays on the group.
    const Quaternion q1 = normalised(turn(b.q, b.q, constant(1.0f), m.g * m.middle.u));
    const auto velocity = [&](const Twist& t) LR_LAMBDA {
        if constexpr (kFull || !kStretched)
            return t.v;
        else
            return t.v - arm_velocity(c, t.u);
    };
    b.x += constant(0.5f * h) * (to_world(b.q, velocity(b.t)) + to_world(q1, velocity(m.end)));
    b.q = q1;
    b.t = m.end;
}

// For Loads::none and Loads::langevin.
template <bool kFull, bool kUsual, class C>
HWY_INLINE void splitting_substep(const StepInput& in, const C& c, Held& held, VF beta_unit, const VF gauss[6],
                                  Body& b) {
    const VF half = constant(0.5f * in.h);
    if (HWY_UNLIKELY(!without_loads<kUsual>(in) && !by_speed<kUsual>(in))) {
        VF beta_squared;
        sample_table(in.table, b.age + half, held.alpha, beta_squared);
        held.beta = hn::Sqrt(beta_squared);
    }
    if constexpr (kFull)
        load_half_full<false, kUsual>(in, c, held, beta_unit, gauss, b);
    else
        load_half_diagonal<false, kUsual>(in, c, held, beta_unit, gauss, b);
    free_step<kFull>(in.h, c, held, b);
    if constexpr (kFull)
        load_half_full<true, kUsual>(in, c, held, beta_unit, gauss, b);
    else
        load_half_diagonal<true, kUsual>(in, c, held, beta_unit, gauss, b);
    b.x += constant(in.h) * held.wind;
    grow_older(b, constant(in.h));
}
} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
