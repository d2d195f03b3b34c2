// Free motion by the implicit midpoint: Kirchhoff's equations without loads, with energy conserved at any step. docs/maintainers/numerics.md.
#if defined(LR_KERNEL_INTEGRATOR_FREE_MOTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_INTEGRATOR_FREE_MOTION_INL_H_
#undef LR_KERNEL_INTEGRATOR_FREE_MOTION_INL_H_
#else
#define LR_KERNEL_INTEGRATOR_FREE_MOTION_INL_H_
#endif

#include "kernel/integrator/equations_of_motion-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::LR_KERNEL_NAMESPACE {

struct Columns {
    Vec3 x, y, z;
};

// Cramer's rule. Positive definite plus skew is never singular. A Newton matrix can be; its result is then rejected.
HWY_INLINE Vec3 solve(Columns m, Vec3 r) {
    const Vec3 yz = cross(m.y, m.z);
    const VF inverse = constant(1.0f) / dot(m.x, yz);
    return inverse * Vec3{dot(r, yz), dot(r, cross(m.z, m.x)), dot(r, cross(m.x, m.y))};
}

// M11^-1 y.
template <bool kFull, class C> HWY_INLINE Vec3 mobility(const C& c, Vec3 y) {
    if constexpr (kFull) return symmetric3(c.inverse_translation, y);
    return scaled_by(c.inverse_mass, y);
}
// rows(c.slip, x) and columns(c.slip, x) are C x and C^T x with C = M12^T M11^-1; full path only.

// Columns of the cross product matrix [a]x.
HWY_INLINE Columns cross_columns(Vec3 a) {
    const VF zero = hn::Zero(DF());
    return {{zero, a.z, -a.y}, {-a.z, zero, a.x}, {a.y, -a.x, zero}};
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

// Half of a step of M z' = S(mu) z with S skew, so energy is conserved for any momenta mu = (p, l): (M - h/2 S) dz = h/2 S z0. g is h/2 over the
// length d s. With dv = M11^-1 p x u - C^T du
//   (S - [l]x - [p]x M11^-1 [p]x + C [p]x + [p]x C^T) du = l x u0 + p x (v0 + M11^-1 p x u0) - C p x u0.
// The increment is solved for, since the rounding of the middle itself would accumulate as a drift of energy.
template <bool kFull, class C> HWY_INLINE Twist middle_increment(const C& c, Twist start, Twist mu, VF g) {
    const Vec3 p = g * mu.v, l = g * mu.u;
    const Vec3 pu = cross(p, start.u);
    Vec3 r = cross(l, start.u) + cross(p, start.v + mobility<kFull>(c, pu));
    if constexpr (!kFull) {
        const VF a = constant(c.inverse_mass[0]), b = constant(c.inverse_mass[1]), d = constant(c.inverse_mass[2]);
        const VF xx = p.x * p.x, yy = p.y * p.y, zz = p.z * p.z;
        const VF kxy = d * (p.x * p.y), kxz = b * (p.x * p.z), kyz = a * (p.y * p.z);
        const Columns m{{b * zz + (d * yy + constant(c.spin_mass[0])), -(kxy + l.z), l.y - kxz},
                        {l.z - kxy, a * zz + (d * xx + constant(c.spin_mass[1])), -(kyz + l.x)},
                        {-(kxz + l.y), l.x - kyz, a * yy + (b * xx + constant(c.spin_mass[2]))}};
        const Vec3 du = solve(m, r);
        return {scaled_by(c.inverse_mass, pu + cross(p, du)), du};
    } else {
        r -= rows(c.slip, pu);
        const Columns s = reduced_rotation<true>(c), lx = cross_columns(l), px = cross_columns(p);
        const auto column = [&](Vec3 se, Vec3 le, Vec3 pe, const auto* ct) LR_LAMBDA {
            const Vec3 turned = cross(p, broadcast(ct) - mobility<true>(c, pe));
            return se - le + rows(c.slip, pe) + turned;
        };
        const Columns m{column(s.x, lx.x, px.x, c.slip), column(s.y, lx.y, px.y, c.slip + 3),
                        column(s.z, lx.z, px.z, c.slip + 6)};
        const Vec3 du = solve(m, r);
        return {mobility<true>(c, pu + cross(p, du)) - columns(c.slip, du), du};
    }
}

// A Newton step from z for the implicit midpoint M (z - z0) = g f(z), f = (P x u, L x u + P x v). With y = dP and N = (1 + [g u]x)^-1: y = N (r_v + g
// P x du), dv = M11^-1 y - C^T du, dL = C y + S du, where C = M12^T M11^-1 and S = M22 - C M12. Three equations for du remain.
template <bool kFull, class C>
static HWY_NOINLINE Twist newton_step(const C& c, VF shed, Twist start_momentum, Twist z, VF g) {
    const Twist mu = momentum<kFull>(c, z), moving = moving_momentum<kFull, kFull>(c, shed, mu, z);
    const Vec3 a = g * z.u, b = g * z.v, p = g * moving.v, l = g * moving.u;
    const Vec3 rv = start_momentum.v - mu.v + cross(p, z.u);
    const Vec3 ru = start_momentum.u - mu.u + (cross(l, z.u) + cross(p, z.v));

    const VF inverse = constant(1.0f) / (constant(1.0f) + dot(a, a));
    const auto n = [&](Vec3 x) LR_LAMBDA { return inverse * (x + dot(a, x) * a - cross(a, x)); };
    // Share of a momentum y in these equations.
    const auto contribution = [&](Vec3 y) LR_LAMBDA {
        const Vec3 sum = cross(b, y) - cross(p, mobility<kFull>(c, y));
        if constexpr (!kFull) return sum;
        const Vec3 cy = rows(c.slip, y);
        return sum + (cy + cross(a, cy));
    };
    // A column of their matrix: S e + a x S e - l x e + p x C^T e + contribution(N (p x e)).
    const auto column = [&](Vec3 se, Vec3 le, Vec3 pe, const auto* ct) LR_LAMBDA {
        const Vec3 sum = se + cross(a, se) - le + contribution(n(pe));
        if constexpr (kFull) return sum + cross(p, broadcast(ct));
        return sum;
    };
    const Columns s = reduced_rotation<kFull>(c), lx = cross_columns(l), px = cross_columns(p);
    const Columns m{column(s.x, lx.x, px.x, c.slip), column(s.y, lx.y, px.y, c.slip + 3),
                    column(s.z, lx.z, px.z, c.slip + 6)};
    const Vec3 du = solve(m, ru - contribution(n(rv)));
    const Vec3 y = n(rv + cross(p, du));
    Vec3 dv = mobility<kFull>(c, y);
    if constexpr (kFull) dv -= columns(c.slip, du);
    return {z.v + dv, z.u + du};
}

// Limit of lengths moved in half a step. A faster body is not resolved; its step is shortened, so it turns less with the same energy. Beyond 100
// energy would suffer too.
inline constexpr float most_lengths = 8.0f;

// The implicit midpoint turns a steady spin by 2 atan(w h/2) instead of w h, and the moment in the middle of the chord is too small by (w h)^2/12. A
// step longer by that share, x^2/3 with x = w h/2, makes both right to fourth order.
HWY_INLINE VF stretched(Vec3 u, VF g) {
    const VF x2 = hn::Min(g * g * dot(u, u), constant(1.0f));
    return g * (x2 * constant(1.0f / 3.0f) + constant(1.0f));
}

// The increment from the start of a step to its middle, and g of the step taken.
struct Solved {
    Twist increment;
    VF g;
};
template <bool kFull, class C> HWY_INLINE Solved solve_middle(const C& c, VF shed, const Twist& from, VF full_g) {
    const Twist start = momentum<kFull>(c, from);
    const VF energy = dot(from.v, start.v) + dot(from.u, start.u); // twice the energy, over the mass unit
    const VF lengths = full_g * hn::Sqrt(energy);
    const VF g = full_g / hn::Max(lengths * constant(1.0f / most_lengths), constant(1.0f));
    const Twist first = newton_step<kFull>(c, shed, start, from, g);
    const Twist second = newton_step<kFull>(c, shed, start, first, g);
    // The exact middle has no more energy than the ends. Newton can miss it by far if the step is too long; then the start's momenta are used.
    const Twist second_mu = momentum<kFull>(c, second);
    const auto sound = dot(second.v, second_mu.v) + dot(second.u, second_mu.u) <= energy * constant(1.5f);
    const Twist mu =
        moving_momentum<kFull, kFull>(c, shed, select(sound, second_mu, start), select(sound, second, from));
    return {middle_increment<kFull>(c, from, mu, g), g};
}

struct Motion {
    Twist middle, end;
    VF g; // half of the step taken, over the length d s
};

// For bodies that one Newton step does not solve: two of them, then a middle step that conserves energy whatever they give.
template <bool kFull, class C>
static HWY_NOINLINE void resolve_motion(const C& c, VF shed, const Twist& start, VF g, hn::Mask<DF> where, Motion& m) {
    const auto energy = [&](const Twist& t) LR_LAMBDA {
        const Twist p = momentum<kFull>(c, t);
        return dot(t.v, p.v) + dot(t.u, p.u);
    };
    const Solved s = solve_middle<kFull>(c, shed, start, g);
    Twist end = start + (s.increment + s.increment);
    // Rounding can add energy, much if a needle turns many times in a step. If the result is lost in it the body keeps its state.
    const VF before = energy(start), after = energy(end), zero = hn::Zero(DF());
    const auto sound = hn::And(after > zero, after <= before * constant(4.0f));
    const VF factor = hn::Min(hn::Sqrt(before / hn::IfThenElse(sound, after, constant(1.0f))), constant(1.0f));
    end = select(sound, {factor * end.v, factor * end.u}, start);
    m.middle = select(where, select(sound, start + s.increment, start), m.middle);
    m.end = select(where, end, m.end);
    m.g = hn::IfThenElse(where, s.g, m.g);
}

// Implicit midpoint, diagonal path: u1 = u0 + 2 g J^-1 (J u x u + P x v) and P1 - P0 = 2 g P x u at the middle. Since P = (1 + [g u]x)^-1 P0 only u
// is unknown; one Newton step with P = P0 + g P0 x u finds it. Its residual would show as energy, so the spin at the end is scaled. A body that needs
// more than most_scaling goes to resolve_motion().
inline constexpr float most_scaling = 0.05f;
// Squares of lengths moved and of the tangent of half the angle turned, in half a step. Beyond them a body goes to resolve_motion() too.
inline constexpr float most_moved = 64.0f, most_turned = 4.0f;

// (1 + [a]x)^-1 P less P, for the spin in the middle and, as a.(P x a) = 0, for that at the start.
HWY_INLINE Vec3 turned_by(Vec3 a, VF squared, Vec3 momentum) {
    const Vec3 lag = cross(a, momentum);
    return constant(1.0f) / (constant(1.0f) + squared) * (cross(a, lag) - lag);
}
HWY_INLINE Vec3 first_turn(Vec3 a, Vec3 pa) {
    return constant(1.0f) / (constant(1.0f) + dot(a, a)) * (pa - cross(a, pa));
}
// Factor on the spin that removes energy gained.
HWY_INLINE VF spin_factor(VF gained, VF spin_energy) {
    const VF share = gained / hn::Max(spin_energy, constant(1e-30f));
    return hn::Sqrt(hn::Max(constant(1.0f) - share, hn::Zero(DF())));
}
HWY_INLINE hn::Mask<DF> unsolved(VF factor, VF moved, VF turned) {
    const auto solved = hn::And(hn::Abs(factor - constant(1.0f)) <= constant(most_scaling),
                                hn::And(moved <= constant(most_moved), turned <= constant(most_turned)));
    return hn::Not(solved);
}

template <class C> HWY_INLINE Motion free_motion(const C& c, VF shed, Twist start, VF g) {
    const VF one = constant(1.0f);
    const Vec3 v = start.v, u = start.u, momentum = scaled_by(c.mass, v);
    const Vec3 a = g * u, b = g * v, p = g * momentum, munk = broadcast(c.munk);
    const auto products = [](Vec3 w) LR_LAMBDA { return Vec3{w.y * w.z, w.z * w.x, w.x * w.y}; };
    // u' by the gyroscopic and the Munk moment.
    const auto turning = [&](Vec3 spin, Vec3 speed) LR_LAMBDA {
        return scaled_by(c.gyroscopic, products(spin)) + times(munk, products(speed));
    };
    // Rows of 1 - g (derivative of u').
    const auto* const turn = c.munk_turn;
    const Vec3 alpha{constant(turn[0]) * b.z, constant(turn[1]) * b.x, constant(turn[2]) * b.y};
    const Vec3 beta{constant(turn[3]) * b.y, constant(turn[4]) * b.z, constant(turn[5]) * b.x};
    const Vec3 rv = first_turn(a, cross(p, u));
    const Vec3 r{alpha.x * rv.y + beta.x * rv.z, alpha.y * rv.z + beta.y * rv.x, alpha.z * rv.x + beta.z * rv.y};
    const auto diagonal = [&](VF al, VF pa, VF be, VF pb) LR_LAMBDA { return be * pb + (one - al * pa); };
    const auto after = [&](const auto& gy, VF spin, VF be, VF pa)
                           LR_LAMBDA { return -(constant(gy) * spin + be * pa); };
    const auto before = [&](const auto& gy, VF spin, VF al, VF pa) LR_LAMBDA { return al * pa - constant(gy) * spin; };
    const auto* const gy = c.gyroscopic;
    const Columns m{
        {diagonal(alpha.x, p.z, beta.x, p.y), before(gy[1], a.z, alpha.y, p.y), after(gy[2], a.y, beta.z, p.z)},
        {after(gy[0], a.z, beta.x, p.x), diagonal(alpha.y, p.x, beta.y, p.z), before(gy[2], a.x, alpha.z, p.z)},
        {before(gy[0], a.y, alpha.x, p.x), after(gy[1], a.x, beta.y, p.y), diagonal(alpha.z, p.y, beta.z, p.x)}};
    const Vec3 um = u + solve(m, r + g * turning(u, v));

    const Vec3 am = g * um;
    const VF turned = dot(am, am);
    const Vec3 dp = turned_by(am, turned, momentum);
    const Vec3 dv = scaled_by(c.inverse_mass, dp), vm = v + dv;
    const Vec3 du = (g + g) * turning(um, vm), u1 = u + du;
    // Change of kinetic energy: 4 P.dv and (l0 + l1).du.
    const VF gained = constant(4.0f) * dot(momentum + dp, dv) + dot(scaled_by(c.spin_mass, u + u1), du);
    const VF factor = spin_factor(gained, dot(scaled_by(c.spin_mass, u1), u1));
    Motion out{{vm, um}, {vm + dv, factor * u1}, g};
    if (const auto left = unsolved(factor, dot(p, b), turned); !hn::AllFalse(DF(), left))
        resolve_motion<false>(c, shed, start, g, left, out);
    return out;
}

// The same on the full path: v = M11^-1 P - C^T u, L = C P + S u, C = M12^T M11^-1, S = M22 - C M12. In a sheet's frame these have 12 numbers.

// Products with a sheet's matrices, which keep motion in its plane (v_x, v_y, u_z) apart from the rest: symmetric ones from v to v or u to u, those
// between v and u, and their transposes.
template <bool kSheet, class T> HWY_INLINE Vec3 block(const T* m, Vec3 a) {
    if constexpr (!kSheet) return symmetric3(m, a);
    return {constant(m[0]) * a.x + constant(m[1]) * a.y, constant(m[1]) * a.x + constant(m[3]) * a.y,
            constant(m[5]) * a.z};
}
template <bool kSheet, class T> HWY_INLINE Vec3 coupled(const T* m, Vec3 a) {
    if constexpr (!kSheet) return rows(m, a);
    return {constant(m[2]) * a.z, constant(m[5]) * a.z, constant(m[6]) * a.x + constant(m[7]) * a.y};
}
template <bool kSheet, class T> HWY_INLINE Vec3 coupled_back(const T* m, Vec3 a) {
    if constexpr (!kSheet) return columns(m, a);
    return {constant(m[6]) * a.z, constant(m[7]) * a.z, constant(m[2]) * a.x + constant(m[5]) * a.y};
}
template <bool kSheet, class C> HWY_INLINE Vec3 linear_momentum(const C& c, const Twist& t) {
    const auto* const m = c.full_mass;
    if constexpr (!kSheet) return symmetric6(m, t).v;
    return {constant(m[0]) * t.v.x + (constant(m[1]) * t.v.y + constant(m[5]) * t.u.z),
            constant(m[1]) * t.v.x + (constant(m[6]) * t.v.y + constant(m[10]) * t.u.z),
            constant(m[11]) * t.v.z + (constant(m[12]) * t.u.x + constant(m[13]) * t.u.y)};
}

// Columns of (1 + [a]x) C - [p]x M11^-1.
template <bool kSheet, class C> HWY_INLINE Columns slip_columns(const C& c, Vec3 a, Vec3 p) {
    const auto* const k = c.slip;
    const auto* const n = c.inverse_translation;
    if constexpr (kSheet) {
        const VF cx = constant(k[2]), cy = constant(k[5]), ex = constant(k[6]), ey = constant(k[7]);
        const VF xx = constant(n[0]), xy = constant(n[1]), yy = constant(n[3]), zz = constant(n[5]);
        return {{ex * a.y + xy * p.z, -(ex * a.x + xx * p.z), ex - (xy * p.x - xx * p.y)},
                {ey * a.y + yy * p.z, -(ey * a.x + xy * p.z), ey - (yy * p.x - xy * p.y)},
                {cx - cy * a.z - zz * p.y, cy + cx * a.z + zz * p.x, cy * a.x - cx * a.y}};
    }
    const auto column = [&](const auto& c0, const auto& c1, const auto& c2, const auto& m0, const auto& m1,
                            const auto& m2) LR_LAMBDA {
        const Vec3 slip{constant(c0), constant(c1), constant(c2)}, rate{constant(m0), constant(m1), constant(m2)};
        return slip + cross(a, slip) - cross(p, rate);
    };
    return {column(k[0], k[3], k[6], n[0], n[1], n[2]), column(k[1], k[4], k[7], n[1], n[3], n[4]),
            column(k[2], k[5], k[8], n[2], n[4], n[5])};
}
// Columns of (1 + [a]x) S + [p]x C^T.
template <bool kSheet, class C> HWY_INLINE Columns turning_columns(const C& c, Vec3 a, Vec3 p) {
    const auto* const k = c.slip;
    const auto* const s = c.reduced_rotation;
    if constexpr (kSheet) {
        const VF cx = constant(k[2]), cy = constant(k[5]), ex = constant(k[6]), ey = constant(k[7]);
        const VF xx = constant(s[0]), xy = constant(s[1]), yy = constant(s[3]), zz = constant(s[5]);
        return {{xx - xy * a.z + cx * p.y, xy + xx * a.z - cx * p.x, xy * a.x - xx * a.y},
                {xy - yy * a.z + cy * p.y, yy + xy * a.z - cy * p.x, yy * a.x - xy * a.y},
                {zz * a.y - ey * p.z, ex * p.z - zz * a.x, zz + (ey * p.x - ex * p.y)}};
    }
    const auto column = [&](const auto& s0, const auto& s1, const auto& s2, const auto* ct) LR_LAMBDA {
        const Vec3 e{constant(s0), constant(s1), constant(s2)};
        return e + cross(a, e) + cross(p, broadcast(ct));
    };
    return {column(s[0], s[1], s[2], k), column(s[1], s[3], s[4], k + 3), column(s[2], s[4], s[5], k + 6)};
}

// kShed: AERODYNAMIC loads, which leave momentum in the wake.
template <bool kShed, bool kSheet, class C> HWY_INLINE Motion free_motion_full(const C& c, VF shed, Twist start, VF g) {
    const Vec3 v = start.v, u = start.u;
    const auto* const s = c.reduced_rotation;
    const auto* const n = c.inverse_translation;
    const Vec3 momentum = linear_momentum<kSheet>(c, start), spin_momentum = block<kSheet>(s, u);
    const Vec3 angular = coupled<kSheet>(c.slip, momentum) + spin_momentum;
    Twist moving{momentum, angular};
    if constexpr (kSheet)
        moving.v.z = moving.v.z - shed * v.z;
    else
        moving = moving_momentum<true, kShed>(c, shed, moving, start);
    const Vec3 a = g * u, b = g * v, p = g * moving.v, l = g * moving.u;
    // Columns of H = (1 + [a]x) C + [b]x - [p]x M11^-1, and of 1 - g (derivative) = (1 + [a]x) S - [l]x + [p]x C^T + H [p]x.
    Columns h = slip_columns<kSheet>(c, a, p);
    h.x.y = h.x.y + b.z, h.x.z = h.x.z - b.y;
    h.y.x = h.y.x - b.z, h.y.z = h.y.z + b.x;
    Vec3 axis, arm, moved_along;
    if constexpr (kSheet) {
        const VF kept = constant(1.0f) - shed * constant(n[5]);
        h.z.x = h.z.x + kept * b.y, h.z.y = h.z.y - kept * b.x;
    } else {
        h.z.x = h.z.x + b.y, h.z.y = h.z.y - b.x;
        if constexpr (kShed) {
            axis = broadcast(c.aerodynamics.normal), arm = broadcast(c.aerodynamics.normal_arm);
            moved_along = symmetric3(n, axis);
            const Vec3 lost = shed * cross(b, axis);
            h.x -= moved_along.x * lost, h.y -= moved_along.y * lost, h.z -= moved_along.z * lost;
        }
    }
    Columns m = turning_columns<kSheet>(c, a, p);
    m.x += p.z * h.y - p.y * h.z;
    m.y += p.x * h.z - p.z * h.x;
    m.z += p.y * h.x - p.x * h.y;
    m.x.y = m.x.y - l.z, m.x.z = m.x.z + l.y;
    m.y.x = m.y.x + l.z, m.y.z = m.y.z - l.x;
    m.z.x = m.z.x - l.y, m.z.y = m.z.y + l.x;
    const Vec3 rv = first_turn(a, cross(p, u));
    const Vec3 hr = rv.x * h.x + (rv.y * h.y + rv.z * h.z);
    const Vec3 r = cross(l, u) + cross(p, v) - hr;
    const Vec3 dum = solve(m, r), um = u + dum;

    const Vec3 am = g * um;
    const VF turned = dot(am, am);
    Vec3 dp = turned_by(am, turned, momentum);
    VF f;
    if constexpr (kShed) {
        // P = (1 + [a]x)^-1 (P0 + f a x n), f the shed momentum in the middle.
        const VF one = constant(1.0f), inverse = one / (one + turned);
        if constexpr (kSheet) {
            const VF lighter = shed * constant(n[5]);
            const Vec3 wake = inverse * Vec3{am.y - am.z * am.x, -(am.x + am.z * am.y), turned - am.z * am.z};
            const VF carried = constant(c.slip[2]) * um.x + constant(c.slip[5]) * um.y;
            f = (lighter * (momentum.z + dp.z) - shed * carried) / (one - lighter * wake.z);
            dp += f * wake;
        } else {
            const Vec3 wake = inverse * (cross(am, axis) + turned * axis - dot(am, axis) * am);
            const VF carried = dot(arm, um) - dot(axis, columns(c.slip, um));
            f = shed * (dot(moved_along, momentum + dp) + carried) / (one - shed * dot(moved_along, wake));
            dp += f * wake;
        }
    }
    const Vec3 pm = momentum + dp;
    const Vec3 moved_by = block<kSheet>(n, dp), dragged_along = coupled<kSheet>(c.slip, dp);
    const Vec3 lm = angular + (dragged_along + block<kSheet>(s, dum));
    const Vec3 vm = v + (moved_by - coupled_back<kSheet>(c.slip, dum));
    Vec3 dl = cross(lm, um) + cross(pm, vm);
    if constexpr (kSheet)
        dl -= f * Vec3{-vm.y, vm.x, hn::Zero(DF())};
    else if constexpr (kShed)
        dl -= f * (cross(arm, um) + cross(axis, vm));
    dl = (g + g) * dl;
    const Vec3 spun = dl - (dragged_along + dragged_along); // S du
    // S^-1 is the lower block of M^-1: the last six of its upper triangle.
    const Vec3 du = block<kSheet>(c.full_inverse + 15, spun), u1 = u + du;
    const VF gained = constant(4.0f) * dot(pm, moved_by) + dot(u + u1, spun);
    const VF factor = spin_factor(gained, dot(spin_momentum + spun, u1));
    const Vec3 scaled = factor * u1;
    Motion out{{vm, um}, {v + (moved_by + moved_by) - coupled_back<kSheet>(c.slip, scaled - u), scaled}, g};
    if (const auto left = unsolved(factor, dot(p, b), turned); !hn::AllFalse(DF(), left))
        resolve_motion<true>(c, shed, start, g, left, out);
    return out;
}

} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
