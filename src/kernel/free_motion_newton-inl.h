// The implicit midpoint of Kirchhoff's equations, solved so that the energy is kept whatever the step
// (docs/maintainers/numerics.md, "Free motion").
#if defined(LR_KERNEL_FREE_MOTION_NEWTON_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_FREE_MOTION_NEWTON_INL_H_
#undef LR_KERNEL_FREE_MOTION_NEWTON_INL_H_
#else
#define LR_KERNEL_FREE_MOTION_NEWTON_INL_H_
#endif

#include "kernel/motion-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

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
        const auto column = [&](Vec3 se, Vec3 le, Vec3 pe, const auto* ct) LR_LAMBDA {
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
    const auto n = [&](Vec3 x) LR_LAMBDA { return scale(inverse, sub(add_scaled(x, dot(a, x), a), cross(a, x))); };
    // What momentum y adds to the three equations.
    const auto coupled = [&](Vec3 y) LR_LAMBDA {
        const Vec3 sum = sub(cross(b, y), cross(p, mobility<kFull>(c, y)));
        if constexpr (!kFull) return sum;
        const Vec3 cy = slip(c, y);
        return add(sum, add(cy, cross(a, cy)));
    };
    // A column of the matrix for du: S e + a x S e - l x e + p x C^T e + coupled(N (p x e)).
    const auto column = [&](Vec3 se, Vec3 le, Vec3 pe, const auto* ct) LR_LAMBDA {
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

// From the start of a step to its middle, and the step that was taken.
struct Solved {
    Twist increment;
    VF g;
};
template <bool kFull, class C> HWY_INLINE Solved solve_middle(const C& c, const Twist& from, VF full_g) {
    const Twist start = momentum<kFull>(c, from);
    const VF energy = hn::Add(dot(from.v, start.v), dot(from.u, start.u)); // twice it, over the mass unit
    const VF lengths = hn::Mul(full_g, hn::Sqrt(energy));
    const VF g = hn::Div(full_g, hn::Max(hn::Mul(lengths, constant(1.0f / most_lengths)), constant(1.0f)));
    const Twist first = newton_step<kFull>(c, start, from, g);
    const Twist second = newton_step<kFull>(c, start, first, g);
    // The true middle has no more energy than the ends. Newton's steps may miss it by far where the step is too long to
    // resolve: then the momenta of the start are better.
    const Twist second_mu = momentum<kFull>(c, second);
    const auto sound =
        hn::Le(hn::Add(dot(second.v, second_mu.v), dot(second.u, second_mu.u)), hn::Mul(energy, constant(1.5f)));
    return {middle_increment<kFull>(c, from, choose(sound, second_mu, start), g), g};
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
