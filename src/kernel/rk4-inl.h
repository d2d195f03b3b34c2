// The paper's scheme: classical Runge-Kutta (docs/maintainers/physics.md section 4, docs/maintainers/numerics.md).
#if defined(LR_KERNEL_RK4_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_RK4_INL_H_
#undef LR_KERNEL_RK4_INL_H_
#else
#define LR_KERNEL_RK4_INL_H_
#endif

#include "kernel/aerodynamic-inl.h"
#include "kernel/motion-inl.h"
#include "kernel/step.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// Time derivative of the twist. P, L: momenta over mass unit; with w = u/(d s)
//   P' = P x w + weight vector - alpha rho(V + A) v + noise
//   L' = L x w + P x v/(d s) + b x R^T g - alpha rho D (u - fluid spin) + noise
// The Munk moment P x v carries the body's own momentum too, which is parallel to v and drops out.
template <bool kFull, bool kAerodynamic, class C>
HWY_INLINE Twist twist_rate(const StepInput& in, const C& c, const Held& held, Quaternion q, Twist t) {
    const Twist p = momentum<kFull>(c, t);
    Twist f;
    f.v = add_scaled(to_body(q, held.weight), held.inverse_length, cross(p.v, t.u));
    f.u = scale(held.inverse_length, add(cross(p.u, t.u), cross(p.v, t.v)));
    if constexpr (kFull) f.u = add(f.u, cross(broadcast(c.buoyancy), to_body(q, held.gravity)));
    if (held.external) f = add(f, external_force<kFull>(c, *held.external, q));
    if (!kAerodynamic && in.loads == Loads::langevin) {
        VF alpha = held.alpha;
        if (in.clock == Clock::speed)
            alpha = hn::Mul(hn::Mul(constant(c.speed_alpha), held.inverse_length), hn::Sqrt(dot(t.v, t.v)));
        if (held.sheared) t.u = sub(t.u, to_body(q, held.fluid_spin)); // drag of the spin through the fluid
        const Twist d = dragged<kFull>(c, t);
        f.v = sub(add(f.v, held.noise.v), scale(alpha, d.v));
        f.u = sub(add(f.u, held.noise.u), scale(alpha, d.u));
    }
    return acceleration<kFull>(c, f);
}

// One substep of the classical Runge-Kutta scheme, with the noise held over its stages (docs/maintainers/physics.md section 4).
template <bool kFull, bool kAerodynamic, class C>
HWY_INLINE void rk4_substep(const StepInput& in, const C& c, Held& held, VF beta_unit, const VF gauss[6], Body& b) {
    const VF h = constant(in.h), half = constant(0.5f * in.h), quarter = constant(0.25f * in.h);
    if (!kAerodynamic && in.loads == Loads::langevin) {
        VF beta;
        if (in.clock == Clock::speed) {
            const VF s2 = dot(b.t.v, b.t.v);
            beta = hn::Sqrt(hn::Mul(beta_unit, hn::Mul(s2, hn::Sqrt(s2))));
        } else {
            VF beta_squared;
            sample_table(in.table, hn::Add(b.age, half), held.alpha, beta_squared);
            beta = hn::Sqrt(beta_squared);
        }
        beta = hn::Mul(beta, constant(in.inverse_sqrt_h));
        const VF spin_beta = hn::Mul(beta, constant(c.noise_spin));
        held.noise = dragged<kFull>(
            c, {scale(beta, Vec3{gauss[0], gauss[1], gauss[2]}), scale(spin_beta, Vec3{gauss[3], gauss[4], gauss[5]})});
    }
    const auto rate = [&](Quaternion q, Twist t) LR_LAMBDA {
        const Twist r = twist_rate<kFull, kAerodynamic>(in, c, held, q, t);
        if constexpr (!kAerodynamic) return r;
        if (held.sheared) t.u = sub(t.u, to_body(q, held.fluid_spin));
        return add(r, acceleration<kFull>(c, aerodynamic_loads<kFull>(c.aerodynamics, held.inverse_length, t)));
    };
    const auto spin = [&](Twist t) LR_LAMBDA { return scale(held.inverse_length, t.u); };

    const Twist k1 = rate(b.q, b.t);
    const Vec3 w1 = spin(b.t);
    Vec3 travel = to_world(b.q, b.t.v);
    Quaternion turned = turn(b.q, b.q, constant(in.h / 12.0f), w1);

    Quaternion q = turn(b.q, b.q, quarter, w1);
    Twist t = add_scaled(b.t, half, k1);
    const Twist k2 = rate(q, t);
    const Vec3 w2 = spin(t);
    Vec3 middle = to_world(q, t.v);
    turned = turn(turned, q, constant(in.h / 6.0f), w2);

    q = turn(b.q, q, quarter, w2);
    t = add_scaled(b.t, half, k2);
    const Twist k3 = rate(q, t);
    const Vec3 w3 = spin(t);
    middle = add(middle, to_world(q, t.v));
    turned = turn(turned, q, constant(in.h / 6.0f), w3);

    q = turn(b.q, q, half, w3);
    t = add_scaled(b.t, h, k3);
    const Twist k4 = rate(q, t);
    travel = add(travel, to_world(q, t.v));
    turned = turn(turned, q, constant(in.h / 12.0f), spin(t));

    const VF sixth = constant(in.h / 6.0f);
    b.x = add(b.x, scale(h, held.wind));
    b.x = add_scaled(b.x, sixth, add(travel, add(middle, middle)));
    const Twist inner = add(k2, k3);
    b.t = add_scaled(b.t, sixth, add(add(k1, k4), add(inner, inner)));
    b.q = normalised(turned);
    grow_older(b, h);
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
