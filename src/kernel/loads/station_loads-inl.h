// Loads of bodies with stations, and their substep: docs/maintainers/physics.md, section 5.4; numerics.md, "Stations". Kernel units:
// body_constants.h. The loads of all stations are -(S - W) (v, u) with S symmetric and positive, W skew. Kirchhoff's products have this form
// with S = 0. So one linear system solves all motion at once, and no step gains energy.
#if defined(LR_KERNEL_LOADS_STATION_LOADS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_LOADS_STATION_LOADS_INL_H_
#undef LR_KERNEL_LOADS_STATION_LOADS_INL_H_
#else
#define LR_KERNEL_LOADS_STATION_LOADS_INL_H_
#endif

#include "kernel/integrator/equations_of_motion-inl.h"
#include "kernel/integrator/splitting_scheme-inl.h"
#include "kernel/integrator/step.h"
#include "kernel/loads/aerodynamic_loads-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::LR_KERNEL_NAMESPACE {

// S in blocks (upper triangles): drag on v, `mixed` from u to v and its transpose back, spin_drag on u.
// W: [turn]x on v, `couple` from u to v and its negative transpose back, [spin]x on u.
struct Resistance {
    VF drag[6], spin_drag[6];
    Matrix mixed;
    Vec3 turn, spin;
    Matrix couple;
    Twist lost; // momentum shed by separated streams
};

HWY_INLINE VF along6(const float* k, const Twist& t) {
    return weighted(k, t.v) + weighted(k + 3, t.u);
}

// behind_body: the wake's stream less the present one, body axes. tumbling: the spin without that about the body's normal.
template <class A>
HWY_INLINE void add_station(const StationConstants& k, const A& a, const Held& held, VF nu, Vec3 behind_body,
                            const Twist& t, Vec3 tumbling, Resistance& out) {
    const VF one = constant(1.0f), zero = hn::Zero(DF()), least = constant(1e-20f);
    const VF fluid_drag = held.drag * constant(a.fluid[0]), fluid_lift = held.lift * constant(a.fluid[1]);
    const Vec3 u{along6(k.along[0], t), along6(k.along[1], t), along6(k.along[2], t)};
    const Vec3 w = rows(k.axes, t.u), behind = rows(k.axes, behind_body);
    const Vec3 f = u + constant(a.wake_share) * behind;

    const VF x2 = f.x * f.x + least, y2 = f.y * f.y + least, along = x2 + y2, inverse = one / along;
    const VF across = f.z - constant(k.camber) * hn::Abs(f.x), a2 = across * across, f2 = along + a2;
    const auto by_direction = [&](const float(&value)[2])
                                  LR_LAMBDA { return (constant(value[0]) * x2 + constant(value[1]) * y2) * inverse; };
    const VF stall = hn::Max(by_direction(k.stall), one);
    VF x = a2 * stall / f2;
    x *= x;
    const VF kept = along * stall, attached = kept / (kept + f2 * (stall - one) * x + constant(1e-30f));
    const VF separated = one - attached;

    const VF s2 = speed_squared(u), s = hn::Sqrt(s2), inverse_s2 = one / s2, root = hn::Sqrt(s * nu);
    const Vec3 part = inverse_s2 * times(u, u);
    // The normal force: `stiff` times the stream's normal component, against it; and the lift of camber and wake, across the stream.
    const VF open = hn::Max(one - inverse_s2 * s * dot(broadcast(k.hollow), u), zero);
    const VF lift = open * fluid_lift * attached *
                    (by_direction(k.lift) * hn::Sqrt(along) + by_direction(k.vortex) * hn::Abs(across));
    const VF growing = hn::Sqrt(speed_squared(behind)) * dot(behind, u) * inverse_s2;
    const VF broad = open * constant(k.plate_drag) * separated * (constant(0.8f) * (one - part.z) + one) * s;
    const VF stiff =
        hn::Max(lift + fluid_drag * (broad - constant(k.start_drag) * constant(a.streaming) * growing), zero);
    const VF normal = inverse_s2 * lift * (across - u.z);

    const VF late = s / (constant(8710.0f) * nu + s); // Re/(Re + 8710)
    const VF form = late * weighted(k.drag_blunt, part) + weighted(k.drag, part);
    const VF layer = root * weighted(k.drag_layer, part);
    const VF drag = fluid_drag * (s * form + (nu * weighted(k.drag_stokes, part) + layer));
    const VF pitching = fluid_lift * (one - constant(k.plate_share) * (one - constant(a.streaming)));
    const auto circulation = [&](int i, VF wi)
                                 LR_LAMBDA { return (i < 2 ? pitching : fluid_lift) * constant(k.spin_lift[i]) * wi; };
    const VF crossing = one - part.y;
    const Vec3 turn =
        columns(k.axes, {(one - part.x) * circulation(0, dot(broadcast(k.axes), tumbling)) - normal * u.y,
                         crossing * crossing * circulation(1, dot(broadcast(k.axes + 3), tumbling)) + normal * u.x,
                         circulation(2, w.z)});

    const Vec3 r = broadcast(k.place);
    const VF twist = dot(turn, r);
    const Vec3 n = broadcast(k.along[2]), arm = broadcast(k.along[2] + 3), by = drag * r;
    // Munk's moment puts the attached lift ahead of the middle; on a short wing this is more than a quarter chord. So the lift acts farther aft by
    // the excess.
    const VF aft = hn::Min(lift / hn::Max(stiff, least), one) * hn::Sqrt(inverse);
    const Vec3 at = arm + constant(k.lift_arm[0]) * aft * f.x * broadcast(k.axes + 3) -
                    constant(k.lift_arm[1]) * aft * f.y * broadcast(k.axes);
    for (int i = 0; i < 6; ++i) out.drag[i] += constant(k.outer[2][i]) * stiff;
    for (int i : {0, 3, 5}) out.drag[i] += drag;
    out.mixed += outer(stiff * n, at) + Matrix{{{zero, by.z, -by.y}, {-by.z, zero, by.x}, {by.y, -by.x, zero}}};
    out.turn += turn;
    out.spin += twist * r;
    out.couple.row[0] -= r.x * turn;
    out.couple.row[1] -= r.y * turn;
    out.couple.row[2] -= r.z * turn;
    out.couple.row[0].x += twist;
    out.couple.row[1].y += twist;
    out.couple.row[2].z += twist;
    const Vec3 resist = spin_drag_rate(k, held.drag * constant(a.fluid[2]), nu, hn::Abs(u.z), w);
    for (int i = 0; i < 6; ++i)
        out.spin_drag[i] +=
            constant(k.spread[i]) * drag + (constant(k.outer[0][i]) * resist.x +
                                            (constant(k.outer[1][i]) * resist.y + constant(k.outer[2][i]) * resist.z));
    const Vec3 push = stiff * at;
    out.spin_drag[0] += push.x * at.x;
    out.spin_drag[1] += push.x * at.y;
    out.spin_drag[2] += push.x * at.z;
    out.spin_drag[3] += push.y * at.y;
    out.spin_drag[4] += push.y * at.z;
    out.spin_drag[5] += push.z * at.z;
    // A separated stream leaves the momentum of its added mass behind, if the plate does not turn before.
    const VF turned = constant(k.shed_length) * w.y, slow = s2 / (s2 + turned * turned);
    const VF critical = constant(a.shedding_reynolds) * nu * hn::Sqrt(inverse_s2);
    const VF shed = separated * hn::Max(one - critical * critical, zero) * slow * constant(k.separated_shedding) *
                    constant(a.fluid[3]) * u.z;
    out.lost += Twist{shed * n, shed * arm};
}

template <class A>
static HWY_NOINLINE Resistance station_resistance(const StationSet& stations, const A& a, const Held& held, VF nu,
                                                  Vec3 lag, const Twist& t) {
    const VF zero = hn::Zero(DF());
    const Vec3 none = zero3();
    Resistance out;
    for (VF& x : out.drag) x = zero;
    for (VF& x : out.spin_drag) x = zero;
    out.mixed = out.couple = {{none, none, none}};
    out.turn = out.spin = out.lost.v = out.lost.u = none;
    // The wake remembers the fall of the whole body. Ends that move faster, as a winged seed's do, meet streams of their own; the edges of a long
    // strip that turns about its length hardly leave the wake.
    const Vec3 v = centre_velocity<true>(a, t), w = load_spin<true>(a, t);
    const auto of_ends = [&](int k) LR_LAMBDA {
        const VF weight = constant(a.spin_weight[k]);
        return hn::Min(constant(10.0f) * (weight * weight), constant(1.0f));
    };
    const VF v2 = speed_squared(v), ends2 = of_ends(0) * (w.x * w.x) + (of_ends(1) * (w.y * w.y) + w.z * w.z);
    const Vec3 behind = columns(a.axes, v2 / (v2 + ends2) * (lag - v));
    const Vec3 n = broadcast(a.axes + 6), tumbling = t.u - dot(n, t.u) * n;
    for (uint32_t i = 0; i < stations.count; ++i)
        add_station(stations.station[i], a, held, nu, behind, t, tumbling, out);
    return out;
}

// Adds Kirchhoff's products of a momentum with velocity and spin. g: 1/(d s).
HWY_INLINE void add_momentum(VF g, const Twist& mu, Resistance& out) {
    const Vec3 p = g * mu.v;
    out.spin += g * mu.u;
    out.couple.row[0] += Vec3{hn::Zero(DF()), -p.z, p.y};
    out.couple.row[1] += Vec3{p.z, hn::Zero(DF()), -p.x};
    out.couple.row[2] += Vec3{-p.y, p.x, hn::Zero(DF())};
}

// Added momentum that is left in the wake pushes a body that turns. g: 1/(d s).
HWY_INLINE Twist push_of_shed(VF g, const Twist& lost, const Twist& t) {
    const Vec3 p = g * lost.v, l = g * lost.u;
    return {cross(t.u, p), cross(t.u, l) + cross(t.v, p)};
}

// (W - S) t.
HWY_INLINE Twist resisted(const Resistance& k, const Twist& t) {
    const Vec3 v = cross(k.turn, t.v) - symmetric3(k.drag, t.v) + (k.couple - k.mixed) * t.u;
    const Vec3 u = cross(k.spin, t.u) - symmetric3(k.spin_drag, t.u) - transposed(k.couple + k.mixed) * t.v;
    return {v, u};
}

// Block of a mass matrix from spin to momentum, by its upper triangle.
template <class T> HWY_INLINE Matrix coupling(const T* m) {
    return {{broadcast(m + 3), broadcast(m + 8), broadcast(m + 12)}};
}
template <class T>
HWY_INLINE Matrix symmetric(const T& xx, const T& xy, const T& xz, const T& yy, const T& yz, const T& zz) {
    const VF y = constant(xy), z = constant(xz), w = constant(yz);
    return {{{constant(xx), y, z}, {y, constant(yy), w}, {z, w, constant(zz)}}};
}

// Derivative of Kirchhoff's products by the momentum, near a motion: blocks from v and from u.
struct Products {
    Matrix v_of_v, v_of_u, u_of_v, u_of_u;
};
template <class C> HWY_INLINE Products products(const C& c, VF g, const Twist& t) {
    const auto* const m = c.full_mass;
    const Matrix first = symmetric(m[0], m[1], m[2], m[6], m[7], m[11]), mixed = coupling(m);
    const Matrix last = symmetric(m[15], m[16], m[17], m[18], m[19], m[20]);
    const auto times = [](Vec3 a, const Matrix& b) LR_LAMBDA {
        return Matrix{
            {a.z * b.row[1] - a.y * b.row[2], a.x * b.row[2] - a.z * b.row[0], a.y * b.row[0] - a.x * b.row[1]}};
    };
    const Vec3 v = g * t.v, u = g * t.u;
    return {times(u, first), times(u, mixed), times(v, first) + times(u, transposed(mixed)),
            times(v, mixed) + times(u, last)};
}
HWY_INLINE Twist operator*(const Products& p, const Twist& t) {
    return {p.v_of_v * t.v + p.v_of_u * t.u, p.u_of_v * t.v + p.u_of_u * t.u};
}

// (M + theta (S - W))^-1 by the inverse of the block of v and its Schur complement. Positive definite plus skew needs no pivots.
struct Factors {
    Matrix inverse;      // of the block of v
    Matrix right, below; // inverse times the block from u to v; the block from v to u times inverse
    Columns rest;
};
template <class C> HWY_INLINE Factors factors(const C& c, VF theta, const Resistance& k, const Products& p) {
    const auto* const m = c.full_mass;
    const Vec3 turn = theta * k.turn;
    const auto entry = [&](int i) LR_LAMBDA { return theta * k.drag[i]; };
    const VF xy0 = constant(m[1]) + entry(1), xz0 = constant(m[2]) + entry(2), yz0 = constant(m[7]) + entry(4);
    const Vec3 a0 = Vec3{constant(m[0]) + entry(0), xy0 + turn.z, xz0 - turn.y} - theta * p.v_of_v.row[0];
    const Vec3 a1 = Vec3{xy0 - turn.z, constant(m[6]) + entry(3), yz0 + turn.x} - theta * p.v_of_v.row[1];
    const Vec3 a2 = Vec3{xz0 + turn.y, yz0 - turn.x, constant(m[11]) + entry(5)} - theta * p.v_of_v.row[2];
    const Vec3 c0 = cross(a1, a2), c1 = cross(a2, a0), c2 = cross(a0, a1); // columns of the adjugate
    const VF over = constant(1.0f) / dot(a0, c0);
    const Matrix inverse{{over * Vec3{c0.x, c1.x, c2.x}, over * Vec3{c0.y, c1.y, c2.y}, over * Vec3{c0.z, c1.z, c2.z}}};
    // Block from u to v: M12 + theta (mixed - couple); from v to u: M12^T + theta (mixed + couple)^T.
    const Matrix couple = theta * k.couple, both = coupling(m) + theta * k.mixed, to = both - couple - theta * p.v_of_u;
    const Matrix back = transposed(both + couple) - theta * p.u_of_v;
    Factors out{inverse, inverse * to, back * inverse, {}};
    const Matrix schur = back * out.right + theta * p.u_of_u;
    const Vec3 spin = theta * k.spin;
    const VF* const s = k.spin_drag;
    const VF xx = constant(m[15]) + theta * s[0], xy = constant(m[16]) + theta * s[1],
             xz = constant(m[17]) + theta * s[2];
    const VF yy = constant(m[18]) + theta * s[3], yz = constant(m[19]) + theta * s[4],
             zz = constant(m[20]) + theta * s[5];
    const Vec3* const q = schur.row;
    out.rest = {{xx - q[0].x, xy - spin.z - q[1].x, xz + spin.y - q[2].x},
                {xy + spin.z - q[0].y, yy - q[1].y, yz - spin.x - q[2].y},
                {xz - spin.y - q[0].z, yz + spin.x - q[1].z, zz - q[2].z}};
    return out;
}
HWY_INLINE Twist solve(const Factors& f, const Twist& r) {
    const Vec3 u = solve(f.rest, r.u - f.below * r.v);
    return {f.inverse * r.v - f.right * u, u};
}

// Weight, buoyancy and external forces.
template <class C> HWY_INLINE Twist applied(const C& c, const Held& held, Quaternion q) {
    Twist f{to_body(q, held.weight), cross(broadcast(c.buoyancy), to_body(q, held.gravity))};
    if (held.external) f += external_force<true>(c, *held.external, q);
    return f;
}

// Couple of shed vortices, body axes, bounded so that in a substep it spins the rim up to most_rim times the stream at most.
template <class C> HWY_INLINE Vec3 body_shedding_couple(float h, const C& c, const Held& held, const VF q[4], Vec3 v) {
    const Vec3 couple = columns(c.aerodynamics.axes, shedding_couple(c.aerodynamics, held, q, v));
    const VF rim = constant(most_rim / h) * hn::Sqrt(speed_squared(v));
    const auto bound = [&](VF x, const auto& inverse) LR_LAMBDA {
        const VF most = rim / constant(inverse);
        return hn::Max(hn::Min(x, most), -most);
    };
    return {bound(couple.x, c.inverse_spin_mass[0]), bound(couple.y, c.inverse_spin_mass[1]),
            bound(couple.z, c.inverse_spin_mass[2])};
}

// Resistance to a motion: of the stations, and Kirchhoff's products with the momentum that moves along. push: receives the stations' loads by the
// fluid's spin.
template <class C>
HWY_INLINE Resistance resistance(const StepInput& in, const C& c, const Held& held, VF nu, const Body& b,
                                 const Twist& t, Vec3 fluid_spin, Twist& push) {
    Resistance k = station_resistance(in.body.stations, c.aerodynamics, held, nu, b.lag, {t.v, t.u - fluid_spin});
    push = {zero3(), zero3()};
    if (held.sheared) push = Twist{zero3(), zero3()} - resisted(k, {zero3(), fluid_spin});
    add_momentum(held.inverse_length, momentum<true>(c, t) - k.lost, k);
    return k;
}

// An L-stable pair of implicit stages (Alexander 1977) with the resistance in the middle, which an implicit midpoint step over half the time finds:
// of second order, with rest as a fixed point. It is A-stable and S positive, so loads and products cannot add energy. Returns the velocity of the
// load centre in the middle.
template <class C>
HWY_INLINE Vec3 station_motion(const StepInput& in, float h, const C& c, const Held& held, VF nu, Body& b) {
    const auto& a = c.aerodynamics;
    const VF turning = constant(0.25f * h) * held.inverse_length;
    const Twist start = b.t;
    const auto fluid_spin = [&](Quaternion q)
                                LR_LAMBDA { return held.sheared ? to_body(q, held.fluid_spin) : zero3(); };
    Twist push;
    Quaternion q = normalised(turn(b.q, b.q, turning, start.u));
    Twist shed{zero3(), body_shedding_couple(h, c, held, b.shedding, centre_velocity<true>(a, start))};
    Resistance k = resistance(in, c, held, nu, b, start, fluid_spin(b.q), push);
    Products p = products(c, held.inverse_length, start);
    Factors f = factors(c, constant(0.25f * h), k, p);
    const Twist half = solve(f, constant(0.5f * h) * (applied(c, held, q) + shed + push + resisted(k, start)));
    const Twist middle = start + half;

    q = normalised(turn(b.q, b.q, turning, start.u + constant(0.5f) * half.u));
    shed.u = body_shedding_couple(h, c, held, b.shedding, centre_velocity<true>(a, middle));
    k = resistance(in, c, held, nu, b, middle, fluid_spin(q), push);
    p = products(c, held.inverse_length, middle);
    f = factors(c, constant(stage_gamma * h), k, p);
    const Twist force = applied(c, held, q) + push;
    const Twist r = constant(h) * (force + shed + resisted(k, start) - p * half);
    const Twist first = solve(f, r);
    // h (W - S) first = (M first - r)/stage_gamma
    const Twist second = solve(f, r - constant(stage_rest) * (r - momentum<true>(c, first)));
    b.t = start + (constant(1.0f - stage_gamma) * first + constant(stage_gamma) * second);

    // The derivative of the products is not skew, and the couple of shed vortices takes nothing from the stream. So the twist is scaled: no step may gain
    // more energy than weight and other forces give. The factor k of the new twist z solves k^2 z.Mz = start.M start + h f.(start + k z).
    const auto work = [&](const Twist& a, const Twist& t) LR_LAMBDA { return dot(a.v, t.v) + dot(a.u, t.u); };
    const auto energy = [&](const Twist& t) LR_LAMBDA { return work(momentum<true>(c, t), t); };
    const VF now = energy(b.t), over = constant(1.0f) / hn::Max(now, constant(1e-30f));
    const VF pushed = constant(0.5f * h) * over * work(force, b.t);
    const VF begun = over * hn::Max(energy(start) + constant(h) * work(force, start), hn::Zero(DF()));
    const VF kept = hn::Min(hn::Sqrt(pushed * pushed + begun) + pushed, constant(1.0f));
    // A twist that gained much is none of the loads: in a gale a leaf moves many lengths in a step, and would keep its energy for ever. With the factor
    // squared it comes to rest in the fluid, as drag would have it. So it does beyond single precision, and if the products leave no solution (NaN
    // fails the comparison).
    const Twist still{zero3(), zero3()};
    b.t = select(now <= constant(1e30f), kept * kept * b.t, still);
    // The products turn motion across a plate into motion along it, where in water it has 1/300 of the mass. A step that cannot resolve this shot leaves
    // off a wall in a stream at 14 times its speed. So in a step the speed grows by at most a quarter, a little of the spin, and what the forces give.
    const VF most = constant(1.6f) * dot(start.v, start.v) +
                    (constant(1e-3f) * dot(start.u, start.u) + constant(20.0f * h * h) * dot(force.v, force.v));
    b.t = hn::Sqrt(hn::Min(most / hn::Max(dot(b.t.v, b.t.v), constant(1e-30f)), constant(1.0f))) * b.t;

    const VF g = stretched(constant(0.5f) * (start.u + b.t.u), constant(0.5f * h) * held.inverse_length);
    const Quaternion q1 = normalised(turn(b.q, b.q, g, constant(0.5f) * (start.u + b.t.u)));
    b.x += constant(0.5f * h) * (to_world(b.q, start.v) + to_world(q1, b.t.v));
    b.q = q1;
    return centre_velocity<true>(a, constant(0.5f) * (start + b.t)); // its energy is bounded, that of `middle` is not
}

// Force and torque for Runge-Kutta, with the products of the shed momentum.
template <class C>
static HWY_NOINLINE Twist station_loads(const StepInput& in, const C& c, const Held& held, VF nu, const Body& b,
                                        Vec3 fluid_spin, const Twist& t) {
    const Twist through{t.v, t.u - fluid_spin};
    const Resistance k = station_resistance(in.body.stations, c.aerodynamics, held, nu, b.lag, through);
    Twist out = resisted(k, through);
    out += push_of_shed(held.inverse_length, k.lost, t);
    out.u += body_shedding_couple(in.h, c, held, b.shedding, centre_velocity<true>(c.aerodynamics, through));
    return out;
}
} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
