// Generalised Kirchhoff equations with turbulent loads, for a vector of bodies: docs/maintainers/physics.md, section 3 (paper Eqs. 4-6, 11 and 12,
// corrected). Kernel units: body_constants.h.
#if defined(LR_KERNEL_INTEGRATOR_EQUATIONS_OF_MOTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_INTEGRATOR_EQUATIONS_OF_MOTION_INL_H_
#undef LR_KERNEL_INTEGRATOR_EQUATIONS_OF_MOTION_INL_H_
#else
#define LR_KERNEL_INTEGRATOR_EQUATIONS_OF_MOTION_INL_H_
#endif

#include "kernel/body_constants.h"
#include "kernel/divergence.h"
#include "kernel/math/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::LR_KERNEL_NAMESPACE {

struct Vec3 {
    VF x, y, z;
};
struct Quaternion {
    VF x, y, z, w;
};

HWY_INLINE Vec3 zero3() {
    const VF zero = hn::Zero(DF());
    return {zero, zero, zero};
}
template <class F, class... V> HWY_INLINE Vec3 each_axis(const F& f, const V&... v) {
    return {f(v.x...), f(v.y...), f(v.z...)};
}

HWY_INLINE Vec3 operator+(Vec3 a, Vec3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE Vec3 operator-(Vec3 a, Vec3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE Vec3 operator*(VF s, Vec3 a) {
    return {s * a.x, s * a.y, s * a.z};
}
HWY_INLINE Vec3& operator+=(Vec3& a, Vec3 b) {
    return a = a + b;
}
HWY_INLINE Vec3& operator-=(Vec3& a, Vec3 b) {
    return a = a - b;
}
HWY_INLINE Vec3 times(Vec3 a, Vec3 b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
HWY_INLINE VF dot(Vec3 a, Vec3 b) {
    return a.x * b.x + (a.y * b.y + a.z * b.z);
}
HWY_INLINE Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T> HWY_INLINE Vec3 broadcast(const T* v) {
    return {constant(v[0]), constant(v[1]), constant(v[2])};
}
template <class T> HWY_INLINE Vec3 scaled_by(const T* d, Vec3 a) {
    return {constant(d[0]) * a.x, constant(d[1]) * a.y, constant(d[2]) * a.z};
}

HWY_INLINE VF norm_squared(Quaternion q) {
    return q.x * q.x + (q.y * q.y + (q.z * q.z + q.w * q.w));
}

// R(q) a and R(q)^T a. Runge-Kutta's stages leave the unit sphere; there this is a smooth extension, so the scheme keeps its order.
HWY_INLINE Vec3 to_world(Quaternion q, Vec3 a) {
    const Vec3 axis{q.x, q.y, q.z};
    Vec3 t = cross(axis, a);
    t += t;
    return a + q.w * t + cross(axis, t);
}
HWY_INLINE Vec3 to_body(Quaternion q, Vec3 a) {
    const Vec3 axis{q.x, q.y, q.z};
    Vec3 t = cross(a, axis);
    t += t;
    return a + q.w * t + cross(t, axis);
}
// q + s q (w, 0). With s = h/2 this is an Euler step of q' = 1/2 q (w, 0).
HWY_INLINE Quaternion turn(Quaternion from, Quaternion q, VF s, Vec3 w) {
    const Vec3 v = s * w;
    return {from.x + (q.w * v.x + q.y * v.z - q.z * v.y), from.y + (q.w * v.y + q.z * v.x - q.x * v.z),
            from.z + (q.w * v.z + q.x * v.y - q.y * v.x), from.w - dot({q.x, q.y, q.z}, v)};
}
HWY_INLINE Quaternion normalised(Quaternion q) {
    const VF s = constant(1.0f) / hn::Sqrt(norm_squared(q));
    return {q.x * s, q.y * s, q.z * s, q.w * s};
}

HWY_INLINE VF greatest(Vec3 v) {
    return hn::Max(hn::Abs(v.x), hn::Max(hn::Abs(v.y), hn::Abs(v.z)));
}
// The inverse of a vector's length; 0 for the zero vector.
HWY_INLINE VF inverse_length(VF length) {
    const VF least = constant(1e-30f);
    return hn::IfThenElseZero(length > least, constant(1.0f) / hn::Max(length, least));
}

// Sets magnitudes below 1e-15 to zero: their squares would be denormal, which is slow, and nobody can see them.
HWY_INLINE VF without_dust(VF v) {
    return hn::IfThenElseZero(hn::Abs(v) >= constant(1e-15f), v);
}
HWY_INLINE Vec3 without_dust(Vec3 v) {
    return each_axis([](VF x) LR_LAMBDA { return without_dust(x); }, v);
}

template <class M> HWY_INLINE Vec3 select(M mask, Vec3 yes, Vec3 no) {
    return each_axis([&](VF x, VF y) LR_LAMBDA { return hn::IfThenElse(mask, x, y); }, yes, no);
}
template <class M> HWY_INLINE Quaternion select(M mask, Quaternion yes, Quaternion no) {
    return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z),
            hn::IfThenElse(mask, yes.w, no.w)};
}

// Velocity through the fluid and spin, in kernel units: u = d s w.
struct Twist {
    Vec3 v, u;
};
HWY_INLINE Twist operator+(const Twist& a, const Twist& b) {
    return {a.v + b.v, a.u + b.u};
}
HWY_INLINE Twist operator-(const Twist& a, const Twist& b) {
    return {a.v - b.v, a.u - b.u};
}
HWY_INLINE Twist operator*(VF s, const Twist& a) {
    return {s * a.v, s * a.u};
}
HWY_INLINE Twist& operator+=(Twist& a, const Twist& b) {
    return a = a + b;
}
template <class M> HWY_INLINE Twist select(M mask, const Twist& yes, const Twist& no) {
    return {select(mask, yes.v, no.v), select(mask, yes.u, no.u)};
}
template <class F, class... T> HWY_INLINE Twist each_axis6(const F& f, const T&... t) {
    return {each_axis(f, t.v...), each_axis(f, t.u...)};
}

// A 3x3 matrix by rows, different for each body.
struct Matrix {
    Vec3 row[3];
};
HWY_INLINE Vec3 operator*(const Matrix& m, Vec3 a) {
    return {dot(m.row[0], a), dot(m.row[1], a), dot(m.row[2], a)};
}
HWY_INLINE Matrix operator+(const Matrix& a, const Matrix& b) {
    return {{a.row[0] + b.row[0], a.row[1] + b.row[1], a.row[2] + b.row[2]}};
}
HWY_INLINE Matrix& operator+=(Matrix& a, const Matrix& b) {
    return a = a + b;
}
HWY_INLINE Matrix operator-(const Matrix& a, const Matrix& b) {
    return {{a.row[0] - b.row[0], a.row[1] - b.row[1], a.row[2] - b.row[2]}};
}
HWY_INLINE Matrix operator*(VF s, const Matrix& m) {
    return {{s * m.row[0], s * m.row[1], s * m.row[2]}};
}
HWY_INLINE Matrix transposed(const Matrix& m) {
    return {{{m.row[0].x, m.row[1].x, m.row[2].x},
             {m.row[0].y, m.row[1].y, m.row[2].y},
             {m.row[0].z, m.row[1].z, m.row[2].z}}};
}
HWY_INLINE Matrix operator*(const Matrix& a, const Matrix& b) {
    const auto row = [&](Vec3 r) LR_LAMBDA { return r.x * b.row[0] + (r.y * b.row[1] + r.z * b.row[2]); };
    return {{row(a.row[0]), row(a.row[1]), row(a.row[2])}};
}
HWY_INLINE Matrix outer(Vec3 a, Vec3 b) {
    return {{a.x * b, a.y * b, a.z * b}};
}

template <class T> HWY_INLINE VF weighted(const T* k, Vec3 w) {
    return constant(k[0]) * w.x + (constant(k[1]) * w.y + constant(k[2]) * w.z);
}
// A row-major 3x3 matrix times a vector, and its transpose times a vector.
template <class T> HWY_INLINE Vec3 rows(const T* m, Vec3 a) {
    return {weighted(m, a), weighted(m + 3, a), weighted(m + 6, a)};
}
template <class T> HWY_INLINE Vec3 columns(const T* m, Vec3 a) {
    return a.x * broadcast(m) + (a.y * broadcast(m + 3) + a.z * broadcast(m + 6));
}

template <class T> HWY_INLINE Vec3 symmetric3(const T* m, Vec3 a) {
    return {constant(m[0]) * a.x + (constant(m[1]) * a.y + constant(m[2]) * a.z),
            constant(m[1]) * a.x + (constant(m[3]) * a.y + constant(m[4]) * a.z),
            constant(m[2]) * a.x + (constant(m[4]) * a.y + constant(m[5]) * a.z)};
}

template <class T> HWY_INLINE Twist broadcast6(const T* v) {
    return {broadcast(v), broadcast(v + 3)};
}
template <class Entry> HWY_INLINE Twist times_matrix6(const Entry& entry, const Twist& t) {
    const VF in[6] = {t.v.x, t.v.y, t.v.z, t.u.x, t.u.y, t.u.z};
    VF out[6];
    for (int i = 0; i < 6; ++i) {
        VF sum = constant(entry(i, 0)) * in[0];
        for (int j = 1; j < 6; ++j) sum = constant(entry(i, j)) * in[j] + sum;
        out[i] = sum;
    }
    return broadcast6(out);
}
template <class T> HWY_INLINE Twist symmetric6(const T* m, const Twist& t) {
    return times_matrix6([&](int i, int j) LR_LAMBDA { return m[upper6[i][j]]; }, t);
}
// m t or m^T t for a full 6x6 matrix.
template <bool kTransposed, class T> HWY_INLINE Twist general6(const T* m, const Twist& t) {
    return times_matrix6([&](int i, int j) LR_LAMBDA { return m[kTransposed ? 6 * j + i : 6 * i + j]; }, t);
}

HWY_INLINE Quaternion product(Quaternion a, Quaternion b) {
    return {a.w * b.x + a.x * b.w + (a.y * b.z - a.z * b.y), a.w * b.y + a.y * b.w + (a.z * b.x - a.x * b.z),
            a.w * b.z + a.z * b.w + (a.x * b.y - a.y * b.x), a.w * b.w - a.x * b.x - (a.y * b.y + a.z * b.z)};
}

struct Body {
    Vec3 x;
    Quaternion q;
    Twist t; // relative to the fluid
    VF age, age_remainder;
    // AERODYNAMIC loads
    Vec3 gust;      // m/s, world
    Vec3 lag;       // m/s, load axes: the stream in which the wake was left (physics.md 5.1)
    VF shedding[4]; // the wake's oscillator along two axes, then its rates
};

// From this age on the sum is compensated (Kahan 1965), since a plain sum of 4 ms substeps stops growing after 18 hours. Before, it errs by less than
// 1e-3 for substeps of 0.1 ms and more.
inline constexpr float plain_age = 2.0f; // s
HWY_INLINE void grow_older(Body& b, VF h) {
    const VF growth = h - b.age_remainder;
    const VF age = b.age + growth;
    b.age_remainder = hn::IfThenElseZero(age >= constant(plain_age), age - b.age - growth);
    b.age = age;
}

// alpha and beta^2 at an age, linear between samples (physics.md, section 4, AGE clock). Not inlined, since few batches use this clock.
[[maybe_unused, gnu::cold]] static HWY_NOINLINE void sample_table(const TableConstants& t, VF age, VF& alpha,
                                                                  VF& beta_squared) {
    const DI di;
    VF at = age * constant(t.inverse_dt);
    const VF last = constant(t.last);
    if (t.loop && t.last > 0.0f) {
        const VF turns = hn::Floor(at / last);
        at -= turns * last;
    }
    at = hn::Max(hn::Min(at, last), constant(0.0f));
    const VI below = hn::ConvertTo(di, hn::Min(at, hn::Max(last - constant(1.0f), constant(0.0f))));
    const VI above = hn::ConvertTo(di, hn::Min(hn::ConvertTo(DF(), below) + constant(1.0f), last));
    const VF part = at - hn::ConvertTo(DF(), below);
    const VF a0 = hn::GatherIndex(DF(), t.alpha, below), a1 = hn::GatherIndex(DF(), t.alpha, above);
    const VF b0 = hn::GatherIndex(DF(), t.beta_squared, below), b1 = hn::GatherIndex(DF(), t.beta_squared, above);
    alpha = part * (a1 - a0) + a0;
    beta_squared = part * (b1 - b0) + b0;
}

// External forces in kernel units: force/(U s^3), torque/(U s^3 d s), and accelerations v', u'.
struct External {
    Twist force[2], rate[2]; // in the world's frame, in the body's
};

// Values that stay constant over the stages of a substep.
struct Held {
    VF inverse_length; // 1/(d s)
    VF drag, lift;     // AERODYNAMIC: inverse_length times the body's own factors, from vary()
    VF alpha, beta;    // AGE clock: 1/s, m/s^(3/2)
    VF shed;           // AERODYNAMIC: added mass along the normal that stays in the wake
    Twist noise;       // weighted turbulent force and torque per unit mass
    // The fluid at the body in the middle of the substep, world axes (docs/reference/wind_and_water.md).
    Vec3 wind;       // m/s
    Vec3 weight;     // force over the mass unit: gravity, buoyancy, acceleration of the fluid and of the frame of t
    Vec3 gravity;    // m/s^2, as buoyancy sees it: less the fluid's acceleration
    Vec3 fluid_spin; // d s times half the vorticity; valid if `sheared`
    bool sheared;
    bool uniform;                       // weight is (m - rho V)/U times gravity
    const External* external = nullptr; // null without external forces
};

template <bool kFull, class C> HWY_INLINE Twist momentum(const C& c, Twist t) {
    if constexpr (kFull) return symmetric6(c.full_mass, t);
    return {scaled_by(c.mass, t.v), scaled_by(c.spin_mass, t.u)};
}
// Momentum that moves with the body: a plate leaves a part of its added momentum, that of the mass `shed` along the normal, in the wake. Kirchhoff's
// products conserve energy for any momentum.
template <bool kFull, bool kShed, class C>
HWY_INLINE Twist moving_momentum(const C& c, VF shed, const Twist& momentum, const Twist& t) {
    static_assert(kFull || !kShed);
    if constexpr (!kShed) return momentum;
    const Vec3 n = broadcast(c.aerodynamics.normal), arm = broadcast(c.aerodynamics.normal_arm);
    const VF lost = shed * (dot(n, t.v) + dot(arm, t.u));
    return {momentum.v - lost * n, momentum.u - lost * arm};
}
template <bool kFull, class C> HWY_INLINE Twist acceleration(const C& c, Twist force) {
    if constexpr (kFull) return symmetric6(c.full_inverse, force);
    return {scaled_by(c.inverse_mass, force.v), scaled_by(c.inverse_spin_mass, force.u)};
}
HWY_INLINE Twist to_body(Quaternion q, Twist t) {
    return {to_body(q, t.v), to_body(q, t.u)};
}

// External force and torque at an orientation. Not inlined: few batches have any, and each variant would contain it four times.
template <bool kFull, class C> static HWY_NOINLINE Twist external_force(const C& c, const External& e, Quaternion q) {
    const Twist rate = e.rate[1] + to_body(q, e.rate[0]);
    return e.force[1] + to_body(q, e.force[0]) + momentum<kFull>(c, rate);
}

// rho (V I + A) times velocity, rho D' times spin: the fluid on which turbulence acts (physics.md, section 4).
template <bool kFull, class C> HWY_INLINE Twist dragged(const C& c, Twist t) {
    if constexpr (kFull) return {symmetric3(c.full_damping, t.v), symmetric3(c.full_spin_damping, t.u)};
    return {scaled_by(c.damping, t.v), scaled_by(c.spin_damping, t.u)};
}

// Loads and stores of a vector of bodies, in a batch's arrays or in rows of a block. Diverged bodies are not stored (kernel/divergence.h).

HWY_INLINE VF load1(const float* row, size_t at) {
    return hn::Load(DF(), row + at);
}
HWY_INLINE VU load1(const uint32_t* row, size_t at) {
    return hn::Load(DU(), row + at);
}
HWY_INLINE VF load1(const BatchArrays& a, size_t field, size_t at) {
    return load1(a.field[field], at);
}
HWY_INLINE void store1(float* row, size_t at, VF v) {
    hn::Store(v, DF(), row + at);
}
HWY_INLINE void store1(uint32_t* row, size_t at, VU v) {
    hn::Store(v, DU(), row + at);
}
HWY_INLINE void store1(const BatchArrays& a, size_t field, size_t at, VF v) {
    store1(a.field[field], at, v);
}

// x, y, z (and w) from successive rows or fields.
template <class Row> HWY_INLINE Vec3 load3(const Row* rows, size_t at) {
    return {load1(rows[0], at), load1(rows[1], at), load1(rows[2], at)};
}
template <class Row> HWY_INLINE Quaternion load4(const Row* rows, size_t at) {
    return {load1(rows[0], at), load1(rows[1], at), load1(rows[2], at), load1(rows[3], at)};
}
template <class Row> HWY_INLINE void store3(Row* rows, size_t at, Vec3 v) {
    store1(rows[0], at, v.x);
    store1(rows[1], at, v.y);
    store1(rows[2], at, v.z);
}
template <class Row> HWY_INLINE void store4(Row* rows, size_t at, Quaternion q) {
    store3(rows, at, {q.x, q.y, q.z});
    store1(rows[3], at, q.w);
}
template <class Row> HWY_INLINE Matrix load_matrix(const Row* rows, size_t at) {
    return {{load3(rows, at), load3(rows + 3, at), load3(rows + 6, at)}};
}
template <class Row> HWY_INLINE void store_matrix(Row* rows, size_t at, const Matrix& m) {
    for (int i = 0; i < 3; ++i) store3(rows + 3 * i, at, m.row[i]);
}
HWY_INLINE Vec3 load3(const BatchArrays& a, size_t field, size_t at) {
    return load3(a.field + field, at);
}
HWY_INLINE void store3(const BatchArrays& a, size_t field, size_t at, Vec3 v) {
    store3(a.field + field, at, v);
}
HWY_INLINE Quaternion load4(const BatchArrays& a, size_t at) {
    return load4(a.field + field_qx, at);
}

// Numbers that are not finite become 0, or they would reach other bodies through the bounds of their block.
HWY_INLINE Vec3 within(Vec3 v, float limit) {
    const VF most = constant(limit);
    return each_axis([&](VF x) LR_LAMBDA { return hn::IfThenElseZero(hn::Abs(x) <= most, x); }, v);
}

template <bool kGust> HWY_INLINE Body load_body(const BatchArrays& a, size_t at) {
    Body b;
    b.x = load3(a, field_x, at);
    b.q = load4(a, at);
    b.age = load1(a, field_age, at);
    b.age_remainder = load1(a, field_age_remainder, at);
    if constexpr (kGust) {
        b.gust = load3(a, field_gust_x, at);
        b.lag = load3(a, field_lag_x, at);
        for (size_t i = 0; i < 4; ++i) b.shedding[i] = load1(a, field_shedding_0 + i, at);
    }
    return b;
}

// False for NaN, which fails every comparison.
HWY_INLINE hn::Mask<DF> sane_pose(Vec3 x, Quaternion q) {
    const VF far = constant(farthest_place);
    const VF turn = norm_squared(q);
    const auto near = hn::And(hn::Abs(x.x) <= far, hn::And(hn::Abs(x.y) <= far, hn::Abs(x.z) <= far));
    return hn::And(near, hn::And(turn >= constant(shortest_turn), turn <= constant(longest_turn)));
}
HWY_INLINE hn::Mask<DF> sane_motion(Vec3 v, Vec3 w) {
    return hn::And(dot(v, v) <= constant(fastest_squared), dot(w, w) <= constant(fastest_spin_squared));
}
HWY_INLINE hn::Mask<DF> not_held(const BatchArrays& a, size_t at) {
    return load1(a, field_age_remainder, at) > constant(least_age_remainder);
}

// Stores bodies after `seconds`; diverged and held ones keep their state.
template <class Store>
HWY_INLINE void store_sane(const BatchArrays& a, size_t at, hn::Mask<DF> sane, float seconds, bool gusts,
                           uint32_t* faults, const Store& store) {
    const bool all_sane = hn::AllTrue(DF(), hn::And(sane, not_held(a, at)));
    BodiesBefore before;
    if (HWY_UNLIKELY(!all_sane)) before.take(a, at, hn::Lanes(DF()));
    store();
    if (HWY_UNLIKELY(!all_sane)) before.hold(a, at, hn::Lanes(DF()), seconds, gusts, faults);
}
// v, w: body frame, m/s and rad/s.
HWY_INLINE void store_velocities(const BatchArrays& a, size_t at, Vec3 v, Vec3 w, uint32_t* faults) {
    store_sane(a, at, sane_motion(v, w), 0.0f, false, faults, [&]() LR_LAMBDA {
        store3(a, field_vx, at, without_dust(v));
        store3(a, field_wx, at, without_dust(w));
    });
}
template <bool kGust>
HWY_INLINE void store_body(const BatchArrays& a, size_t at, const Body& b, Vec3 v, Vec3 w, float seconds,
                           uint32_t* faults) {
    auto sane = hn::And(sane_pose(b.x, b.q), sane_motion(v, w));
    if constexpr (kGust) sane = hn::And(sane, dot(b.gust, b.gust) <= constant(fastest_squared));
    store_sane(a, at, sane, seconds, kGust, faults, [&]() LR_LAMBDA {
        if constexpr (kGust) {
            store3(a, field_gust_x, at, b.gust);
            store3(a, field_lag_x, at, b.lag);
            for (size_t i = 0; i < 4; ++i) store1(a, field_shedding_0 + i, at, b.shedding[i]);
        }
        store3(a, field_x, at, b.x);
        store4(a.field + field_qx, at, b.q);
        store3(a, field_vx, at, without_dust(v));
        store3(a, field_wx, at, without_dust(w));
        store1(a, field_age, at, b.age);
        store1(a, field_age_remainder, at, b.age_remainder);
    });
}
} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
