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
HWY_INLINE Twist broadcast6(const float v[6]) {
    return {broadcast(v), broadcast(v + 3)};
}

// m t or m^T t for a full 6x6 matrix.
template <bool kTransposed> HWY_INLINE Twist general6(const float m[36], Twist t) {
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
template <bool kFull> HWY_INLINE Twist to_modes(const BodyConstants& c, Twist t) {
    if constexpr (kFull) return general6<false>(c.to_modes, t);
    return t;
}
template <bool kFull> HWY_INLINE Twist from_modes(const BodyConstants& c, Twist y) {
    if constexpr (kFull) return general6<false>(c.from_modes, y);
    return y;
}
template <bool kFull> HWY_INLINE Twist force_to_modes(const BodyConstants& c, Twist f) {
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
template <bool kFull, Loads kLoads, bool kNoise>
HWY_INLINE void load_half(const StepInput& in, const BodyConstants& c, const Held& held, Vec3 weight, Vec3 gravity,
                          VF beta_unit, const VF gauss[6], Body& b) {
    const VF tau = constant(0.5f * in.h);
    Twist f{to_body(b.q, weight), {}};
    f.u = {hn::Zero(DF()), hn::Zero(DF()), hn::Zero(DF())};
    if constexpr (kFull) f.u = cross(broadcast(c.buoyancy), to_body(b.q, gravity));
    const Twist tau_f = scale(tau, force_to_modes<kFull>(c, f));
    const Twist y = to_modes<kFull>(c, b.t);
    if constexpr (kLoads == Loads::none) {
        b.t = from_modes<kFull>(c, add(y, tau_f));
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
    b.t = from_modes<kFull>(
        c, {{relax<kNoise>(y.v.x, x.v.x, tau_f.v.x, kick.v.x), relax<kNoise>(y.v.y, x.v.y, tau_f.v.y, kick.v.y),
             relax<kNoise>(y.v.z, x.v.z, tau_f.v.z, kick.v.z)},
            {relax<kNoise>(y.u.x, x.u.x, tau_f.u.x, kick.u.x), relax<kNoise>(y.u.y, x.u.y, tau_f.u.y, kick.u.y),
             relax<kNoise>(y.u.z, x.u.z, tau_f.u.z, kick.u.z)}});
}

struct Matrix3 {
    VF a[3][3];
};

// Cramer's rule. The matrices here are positive definite plus skew: never singular.
HWY_INLINE Vec3 solve(const Matrix3& m, Vec3 r) {
    const Vec3 c0{m.a[0][0], m.a[1][0], m.a[2][0]}, c1{m.a[0][1], m.a[1][1], m.a[2][1]},
        c2{m.a[0][2], m.a[1][2], m.a[2][2]};
    const Vec3 c12 = cross(c1, c2);
    const VF inverse = hn::Div(constant(1.0f), dot(c0, c12));
    return scale(inverse, Vec3{dot(r, c12), dot(r, cross(c2, c0)), dot(r, cross(c0, c1))});
}

// Twist in the middle of a step of M z' = S(mu) z, S skew: (M - h/2 S) z = M z0. Its energy is kept whatever mu is.
// p, l: the momenta mu. g: h/2 over the length d s. Translation is eliminated first.
template <bool kFull>
HWY_INLINE Twist middle_twist(const BodyConstants& c, Twist start, Twist start_momentum, Twist mu, VF g) {
    const Vec3 p = scale(g, mu.v), l = scale(g, mu.u);
    if constexpr (!kFull) {
        const VF a = constant(c.inverse_mass[0]), b = constant(c.inverse_mass[1]), d = constant(c.inverse_mass[2]);
        const VF xx = hn::Mul(p.x, p.x), yy = hn::Mul(p.y, p.y), zz = hn::Mul(p.z, p.z);
        // J - [l]x - [p]x M^-1 [p]x
        const VF kxy = hn::Mul(d, hn::Mul(p.x, p.y)), kxz = hn::Mul(b, hn::Mul(p.x, p.z)),
                 kyz = hn::Mul(a, hn::Mul(p.y, p.z));
        const Matrix3 m{
            {{mul_add(b, zz, mul_add(d, yy, constant(c.spin_mass[0]))), hn::Sub(l.z, kxy), hn::Neg(hn::Add(kxz, l.y))},
             {hn::Neg(hn::Add(kxy, l.z)), mul_add(a, zz, mul_add(d, xx, constant(c.spin_mass[1]))), hn::Sub(l.x, kyz)},
             {hn::Sub(l.y, kxz), hn::Neg(hn::Add(kyz, l.x)),
              mul_add(a, yy, mul_add(b, xx, constant(c.spin_mass[2])))}}};
        const Vec3 u = solve(m, add(start_momentum.u, cross(p, start.v)));
        return {add(start.v, scaled_by(c.inverse_mass, cross(p, u))), u};
    } else {
        // G = M12 - [p]x, H^T = M12^T - [p]x; (M22 - [l]x - H^T M11^-1 G) u = l0 - H^T M11^-1 p0; v = M11^-1 (p0 - G u)
        const float* const m12 = c.coupling;
        const Vec3 columns[3] = {{constant(m12[0]), hn::Sub(constant(m12[3]), p.z), hn::Add(constant(m12[6]), p.y)},
                                 {hn::Add(constant(m12[1]), p.z), constant(m12[4]), hn::Sub(constant(m12[7]), p.x)},
                                 {hn::Sub(constant(m12[2]), p.y), hn::Add(constant(m12[5]), p.x), constant(m12[8])}};
        const Vec3 rows[3] = {{constant(m12[0]), hn::Add(constant(m12[3]), p.z), hn::Sub(constant(m12[6]), p.y)},
                              {hn::Sub(constant(m12[1]), p.z), constant(m12[4]), hn::Add(constant(m12[7]), p.x)},
                              {hn::Add(constant(m12[2]), p.y), hn::Sub(constant(m12[5]), p.x), constant(m12[8])}};
        Vec3 solved[3];
        for (int j = 0; j < 3; ++j) solved[j] = symmetric3(c.inverse_translation, columns[j]);
        const float* const m22 = c.rotation_mass;
        const VF zero = hn::Zero(DF());
        const VF skew[3][3] = {{zero, l.z, hn::Neg(l.y)}, {hn::Neg(l.z), zero, l.x}, {l.y, hn::Neg(l.x), zero}};
        static constexpr int at[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
        Matrix3 m;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                m.a[i][j] = hn::Sub(hn::Add(constant(m22[at[i][j]]), skew[i][j]), dot(rows[i], solved[j]));
        const Vec3 free = symmetric3(c.inverse_translation, start_momentum.v);
        const Vec3 u = solve(m, sub(start_momentum.u, {dot(rows[0], free), dot(rows[1], free), dot(rows[2], free)}));
        return {sub(free, add(scale(u.x, solved[0]), add(scale(u.y, solved[1]), scale(u.z, solved[2])))), u};
    }
}

// Solves of the implicit midpoint. Each is of second order and keeps the energy whatever the last one found; |p| and
// p.l are kept only as far as the solves have converged, and with them the tumbling. Two solves are stable too, but
// lose a third of a tumbling leaf's spin at 4 ms; four are within 3 % of the limit (docs/numerics.md).
inline constexpr int midpoint_solves = 4;

// A body that moves by more than this many of its lengths in half a step turns more often than can be seen or resolved:
// it is turned by less, with the same energy. Beyond a hundred, single precision would lose that too.
inline constexpr float most_lengths = 8.0f;

// A step of Kirchhoff's equations without loads.
template <bool kFull>
HWY_INLINE void free_step(const StepInput& in, const BodyConstants& c, const Held& held, Body& b) {
    const Twist start = momentum<kFull>(c, b.t);
    const VF full_g = hn::Mul(constant(0.5f * in.h), held.inverse_length);
    const VF energy = hn::Add(dot(b.t.v, start.v), dot(b.t.u, start.u)); // twice it, over the mass unit
    const VF lengths = hn::Mul(full_g, hn::Sqrt(energy));
    const VF g = hn::Div(full_g, hn::Max(hn::Mul(lengths, constant(1.0f / most_lengths)), constant(1.0f)));
    Twist t = middle_twist<kFull>(c, b.t, start, start, g);
    for (int i = 1; i < midpoint_solves; ++i) t = middle_twist<kFull>(c, b.t, start, momentum<kFull>(c, t), g);

    // Orientation by Cayley's map of h w, on the group; half of it is the middle orientation.
    const Vec3 half_turn = scale(g, t.u);
    const Quaternion q1 = normalised(turn(b.q, b.q, constant(1.0f), half_turn));
    const Quaternion middle =
        normalised({hn::Add(b.q.x, q1.x), hn::Add(b.q.y, q1.y), hn::Add(b.q.z, q1.z), hn::Add(b.q.w, q1.w)});
    b.x = add_scaled(b.x, constant(in.h), to_world(middle, t.v));
    b.q = q1;
    b.t = {sub(add(t.v, t.v), b.t.v), sub(add(t.u, t.u), b.t.u)};
}

template <bool kFull, Loads kLoads>
HWY_INLINE void splitting_substep(const StepInput& in, const BodyConstants& c, Held& held, Vec3 weight, Vec3 gravity,
                                  VF beta_unit, const VF gauss[6], Body& b) {
    const VF half = constant(0.5f * in.h);
    if constexpr (kLoads == Loads::langevin_age) {
        VF beta_squared;
        sample_table(in.table, hn::Add(b.age, half), held.alpha, beta_squared);
        held.beta = hn::Sqrt(beta_squared);
    }
    load_half<kFull, kLoads, false>(in, c, held, weight, gravity, beta_unit, gauss, b);
    free_step<kFull>(in, c, held, b);
    load_half<kFull, kLoads, kLoads != Loads::none>(in, c, held, weight, gravity, beta_unit, gauss, b);
    b.x = add(b.x, scale(constant(in.h), broadcast(in.wind)));
    b.age = hn::Add(b.age, constant(in.h));
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
