// Quasi-steady loads for one vector of bodies: docs/maintainers/physics.md, "AERODYNAMIC". Kernel units and constants: body_constants.h.
// `b`: 1/(d s). `nu`: viscosity over d s, a velocity. v: of the load centre, along the load axes.
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

template <class T> HWY_INLINE Twist rows6(const T* m, Vec3 a) {
    return {rows(m, a), rows(m + 9, a)};
}

// Above zero, so that directions exist; far below any visible speed.
HWY_INLINE VF speed_squared(Vec3 v) {
    return dot(v, v) + constant(1e-20f);
}

// A steady wake, below the critical Reynolds number, sheds nothing.
template <class A> HWY_INLINE VF shedding_share(const A& c, VF nu, VF inverse_s) {
    const VF x = constant(c.shedding_reynolds) * nu * inverse_s;
    return hn::Max(constant(1.0f) - x * x, constant(0.0f));
}

// The flow past a plate at one moment of the loads: their start, their middle, or their end.
struct Plate {
    Vec3 lag;
    VF lift, vortex; // attached
    VF drag, start;  // separated, and of a wake that is being made
    VF shed;         // the added mass that does not move with the body
};

// The stream that the attached flow follows: partly that of the wake.
template <class A> HWY_INLINE Vec3 followed(const A& c, Vec3 lag, Vec3 v) {
    return v + constant(c.wake_share) * (lag - v);
}

template <class A> HWY_INLINE Plate plate_at(const A& c, const Held& held, VF nu, Vec3 lag, Vec3 v) {
    const VF one = constant(1.0f);
    // A stream exactly along the normal is as one along both other axes by turns.
    const VF least = constant(1e-20f);
    const Vec3 u = followed(c, lag, v), squares = times(u, u) + Vec3{least, least, least};
    const VF across = dot(broadcast(c.normal_axis), u), a2 = across * across;
    const VF along = dot(broadcast(c.plate_axes) + broadcast(c.plate_axes + 3), squares), inverse = one / along;
    const VF s2 = along + a2;
    // (sin a)^2 over that of the stall angle, to the fourth power against (cos a)^2: half of each at the stall angle.
    const VF stall = hn::Max(weighted(c.plate_stall, squares) * inverse, one);
    VF x = a2 * stall / s2;
    x *= x;
    const VF kept = along * stall, attached = kept / (kept + s2 * (stall - one) * (x * x) + constant(1e-30f));
    const VF lift = held.lift * attached * inverse;
    const Vec3 behind = lag - v;
    const VF inverse_v2 = one / speed_squared(v);
    const VF growing = hn::Sqrt(speed_squared(behind)) * dot(behind, v) * inverse_v2;
    const VF rest = constant(c.separated_shed) * shedding_share(c, nu, hn::Sqrt(inverse_v2));
    Plate out;
    out.lag = lag;
    out.lift = lift * weighted(c.plate_lift, squares);
    out.vortex = lift * weighted(c.plate_vortex, squares);
    out.drag = held.drag * constant(c.plate_drag) * (one - attached);
    out.start = -(held.drag * constant(c.start_drag) * growing);
    out.shed = (one - attached) * rest;
    return out;
}

// The flow at the end of the loads, extrapolated linearly from their start and their middle.
HWY_INLINE Plate extrapolated(const Plate& begin, const Plate& middle) {
    const auto end = [](VF a, VF b) LR_LAMBDA { return hn::Max(b + b - a, constant(0.0f)); };
    return {middle.lag,
            end(begin.lift, middle.lift),
            end(begin.vortex, middle.vortex),
            end(begin.drag, middle.drag),
            middle.start + middle.start - begin.start,
            end(begin.shed, middle.shed)};
}

// Loads of a stream: the force is -drag v + circulation x v, per mass unit.
struct Stream {
    VF drag;
    Vec3 circulation;
};

// A plate's normal force -N n is drag N v_n/s^2 and circulation N/s^2 (n x v). The drag is never negative: a wake does not push.
template <bool kDrag, bool kLift, class A>
HWY_INLINE Stream stream_loads(const A& c, const Held& held, const Plate& plate, VF nu, Vec3 v, Vec3 u) {
    const VF s2 = speed_squared(v), s = hn::Sqrt(s2), inverse_s2 = constant(1.0f) / s2, root = hn::Sqrt(s * nu);
    const Vec3 n = broadcast(c.normal_axis), followed_stream = followed(c, plate.lag, v);
    const VF vn = dot(n, v), un = dot(n, followed_stream);
    const VF ut = hn::Sqrt(hn::Max(speed_squared(followed_stream) - un * un, constant(0.0f)));
    const VF sheared_off = s2 - vn * vn;
    const VF normal =
        inverse_s2 * (un * (plate.lift * ut + plate.vortex * hn::Abs(un)) +
                      vn * (plate.drag * (constant(0.8f) * (sheared_off * inverse_s2) * s + s) + plate.start));
    Stream out;
    if constexpr (kDrag) {
        const Vec3 part = inverse_s2 * times(v, v);
        const VF separated = s / (constant(8710.0f) * nu + s); // Re/(Re + 8710)
        const VF form = separated * weighted(c.drag_blunt, part) + weighted(c.drag, part);
        const VF layer = root * weighted(c.drag_layer, part);
        out.drag = held.drag * (s * form + (nu * weighted(c.drag_stokes, part) + layer)) +
                   hn::Max(normal * vn, constant(0.0f));
    }
    if constexpr (kLift) {
        const VF inverse = held.lift * inverse_s2;
        const auto along = [&](int k, VF vi, VF vj, VF uk) LR_LAMBDA {
            const VF sum =
                constant(c.lift[k]) * s + (constant(c.lift_layer[k]) * root + constant(c.lift_stokes[k]) * nu);
            return held.lift * constant(c.spin_lift[k]) * uk - inverse * (vi * vj) * sum;
        };
        out.circulation =
            Vec3{along(0, v.y, v.z, u.x), along(1, v.z, v.x, u.y), along(2, v.x, v.y, u.z)} + normal * cross(n, v);
    }
    return out;
}
template <class A> HWY_INLINE VF drag_rate(const A& c, const Held& held, const Plate& plate, VF nu, Vec3 v) {
    return stream_loads<true, false>(c, held, plate, nu, v, v).drag;
}
template <class A>
HWY_INLINE Vec3 circulation(const A& c, const Held& held, const Plate& plate, VF nu, Vec3 v, Vec3 u) {
    return stream_loads<false, true>(c, held, plate, nu, v, u).circulation;
}

// Couple of the vortices that the wake sheds.
template <class A> HWY_INLINE Vec3 shedding_couple(const A& c, const Held& held, const VF q[4], VF nu, Vec3 v) {
    const Vec3 n = broadcast(c.normal_axis);
    const VF vn = dot(n, v), inverse_s = constant(1.0f) / hn::Sqrt(speed_squared(v));
    const VF size = held.lift * (vn * vn) * shedding_share(c, nu, inverse_s);
    const auto moment = [&](int i) LR_LAMBDA {
        return size * (constant(c.shedding_moment) * q[i] + constant(c.shedding_rate_moment) * q[i + 2]);
    };
    // n x (a, b) = (-b, a) along the two axes after n.
    return moment(0) * broadcast(c.plate_axes + 3) - moment(1) * broadcast(c.plate_axes);
}

// The wake follows the stream for a substep: its memory by relaxation, its oscillator as Stuart and Landau's, a rotation of (q, r) and a change of
// its size, both exact at any step but for exp(-x). Forces use the wake in the middle of a substep, so it is advanced from middle to middle.
template <class A>
HWY_INLINE void advance_wake(const StepInput& in, const A& c, const Held& held, VF nu, VF fluctuation, const VF gauss[],
                             Vec3 v, Vec3 u, Body& b) {
    const VF one = constant(1.0f), half = constant(0.5f), zero = hn::Zero(DF());
    const Vec3 n = broadcast(c.normal_axis);
    const VF s = hn::Sqrt(speed_squared(v)), inverse_s = one / s;
    const VF travel = constant(in.h) * held.inverse_length * s;

    // The body spins about its normal below its wake.
    const VF t = constant(0.5f * in.h) * held.inverse_length * dot(n, u), over = one / (t * t + one);
    const VF cosine = (one - t * t) * over, sine = (t + t) * over;
    // A wake outlives the body's motion by its own time, not for ever.
    const VF moved = constant(in.h) * held.inverse_length * hn::Sqrt(hn::Max(speed_squared(b.lag), s * s));
    const VF x = moved * constant(c.wake_rate), keep = one / (x * (half * x + one) + one);
    const VF along = dot(n, b.lag);
    const Vec3 turned = cosine * b.lag + (along - cosine * along) * n - sine * cross(n, b.lag);
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
        const VF r = turned_q[i + 2] + kick * gauss[i];
        q[i] = cos_shed * turned_q[i] + sin_shed * r;
        q[i + 2] = cos_shed * r - sin_shed * turned_q[i];
        size2 = q[i] * q[i] + (q[i + 2] * q[i + 2] + size2);
    }
    // size' = growth angle (limit - size) size, by its exact solution; size: half the square of (q, r).
    const VF across = hn::Abs(dot(n, v));
    const VF limit = hn::Max((across - constant(c.shedding_reynolds) * nu) * inverse_s, constant(-3.0f));
    const VF rate = constant(c.shedding_growth) * angle, y = rate * limit, yy = hn::Abs(y);
    const VF rise = half * yy + one, exponential = hn::Min(yy * rise + one, constant(1e15f));
    const auto grows = y >= zero;
    const VF used = half * size2 * rate * rise;
    const VF scale =
        hn::Sqrt(hn::IfThenElse(grows, exponential, one) / (hn::IfThenElse(grows, one, exponential) + used));
    for (int i = 0; i < 4; ++i) q[i] = without_dust(scale * q[i]);
}

// Spin drag is -rate u along each axis.
template <class A> HWY_INLINE Vec3 spin_drag_rate(const A& c, VF b, VF nu, VF s, Vec3 u) {
    const VF spin = hn::Sqrt(weighted(c.spin_weight, times(u, u)));
    const auto along = [&](int k) LR_LAMBDA {
        return b * (constant(c.spin_drag[k]) * spin +
                    (constant(c.spin_drag_stream[k]) * s + constant(c.spin_drag_stokes[k]) * nu));
    };
    return {along(0), along(1), along(2)};
}

template <bool kFull, class A> HWY_INLINE Vec3 centre_velocity(const A& c, Twist t) {
    if constexpr (!kFull) return t.v;
    return rows(c.axes, t.v + cross(t.u, broadcast(c.arm)));
}
template <bool kFull, class A> HWY_INLINE Vec3 load_spin(const A& c, Twist t) {
    if constexpr (!kFull) return t.u;
    return rows(c.axes, t.u);
}

// Real leaves differ. Thickness multiplies all loads, as they are per mass; curl the lift, unless stations have it. Both factors are uniform with the
// same deviation, from a hash of the noise seed (finalizer of MurmurHash3).
HWY_INLINE void vary(const StepInput& in, VU noise_seed, Held& held) {
    held.drag = held.lift = held.inverse_length;
    if (in.variation == 0.0f) return;
    const DU du;
    VU x = hn::Xor(noise_seed, hn::Set(du, static_cast<uint32_t>(in.seed ^ in.seed >> 32)));
    x = hn::Xor(x, hn::ShiftRight<16>(x)) * hn::Set(du, 0x85ebca6bu);
    x = hn::Xor(x, hn::ShiftRight<13>(x)) * hn::Set(du, 0xc2b2ae35u);
    x = hn::Xor(x, hn::ShiftRight<16>(x));
    const float most = in.variation * 1.7320508f; // of a uniform distribution
    const auto factor = [&](VU bits) LR_LAMBDA {
        return from_signed(bits) * constant(most / 32768.0f) + constant(1.0f - most * (65535.0f / 65536.0f));
    };
    held.drag = held.inverse_length * factor(hn::ShiftRight<16>(x));
    held.lift = held.drag;
    if (in.body.stations.count == 0) held.lift *= factor(hn::And(x, hn::Set(du, 0xffffu)));
}

// The sum of all loads as force and torque about the centre of mass, body axes, for Runge-Kutta.
template <bool kFull, class A>
static HWY_NOINLINE Twist aerodynamic_loads(const A& c, const Held& held, const Plate& plate, const VF shedding[4],
                                            Twist t) {
    const VF nu = constant(c.viscosity) * held.inverse_length;
    const Vec3 v = centre_velocity<kFull>(c, t), u = load_spin<kFull>(c, t);
    const Stream stream = stream_loads<true, true>(c, held, plate, nu, v, u);
    const Vec3 force = cross(stream.circulation, v) - stream.drag * v;
    const VF s = hn::Sqrt(speed_squared(v));
    const Vec3 torque = shedding_couple(c, held, shedding, nu, v) - times(spin_drag_rate(c, held.drag, nu, s, u), u);
    if constexpr (!kFull) return {force, torque};
    const Vec3 f = columns(c.axes, force);
    return {f, columns(c.axes, torque) + cross(broadcast(c.arm), f)};
}

// The gust after a substep (world frame): an Ornstein-Uhlenbeck process whose rate and variance, alpha and beta^2/(2 alpha), are fixed over it.
HWY_INLINE Vec3 next_gust(Vec3 gust, VF alpha, VF variance, float h, const VF gauss[3]) {
    // exp(-x), to 1e-6 for x below 1, and towards zero beyond.
    const VF x = hn::Min(alpha * constant(0.125f * h), constant(8.0f));
    VF e = constant(1.0f) / polynomial({1.0f / 24.0f, 1.0f / 6.0f, 0.5f, 1.0f, 1.0f}, x);
    e *= e;
    e *= e;
    e *= e;
    const VF kick = hn::Sqrt(variance * hn::Max(constant(1.0f) - e * e, constant(0.0f)));
    return e * gust + kick * broadcast(gauss);
}

// The substep with quasi-steady loads: free motion, drag and weight, spin drag, lift, and back (docs/maintainers/numerics.md, "AERODYNAMIC loads").

// y' = f - x/tau y over tau, given tau f: exp(-x) = 1/D and (1 - exp(-x))/x = C/D with D = 1 + x C, C = 1 + x/2.
HWY_INLINE VF relax_second(VF y, VF x, VF tau_f) {
    x = hn::Min(x, constant(1e15f));
    const VF c = x * constant(0.5f) + constant(1.0f);
    return (tau_f * c + y) / (x * c + constant(1.0f));
}
// Its middle: m = r/(1 + e), r = y plus half of tau f, as if the rate grew with y: with x/tau the rate at r, m (1 + x m/(2 r)) = r. The rate at y
// instead would leave y unchanged for large x, and a body at rest there for long.
HWY_INLINE VF eased(VF x) {
    return x / (constant(1.0f) + hn::Sqrt(constant(2.0f) * x + constant(1.0f)));
}
HWY_INLINE VF over_one_and(VF r, VF e) {
    return r / (constant(1.0f) + e);
}
// relax_middle(r, x) is r/(1 + eased(x)) with one division.
HWY_INLINE VF relax_middle(VF r, VF x) {
    return (r + r) / (constant(1.0f) + hn::Sqrt(constant(2.0f) * x + constant(1.0f)));
}

// Twist of the body about the load centre, in load axes, for both halves of the loads.
struct Pull {
    Twist t;    // gain by weight, buoyancy and external forces in half a substep
    Vec3 modes; // its velocity along the modes of the mobility
};
// Rates in the middle of one half. The other half starts from them to find its own middle: second order, with the same equilibrium.
struct Rates {
    VF drag;
    Vec3 spin;
};

// Drag opposes the velocity with one factor in all directions, so the modes of the mobility P M^-1 P^T decay independently, each towards its terminal
// velocity. On the diagonal path they are the axes.
template <bool kFull, class C>
HWY_INLINE void drag_along_modes(const StepInput& in, const C& c, const Held& held, const Plate& plate, VF nu,
                                 const Pull& pull, bool before_lift, Rates& rates, Twist& t) {
    const auto& a = c.aerodynamics;
    const auto from_modes = [&](Vec3 y) LR_LAMBDA {
        if constexpr (!kFull) return y;
        return rows(a.modes, y);
    };
    const VF tau = constant(0.5f * in.h), half = constant(0.5f);
    const Vec3 rate = tau * broadcast(kFull ? a.rate : c.inverse_mass), y = kFull ? columns(a.modes, t.v) : t.v;
    const Vec3 r = y + half * pull.modes;
    Vec3 middle;
    if (before_lift)
        middle = each_axis(relax_middle, r, drag_rate(a, held, plate, nu, t.v + half * pull.t.v) * rate);
    else
        middle = each_axis(over_one_and, r, half * rates.drag * rate);
    rates.drag = drag_rate(a, held, plate, nu, from_modes(middle));
    const Vec3 after = each_axis(relax_second, y, rates.drag * rate, pull.modes);
    if constexpr (!kFull) {
        t.v = after;
        return;
    }
    const Vec3 lost = rows(a.modes, after - y - pull.modes);
    t += pull.t + Twist{lost, rows(a.spin_of_force, lost)};
}
// Not inlined: the full path has each half twice, and a substep would exceed the instruction cache.
template <class C>
static HWY_NOINLINE void drag_half_full(const StepInput& in, const C& c, const Held& held, const Plate& plate, VF nu,
                                        const Pull& pull, bool before_lift, Rates& rates, Twist& t) {
    drag_along_modes<true>(in, c, held, plate, nu, pull, before_lift, rates, t);
}
template <bool kFull, bool kBeforeLift, class C>
HWY_INLINE void drag_half(const StepInput& in, const C& c, const Held& held, const Plate& plate, VF nu,
                          const Pull& pull, Rates& rates, Twist& t) {
    if constexpr (kFull)
        drag_half_full(in, c, held, plate, nu, pull, kBeforeLift, rates, t);
    else
        drag_along_modes<false>(in, c, held, plate, nu, pull, kBeforeLift, rates, t);
}

// N a, N the mobility of the spin.
template <bool kFull, class C> HWY_INLINE Vec3 spin_mobility(const C& c, Vec3 a) {
    if constexpr (kFull) return symmetric3(c.aerodynamics.spin_mobility, a);
    return scaled_by(c.inverse_spin_mass, a);
}
// Its diagonal.
template <bool kFull, class C> HWY_INLINE Vec3 spin_mobility(const C& c) {
    const auto* const n = c.aerodynamics.spin_mobility;
    if constexpr (kFull) return {constant(n[0]), constant(n[3]), constant(n[5])};
    return broadcast(c.inverse_spin_mass);
}

HWY_INLINE Vec3 bounded(Vec3 v, VF most, VF least) {
    return each_axis([&](VF x) LR_LAMBDA { return hn::Max(hn::Min(x, most), least); }, v);
}

// Spin along one axis under couple and drag along it; all spin answers by N e, here over e.N e. Axis after axis, in reverse order in the other half,
// is of second order, contracts in the norm of N^-1, and rests at any step if couple and drag agree along every axis.
template <int kAxis, class T> HWY_INLINE Vec3 answering(const T* n, VF change, Vec3 u) {
    if constexpr (kAxis == 0) return {u.x + change, constant(n[0]) * change + u.y, constant(n[1]) * change + u.z};
    if constexpr (kAxis == 1) return {constant(n[2]) * change + u.x, u.y + change, constant(n[3]) * change + u.z};
    return {constant(n[4]) * change + u.x, constant(n[5]) * change + u.y, u.z + change};
}
template <int kAxis, class T> HWY_INLINE Vec3 relax_axis(const T* n, VF x, VF push, Vec3 u) {
    const VF y = kAxis == 0 ? u.x : kAxis == 1 ? u.y : u.z;
    x = hn::Min(x, constant(1e15f));
    const VF p = x * constant(0.5f) + constant(1.0f);
    return answering<kAxis>(n, (push - x * y) * (p / (x * p + constant(1.0f))), u);
}

// A couple's push of the rim in half a substep, over the stream, is bounded: in truth the body would have turned away.
inline constexpr float most_rim = 8.0f;
HWY_INLINE Vec3 bounded_push(Vec3 push, VF s) {
    const VF most = constant(most_rim) * s;
    return bounded(push, most, -most);
}

// couple: on the spin, constant over the substep.
template <class C>
static HWY_NOINLINE void spin_drag_half_full(const StepInput& in, const C& c, const Held& held, VF nu, Vec3 couple,
                                             bool before_lift, Rates& rates, Twist& t) {
    const auto& a = c.aerodynamics;
    const auto* const n = a.spin_answer;
    const VF tau = constant(0.5f * in.h), half = constant(0.5f);
    const VF s = hn::Sqrt(speed_squared(t.v));
    const Vec3 own = spin_mobility<true>(c), rate = tau * own, push = bounded_push(times(rate, couple), s);
    const Vec3 first = half * push;
    const Vec3 r = answering<2>(n, first.z, answering<1>(n, first.y, answering<0>(n, first.x, t.u)));
    Vec3 e = half * times(rate, rates.spin);
    if (before_lift) e = each_axis(eased, times(rate, spin_drag_rate(a, held.drag, nu, s, r)));
    const auto lost = [&](VF y, VF by) LR_LAMBDA { return -over_one_and(y * by, by); };
    Vec3 middle = answering<0>(n, lost(r.x, e.x), r);
    middle = answering<1>(n, lost(middle.y, e.y), middle);
    middle = answering<2>(n, lost(middle.z, e.z), middle);
    // A couple moves a load centre that lies off the centre of mass.
    const Vec3 v = t.v + rows(a.velocity_of_couple, middle - t.u);
    rates.spin = spin_drag_rate(a, held.drag, nu, hn::Sqrt(speed_squared(v)), middle);
    const Vec3 x = times(rate, rates.spin);
    Vec3 u = t.u;
    if (before_lift) {
        u = relax_axis<0>(n, x.x, push.x, u);
        u = relax_axis<1>(n, x.y, push.y, u);
        u = relax_axis<2>(n, x.z, push.z, u);
    } else {
        u = relax_axis<2>(n, x.z, push.z, u);
        u = relax_axis<1>(n, x.y, push.y, u);
        u = relax_axis<0>(n, x.x, push.x, u);
    }
    t.v += rows(a.velocity_of_couple, u - t.u);
    t.u = u;
}

template <bool kFull, bool kBeforeLift, class C>
HWY_INLINE void spin_drag_half(const StepInput& in, const C& c, const Held& held, VF nu, Vec3 couple, const Pull& pull,
                               Rates& rates, Twist& t) {
    if constexpr (kFull) {
        spin_drag_half_full(in, c, held, nu, couple, kBeforeLift, rates, t);
    } else {
        const auto& a = c.aerodynamics;
        const VF tau = constant(0.5f * in.h), half = constant(0.5f), s = hn::Sqrt(speed_squared(t.v));
        const Vec3 u = t.u, rate = tau * spin_mobility<false>(c);
        const Vec3 push = bounded_push(times(rate, couple), s) + pull.t.u;
        const Vec3 r = u + half * push;
        Vec3 middle;
        if constexpr (kBeforeLift)
            middle = each_axis(relax_middle, r, times(rate, spin_drag_rate(a, held.drag, nu, s, r)));
        else
            middle = each_axis(over_one_and, r, times(rate, half * rates.spin));
        rates.spin = spin_drag_rate(a, held.drag, nu, s, middle);
        t.u = each_axis(relax_second, u, times(rate, rates.spin), push);
    }
}

// The middle of the implicit midpoint for v' = N (2 k) x v: (1 - N [k]x)^-1 v = (v + N (k x v) + (k.a v) k)/(1 + k.a k),
// a the adjugate of N; a rotation if N is the unit matrix.
template <bool kFull, class C> HWY_INLINE Vec3 lifted_middle(const C& c, Vec3 k, Vec3 v) {
    const auto& a = c.aerodynamics;
    const Vec3 kv = cross(k, v);
    Vec3 ak, moved;
    if constexpr (kFull) {
        ak = symmetric3(a.mobility_adjugate, k);
        moved = symmetric3(a.mobility, kv);
    } else {
        ak = {constant(c.inverse_mass[1]) * constant(c.inverse_mass[2]) * k.x,
              constant(c.inverse_mass[2]) * constant(c.inverse_mass[0]) * k.y,
              constant(c.inverse_mass[0]) * constant(c.inverse_mass[1]) * k.z};
        moved = scaled_by(c.inverse_mass, kv);
    }
    const VF inverse = constant(1.0f) / (constant(1.0f) + dot(ak, k));
    return inverse * (v + moved + dot(ak, v) * k);
}

// In the middle of a substep: the flow past the plate, and the velocity of the load centre.
struct Middle {
    Plate plate;
    Vec3 v;
};

// Lift does no work: the force g x v_middle of the implicit midpoint keeps the energy at any step, whatever the circulation g. That is taken at the
// middle which the circulation at the start leads to. plate: at the start of the loads.
template <bool kFull, class C>
HWY_INLINE Middle lift_step(const StepInput& in, const C& c, const Held& held, const Plate& plate, VF nu, Twist& t) {
    const auto& a = c.aerodynamics;
    const VF half = constant(0.5f * in.h);
    const Vec3 v = t.v, u = t.u;
    // Beyond this the velocity turns too far in a step to be resolved.
    const VF most = constant(5e3f), least = constant(-5e3f);
    const Vec3 start = bounded(half * circulation(a, held, plate, nu, v, u), most, least);
    const Vec3 v_middle = lifted_middle<kFull>(c, start, v);
    const Plate middle = plate_at(a, held, nu, plate.lag, v_middle);
    Vec3 u_middle = u;
    if constexpr (kFull) u_middle = u + rows(a.spin_response_to_force, cross(start, v_middle));
    const Vec3 k = bounded(half * circulation(a, held, middle, nu, v_middle, u_middle), most, least);
    const Vec3 half_impulse = cross(k, lifted_middle<kFull>(c, k, v));
    const Vec3 impulse = half_impulse + half_impulse;
    if constexpr (kFull)
        t += Twist{symmetric3(a.mobility, impulse), rows(a.spin_response_to_force, impulse)};
    else
        t.v += scaled_by(c.inverse_mass, impulse);
    return {middle, v_middle};
}

// The gain by weight, buoyancy and external forces. A torque acts with the drag (full path: it moves the load centre) or the spin drag (diagonal).
template <bool kFull, class C>
HWY_INLINE Pull pull_of(const StepInput& in, const C& c, const Held& held, Quaternion q) {
    const VF tau = constant(0.5f * in.h);
    if constexpr (!kFull) {
        Twist f{to_body(q, held.weight), zero3()};
        if (held.external) f += external_force<false>(c, *held.external, q);
        const Twist t = tau * acceleration<false>(c, f);
        return {t, t.v};
    }
    const auto& a = c.aerodynamics;
    const auto answer = [&](const Twist& f) LR_LAMBDA {
        const Twist t = acceleration<true>(c, f);
        return Twist{centre_velocity<true>(a, t), load_spin<true>(a, t)};
    };
    const Vec3 gravity = to_body(q, held.gravity);
    Twist t;
    if (held.uniform) {
        t = {rows(a.fall, gravity), rows(a.fall + 9, gravity)};
        if (held.external) t += answer(external_force<true>(c, *held.external, q));
    } else {
        Twist f{to_body(q, held.weight), cross(broadcast(c.buoyancy), gravity)};
        if (held.external) f += external_force<true>(c, *held.external, q);
        t = answer(f);
    }
    t = tau * t;
    return {t, columns(a.modes, t.v)};
}

template <bool kFull, class C>
HWY_INLINE Middle loads_in_middle(const StepInput& in, const C& c, const Held& held, VF nu, Body& b) {
    const Pull pull = pull_of<kFull>(in, c, held, b.q);
    // Loads act on the spin relative to the fluid.
    if (held.sheared) b.t.u -= to_body(b.q, held.fluid_spin);
    const auto& a = c.aerodynamics;
    const Twist before{centre_velocity<kFull>(a, b.t), load_spin<kFull>(a, b.t)};
    Twist t = before;
    Rates rates{hn::Zero(DF()), zero3()};
    const Plate plate = plate_at(a, held, nu, b.lag, t.v);
    const Vec3 couple = shedding_couple(a, held, b.shedding, nu, t.v);
    drag_half<kFull, true>(in, c, held, plate, nu, pull, rates, t);
    spin_drag_half<kFull, true>(in, c, held, nu, couple, pull, rates, t);
    const Middle middle = lift_step<kFull>(in, c, held, plate, nu, t);
    const Vec3 later = shedding_couple(a, held, b.shedding, nu, middle.v);
    spin_drag_half<kFull, false>(in, c, held, nu, later + later - couple, pull, rates, t);
    drag_half<kFull, false>(in, c, held, extrapolated(plate, middle.plate), nu, pull, rates, t);
    if constexpr (kFull) {
        // Only the change: a round trip through the load axes would round the whole.
        const Vec3 u = columns(a.axes, t.u - before.u);
        b.t += Twist{columns(a.axes, t.v - before.v) - cross(u, broadcast(a.arm)), u};
    } else {
        b.t = t;
    }
    if (held.sheared) b.t.u += to_body(b.q, held.fluid_spin);
    return middle;
}

// Free motion has the largest error, growing with the square of its step: it takes the two outer places, the loads the middle.
// Returns the velocity of the load centre in the middle.
template <bool kFull, class C>
HWY_INLINE Vec3 aerodynamic_splitting_substep(const StepInput& in, const C& c, Held& held, VF nu, Body& b) {
    const auto& a = c.aerodynamics;
    held.shed = plate_at(a, held, nu, b.lag, centre_velocity<kFull>(a, b.t)).shed;
    free_step<kFull, true>(0.5f * in.h, c, held, b);
    const Middle middle = loads_in_middle<kFull>(in, c, held, nu, b);
    const VF most = constant(a.most_shed);
    held.shed = hn::Max(hn::Min(middle.plate.shed + middle.plate.shed - held.shed, most), hn::Zero(DF()));
    free_step<kFull, true>(0.5f * in.h, c, held, b);
    return middle.v;
}
} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
