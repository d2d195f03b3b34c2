// The default scheme: half a step of damping, weight and noise, exactly; a step of Kirchhoff's equations without loads,
// by a linearly implicit midpoint that keeps their energy; the other half (docs/numerics.md). Stable whatever the step:
// the first part contracts towards its own equilibrium, the second neither gains nor loses.
#if defined(LR_KERNEL_SPLITTING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_SPLITTING_INL_H_
#undef LR_KERNEL_SPLITTING_INL_H_
#else
#define LR_KERNEL_SPLITTING_INL_H_
#endif

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

// Modes in which mass is the unit matrix and damping diagonal. A diagonal body's modes are its axes, up to their
// length.
template <bool kFull, class C> HWY_INLINE Twist to_modes(const C& c, Twist t) {
    if constexpr (kFull) return general6<false>(c.to_modes, t);
    return t;
}
template <bool kFull, class C> HWY_INLINE Twist from_modes(const C& c, Twist y) {
    if constexpr (kFull) return general6<false>(c.from_modes, y);
    return y;
}
template <bool kFull, class C> HWY_INLINE Twist force_to_modes(const C& c, Twist f) {
    if constexpr (kFull) return general6<true>(c.from_modes, f);
    return acceleration<false>(c, f);
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

// One mode: y' = -x/tau y + f over tau, and the noise that leaves its stationary variance exact. `kick` is the noise
// force times sqrt(2 tau).
template <bool kNoise> HWY_INLINE VF relax(VF y, VF x, VF tau_f, VF kick) {
    const Relaxation r = relaxation(x);
    const VF inverse = hn::Div(constant(1.0f), r.d);
    const VF still = hn::Mul(mul_add(tau_f, r.c, y), inverse);
    if constexpr (!kNoise) return still;
    // Over the whole step exp(-2x) = 1/D^2; variance (1 - 1/D^4)/(4x) without the cancellation, as D - 1 = x C.
    const VF one = constant(1.0f);
    const VF tail = hn::Mul(hn::Add(one, inverse), mul_add(inverse, inverse, one));
    const VF variance = hn::Mul(hn::Mul(constant(0.25f), hn::Mul(r.c, inverse)), tail);
    return mul_add(kick, hn::Sqrt(variance), still);
}

// Damping, weight, and at the end of a step noise, for half a substep; orientation held.
template <bool kFull, Loads kLoads, bool kNoise, class C>
HWY_INLINE void load_half(const StepInput& in, const C& c, const Held& held, VF beta_unit, const VF gauss[6], Body& b) {
    const VF tau = constant(0.5f * in.h);
    // Damping is towards the fluid's own rotation: relax the spin through the fluid.
    const bool sheared = kLoads != Loads::none && held.sheared;
    const auto fluid_spin = [&]() HWY_ATTR { return to_body(b.q, held.fluid_spin); };
    if (sheared) b.t.u = sub(b.t.u, fluid_spin());
    Twist f{to_body(b.q, held.weight), {}};
    f.u = {hn::Zero(DF()), hn::Zero(DF()), hn::Zero(DF())};
    if constexpr (kFull) f.u = cross(broadcast(c.buoyancy), to_body(b.q, held.gravity));
    if (held.external) f = add(f, external_force<kFull>(c, *held.external, b.q));
    const Twist tau_f = scale(tau, force_to_modes<kFull>(c, f));
    const Twist y = to_modes<kFull>(c, b.t);
    if constexpr (kLoads == Loads::none) {
        b.t = add(b.t, from_modes<kFull>(c, tau_f));
        return;
    }
    const Twist rate = broadcast6(c.rate);
    VF alpha = held.alpha;
    VF beta = held.beta;
    if constexpr (kLoads == Loads::langevin_speed) {
        // Speed in the middle of the half step, estimated implicitly: it makes the damping of second order.
        const VF unit = hn::Mul(constant(c.speed_alpha), held.inverse_length);
        const VF half_tau = constant(0.25f * in.h);
        const VF guess = hn::Mul(hn::Mul(unit, hn::Sqrt(dot(b.t.v, b.t.v))), half_tau);
        const auto middle = [&](VF value, VF kick, VF lambda) HWY_ATTR {
            return hn::Div(mul_add(constant(0.5f), kick, value), mul_add(guess, lambda, constant(1.0f)));
        };
        Twist m{{middle(y.v.x, tau_f.v.x, rate.v.x), middle(y.v.y, tau_f.v.y, rate.v.y),
                 middle(y.v.z, tau_f.v.z, rate.v.z)},
                y.u};
        if constexpr (kFull) {
            m.u = {middle(y.u.x, tau_f.u.x, rate.u.x), middle(y.u.y, tau_f.u.y, rate.u.y),
                   middle(y.u.z, tau_f.u.z, rate.u.z)};
            m = from_modes<true>(c, m);
        }
        const VF s2 = dot(m.v, m.v), s = hn::Sqrt(s2);
        alpha = hn::Mul(unit, s);
        if constexpr (kNoise) beta = hn::Sqrt(hn::Mul(beta_unit, hn::Mul(s2, s)));
    }
    const Twist x = scale(hn::Mul(alpha, tau), rate);
    Twist kick = x;
    if constexpr (kNoise) {
        beta = hn::Mul(beta, constant(in.sqrt_h));
        const VF spin_beta = hn::Mul(beta, constant(c.noise_spin));
        kick = force_to_modes<kFull>(c, dragged<kFull>(c, {scale(beta, Vec3{gauss[0], gauss[1], gauss[2]}),
                                                           scale(spin_beta, Vec3{gauss[3], gauss[4], gauss[5]})}));
    }
    const Twist relaxed{
        {relax<kNoise>(y.v.x, x.v.x, tau_f.v.x, kick.v.x), relax<kNoise>(y.v.y, x.v.y, tau_f.v.y, kick.v.y),
         relax<kNoise>(y.v.z, x.v.z, tau_f.v.z, kick.v.z)},
        {relax<kNoise>(y.u.x, x.u.x, tau_f.u.x, kick.u.x), relax<kNoise>(y.u.y, x.u.y, tau_f.u.y, kick.u.y),
         relax<kNoise>(y.u.z, x.u.z, tau_f.u.z, kick.u.z)}};
    // The full path adds the change only: to modes and back costs a rounding each time.
    if constexpr (kFull)
        b.t = add(b.t, from_modes<true>(c, {sub(relaxed.v, y.v), sub(relaxed.u, y.u)}));
    else
        b.t = relaxed;
    if (sheared) b.t.u = add(b.t.u, fluid_spin());
}

// A 3x3 matrix by its columns.
struct Columns {
    Vec3 x, y, z;
};

// Cramer's rule. Positive definite plus skew is never singular; a Newton step's matrix may be, and is then found unsound.
HWY_INLINE Vec3 solve(Columns m, Vec3 r) {
    const Vec3 yz = cross(m.y, m.z);
    const VF inverse = hn::Div(constant(1.0f), dot(m.x, yz));
    return scale(inverse, Vec3{dot(r, yz), dot(r, cross(m.z, m.x)), dot(r, cross(m.x, m.y))});
}

// M11^-1 y.
template <bool kFull, class C> HWY_INLINE Vec3 mobility(const C& c, Vec3 y) {
    if constexpr (kFull) return symmetric3(c.inverse_translation, y);
    return scaled_by(c.inverse_mass, y);
}
// C x and C^T x, C = M12^T M11^-1, full path only.
template <class C> HWY_INLINE Vec3 slip(const C& c, Vec3 x) {
    return {dot(broadcast(c.slip), x), dot(broadcast(c.slip + 3), x), dot(broadcast(c.slip + 6), x)};
}
template <class C> HWY_INLINE Vec3 slip_transposed(const C& c, Vec3 x) {
    return add(scale(x.x, broadcast(c.slip)),
               add(scale(x.y, broadcast(c.slip + 3)), scale(x.z, broadcast(c.slip + 6))));
}

// The three columns of a x for the unit vectors x.
HWY_INLINE Columns cross_columns(Vec3 a) {
    const VF zero = hn::Zero(DF());
    return {{zero, a.z, hn::Neg(a.y)}, {hn::Neg(a.z), zero, a.x}, {a.y, hn::Neg(a.x), zero}};
}
// S = M22 - C M12.
template <bool kFull, class C> HWY_INLINE Columns reduced_rotation(const C& c) {
    const VF zero = hn::Zero(DF());
    if constexpr (!kFull)
        return {{constant(c.spin_mass[0]), zero, zero},
                {zero, constant(c.spin_mass[1]), zero},
                {zero, zero, constant(c.spin_mass[2])}};
    const auto* const m = c.reduced_rotation;
    return {{constant(m[0]), constant(m[1]), constant(m[2])},
            {constant(m[1]), constant(m[3]), constant(m[4])},
            {constant(m[2]), constant(m[4]), constant(m[5])}};
}

// How far the middle of a step of M z' = S(mu) z, S skew, lies from its start: (M - h/2 S) dz = h/2 S z0. Energy is kept
// whatever mu is. p, l: the momenta mu. g: h/2 over the length d s. With dv = M11^-1 p x u - C^T du
//   (S - [l]x - [p]x M11^-1 [p]x + C [p]x + [p]x C^T) du = l x u0 + p x (v0 + M11^-1 p x u0) - C p x u0.
// An increment, and not the middle itself: over many steps its rounding would show as a drift of energy.
template <bool kFull, class C> HWY_INLINE Twist middle_increment(const C& c, Twist start, Twist mu, VF g) {
    const Vec3 p = scale(g, mu.v), l = scale(g, mu.u);
    const Vec3 pu = cross(p, start.u);
    Vec3 r = add(cross(l, start.u), cross(p, add(start.v, mobility<kFull>(c, pu))));
    if constexpr (!kFull) {
        const VF a = constant(c.inverse_mass[0]), b = constant(c.inverse_mass[1]), d = constant(c.inverse_mass[2]);
        const VF xx = hn::Mul(p.x, p.x), yy = hn::Mul(p.y, p.y), zz = hn::Mul(p.z, p.z);
        const VF kxy = hn::Mul(d, hn::Mul(p.x, p.y)), kxz = hn::Mul(b, hn::Mul(p.x, p.z)),
                 kyz = hn::Mul(a, hn::Mul(p.y, p.z));
        const Columns m{
            {mul_add(b, zz, mul_add(d, yy, constant(c.spin_mass[0]))), hn::Neg(hn::Add(kxy, l.z)), hn::Sub(l.y, kxz)},
            {hn::Sub(l.z, kxy), mul_add(a, zz, mul_add(d, xx, constant(c.spin_mass[1]))), hn::Neg(hn::Add(kyz, l.x))},
            {hn::Neg(hn::Add(kxz, l.y)), hn::Sub(l.x, kyz), mul_add(a, yy, mul_add(b, xx, constant(c.spin_mass[2])))}};
        const Vec3 du = solve(m, r);
        return {scaled_by(c.inverse_mass, add(pu, cross(p, du))), du};
    } else {
        r = sub(r, slip(c, pu));
        const Columns s = reduced_rotation<true>(c), lx = cross_columns(l), px = cross_columns(p);
        const auto column = [&](Vec3 se, Vec3 le, Vec3 pe, const auto* ct) HWY_ATTR {
            const Vec3 turned = cross(p, sub(broadcast(ct), mobility<true>(c, pe)));
            return add(add(sub(se, le), slip(c, pe)), turned);
        };
        const Columns m{column(s.x, lx.x, px.x, c.slip), column(s.y, lx.y, px.y, c.slip + 3),
                        column(s.z, lx.z, px.z, c.slip + 6)};
        const Vec3 du = solve(m, r);
        return {sub(mobility<true>(c, add(pu, cross(p, du))), slip_transposed(c, du)), du};
    }
}

// One Newton step for the implicit midpoint M (z - z0) = g f(z), f = (P x u, L x u + P x v), from the estimate z.
// With y = dP for unknown and N = (1 + [g u]x)^-1: y = N (r_v + g P x du), dv = M11^-1 y - C^T du, dL = C y + S du,
// where C = M12^T M11^-1 and S = M22 - C M12; what is left is three equations for du.
template <bool kFull, class C> HWY_INLINE Twist newton_step(const C& c, Twist start_momentum, Twist z, VF g) {
    const Twist mu = momentum<kFull>(c, z);
    const Vec3 a = scale(g, z.u), b = scale(g, z.v), p = scale(g, mu.v), l = scale(g, mu.u);
    const Vec3 rv = add(sub(start_momentum.v, mu.v), cross(p, z.u));
    const Vec3 ru = add(sub(start_momentum.u, mu.u), add(cross(l, z.u), cross(p, z.v)));

    const VF inverse = hn::Div(constant(1.0f), hn::Add(constant(1.0f), dot(a, a)));
    const auto n = [&](Vec3 x) HWY_ATTR { return scale(inverse, sub(add_scaled(x, dot(a, x), a), cross(a, x))); };
    // What momentum y adds to the three equations.
    const auto coupled = [&](Vec3 y) HWY_ATTR {
        const Vec3 sum = sub(cross(b, y), cross(p, mobility<kFull>(c, y)));
        if constexpr (!kFull) return sum;
        const Vec3 cy = slip(c, y);
        return add(sum, add(cy, cross(a, cy)));
    };
    // A column of the matrix for du: S e + a x S e - l x e + p x C^T e + coupled(N (p x e)).
    const auto column = [&](Vec3 se, Vec3 le, Vec3 pe, const auto* ct) HWY_ATTR {
        const Vec3 sum = add(sub(add(se, cross(a, se)), le), coupled(n(pe)));
        if constexpr (kFull) return add(sum, cross(p, broadcast(ct)));
        return sum;
    };
    const Columns s = reduced_rotation<kFull>(c), lx = cross_columns(l), px = cross_columns(p);
    const Columns m{column(s.x, lx.x, px.x, c.slip), column(s.y, lx.y, px.y, c.slip + 3),
                    column(s.z, lx.z, px.z, c.slip + 6)};
    const Vec3 du = solve(m, sub(ru, coupled(n(rv))));
    const Vec3 y = n(add(rv, cross(p, du)));
    Vec3 dv = mobility<kFull>(c, y);
    if constexpr (kFull) dv = sub(dv, slip_transposed(c, du));
    return {add(z.v, dv), add(z.u, du)};
}

HWY_INLINE Twist choose(hn::Mask<DF> m, Twist a, Twist b) {
    return {{hn::IfThenElse(m, a.v.x, b.v.x), hn::IfThenElse(m, a.v.y, b.v.y), hn::IfThenElse(m, a.v.z, b.v.z)},
            {hn::IfThenElse(m, a.u.x, b.u.x), hn::IfThenElse(m, a.u.y, b.u.y), hn::IfThenElse(m, a.u.z, b.u.z)}};
}

// A body that moves by more than this many of its lengths in half a step turns more often than can be seen or resolved:
// it is turned by less, with the same energy. Beyond a hundred, single precision would lose that too.
inline constexpr float most_lengths = 8.0f;

// The implicit midpoint turns a steady spin through 2 atan(w h/2) instead of w h, and the moment in the middle of the chord is
// too small by (w h)^2/12: a step longer by that share, x^2/3 with x = w h/2, makes both right to fourth order.
HWY_INLINE VF stretched(Vec3 u, VF g) {
    const VF x2 = hn::Min(hn::Mul(hn::Mul(g, g), dot(u, u)), constant(1.0f));
    return hn::Mul(g, mul_add(x2, constant(1.0f / 3.0f), constant(1.0f)));
}

// A step of Kirchhoff's equations without loads. Stretched: with the error of the turning made good, and along the velocities
// at the ends: the middle one is the chord of an arc, too short by (w h)^2/8.
template <bool kFull, bool kStretched = false, class C>
HWY_INLINE void free_step(float h, const C& c, const Held& held, Body& b) {
    const Twist start = momentum<kFull>(c, b.t);
    const VF full_g = hn::Mul(constant(0.5f * h), held.inverse_length);
    const VF energy = hn::Add(dot(b.t.v, start.v), dot(b.t.u, start.u)); // twice it, over the mass unit
    const VF lengths = hn::Mul(full_g, hn::Sqrt(energy));
    VF g = hn::Div(full_g, hn::Max(hn::Mul(lengths, constant(1.0f / most_lengths)), constant(1.0f)));
    const Twist first = newton_step<kFull>(c, start, b.t, g);
    if constexpr (kStretched) g = stretched(first.u, g);
    const Twist second = newton_step<kFull>(c, start, first, g);
    // The true middle has no more energy than the ends. Newton's steps may miss it by far where the step is too long to
    // resolve: then the momenta of the start are better.
    const Twist second_mu = momentum<kFull>(c, second);
    const auto sound =
        hn::Le(hn::Add(dot(second.v, second_mu.v), dot(second.u, second_mu.u)), hn::Mul(energy, constant(1.5f)));
    const Twist dz = middle_increment<kFull>(c, b.t, choose(sound, second_mu, start), g);
    const Twist t = add(b.t, dz), end = add(b.t, add(dz, dz));

    // Orientation by Cayley's map of h w, on the group; half of it is the middle orientation.
    const Vec3 half_turn = scale(g, t.u);
    const Quaternion q1 = normalised(turn(b.q, b.q, constant(1.0f), half_turn));
    if constexpr (kStretched) {
        b.x = add_scaled(b.x, constant(0.5f * h), add(to_world(b.q, b.t.v), to_world(q1, end.v)));
    } else {
        const Quaternion middle =
            normalised({hn::Add(b.q.x, q1.x), hn::Add(b.q.y, q1.y), hn::Add(b.q.z, q1.z), hn::Add(b.q.w, q1.w)});
        b.x = add_scaled(b.x, constant(h), to_world(middle, t.v));
    }
    b.q = q1;
    b.t = end;
}

template <bool kFull, Loads kLoads, class C>
HWY_INLINE void splitting_substep(const StepInput& in, const C& c, Held& held, VF beta_unit, const VF gauss[6],
                                  Body& b) {
    const VF half = constant(0.5f * in.h);
    if constexpr (kLoads == Loads::langevin_age) {
        VF beta_squared;
        sample_table(in.table, hn::Add(b.age, half), held.alpha, beta_squared);
        held.beta = hn::Sqrt(beta_squared);
    }
    load_half<kFull, kLoads, false>(in, c, held, beta_unit, gauss, b);
    free_step<kFull>(in.h, c, held, b);
    load_half<kFull, kLoads, kLoads != Loads::none>(in, c, held, beta_unit, gauss, b);
    b.x = add(b.x, scale(constant(in.h), held.wind));
    grow_older(b, constant(in.h));
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
