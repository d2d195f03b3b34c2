// Kirchhoff's equations without loads over one step, for diagonal and for full mass matrices (docs/maintainers/numerics.md, "Free motion").
#if defined(LR_KERNEL_FREE_MOTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_FREE_MOTION_INL_H_
#undef LR_KERNEL_FREE_MOTION_INL_H_
#else
#define LR_KERNEL_FREE_MOTION_INL_H_
#endif

#include "kernel/free_motion_newton-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// Velocities in the middle of a step and at its end.
struct Motion {
    Twist middle, end;
    VF g; // half the step that was taken over the length d s
};

// Bodies that one Newton step does not solve: two, and a middle that keeps the energy whatever they give.
template <bool kFull, class C>
static HWY_NOINLINE void resolve_motion(const C& c, const Twist& start, VF g, hn::Mask<DF> where, Motion& m) {
    const auto energy = [&](const Twist& t) LR_LAMBDA {
        const Twist p = momentum<kFull>(c, t);
        return hn::Add(dot(t.v, p.v), dot(t.u, p.u));
    };
    const Solved s = solve_middle<kFull>(c, start, g);
    Twist end = add(start, add(s.increment, s.increment));
    // What rounding has added: much where a needle turns many times in a step. A body that got lost in it stays as it was.
    const VF before = energy(start), after = energy(end), zero = hn::Zero(DF());
    const auto sound = hn::And(hn::Gt(after, zero), hn::Le(after, hn::Mul(before, constant(4.0f))));
    const VF factor = hn::Min(hn::Sqrt(hn::Div(before, hn::IfThenElse(sound, after, constant(1.0f)))), constant(1.0f));
    end = choose(sound, {scale(factor, end.v), scale(factor, end.u)}, start);
    m.middle = choose(where, choose(sound, add(start, s.increment), start), m.middle);
    m.end = choose(where, end, m.end);
    m.g = hn::IfThenElse(where, s.g, m.g);
}

// The implicit midpoint u1 = u0 + 2 g J^-1 (J u x u + P x v), P1 - P0 = 2 g P x u, at the middle. P there is
// (1 + [g u]x)^-1 P0, so that only u is unknown; one Newton step finds it, for which P is P0 + g P0 x u. What that leaves
// undone would show as energy: spin at the end is scaled by what is missing, and a body that would need more than `most_scaling`
// is solved the long way.
inline constexpr float most_scaling = 0.05f;
// Beyond these, squares of lengths moved and of the tangent of half the angle turned in half the step, the long way too.
inline constexpr float most_moved = 64.0f, most_turned = 4.0f;

// (1 + [a]x)^-1 P less P, for the spin in the middle, and for that at the start, a.(P x a) being 0.
HWY_INLINE Vec3 turned_by(Vec3 a, VF squared, Vec3 momentum) {
    const Vec3 lag = cross(a, momentum);
    return scale(hn::Div(constant(1.0f), hn::Add(constant(1.0f), squared)), sub(cross(a, lag), lag));
}
HWY_INLINE Vec3 first_turn(Vec3 a, Vec3 pa) {
    return scale(hn::Div(constant(1.0f), hn::Add(constant(1.0f), dot(a, a))), sub(pa, cross(a, pa)));
}
// What the spin must be multiplied by to lose the energy gained.
HWY_INLINE VF spin_factor(VF gained, VF spin_energy) {
    const VF share = hn::Div(gained, hn::Max(spin_energy, constant(1e-30f)));
    return hn::Sqrt(hn::Max(hn::Sub(constant(1.0f), share), hn::Zero(DF())));
}
HWY_INLINE hn::Mask<DF> unsolved(VF factor, VF moved, VF turned) {
    const auto solved = hn::And(hn::Le(hn::Abs(hn::Sub(factor, constant(1.0f))), constant(most_scaling)),
                                hn::And(hn::Le(moved, constant(most_moved)), hn::Le(turned, constant(most_turned))));
    return hn::Not(solved);
}

template <class C> HWY_INLINE Motion free_motion(const C& c, Twist start, VF g) {
    const VF one = constant(1.0f);
    const Vec3 v = start.v, u = start.u, momentum = scaled_by(c.mass, v);
    const Vec3 a = scale(g, u), b = scale(g, v), p = scale(g, momentum);
    const auto products = [](Vec3 w) LR_LAMBDA {
        return Vec3{hn::Mul(w.y, w.z), hn::Mul(w.z, w.x), hn::Mul(w.x, w.y)};
    };
    // u' over the body: gyroscopic and Munk moment.
    const auto turning = [&](Vec3 spin, Vec3 speed) LR_LAMBDA {
        return add(scaled_by(c.gyroscopic, products(spin)), scaled_by(c.munk, products(speed)));
    };
    // Rows of 1 - g (derivative of u').
    const Vec3 alpha{hn::Mul(constant(c.munk_turn[0]), b.z), hn::Mul(constant(c.munk_turn[1]), b.x),
                     hn::Mul(constant(c.munk_turn[2]), b.y)};
    const Vec3 beta{hn::Mul(constant(c.munk_turn[3]), b.y), hn::Mul(constant(c.munk_turn[4]), b.z),
                    hn::Mul(constant(c.munk_turn[5]), b.x)};
    const Vec3 rv = first_turn(a, cross(p, u));
    const Vec3 r{mul_add(alpha.x, rv.y, hn::Mul(beta.x, rv.z)), mul_add(alpha.y, rv.z, hn::Mul(beta.y, rv.x)),
                 mul_add(alpha.z, rv.x, hn::Mul(beta.z, rv.y))};
    const auto diagonal = [&](VF al, VF pa, VF be, VF pb)
                              LR_LAMBDA { return mul_add(be, pb, neg_mul_add(al, pa, one)); };
    const auto after = [&](const auto& gy, VF spin, VF be, VF pa)
                           LR_LAMBDA { return hn::Neg(mul_add(constant(gy), spin, hn::Mul(be, pa))); };
    const auto before = [&](const auto& gy, VF spin, VF al, VF pa)
                            LR_LAMBDA { return mul_sub(al, pa, hn::Mul(constant(gy), spin)); };
    const auto* const gy = c.gyroscopic;
    const Columns m{
        {diagonal(alpha.x, p.z, beta.x, p.y), before(gy[1], a.z, alpha.y, p.y), after(gy[2], a.y, beta.z, p.z)},
        {after(gy[0], a.z, beta.x, p.x), diagonal(alpha.y, p.x, beta.y, p.z), before(gy[2], a.x, alpha.z, p.z)},
        {before(gy[0], a.y, alpha.x, p.x), after(gy[1], a.x, beta.y, p.y), diagonal(alpha.z, p.y, beta.z, p.x)}};
    const Vec3 um = add(u, solve(m, add_scaled(r, g, turning(u, v))));

    const Vec3 am = scale(g, um);
    const VF turned = dot(am, am);
    const Vec3 dp = turned_by(am, turned, momentum);
    const Vec3 dv = scaled_by(c.inverse_mass, dp), vm = add(v, dv);
    const Vec3 du = scale(hn::Add(g, g), turning(um, vm)), u1 = add(u, du);
    // Kinetic energies at the end less those at the start: 4 P.dv and (l0 + l1).du.
    const VF gained =
        hn::Add(hn::Mul(constant(4.0f), dot(add(momentum, dp), dv)), dot(scaled_by(c.spin_mass, add(u, u1)), du));
    const VF factor = spin_factor(gained, dot(scaled_by(c.spin_mass, u1), u1));
    Motion out{{vm, um}, {add(vm, dv), scale(factor, u1)}, g};
    if (const auto left = unsolved(factor, dot(p, b), turned); !hn::AllFalse(DF(), left))
        resolve_motion<false>(c, start, g, left, out);
    return out;
}

// The same for any mass matrix: v = M11^-1 P - C^T u and L = C P + S u with C = M12^T M11^-1 and S = M22 - C M12.
template <class C> HWY_INLINE Motion free_motion_full(const C& c, Twist start, VF g) {
    const Vec3 v = start.v, u = start.u;
    const auto* const s = c.reduced_rotation;
    const Vec3 momentum = symmetric6(c.full_mass, start).v, spin_momentum = symmetric3(s, u);
    const Vec3 angular = add(slip(c, momentum), spin_momentum);
    const Vec3 a = scale(g, u), b = scale(g, v), p = scale(g, momentum), l = scale(g, angular);
    // Columns of H = (1 + [a]x) C + [b]x - [p]x M11^-1, and of 1 - g (derivative): (1 + [a]x) S - [l]x + [p]x C^T + H [p]x.
    const auto column = [&](const auto& c0, const auto& c1, const auto& c2, const auto& m0, const auto& m1,
                            const auto& m2) LR_LAMBDA {
        const Vec3 slip{constant(c0), constant(c1), constant(c2)}, rate{constant(m0), constant(m1), constant(m2)};
        return sub(add(slip, cross(a, slip)), cross(p, rate));
    };
    const auto* const k = c.slip;
    const auto* const n = c.inverse_translation;
    Columns h{column(k[0], k[3], k[6], n[0], n[1], n[2]), column(k[1], k[4], k[7], n[1], n[3], n[4]),
              column(k[2], k[5], k[8], n[2], n[4], n[5])};
    h.x.y = hn::Add(h.x.y, b.z), h.x.z = hn::Sub(h.x.z, b.y);
    h.y.x = hn::Sub(h.y.x, b.z), h.y.z = hn::Add(h.y.z, b.x);
    h.z.x = hn::Add(h.z.x, b.y), h.z.y = hn::Sub(h.z.y, b.x);
    const auto turning = [&](const auto& s0, const auto& s1, const auto& s2, const auto* ct) LR_LAMBDA {
        const Vec3 e{constant(s0), constant(s1), constant(s2)};
        return add(add(e, cross(a, e)), cross(p, broadcast(ct)));
    };
    Columns m{turning(s[0], s[1], s[2], k), turning(s[1], s[3], s[4], k + 3), turning(s[2], s[4], s[5], k + 6)};
    m.x = add(m.x, sub(scale(p.z, h.y), scale(p.y, h.z)));
    m.y = add(m.y, sub(scale(p.x, h.z), scale(p.z, h.x)));
    m.z = add(m.z, sub(scale(p.y, h.x), scale(p.x, h.y)));
    m.x.y = hn::Sub(m.x.y, l.z), m.x.z = hn::Add(m.x.z, l.y);
    m.y.x = hn::Add(m.y.x, l.z), m.y.z = hn::Sub(m.y.z, l.x);
    m.z.x = hn::Sub(m.z.x, l.y), m.z.y = hn::Add(m.z.y, l.x);
    const Vec3 rv = first_turn(a, cross(p, u));
    const Vec3 hr = add(scale(rv.x, h.x), add(scale(rv.y, h.y), scale(rv.z, h.z)));
    const Vec3 r = sub(add(cross(l, u), cross(p, v)), hr);
    const Vec3 dum = solve(m, r), um = add(u, dum);

    const Vec3 am = scale(g, um);
    const VF turned = dot(am, am);
    const Vec3 dp = turned_by(am, turned, momentum), pm = add(momentum, dp);
    const Vec3 moved_by = symmetric3(n, dp), dragged_along = slip(c, dp);
    const Vec3 lm = add(angular, add(dragged_along, symmetric3(s, dum)));
    const Vec3 vm = add(v, sub(moved_by, slip_transposed(c, dum)));
    const Vec3 dl = scale(hn::Add(g, g), add(cross(lm, um), cross(pm, vm)));
    const Vec3 spun = sub(dl, add(dragged_along, dragged_along)); // S du
    // S^-1 is the lower block of M^-1, the last six of its upper triangle.
    const Vec3 du = symmetric3(c.full_inverse + 15, spun), u1 = add(u, du);
    const VF gained = hn::Add(hn::Mul(constant(4.0f), dot(pm, moved_by)), dot(add(u, u1), spun));
    const VF factor = spin_factor(gained, dot(add(spin_momentum, spun), u1));
    const Vec3 scaled = scale(factor, u1);
    Motion out{{vm, um}, {sub(add(v, add(moved_by, moved_by)), slip_transposed(c, sub(scaled, u))), scaled}, g};
    if (const auto left = unsolved(factor, dot(p, b), turned); !hn::AllFalse(DF(), left))
        resolve_motion<true>(c, start, g, left, out);
    return out;
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
