// Quasi-steady loads for a vector of bodies: docs/maintainers/physics.md, section 5. Kernel units and constants: body_constants.h. `b`: 1/(d s).
// `nu`: viscosity over d s, a velocity. v: of the load centre, along the load axes.
#if defined(LR_KERNEL_LOADS_AERODYNAMIC_LOADS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_LOADS_AERODYNAMIC_LOADS_INL_H_
#undef LR_KERNEL_LOADS_AERODYNAMIC_LOADS_INL_H_
#else
#define LR_KERNEL_LOADS_AERODYNAMIC_LOADS_INL_H_
#endif

#include "kernel/integrator/equations_of_motion-inl.h"
#include "kernel/integrator/splitting_scheme-inl.h"
#include "kernel/integrator/step.h"
#include "kernel/math/gaussian_noise-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::LR_KERNEL_NAMESPACE {

// Positive, so that the direction exists; far below any visible speed.
HWY_INLINE VF speed_squared(Vec3 v) {
    return dot(v, v) + constant(1e-20f);
}

// Below the onset of shedding a plate's wake is closed, is renewed slowly and stalls late: 0.4. Far above the onset: 1.
HWY_INLINE VF open_wake(VF calm) {
    const VF one = constant(1.0f);
    return one - constant(0.6f) * hn::Min(calm, one);
}

// Flow past a plate: the stream that its attached part follows, a mean of the present one and the wake's, and the attached share.
struct PlateFlow {
    VF across, x2, y2, along2, inverse_along2, attached; // x2, y2, along2: squares in the plate's plane
};
template <class T> HWY_INLINE VF along_plate(const T* k, const PlateFlow& flow) {
    return constant(k[0]) * flow.x2 + constant(k[1]) * flow.y2;
}
template <class A> HWY_INLINE PlateFlow plate_flow(const A& c, VF nu, VF inverse_s, Vec3 lag, Vec3 v) {
    const VF one = constant(1.0f);
    // Keeps a direction in the plane for a stream exactly along the normal.
    const VF least = constant(1e-20f);
    const Vec3 u = v + constant(c.wake_share) * (lag - v);
    PlateFlow out;
    out.across = u.z;
    out.x2 = u.x * u.x + least;
    out.y2 = u.y * u.y + least;
    const VF a2 = u.z * u.z;
    out.along2 = out.x2 + out.y2;
    out.inverse_along2 = one / out.along2;
    const VF s2 = out.along2 + a2;
    // attached = cos^2 a/(cos^2 a + cos^2 a_s (sin a/sin a_s)^8): half at the stall angle a_s, with `stall` = 1/sin^2 a_s.
    const VF critical = constant(c.shedding_reynolds) * nu * inverse_s, open = open_wake(critical * critical);
    const VF stall = open * hn::Max(along_plate(c.plate_stall, out) * out.inverse_along2 - one, hn::Zero(DF())) + one;
    VF x = a2 * stall / s2;
    x *= x;
    const VF kept = out.along2 * stall;
    out.attached = kept / (kept + s2 * (stall - one) * (x * x) + constant(1e-30f));
    return out;
}
// Added mass along the normal that stays in the wake; a steady wake keeps none.
template <class A> HWY_INLINE VF shed_mass(const A& c, const PlateFlow& flow, VF nu, VF inverse_s) {
    VF x = constant(c.steady_reynolds) * nu * inverse_s;
    x *= x;
    const VF share = hn::Max(constant(1.0f) - x * x, constant(0.0f));
    return (constant(1.0f) - flow.attached) * share * constant(c.separated_shed);
}

// Loads of a stream, per mass unit: the force is -drag v + circulation x v.
struct Stream {
    VF drag, shed;
    Vec3 circulation;
};

// The normal force -N n of a plate equals a drag N v_n/s^2 and a circulation N/s^2 (n x v). Drag is never negative, since a wake does not push.
template <class A> HWY_INLINE Stream stream_loads(const A& c, const Held& held, VF nu, Vec3 lag, Vec3 v, Vec3 u) {
    const VF s2 = speed_squared(v), s = hn::Sqrt(s2), inverse_s2 = constant(1.0f) / s2, root = hn::Sqrt(s * nu);
    const PlateFlow flow = plate_flow(c, nu, s * inverse_s2, lag, v);
    const Vec3 behind = lag - v;
    const VF sheared_off = v.x * v.x + v.y * v.y;
    const VF lift = held.lift * flow.attached * flow.inverse_along2;
    const VF attached = lift * (along_plate(c.plate_lift, flow) * hn::Sqrt(flow.along2) +
                                along_plate(c.plate_vortex, flow) * hn::Abs(flow.across));
    const VF separated = constant(c.plate_drag) * (constant(1.0f) - flow.attached);
    const VF growing = hn::Sqrt(speed_squared(behind)) * dot(behind, v) * inverse_s2;
    const VF drag = held.drag * (separated * (constant(0.8f) * (sheared_off * inverse_s2) * s + s) -
                                 constant(c.start_drag) * growing);
    const VF normal = inverse_s2 * (flow.across * attached + v.z * drag);

    Stream out;
    out.shed = shed_mass(c, flow, nu, s * inverse_s2);
    const Vec3 part = inverse_s2 * times(v, v);
    const VF blunt = s / (constant(8710.0f) * nu + s); // Re/(Re + 8710)
    const VF form = blunt * weighted(c.drag_blunt, part) + weighted(c.drag, part);
    const VF layer = root * weighted(c.drag_layer, part);
    out.drag =
        held.drag * (s * form + (nu * weighted(c.drag_stokes, part) + layer)) + hn::Max(normal * v.z, constant(0.0f));
    const VF inverse = held.lift * inverse_s2;
    const auto around = [&](int k, VF vi, VF vj, VF uk) LR_LAMBDA {
        const VF sum = constant(c.lift[k]) * s + (constant(c.lift_layer[k]) * root + constant(c.lift_stokes[k]) * nu);
        return held.lift * constant(c.spin_lift[k]) * uk - inverse * (vi * vj) * sum;
    };
    out.circulation = {around(0, v.y, v.z, u.x) - normal * v.y, around(1, v.z, v.x, u.y) + normal * v.x,
                       around(2, v.x, v.y, u.z)};
    return out;
}

// Couple of vortices shed into the wake.
template <class A> HWY_INLINE Vec3 shedding_couple(const A& c, const Held& held, const VF q[4], Vec3 v) {
    const VF size = held.lift * (v.z * v.z);
    const auto moment = [&](int i) LR_LAMBDA {
        return size * (constant(c.shedding_moment) * q[i] + constant(c.shedding_rate_moment) * q[i + 2]);
    };
    return {-moment(1), moment(0), hn::Zero(DF())}; // normal x force
}

// The wake over a substep: its memory relaxes towards the stream, and its oscillator (q, r) is rotated and changes its size (Stuart-Landau). Both are
// exact at any step but for exp(-x). Forces use the wake in the middle of a substep, so it advances from middle to middle.
template <class A>
HWY_INLINE void advance_wake(const StepInput& in, const A& c, const Held& held, VF nu, VF fluctuation,
                             const VF noise[2], Vec3 v, Vec3 u, Body& b) {
    const VF one = constant(1.0f), half = constant(0.5f), zero = hn::Zero(DF());
    const VF s = hn::Sqrt(speed_squared(v)), inverse_s = one / s;
    const VF travel = constant(in.h) * held.inverse_length * s;

    // The body spins about its normal while the wake stays behind.
    const VF t = constant(0.5f * in.h) * held.inverse_length * u.z, over = one / (t * t + one);
    const VF cosine = (one - t * t) * over, sine = (t + t) * over;
    // By the faster of body and wake, so that the wake of a body that stops fades too.
    const VF moved = constant(in.h) * held.inverse_length * hn::Sqrt(hn::Max(speed_squared(b.lag), s * s));
    const VF steady = constant(c.shedding_reynolds) * nu * inverse_s, calm = steady * steady;
    const VF rate_of_wake = constant(c.wake_rate) * (in.body.stations.count == 0 ? open_wake(calm) : one);
    const VF x = moved * rate_of_wake, keep = one / (x * (half * x + one) + one);
    const Vec3 turned{cosine * b.lag.x + sine * b.lag.y, cosine * b.lag.y - sine * b.lag.x, b.lag.z};
    b.lag = v + keep * (turned - v);

    const VF angle = travel * constant(c.shedding_rate), tan_half = half * angle, square = tan_half * tan_half;
    const VF inverse = one / (one + square);
    const VF cos_shed = (one - square) * inverse, sin_shed = (tan_half + tan_half) * inverse;
    VF* const q = b.shedding;
    const VF turned_q[4] = {cosine * q[0] + sine * q[1], cosine * q[1] - sine * q[0], cosine * q[2] + sine * q[3],
                            cosine * q[3] - sine * q[2]};
    const VF kick = constant(c.shedding_noise) * fluctuation * inverse_s * hn::Sqrt(angle);
    VF size2 = zero;
    for (int i = 0; i < 2; ++i) {
        const VF r = turned_q[i + 2] + kick * noise[i];
        q[i] = cos_shed * turned_q[i] + sin_shed * r;
        q[i + 2] = cos_shed * r - sin_shed * turned_q[i];
        size2 = q[i] * q[i] + (q[i + 2] * q[i + 2] + size2);
    }
    // Exact solution of size' = growth angle (limit - size) size, where size is half the square of (q, r).
    const VF limit = hn::Max(hn::Abs(v.z) * inverse_s - calm, constant(-3.0f));
    const VF rate = constant(c.shedding_growth) * angle, y = rate * limit, yy = hn::Abs(y);
    const VF rise = half * yy + one, exponential = hn::Min(yy * rise + one, constant(1e15f));
    const auto grows = y >= zero;
    const VF used = half * size2 * rate * rise;
    const VF scale =
        hn::Sqrt(hn::IfThenElse(grows, exponential, one) / (hn::IfThenElse(grows, one, exponential) + used));
    for (int i = 0; i < 4; ++i) q[i] = without_dust(scale * q[i]);
}

// Plates have no friction by spin: their batches save the square root.
HWY_INLINE bool has_layer(const float (&layer)[3]) {
    return layer[0] + layer[1] + layer[2] > 0.0f;
}
HWY_INLINE bool has_layer(const VF (&)[3]) {
    return true; // differs from body to body
}

// Spin drag is -rate u along each axis.
template <class A> HWY_INLINE Vec3 spin_drag_rate(const A& c, VF b, VF nu, VF s, Vec3 u) {
    const VF spin = hn::Sqrt(weighted(c.spin_weight, times(u, u)));
    const auto along = [&](int k) LR_LAMBDA {
        return b * (constant(c.spin_drag[k]) * spin +
                    (constant(c.spin_drag_stream[k]) * s + constant(c.spin_drag_stokes[k]) * nu));
    };
    const Vec3 rate{along(0), along(1), along(2)};
    if constexpr (requires { c.spin_drag_layer; }) {
        if (has_layer(c.spin_drag_layer)) {
            const VF root = b * hn::Sqrt(nu * (constant(0.5f) * spin + s));
            return rate + Vec3{root * constant(c.spin_drag_layer[0]), root * constant(c.spin_drag_layer[1]),
                               root * constant(c.spin_drag_layer[2])};
        }
    }
    return rate;
}

template <bool kFull, class A> HWY_INLINE Vec3 centre_velocity(const A& c, Twist t) {
    if constexpr (!kFull) return t.v;
    return rows(c.axes, t.v + cross(t.u, broadcast(c.arm)));
}
template <bool kFull, class A> HWY_INLINE Vec3 load_spin(const A& c, Twist t) {
    if constexpr (!kFull) return t.u;
    return rows(c.axes, t.u);
}

// Bodies of a batch differ by lr_batch_desc.variation: thickness scales all loads, since these are per mass, and curl scales the lift (not that of
// stations). Both factors are uniform with that standard deviation, from a hash of the noise seed (MurmurHash3's finaliser).
HWY_INLINE void vary(const StepInput& in, VU noise_seed, Held& held) {
    held.drag = held.lift = held.inverse_length;
    if (in.variation == 0.0f) return;
    const DU du;
    VU x = hn::Xor(noise_seed, hn::Set(du, static_cast<uint32_t>(in.seed ^ in.seed >> 32)));
    x = hn::Xor(x, hn::ShiftRight<16>(x)) * hn::Set(du, 0x85ebca6bu);
    x = hn::Xor(x, hn::ShiftRight<13>(x)) * hn::Set(du, 0xc2b2ae35u);
    x = hn::Xor(x, hn::ShiftRight<16>(x));
    const float most = in.variation * 1.7320508f; // half width of the uniform distribution
    const auto factor = [&](VU bits) LR_LAMBDA {
        return from_signed(bits) * constant(most / 32768.0f) + constant(1.0f - most * (65535.0f / 65536.0f));
    };
    held.drag = held.inverse_length * factor(hn::ShiftRight<16>(x));
    held.lift = held.drag;
    if (in.body.stations.count == 0) held.lift *= factor(hn::And(x, hn::Set(du, 0xffffu)));
}

// All loads as force and torque about the centre of mass, body axes, for Runge-Kutta. shed: as in Held.
template <class A>
static HWY_NOINLINE Twist aerodynamic_loads(const A& c, const Held& held, const Body& b, Twist t, VF& shed) {
    const VF nu = constant(c.viscosity) * held.inverse_length;
    const Vec3 v = centre_velocity<true>(c, t), u = load_spin<true>(c, t);
    const Stream stream = stream_loads(c, held, nu, b.lag, v, u);
    shed = stream.shed;
    const Vec3 force = cross(stream.circulation, v) - stream.drag * v;
    const VF s = hn::Sqrt(speed_squared(v));
    const Vec3 torque = shedding_couple(c, held, b.shedding, v) - times(spin_drag_rate(c, held.drag, nu, s, u), u);
    const Vec3 f = columns(c.axes, force);
    return {f, columns(c.axes, torque) + cross(broadcast(c.arm), f)};
}

// Gust after a substep (world frame): an exact Ornstein-Uhlenbeck step with fixed rate alpha and variance beta^2/(2 alpha).
HWY_INLINE Vec3 next_gust(Vec3 gust, VF alpha, VF variance, float h, const VF gauss[3]) {
    // exp(-x): error below 1e-6 for x < 1, tends to zero beyond.
    const VF x = hn::Min(alpha * constant(0.125f * h), constant(8.0f));
    VF e = constant(1.0f) / polynomial({1.0f / 24.0f, 1.0f / 6.0f, 0.5f, 1.0f, 1.0f}, x);
    e *= e;
    e *= e;
    e *= e;
    const VF kick = hn::Sqrt(variance * hn::Max(constant(1.0f) - e * e, constant(0.0f)));
    return e * gust + kick * broadcast(gauss);
}

// Splitting of a motion: half of the free motion, loads and weight, the other half. docs/maintainers/numerics.md, "AERODYNAMIC loads".

// The middle m of y' = f - x/tau y over tau, if the rate grows with y: with r = y + tau f/2 and x/tau the rate at r, m (1 + x m/(2 r)) = r, or
// m = r/(1 + e). With the rate at y instead, a large x would leave y unchanged, and hold a body at rest for long.
HWY_INLINE VF eased(VF x) {
    return x / (constant(1.0f) + hn::Sqrt(constant(2.0f) * x + constant(1.0f)));
}

HWY_INLINE Vec3 bounded(Vec3 v, VF most, VF least) {
    return each_axis([&](VF x) LR_LAMBDA { return hn::Max(hn::Min(x, most), least); }, v);
}
// Bound of the rim's speed by a couple in half a motion, over the stream's: a real body would have turned away.
inline constexpr float most_rim = 8.0f;
HWY_INLINE Vec3 bounded_push(Vec3 push, VF s) {
    const VF most = constant(most_rim) * s;
    return bounded(push, most, -most);
}

// For the L-stable pair of implicit stages (Alexander 1977): gamma = 1 - 1/sqrt(2), and the first stage's weight in the second.
inline constexpr float stage_gamma = 0.29289322f, stage_rest = (1.0f - stage_gamma) / stage_gamma;

// Loads at a moment: the force is circulation x v - drag v, the torque couple - spin u.
struct Moment {
    VF drag, shed, s;
    Vec3 circulation, spin, couple;
};
template <class A> HWY_INLINE Moment moment_at(const A& c, const Held& held, VF nu, const Body& b, const Twist& t) {
    const Stream stream = stream_loads(c, held, nu, b.lag, t.v, t.u);
    const VF s = hn::Sqrt(speed_squared(t.v));
    return {stream.drag,
            stream.shed,
            s,
            stream.circulation,
            spin_drag_rate(c, held.drag, nu, s, t.u),
            shedding_couple(c, held, b.shedding, t.v)};
}

// An implicit stage of M' v' = k x v - drag v, k and drag times its length: v = r + M'^-1 (k x v - drag v). So
// v - r = S^-1 (k x r - drag r) with S = T - [k]x, T = M' + drag, S^-1 = (adj T + k k^T + [T k]x)/(det T + k.T k).
struct Stage {
    VF drag, inverse;
    Vec3 k, tk;
    VF adjugate[6];
};
template <bool kFull, class C> HWY_INLINE Stage stage_of(const C& c, VF drag, Vec3 k) {
    Stage out;
    // Bounds: beyond them the velocity decays, or turns too far to be resolved in a motion.
    const VF most = constant(5e3f);
    out.drag = hn::Min(drag, constant(1e9f));
    out.k = bounded(k, most, -most);
    VF* const adj = out.adjugate;
    VF det;
    const auto* const m = c.aerodynamics.centre_mass;
    const VF xx = constant(m[0]) + out.drag, yy = constant(m[3]) + out.drag, zz = constant(m[5]) + out.drag;
    const VF xy = constant(m[1]);
    if constexpr (kFull) {
        const VF xz = constant(m[2]), yz = constant(m[4]);
        adj[0] = yy * zz - yz * yz;
        adj[1] = xz * yz - xy * zz;
        adj[2] = xy * yz - xz * yy;
        adj[3] = xx * zz - xz * xz;
        adj[4] = xy * xz - xx * yz;
        adj[5] = xx * yy - xy * xy;
        det = xx * adj[0] + (xy * adj[1] + xz * adj[2]);
        out.tk = {xx * out.k.x + (xy * out.k.y + xz * out.k.z), xy * out.k.x + (yy * out.k.y + yz * out.k.z),
                  xz * out.k.x + (yz * out.k.y + zz * out.k.z)};
    } else {
        adj[0] = yy * zz;
        adj[1] = -(xy * zz);
        adj[3] = xx * zz;
        adj[5] = xx * yy - xy * xy;
        det = zz * adj[5];
        out.tk = {xx * out.k.x + xy * out.k.y, xy * out.k.x + yy * out.k.y, zz * out.k.z};
    }
    out.inverse = constant(1.0f) / (dot(out.tk, out.k) + det);
    return out;
}
template <bool kFull> HWY_INLINE Vec3 moved_from(const Stage& p, Vec3 r) {
    const Vec3 f = cross(p.k, r) - p.drag * r;
    const VF* const adj = p.adjugate;
    Vec3 sum;
    if constexpr (kFull)
        sum = {adj[0] * f.x + (adj[1] * f.y + adj[2] * f.z), adj[1] * f.x + (adj[3] * f.y + adj[4] * f.z),
               adj[2] * f.x + (adj[4] * f.y + adj[5] * f.z)};
    else
        sum = {adj[0] * f.x + adj[1] * f.y, adj[1] * f.x + adj[3] * f.y, adj[5] * f.z};
    return p.inverse * (sum + dot(p.k, f) * p.k + cross(p.tk, f));
}

// Change of a sheet's motion by external forces, in its frame.
template <class C> static HWY_NOINLINE Twist external_answer(const C& c, const External& e, Quaternion q) {
    const auto* const axes = c.aerodynamics.axes;
    const Vec3 arm = broadcast(c.aerodynamics.arm);
    const auto along = [&](const Twist(&both)[2]) LR_LAMBDA {
        return Twist{to_body(q, both[0].v) + rows(axes, both[1].v), to_body(q, both[0].u) + rows(axes, both[1].u)};
    };
    const Twist f = along(e.force), rate = along(e.rate);
    return symmetric6(c.full_inverse, {f.v, f.u - cross(arm, f.v)}) + Twist{rate.v + cross(rate.u, arm), rate.u};
}

// Response of the load centre's twist to a vector along body axes.
template <bool kFull, class T> HWY_INLINE Twist answer_to(const T* m, Vec3 f) {
    if constexpr (kFull) return {rows(m, f), rows(m + 9, f)};
    return {{constant(m[0]) * f.x + constant(m[1]) * f.y, constant(m[3]) * f.x + constant(m[4]) * f.y,
             constant(m[8]) * f.z},
            {constant(m[11]) * f.z, constant(m[14]) * f.z, constant(m[15]) * f.x + constant(m[16]) * f.y}};
}

// Change of the twist about the load centre, load axes, by weight, buoyancy and external forces in half a motion.
template <bool kFull, class C> HWY_INLINE Twist pull_of(float h, const C& c, const Held& held, Quaternion q) {
    const auto& a = c.aerodynamics;
    const Vec3 gravity = to_body(q, held.gravity);
    Twist t = answer_to<kFull>(a.fall, gravity);
    if (!held.uniform) t += answer_to<kFull>(a.push, to_body(q, held.weight) - constant(c.weight) * gravity);
    if (HWY_UNLIKELY(held.external != nullptr)) {
        if constexpr (kFull) {
            const Twist gain = acceleration<true>(c, external_force<true>(c, *held.external, q));
            t += Twist{centre_velocity<true>(a, gain), load_spin<true>(a, gain)};
        } else {
            t += external_answer(c, *held.external, q);
        }
    }
    return constant(0.5f * h) * t;
}

// Mobility of the spin, for each axis by itself.
template <class C> HWY_INLINE Vec3 spin_mobility(const C& c) {
    const auto* const n = c.aerodynamics.spin_mobility;
    return {constant(n[0]), constant(n[3]), constant(n[5])};
}

// Spin along one axis under couple and drag along it. The whole spin responds by N e/(e.N e), N the mobility. One axis after another, in reverse
// order in the other half: of second order, contracts in the norm of N^-1, and stays at rest if couple and drag balance along every axis.
template <bool kFull, int kAxis, class T> HWY_INLINE Vec3 answering(const T* n, VF change, Vec3 u) {
    const auto answer = [&](int i, VF x) LR_LAMBDA { return constant(n[i]) * change + x; };
    if constexpr (kAxis == 0) return {u.x + change, answer(0, u.y), kFull ? answer(1, u.z) : u.z};
    if constexpr (kAxis == 1) return {answer(2, u.x), u.y + change, kFull ? answer(3, u.z) : u.z};
    return {kFull ? answer(4, u.x) : u.x, kFull ? answer(5, u.y) : u.y, u.z + change};
}
// y' = f - x/tau y over tau changes y by (1 - E)/x (tau f - x y). With exp(-2 x) = E^2 = 1/(1 + 2 x + 2 x^2) two halves equal one step of second
// order.
HWY_INLINE VF relaxing(VF x) {
    const VF one = constant(1.0f), c = x + one, inverse = one / (constant(2.0f) * x * c + one);
    return (c + c) * inverse / (one + hn::Sqrt(inverse));
}

// Spin drag and couple over half a motion. x: rates times time; part: relaxing(x). A couple also moves a load centre that is off the centre of mass.
template <bool kFull, class C>
HWY_INLINE Twist spin_half(const C& c, Vec3 x, Vec3 part, Vec3 push, bool before_drag, Twist t) {
    const auto* const n = c.aerodynamics.spin_answer;
    Vec3 u = t.u;
    const auto about_x = [&]() LR_LAMBDA { u = answering<kFull, 0>(n, (push.x - x.x * u.x) * part.x, u); };
    const auto about_y = [&]() LR_LAMBDA { u = answering<kFull, 1>(n, (push.y - x.y * u.y) * part.y, u); };
    const auto about_z = [&]() LR_LAMBDA { u = answering<kFull, 2>(n, (push.z - x.z * u.z) * part.z, u); };
    if (before_drag)
        about_x(), about_y(), about_z();
    else
        about_z(), about_y(), about_x();
    return {t.v + coupled<!kFull>(c.aerodynamics.velocity_of_couple, u - t.u), u};
}

// Twist in the middle of the loads, by an implicit stage of half their length with circulation and couple of `m`. drag, spin: times h/2.
template <bool kFull, class C>
HWY_INLINE Twist middle_by(float h, const C& c, const Moment& m, VF drag, Vec3 spin, const Twist& pull,
                           const Twist& t) {
    const auto& a = c.aerodynamics;
    const auto* const n = a.spin_answer;
    const VF tau = constant(0.5f * h);
    const Stage p = stage_of<kFull>(c, drag, tau * m.circulation);
    const Vec3 lost = moved_from<kFull>(p, t.v + pull.v);
    const Vec3 push = bounded_push(times(tau * spin_mobility(c), m.couple), m.s);
    Twist out = t + pull;
    out.v += lost;
    out.u += coupled<!kFull>(a.spin_of_force, lost);
    const Vec3 before = out.u;
    const auto less = [&](VF y, VF by, VF more) LR_LAMBDA { return (more - y * by) / (constant(1.0f) + by); };
    out.u = answering<kFull, 0>(n, less(out.u.x, spin.x, push.x), out.u);
    out.u = answering<kFull, 1>(n, less(out.u.y, spin.y, push.y), out.u);
    out.u = answering<kFull, 2>(n, less(out.u.z, spin.z, push.z), out.u);
    out.v += coupled<!kFull>(a.velocity_of_couple, out.u - before);
    return out;
}

// In the middle of a motion: velocity of the load centre, added mass along the normal that stays in the wake.
struct Middle {
    Vec3 v;
    VF shed;
};

// Loads and weight at a fixed orientation. The twist in the middle is found twice, from the loads at the start and from those of the first middle.
// With the loads there, drag, circulation and weight act together in an L-stable pair of implicit stages (Alexander 1977).
template <bool kFull, class C>
HWY_INLINE Middle loads_in_middle(float h, const C& c, const Held& held, VF nu, Body& b) {
    const auto& a = c.aerodynamics;
    const VF tau = constant(0.5f * h);
    const Twist pull = pull_of<kFull>(h, c, held, b.q);
    // Loads act on the spin relative to the fluid.
    const auto spun_by_fluid = [&]() LR_LAMBDA {
        const Vec3 u = to_body(b.q, held.fluid_spin);
        return Twist{kFull ? zero3() : arm_velocity(c, u), u};
    };
    if (held.sheared) b.t = b.t - spun_by_fluid();
    const Twist before{centre_velocity<kFull>(a, b.t), load_spin<kFull>(a, b.t)};
    const Vec3 rate = tau * spin_mobility(c);

    Moment m = moment_at(a, held, nu, b, before);
    const Vec3 r = before.v + pull.v, ur = before.u + pull.u + bounded_push(times(rate, m.couple), m.s);
    const VF r2 = speed_squared(r), mass = dot(r, block<!kFull>(a.centre_mass, r)) / r2;
    // Drag at r if it grows with the speed.
    const VF x = constant(h) * m.drag * hn::Sqrt(r2) / (m.s * mass);
    const Vec3 spin = constant(2.0f) * times(rate, spin_drag_rate(a, held.drag, nu, m.s, ur));
    Twist middle = middle_by<kFull>(h, c, m, mass * eased(x), each_axis(eased, spin), pull, before);
    m = moment_at(a, held, nu, b, middle);
    middle = middle_by<kFull>(h, c, m, tau * m.drag, times(rate, m.spin), pull, before);
    m = moment_at(a, held, nu, b, middle);

    const Vec3 push = bounded_push(times(rate, m.couple), m.s);
    const Vec3 rates = each_axis([](VF x) LR_LAMBDA { return hn::Min(x, constant(1e15f)); }, times(rate, m.spin));
    const Vec3 relax = each_axis(relaxing, rates);
    Twist t = spin_half<kFull>(c, rates, relax, push, true, before);
    const Stage p = stage_of<kFull>(c, constant(stage_gamma * h) * m.drag, constant(stage_gamma * h) * m.circulation);
    const Vec3 part = constant(2.0f * stage_gamma) * pull.v;
    const Vec3 first = part + moved_from<kFull>(p, t.v + part);
    const Vec3 second = constant(stage_rest) * first + part;
    const Vec3 gained = second + moved_from<kFull>(p, t.v + second);
    t.v += gained;
    t.u += pull.u + pull.u + coupled<!kFull>(a.spin_of_force, gained - (pull.v + pull.v));
    t = spin_half<kFull>(c, rates, relax, push, false, t);
    if constexpr (kFull) {
        // Adds the change alone: to load axes and back would round the whole.
        const Vec3 u = columns(a.axes, t.u - before.u);
        b.t += Twist{columns(a.axes, t.v - before.v) - cross(u, broadcast(a.arm)), u};
    } else {
        b.t = t;
    }
    if (held.sheared) b.t += spun_by_fluid();
    return {middle.v, m.shed};
}

// Free motion has the largest error, which grows with the square of its step: it takes the outer halves. Returns the load centre's velocity in the
// middle.
template <bool kFull, class C> HWY_INLINE Vec3 splitting_motion(float h, const C& c, Held& held, VF nu, Body& b) {
    const auto& a = c.aerodynamics;
    const Vec3 v = centre_velocity<kFull>(a, b.t);
    const VF inverse_s = constant(1.0f) / hn::Sqrt(speed_squared(v));
    held.shed = shed_mass(a, plate_flow(a, nu, inverse_s, b.lag, v), nu, inverse_s);
    free_step<kFull, true>(0.5f * h, c, held, b);
    const Middle middle = loads_in_middle<kFull>(h, c, held, nu, b);
    const VF most = constant(a.most_shed);
    held.shed = hn::Max(hn::Min(middle.shed + middle.shed - held.shed, most), hn::Zero(DF()));
    free_step<kFull, true>(0.5f * h, c, held, b);
    return middle.v;
}
} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
