// Bodies and pairs of a crowd in vectors: how they are gathered, and what a contact's impulses do to both bodies.
#if defined(LR_KERNEL_CROWD_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_CROWD_LANES_INL_H_
#undef LR_KERNEL_CROWD_LANES_INL_H_
#else
#define LR_KERNEL_CROWD_LANES_INL_H_
#endif

#include "kernel/contact_resolve-inl.h"
#include "kernel/crowd.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// Floats of CrowdBody, side by side for the bodies of a vector.
constexpr size_t body_floats = sizeof(CrowdBody) / sizeof(float), twist_floats = sizeof(CrowdTwist) / sizeof(float);
constexpr size_t at_x = 0, at_q = 3, at_x0 = 7, at_q0 = 10, at_v = 14, at_w = 17, at_v0 = 20, at_w0 = 23, at_scale = 26,
                 at_way = 27, at_correction = 33, at_depth = 39, at_shallow = 40, at_carried = 41, at_touches = 42,
                 at_rolled = 43, at_dust = 46, fields_of_body = 47;
static_assert(offsetof(CrowdBody, rolled) == at_rolled * sizeof(float));

template <size_t kStride, size_t kFields, class Index>
HWY_INLINE void gather(const float* from, const Index& index, LaneRow* to) {
    for (size_t lane = 0; lane < contact_lanes; ++lane) {
        const float* const p = from + kStride * index(lane);
        for (size_t f = 0; f < kFields; ++f) to[f][lane] = p[f];
    }
}
template <size_t kStride, size_t kFields, class Index>
HWY_INLINE void scatter(const LaneRow* from, const Index& index, float* to) {
    for (size_t lane = 0; lane < contact_lanes; ++lane) {
        float* const p = to + kStride * index(lane);
        for (size_t f = 0; f < kFields; ++f) p[f] = from[f][lane];
    }
}
HWY_INLINE float* floats(CrowdBody* b) {
    return b->x;
}
HWY_INLINE float* floats(CrowdTwist* t) {
    return t->v;
}

HWY_INLINE Twist load6(const LaneRow* rows, size_t at) {
    return {load3(rows, at), load3(rows + 3, at)};
}
HWY_INLINE void store6(LaneRow* rows, size_t at, const Twist& t) {
    store3(rows, at, t.v);
    store3(rows + 3, at, t.u);
}

struct Matrix {
    Vec3 row[3];
};
HWY_INLINE Matrix matrix_of(Quaternion q) {
    const VF one = constant(1.0f), two = constant(2.0f);
    const VF x = hn::Mul(two, q.x), y = hn::Mul(two, q.y), z = hn::Mul(two, q.z);
    const VF xx = hn::Mul(x, q.x), yy = hn::Mul(y, q.y), zz = hn::Mul(z, q.z);
    const VF xy = hn::Mul(x, q.y), xz = hn::Mul(x, q.z), yz = hn::Mul(y, q.z);
    const VF wx = hn::Mul(x, q.w), wy = hn::Mul(y, q.w), wz = hn::Mul(z, q.w);
    return {{{hn::Sub(hn::Sub(one, yy), zz), hn::Sub(xy, wz), hn::Add(xz, wy)},
             {hn::Add(xy, wz), hn::Sub(hn::Sub(one, xx), zz), hn::Sub(yz, wx)},
             {hn::Sub(xz, wy), hn::Add(yz, wx), hn::Sub(hn::Sub(one, xx), yy)}}};
}
HWY_INLINE Matrix load_matrix(const LaneRow* rows, size_t at) {
    return {{load3(rows, at), load3(rows + 3, at), load3(rows + 6, at)}};
}
HWY_INLINE void store_matrix(LaneRow* rows, size_t at, const Matrix& m) {
    for (int i = 0; i < 3; ++i) store3(rows + 3 * i, at, m.row[i]);
}
HWY_INLINE Vec3 to_world(const Matrix& m, Vec3 a) {
    return {dot(m.row[0], a), dot(m.row[1], a), dot(m.row[2], a)};
}
HWY_INLINE Vec3 to_body(const Matrix& m, Vec3 a) {
    return add_scaled(add_scaled(scale(a.x, m.row[0]), a.y, m.row[1]), a.z, m.row[2]);
}

// One body of a pair, for a vector of pairs.
struct Side {
    const float* inverse_mass; // 6x6, kernel units
    Matrix turn;
    VF weight; // its share of an impulse over a's mass unit
};

// The velocity of its point at the arm, world axes.
HWY_INLINE Vec3 velocity_of(const Matrix& turn, const Twist& t, Vec3 arm) {
    return to_world(turn, velocity_at(t, arm));
}
HWY_INLINE Twist impulse_at(const Matrix& turn, Vec3 impulse, Vec3 arm) {
    const Vec3 p = to_body(turn, impulse);
    return {p, cross(arm, p)};
}
HWY_INLINE Twist answer(const Side& s, const Twist& impulse) {
    const Twist t = symmetric6(s.inverse_mass, impulse);
    return {scale(s.weight, t.v), scale(s.weight, t.u)};
}

// What the pair's contact gains along its three directions by unit impulses along them.
HWY_INLINE void set_gains(const Side& a, const Side& b, PairContacts& c, size_t at) {
    const DF d;
    const VF one = constant(1.0f);
    const Vec3 arm[2] = {load3(c.arm_a, at), load3(c.arm_b, at)};
    Vec3 direction[3] = {load3(c.normal, at), {}, {}};
    tangents(direction[0], direction[1], direction[2]);
    store3(c.tangent, at, direction[1]);
    direction[2] = cross(direction[0], direction[1]);
    const Side* const side[2] = {&a, &b};
    VF gain[6];
    for (VF& g : gain) g = hn::Zero(d);
    for (int s = 0; s < 2; ++s) {
        Twist along[3], response[3];
        for (int k = 0; k < 3; ++k) {
            along[k] = impulse_at(side[s]->turn, direction[k], arm[s]);
            response[k] = answer(*side[s], along[k]);
        }
        constexpr int first[6] = {0, 1, 2, 1, 1, 2}, second[6] = {0, 0, 0, 1, 2, 2};
        for (int k = 0; k < 6; ++k) gain[k] = hn::Add(gain[k], product(along[first[k]], response[second[k]]));
    }
    const auto put = [&](VF v, float* to) LR_LAMBDA { hn::Store(v, d, to + at); };
    const auto empty = hn::Ge(hn::Load(d, c.gap + at), constant(0.5f * no_contact));
    put(hn::IfThenElse(empty, hn::Zero(d), inverse_length(gain[0])), c.inverse);
    put(gain[1], c.to_first);
    put(gain[2], c.to_second);
    const VF over = hn::Div(one, neg_mul_add(gain[4], gain[4], hn::Mul(gain[3], gain[5]))); // positive definite
    put(hn::Mul(gain[5], over), c.hold[0]);
    put(hn::Neg(hn::Mul(gain[4], over)), c.hold[1]);
    put(hn::Mul(gain[3], over), c.hold[2]);
    const VF half_gap = hn::Mul(constant(0.5f), hn::Sub(gain[3], gain[5]));
    const VF spread = hn::Sqrt(mul_add(half_gap, half_gap, hn::Mul(gain[4], gain[4])));
    put(hn::Div(one, mul_add(constant(0.5f), hn::Add(gain[3], gain[5]), spread)), c.least);
}

HWY_INLINE VF slop_of(VF reach, Vec3 x) {
    return mul_add(constant(1e-3f), reach, hn::Mul(constant(1e-6f), greatest(x)));
}

// Scales, lengths and tolerances of a vector of bodies in the rows of a gather.
struct Size {
    VF length, inverse, reach, slop;
};
HWY_INLINE Size size_of(const CrowdKind& kind, const LaneRow* row, size_t at) {
    const DF d;
    const VF body_scale = hn::Load(d, row[at_scale] + at);
    Size s;
    s.length = hn::Mul(body_scale, constant(kind.body->length));
    s.inverse = hn::Div(constant(1.0f), s.length);
    s.reach = hn::Mul(body_scale, constant(kind.reach));
    s.slop = slop_of(s.reach, load3(row + at_x, at));
    return s;
}

struct Gathered {
    alignas(64) LaneRow a[fields_of_body], b[fields_of_body];
    Gathered(const CrowdInput& in, const PairBlock& block) {
        gather<body_floats, fields_of_body>(
            floats(in.bodies), [&](size_t lane) { return block.a[lane]; }, a);
        gather<body_floats, fields_of_body>(
            floats(in.bodies), [&](size_t lane) { return block.b[lane]; }, b);
    }
};
struct GatheredTwists {
    alignas(64) LaneRow a[twist_floats], b[twist_floats];
    GatheredTwists(const CrowdInput& in, const PairBlock& block) {
        gather<twist_floats, twist_floats>(
            floats(in.twists), [&](size_t lane) { return block.a[lane]; }, a);
        gather<twist_floats, twist_floats>(
            floats(in.twists), [&](size_t lane) { return block.b[lane]; }, b);
    }
    // Nobody's values are read by many and must not change.
    void put_back(const CrowdInput& in, const PairBlock& block) const {
        float* const to = floats(in.twists);
        for (size_t lane = 0; lane < block.lanes; ++lane) {
            float* const p = to + twist_floats * block.a[lane];
            for (size_t f = 0; f < twist_floats; ++f) p[f] = a[f][lane];
            if (block.ratio[lane] == 0.0f) continue;
            float* const other = to + twist_floats * block.b[lane];
            for (size_t f = 0; f < twist_floats; ++f) other[f] = b[f][lane];
        }
    }
};
// Bodies [begin, begin + contact_lanes) and what sweeps change of them.
struct GatheredBodies {
    alignas(64) LaneRow row[fields_of_body], twist[twist_floats];
    GatheredBodies(const CrowdInput& in, uint32_t begin) {
        const auto index = [begin](size_t lane) { return begin + lane; };
        gather<body_floats, fields_of_body>(floats(in.bodies), index, row);
        gather<twist_floats, twist_floats>(floats(in.twists), index, twist);
    }
    void put_back(const CrowdInput& in, uint32_t begin) const {
        const auto index = [begin](size_t lane) { return begin + lane; };
        scatter<body_floats, fields_of_body>(row, index, floats(in.bodies));
        scatter<twist_floats, twist_floats>(twist, index, floats(in.twists));
    }
};

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
