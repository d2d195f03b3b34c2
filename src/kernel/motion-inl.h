// The generalised Kirchhoff equations with turbulent loads, for one vector of bodies.
// Equations: docs/maintainers/physics.md, "Equations of motion" (paper Eqs. 4-6 and 11-12, corrected). Kernel units: constants.h.
#if defined(LR_KERNEL_MOTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_MOTION_INL_H_
#undef LR_KERNEL_MOTION_INL_H_
#else
#define LR_KERNEL_MOTION_INL_H_
#endif

#include "kernel/constants.h"
#include "kernel/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

struct Vec3 {
    VF x, y, z;
};
struct Quaternion {
    VF x, y, z, w;
};

HWY_INLINE Vec3 add(Vec3 a, Vec3 b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Vec3 sub(Vec3 a, Vec3 b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Vec3 scale(VF s, Vec3 a) {
    return {hn::Mul(s, a.x), hn::Mul(s, a.y), hn::Mul(s, a.z)};
}
HWY_INLINE Vec3 add_scaled(Vec3 a, VF s, Vec3 b) {
    return {mul_add(s, b.x, a.x), mul_add(s, b.y, a.y), mul_add(s, b.z, a.z)};
}
HWY_INLINE VF dot(Vec3 a, Vec3 b) {
    return mul_add(a.x, b.x, mul_add(a.y, b.y, hn::Mul(a.z, b.z)));
}
HWY_INLINE Vec3 cross(Vec3 a, Vec3 b) {
    return {mul_sub(a.y, b.z, hn::Mul(a.z, b.y)), mul_sub(a.z, b.x, hn::Mul(a.x, b.z)),
            mul_sub(a.x, b.y, hn::Mul(a.y, b.x))};
}
template <class T> HWY_INLINE Vec3 broadcast(const T* v) {
    return {constant(v[0]), constant(v[1]), constant(v[2])};
}
template <class T> HWY_INLINE Vec3 scaled_by(const T* d, Vec3 a) {
    return {hn::Mul(constant(d[0]), a.x), hn::Mul(constant(d[1]), a.y), hn::Mul(constant(d[2]), a.z)};
}

// R(q) a and R(q)^T a. For a quaternion off the unit sphere by the truncation error of a Runge-Kutta stage, a smooth
// extension of the rotation: the order of the scheme holds.
HWY_INLINE Vec3 to_world(Quaternion q, Vec3 a) {
    const Vec3 axis{q.x, q.y, q.z};
    Vec3 t = cross(axis, a);
    t = add(t, t);
    return add(add_scaled(a, q.w, t), cross(axis, t));
}
HWY_INLINE Vec3 to_body(Quaternion q, Vec3 a) {
    const Vec3 axis{q.x, q.y, q.z};
    Vec3 t = cross(a, axis);
    t = add(t, t);
    return add(add_scaled(a, q.w, t), cross(t, axis));
}
// The same for a quaternion of any length but 0.
HWY_INLINE Vec3 to_world_scaled(Quaternion q, Vec3 a) {
    const Vec3 axis{q.x, q.y, q.z};
    const VF n = mul_add(q.x, q.x, mul_add(q.y, q.y, mul_add(q.z, q.z, hn::Mul(q.w, q.w))));
    const Vec3 t = scale(hn::Div(constant(2.0f), n), cross(axis, a));
    return add(add_scaled(a, q.w, t), cross(axis, t));
}

// q + s q (w, 0): with s = h/2, an Euler step of the kinematics q' = 1/2 q (w, 0).
HWY_INLINE Quaternion turn(Quaternion from, Quaternion q, VF s, Vec3 w) {
    const Vec3 v = scale(s, w);
    return {hn::Add(from.x, hn::Sub(mul_add(q.w, v.x, hn::Mul(q.y, v.z)), hn::Mul(q.z, v.y))),
            hn::Add(from.y, hn::Sub(mul_add(q.w, v.y, hn::Mul(q.z, v.x)), hn::Mul(q.x, v.z))),
            hn::Add(from.z, hn::Sub(mul_add(q.w, v.z, hn::Mul(q.x, v.y)), hn::Mul(q.y, v.x))),
            hn::Sub(from.w, dot({q.x, q.y, q.z}, v))};
}
HWY_INLINE Quaternion normalised(Quaternion q) {
    const VF n = mul_add(q.x, q.x, mul_add(q.y, q.y, mul_add(q.z, q.z, hn::Mul(q.w, q.w))));
    const VF s = hn::Div(constant(1.0f), hn::Sqrt(n));
    return {hn::Mul(q.x, s), hn::Mul(q.y, s), hn::Mul(q.z, s), hn::Mul(q.w, s)};
}

// Magnitudes under 1e-15 become zero: their squares would be denormal, which is slow, and nothing can be seen of them.
HWY_INLINE VF without_dust(VF v) {
    return hn::IfThenElseZero(hn::Ge(hn::Abs(v), constant(1e-15f)), v);
}

// Velocity through the fluid and spin, in kernel units: u = d s w.
struct Twist {
    Vec3 v, u;
};
HWY_INLINE Twist add_scaled(Twist a, VF s, Twist b) {
    return {add_scaled(a.v, s, b.v), add_scaled(a.u, s, b.u)};
}
HWY_INLINE Twist add(Twist a, Twist b) {
    return {add(a.v, b.v), add(a.u, b.u)};
}

template <class T> HWY_INLINE VF weighted(const T* k, Vec3 w) {
    return mul_add(constant(k[0]), w.x, mul_add(constant(k[1]), w.y, hn::Mul(constant(k[2]), w.z)));
}
// Row-major 3x3 matrix.
template <class T> HWY_INLINE Vec3 rows(const T* m, Vec3 a) {
    return {weighted(m, a), weighted(m + 3, a), weighted(m + 6, a)};
}

template <class T> HWY_INLINE Vec3 symmetric3(const T* m, Vec3 a) {
    return {mul_add(constant(m[0]), a.x, mul_add(constant(m[1]), a.y, hn::Mul(constant(m[2]), a.z))),
            mul_add(constant(m[1]), a.x, mul_add(constant(m[3]), a.y, hn::Mul(constant(m[4]), a.z))),
            mul_add(constant(m[2]), a.x, mul_add(constant(m[4]), a.y, hn::Mul(constant(m[5]), a.z)))};
}

// Upper triangle, row by row: 0..5 row vx, 6..10 row vy, 11..14 row vz, 15..17 row wx, 18..19 row wy, 20.
template <class T> HWY_INLINE Twist symmetric6(const T* m, Twist t) {
    static constexpr int at[6][6] = {{0, 1, 2, 3, 4, 5},     {1, 6, 7, 8, 9, 10},    {2, 7, 11, 12, 13, 14},
                                     {3, 8, 12, 15, 16, 17}, {4, 9, 13, 16, 18, 19}, {5, 10, 14, 17, 19, 20}};
    const VF in[6] = {t.v.x, t.v.y, t.v.z, t.u.x, t.u.y, t.u.z};
    VF out[6];
    for (int i = 0; i < 6; ++i) {
        VF sum = hn::Mul(constant(m[at[i][0]]), in[0]);
        for (int j = 1; j < 6; ++j) sum = mul_add(constant(m[at[i][j]]), in[j], sum);
        out[i] = sum;
    }
    return {{out[0], out[1], out[2]}, {out[3], out[4], out[5]}};
}

struct Body {
    Vec3 x;
    Quaternion q;
    Twist t; // relative to the fluid
    VF age, age_rest;
    Vec3 gust; // m/s, world; AERODYNAMIC loads
};

// Up to this age a plain sum errs by less than 1e-3 for substeps of 0.1 ms and more. Beyond, what each addition rounds
// away is made up for at the next (Kahan 1965): a plain sum of 4 ms stops growing after 18 hours.
inline constexpr float plain_age = 2.0f; // s
HWY_INLINE void grow_older(Body& b, VF h) {
    const VF growth = hn::Sub(h, b.age_rest);
    const VF age = hn::Add(b.age, growth);
    b.age_rest = hn::IfThenElseZero(hn::Ge(age, constant(plain_age)), hn::Sub(hn::Sub(age, b.age), growth));
    b.age = age;
}

// alpha and beta^2 at an age, linear between samples (docs/maintainers/physics.md, "AGE clock"). Not inlined: few batches have this clock.
[[maybe_unused, gnu::cold]] static HWY_NOINLINE void sample_table(const TableConstants& t, VF age, VF& alpha,
                                                                  VF& beta_squared) {
    const DI di;
    VF at = hn::Mul(age, constant(t.inverse_dt));
    const VF last = constant(t.last);
    if (t.loop && t.last > 0.0f) {
        const VF turns = hn::Floor(hn::Div(at, last));
        at = neg_mul_add(turns, last, at);
    }
    at = hn::Max(hn::Min(at, last), constant(0.0f));
    const VI below = hn::ConvertTo(di, hn::Min(at, hn::Max(hn::Sub(last, constant(1.0f)), constant(0.0f))));
    const VI above = hn::ConvertTo(di, hn::Min(hn::Add(hn::ConvertTo(DF(), below), constant(1.0f)), last));
    const VF part = hn::Sub(at, hn::ConvertTo(DF(), below));
    const VF a0 = hn::GatherIndex(DF(), t.alpha, below), a1 = hn::GatherIndex(DF(), t.alpha, above);
    const VF b0 = hn::GatherIndex(DF(), t.beta_squared, below), b1 = hn::GatherIndex(DF(), t.beta_squared, above);
    alpha = mul_add(part, hn::Sub(a1, a0), a0);
    beta_squared = mul_add(part, hn::Sub(b1, b0), b0);
}

// Forces from outside in kernel units: force/(U s^3), torque/(U s^3 d s), and accelerations v', u'.
struct External {
    Twist force[2], rate[2]; // in the world's and in the body's frame
};

// What stays fixed over the stages of one substep.
struct Held {
    VF inverse_length; // 1/(d s)
    VF alpha, beta;    // 1/s and m/s^(3/2), AGE clock
    Twist noise;       // weighted turbulent force and torque per unit mass
    // The fluid at the body, world axes, in the middle of the substep (docs/reference/wind_and_water.md).
    Vec3 wind;       // m/s
    Vec3 weight;     // force per mass unit: gravity, buoyancy, acceleration of the fluid and of the frame of t
    Vec3 gravity;    // m/s^2, as buoyancy feels it: less the fluid's own acceleration
    Vec3 fluid_spin; // d s times half the vorticity; read only where `sheared`
    bool sheared;
    bool uniform;                       // weight is (m - rho V)/U gravity
    const External* external = nullptr; // null without forces from outside
};

template <bool kFull, class C> HWY_INLINE Twist momentum(const C& c, Twist t) {
    if constexpr (kFull) return symmetric6(c.full_mass, t);
    return {scaled_by(c.mass, t.v), scaled_by(c.spin_mass, t.u)};
}
template <bool kFull, class C> HWY_INLINE Twist acceleration(const C& c, Twist force) {
    if constexpr (kFull) return symmetric6(c.full_inverse, force);
    return {scaled_by(c.inverse_mass, force.v), scaled_by(c.inverse_spin_mass, force.u)};
}
HWY_INLINE Twist to_body(Quaternion q, Twist t) {
    return {to_body(q, t.v), to_body(q, t.u)};
}

// Force and torque of what acts from outside at an orientation. Not inlined: few batches have any, and it would be there
// four times in each variant of the kernel.
template <bool kFull, class C> static HWY_NOINLINE Twist external_force(const C& c, const External& e, Quaternion q) {
    const Twist rate = add(e.rate[1], to_body(q, e.rate[0]));
    return add(add(e.force[1], to_body(q, e.force[0])), momentum<kFull>(c, rate));
}

// rho (V I + A) on velocity, rho D on spin: the fluid that turbulence acts on (docs/maintainers/physics.md section 3).
template <bool kFull, class C> HWY_INLINE Twist dragged(const C& c, Twist t) {
    if constexpr (kFull) return {symmetric3(c.full_damping, t.v), symmetric3(c.full_spin_damping, t.u)};
    return {scaled_by(c.damping, t.v), scaled_by(c.spin_damping, t.u)};
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
