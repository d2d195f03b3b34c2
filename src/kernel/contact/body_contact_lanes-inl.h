// Body contact in vectors: gathers bodies and pairs, and applies a contact's impulses to both bodies.
#if defined(LR_KERNEL_CONTACT_BODY_CONTACT_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_CONTACT_BODY_CONTACT_LANES_INL_H_
#undef LR_KERNEL_CONTACT_BODY_CONTACT_LANES_INL_H_
#else
#define LR_KERNEL_CONTACT_BODY_CONTACT_LANES_INL_H_
#endif

#include "kernel/contact/body_contact.h"
#include "kernel/contact/collider_solver-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::LR_KERNEL_NAMESPACE {

// Fields of SolverBody by their index in floats.
constexpr size_t at_x = 0, at_q = 3, at_x0 = 7, at_q0 = 10, at_v = 14, at_w = 17, at_v0 = 20, at_w0 = 23, at_scale = 26,
                 at_way = 27, at_correction = 33, at_depth = 39, at_shallow = 40, at_carried = 41, at_touches = 42,
                 at_rolled = 43, at_dust = 46, fields_of_body = 48; // the last is empty
constexpr size_t twist_floats = sizeof(SolverTwist) / sizeof(float);
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

// One body of a pair, for a vector of pairs.
struct Side {
    const float* inverse_mass; // 6x6, kernel units
    Matrix turn;
    VF weight; // its share of an impulse over a's mass unit
};

// Velocity at the arm, world axes.
HWY_INLINE Vec3 velocity_of(const Matrix& turn, const Twist& t, Vec3 arm) {
    return turn * velocity_at(t, arm);
}
HWY_INLINE Twist impulse_at(const Matrix& turn, Vec3 impulse, Vec3 arm) {
    const Vec3 p = transposed_times(turn, impulse);
    return {p, cross(arm, p)};
}
HWY_INLINE Twist answer(const Side& s, const Twist& impulse) {
    return s.weight * symmetric6(s.inverse_mass, impulse);
}
HWY_INLINE void push(const Side& a, const Side& b, const PairContacts& c, size_t at, Vec3 impulse, Twist& ta,
                     Twist& tb) {
    ta += answer(a, impulse_at(a.turn, impulse, load3(c.arm_a, at)));
    tb = tb - answer(b, impulse_at(b.turn, impulse, load3(c.arm_b, at)));
}
// Velocity of a's contact point relative to b's, world axes.
HWY_INLINE Vec3 relative_velocity(const Matrix& turn_a, const Matrix& turn_b, const PairContacts& c, size_t at,
                                  const Twist& ta, const Twist& tb) {
    return velocity_of(turn_a, ta, load3(c.arm_a, at)) - velocity_of(turn_b, tb, load3(c.arm_b, at));
}

HWY_INLINE Matrix frame_of(const PairContacts& c, size_t at) {
    const Vec3 normal = load3(c.normal, at), first = load3(c.tangent, at);
    return {{normal, first, cross(normal, first)}};
}
// Gains of relative velocity along the contact's three directions by unit impulses along them.
HWY_INLINE void set_gains(const Side& a, const Side& b, PairContacts& c, size_t at) {
    const Vec3 arm[2] = {load3(c.arm_a, at), load3(c.arm_b, at)};
    Vec3 direction[3] = {load3(c.normal, at), {}, {}};
    tangents(direction[0], direction[1], direction[2]);
    store3(c.tangent, at, direction[1]);
    direction[2] = cross(direction[0], direction[1]);
    const Side* const side[2] = {&a, &b};
    VF gain[6];
    for (VF& g : gain) g = hn::Zero(DF());
    for (int s = 0; s < 2; ++s) {
        Twist along[3], response[3];
        for (int k = 0; k < 3; ++k) {
            along[k] = impulse_at(side[s]->turn, direction[k], arm[s]);
            response[k] = answer(*side[s], along[k]);
        }
        constexpr int first[6] = {0, 1, 2, 1, 1, 2}, second[6] = {0, 0, 0, 1, 2, 2};
        for (int k = 0; k < 6; ++k) gain[k] += product(along[first[k]], response[second[k]]);
    }
    const auto empty = load1(c.gap, at) >= constant(0.5f * no_contact);
    store1(c.inverse, at, hn::IfThenElse(empty, hn::Zero(DF()), inverse_length(gain[0])));
    store1(c.to_first, at, gain[1]);
    store1(c.to_second, at, gain[2]);
    VF hold[3], least;
    set_hold(gain[3], gain[4], gain[5], hold, least);
    store3(c.hold, at, broadcast(hold));
    store1(c.least, at, least);
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
// Bodies [begin, begin + contact_lanes), and their twists.
struct GatheredBodies {
    alignas(64) LaneRow row[fields_of_body], twist[twist_floats];
    GatheredBodies(const BodyContactInput& in, uint32_t begin) {
        const auto nth = [](size_t lane) { return lane; };
        take(in.bodies + begin, nth, row);
        take(in.twists + begin, nth, twist);
    }
    void put_back(const BodyContactInput& in, uint32_t begin) const {
        const auto nth = [](size_t lane) { return lane; };
        const auto all = [](size_t) { return true; };
        put(row, nth, all, in.bodies + begin);
        put(twist, nth, all, in.twists + begin);
    }
};
} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
