// Body contact in vectors: gathers the bodies of units into lanes, and applies a unit's impulses to both bodies.
#if defined(LR_KERNEL_CONTACT_BODY_CONTACT_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_CONTACT_BODY_CONTACT_LANES_INL_H_
#undef LR_KERNEL_CONTACT_BODY_CONTACT_LANES_INL_H_
#else
#define LR_KERNEL_CONTACT_BODY_CONTACT_LANES_INL_H_
#endif

#include "kernel/contact/body_contact.h"
#include "kernel/contact/collider_solver-inl.h"

#include <initializer_list>

HWY_BEFORE_NAMESPACE();
namespace lr::LR_KERNEL_NAMESPACE {

// Fields of SolverBody by their index in floats.
constexpr size_t at_x = 0, at_q = 3, at_x0 = 7, at_q0 = 10, at_v = 14, at_w = 17, at_v0 = 20, at_w0 = 23, at_scale = 26,
                 at_way = 27, at_correction = 33, at_shallow = 39, at_carried = 40, at_touches = 41, at_rolled = 42,
                 at_dust = 45, at_share = 46, at_acted = 47, fields_of_body = 56; // a multiple of 4
constexpr size_t twist_floats = sizeof(SolverTwist) / sizeof(float), steps_floats = sizeof(SolverSteps) / sizeof(float);
constexpr size_t at_step = 0, at_growth = 6, at_end = 12, at_steps_acted = 18; // of SolverSteps
static_assert(offsetof(SolverBody, rolled) == at_rolled * sizeof(float));

#if HWY_TARGET == HWY_SCALAR
// Body body_of(lane) of `from` into lane `lane` of rows, and back for the lanes that `counts`.
template <class T, size_t kFields, class BodyOf>
HWY_INLINE void take(const T* from, const BodyOf& body_of, LaneRow (&to)[kFields]) {
    for (size_t lane = 0; lane < contact_lanes; ++lane) {
        const float* const p = reinterpret_cast<const float*>(from + body_of(lane));
        for (size_t f = 0; f < kFields; ++f) to[f][lane] = p[f];
    }
}
template <class T, size_t kFields, class BodyOf, class Counts>
HWY_INLINE void put(const LaneRow (&from)[kFields], const BodyOf& body_of, const Counts& counts, T* to) {
    for (size_t lane = 0; lane < contact_lanes; ++lane) {
        float* const p = reinterpret_cast<float*>(to + body_of(lane));
        if (!counts(lane)) continue;
        for (size_t f = 0; f < kFields; ++f) p[f] = from[f][lane];
    }
}
#else
// Four fields of four bodies, transposed: scalar copies were a third of a sweep's time.
using D4 = hn::Full128<float>;
HWY_INLINE void transpose(hn::Vec<D4> (&r)[4]) {
    const D4 d;
    const auto even_low = hn::InterleaveLower(d, r[0], r[2]), odd_low = hn::InterleaveLower(d, r[1], r[3]);
    const auto even_high = hn::InterleaveUpper(d, r[0], r[2]), odd_high = hn::InterleaveUpper(d, r[1], r[3]);
    r[0] = hn::InterleaveLower(d, even_low, odd_low);
    r[1] = hn::InterleaveUpper(d, even_low, odd_low);
    r[2] = hn::InterleaveLower(d, even_high, odd_high);
    r[3] = hn::InterleaveUpper(d, even_high, odd_high);
}
// Body body_of(lane) of `from` into lane `lane` of rows, and back for the lanes that `counts`.
template <class T, size_t kFields, class BodyOf>
HWY_INLINE void take(const T* from, const BodyOf& body_of, LaneRow (&to)[kFields]) {
    static_assert(kFields % 4 == 0 && sizeof(T) >= kFields * sizeof(float));
    const D4 d;
    for (size_t lane = 0; lane < contact_lanes; lane += 4) {
        const float* p[4];
        for (size_t i = 0; i < 4; ++i) p[i] = reinterpret_cast<const float*>(from + body_of(lane + i));
        for (size_t f = 0; f < kFields; f += 4) {
            hn::Vec<D4> r[4] = {hn::Load(d, p[0] + f), hn::Load(d, p[1] + f), hn::Load(d, p[2] + f),
                                hn::Load(d, p[3] + f)};
            transpose(r);
            for (size_t i = 0; i < 4; ++i) hn::Store(r[i], d, to[f + i] + lane);
        }
    }
}
template <class T, size_t kFields, class BodyOf, class Counts>
HWY_INLINE void put(const LaneRow (&from)[kFields], const BodyOf& body_of, const Counts& counts, T* to) {
    const D4 d;
    for (size_t lane = 0; lane < contact_lanes; lane += 4)
        for (size_t f = 0; f < kFields; f += 4) {
            hn::Vec<D4> r[4] = {hn::Load(d, from[f] + lane), hn::Load(d, from[f + 1] + lane),
                                hn::Load(d, from[f + 2] + lane), hn::Load(d, from[f + 3] + lane)};
            transpose(r);
            for (size_t i = 0; i < 4; ++i)
                if (counts(lane + i)) hn::Store(r[i], d, reinterpret_cast<float*>(to + body_of(lane + i)) + f);
        }
}
#endif

HWY_INLINE Twist load6(const LaneRow* rows, size_t at) {
    return {load3(rows, at), load3(rows + 3, at)};
}
HWY_INLINE void store6(LaneRow* rows, size_t at, const Twist& t) {
    store3(rows, at, t.v);
    store3(rows + 3, at, t.u);
}

HWY_INLINE Matrix matrix_of(Quaternion q) {
    const VF one = constant(1.0f), two = constant(2.0f);
    const VF x = two * q.x, y = two * q.y, z = two * q.z;
    const VF xx = x * q.x, yy = y * q.y, zz = z * q.z;
    const VF xy = x * q.y, xz = x * q.z, yz = y * q.z;
    const VF wx = x * q.w, wy = y * q.w, wz = z * q.w;
    return {{{one - yy - zz, xy - wz, xz + wy}, {xy + wz, one - xx - zz, yz - wx}, {xz - wy, yz + wx, one - xx - yy}}};
}
HWY_INLINE Vec3 transposed_times(const Matrix& m, Vec3 a) {
    return a.x * m.row[0] + a.y * m.row[1] + a.z * m.row[2];
}

// One of the two bodies of a unit, for a vector of units.
struct Side {
    const float* inverse_mass; // 6x6, kernel units
    Matrix axes;               // of the contact frame, in the body's
    Vec3 middle;               // of the contacts, from the centre of mass, along the contact frame, over d s
    VF weight, length;         // a's mass unit over its own; a's d s over its own
};

// Velocity and spin, along the contact frame, of the body's point at the middle of the contacts; spin times a's d s.
HWY_INLINE Twist motion_of(const Side& s, const Twist& t) {
    const Vec3 u = s.axes * t.u;
    return {s.axes * t.v + cross(u, s.middle), s.length * u};
}
// The body's change of twist by an impulse at the middle and a couple, both along the contact frame.
template <bool kFull> HWY_INLINE Twist answer(const Side& s, const Twist& impulse) {
    const Vec3 couple = s.length * impulse.u + cross(s.middle, impulse.v);
    const Twist on_body{transposed_times(s.axes, impulse.v), transposed_times(s.axes, couple)};
    if constexpr (kFull) return s.weight * symmetric6(s.inverse_mass, on_body);
    const float* const m = s.inverse_mass;
    const float diagonal[6] = {m[0], m[6], m[11], m[15], m[18], m[20]};
    return s.weight * Twist{scaled_by(diagonal, on_body.v), scaled_by(diagonal + 3, on_body.u)};
}
HWY_INLINE Side side_a(const BodyContactInput& in, const PairBlock& block, size_t at) {
    return {in.kinds[block.kind_a].body->full_inverse, load_matrix(block.axes_a, at), load3(block.middle_a, at),
            constant(1.0f), constant(1.0f)};
}
HWY_INLINE Side side_b(const BodyContactInput& in, const PairBlock& block, size_t at) {
    return {in.kinds[block.kind_b].body->full_inverse, load_matrix(block.axes_b, at), load3(block.middle_b, at),
            load1(block.ratio, at), load1(block.lengths, at)};
}
HWY_INLINE bool between_bodies(const PairBlock& block) {
    return block.ratio[0] != 0.0f;
}
HWY_INLINE bool full_mass(const BodyContactInput& in, const PairBlock& block) {
    return !in.kinds[block.kind_a].body->diagonal || (between_bodies(block) && !in.kinds[block.kind_b].body->diagonal);
}

// Impulses on a unit, or its relative twist, in two parts. press: what contacts do along the normal (a force, couples about the tangents).
// drag: friction (forces along the tangents, a couple about the normal).
struct Reduced {
    Vec3 press, drag; // of a twist, with the normal n and tangents 1 and 2: (v_n, u_1, u_2), (v_1, v_2, u_n)
};
HWY_INLINE Reduced reduced(const Twist& t) {
    return {{t.v.x, t.u.y, t.u.z}, {t.v.y, t.v.z, t.u.x}};
}
HWY_INLINE Twist expanded(const Reduced& r) {
    return {{r.press.x, r.drag.x, r.drag.y}, {r.drag.z, r.press.y, r.press.z}};
}
HWY_INLINE Reduced operator-(const Reduced& a, const Reduced& b) {
    return {a.press - b.press, a.drag - b.drag};
}
// Velocity of a relative to b.
HWY_NOINLINE Reduced relative_motion(const Side& a, const Side& b, const Twist& ta, const Twist& tb) {
    return reduced(motion_of(a, ta) - motion_of(b, tb));
}
template <bool kFull, bool kPair>
HWY_INLINE void push(const Side& a, const Side& b, const Reduced& impulse, Twist& ta, Twist& tb) {
    const Twist p = expanded(impulse);
    ta += answer<kFull>(a, p);
    if constexpr (kPair) tb = tb - answer<kFull>(b, p);
}
HWY_INLINE Vec3 press_direction(const PairBlock::Row& row, size_t at) {
    return {constant(1.0f), load1(row.along[1], at), -load1(row.along[0], at)};
}
HWY_INLINE Vec3 symmetric(const LaneRow* m, size_t at, Vec3 a) {
    const VF xy = load1(m[1], at), xz = load1(m[2], at), yz = load1(m[4], at);
    return {load1(m[0], at) * a.x + (xy * a.y + xz * a.z), xy * a.x + (load1(m[3], at) * a.y + yz * a.z),
            xz * a.x + (yz * a.y + load1(m[5], at) * a.z)};
}

// Sets the gains of the relative twist by unit impulses, and their inverses for friction and for each contact.
template <bool kFull> HWY_INLINE void set_gains(const Side& a, const Side& b, PairBlock& block, size_t at) {
    const VF zero = hn::Zero(DF()), one = constant(1.0f);
    const bool pair = between_bodies(block);
    const auto gained = [&](const Vec3& press, const Vec3& drag) LR_LAMBDA {
        const Twist impulse = expanded({press, drag});
        Twist gain = motion_of(a, answer<kFull>(a, impulse));
        if (pair) gain += motion_of(b, answer<kFull>(b, impulse));
        return reduced(gain);
    };
    const Vec3 unit[3] = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}, none = zero3();
    const Reduced x = gained(unit[0], none), y = gained(unit[1], none), z = gained(unit[2], none);
    const auto put = [&](LaneRow* to, std::initializer_list<VF> values) LR_LAMBDA {
        for (VF v : values) store1(*to++, at, v);
    };
    put(block.press_press, {x.press.x, x.press.y, x.press.z, y.press.y, y.press.z, z.press.z});
    store3(block.press_drag, at, x.drag);
    store3(block.press_drag + 3, at, y.drag);
    store3(block.press_drag + 6, at, z.drag);
    const Vec3 along = gained(none, unit[0]).drag, across = gained(none, unit[1]).drag,
               spin = gained(none, unit[2]).drag;
    put(block.drag_drag, {along.x, along.y, along.z, across.y, across.z, spin.z});
    PairBlock::Friction& f = block.friction;
    VF hold[3], least;
    set_hold(along.x, along.y, across.y, hold, least);
    store3(f.hold, at, broadcast(hold));
    store1(f.least, at, least);
    store1(f.hold_spin, at, inverse_length(spin.z));
    for (uint32_t k = 0; k < block.used; ++k) {
        const Vec3 direction = press_direction(block.row[k], at);
        const VF gain = dot(direction, symmetric(block.press_press, at, direction));
        const auto empty = load1(block.place[k].gap, at) >= constant(0.5f * no_contact);
        store1(block.row[k].inverse, at, hn::IfThenElse(empty, zero, inverse_length(gain)));
    }
}

HWY_INLINE VF slop_of(VF reach, Vec3 x) {
    return constant(1e-3f) * reach + constant(1e-6f) * greatest(x);
}

// Scales, lengths and tolerances of a vector of gathered bodies.
struct Size {
    VF length, inverse, reach, slop;
};
HWY_INLINE Size size_of(const SolverBodyKind& kind, const LaneRow* row, size_t at) {
    const VF body_scale = load1(row[at_scale], at);
    Size s;
    s.length = body_scale * constant(kind.body->length);
    s.inverse = constant(1.0f) / s.length;
    s.reach = body_scale * constant(kind.reach);
    s.slop = slop_of(s.reach, load3(row + at_x, at));
    return s;
}

struct Gathered {
    alignas(64) LaneRow a[fields_of_body], b[fields_of_body];
    Gathered(const BodyContactInput& in, const PairBlock& block) {
        take(
            in.bodies, [&](size_t lane) { return block.a[lane]; }, a);
        take(
            in.bodies, [&](size_t lane) { return block.b[lane]; }, b);
    }
};
struct GatheredTwists {
    alignas(64) LaneRow a[twist_floats], b[twist_floats];
    GatheredTwists(const BodyContactInput& in, const PairBlock& block) {
        take(
            in.twists, [&](size_t lane) { return block.a[lane]; }, a);
        take(
            in.twists, [&](size_t lane) { return block.b[lane]; }, b);
    }
    // The immovable body is shared by many lanes and must not change.
    void put_back(const BodyContactInput& in, const PairBlock& block) const {
        put(
            a, [&](size_t lane) { return block.a[lane]; }, [&](size_t lane) { return lane < block.lanes; }, in.twists);
        put(
            b, [&](size_t lane) { return block.b[lane]; }, [&](size_t lane) { return block.ratio[lane] != 0.0f; },
            in.twists);
    }
};
// contact_lanes neighbours.
template <class T, size_t kFields> HWY_INLINE void take_lanes(const T* from, LaneRow (&to)[kFields]) {
    take(
        from, [](size_t lane) { return lane; }, to);
}
template <class T, size_t kFields> HWY_INLINE void put_lanes(const LaneRow (&from)[kFields], T* to) {
    put(
        from, [](size_t lane) { return lane; }, [](size_t) { return true; }, to);
}
// Bodies [begin, begin + contact_lanes), and their twists.
struct GatheredBodies {
    alignas(64) LaneRow row[fields_of_body], twist[twist_floats];
    GatheredBodies(const BodyContactInput& in, uint32_t begin) {
        take_lanes(in.bodies + begin, row);
        take_lanes(in.twists + begin, twist);
    }
    void put_back(const BodyContactInput& in, uint32_t begin) const {
        put_lanes(row, in.bodies + begin);
        put_lanes(twist, in.twists + begin);
    }
};
} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
