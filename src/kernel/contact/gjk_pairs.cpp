// Many pairs of bodies side by side, compiled once for each instruction set: whose boxes are apart, the nearest points of convex hulls, and contacts of
// plates.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/contact/gjk_pairs.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "kernel/contact/gjk_pairs.h"

#include "hwy/highway.h"
#include "kernel/contact/gjk-inl.h"

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {
namespace search {

namespace hw = hwy::HWY_NAMESPACE;
using Tag = hw::CappedTag<float, search_lanes>;
using Number = hw::Vec<Tag>;

struct Vec {
    Number x, y, z;
};
HWY_INLINE Vec operator+(const Vec& a, const Vec& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE Vec operator-(const Vec& a, const Vec& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE Vec operator*(Number s, const Vec& a) {
    return {s * a.x, s * a.y, s * a.z};
}
HWY_INLINE Number dot(const Vec& a, const Vec& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
HWY_INLINE Vec cross(const Vec& a, const Vec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct Lanes {
    using V = Number;
    using Vec = search::Vec;
    using M = hw::Mask<Tag>;
    static constexpr bool relative = false;
    static constexpr uint32_t most_rounds = 24;
    static HWY_INLINE V number(float a) { return hw::Set(Tag(), a); }
    static HWY_INLINE V root(V a) { return hw::Sqrt(a); }
    static HWY_INLINE M none() { return hw::FirstN(Tag(), 0); }
    static HWY_INLINE bool any(M a) { return !hw::AllFalse(Tag(), a); }
    static HWY_INLINE M both(M a, M b) { return hw::And(a, b); }
    static HWY_INLINE M either(M a, M b) { return hw::Or(a, b); }
    static HWY_INLINE M without(M a, M b) { return hw::AndNot(b, a); }
    static HWY_INLINE M inverse(M a) { return hw::Not(a); }
    static HWY_INLINE V choose(M m, V yes, V no) { return hw::IfThenElse(m, yes, no); }
    static HWY_INLINE Vec choose(M m, const Vec& yes, const Vec& no) {
        return {choose(m, yes.x, no.x), choose(m, yes.y, no.y), choose(m, yes.z, no.z)};
    }
};

HWY_INLINE Vec load(const SearchBlock::Row* rows, size_t at) {
    return {hw::Load(Tag(), rows[0] + at), hw::Load(Tag(), rows[1] + at), hw::Load(Tag(), rows[2] + at)};
}
HWY_INLINE void store(const Vec& a, SearchBlock::Row* rows, size_t at) {
    hw::Store(a.x, Tag(), rows[0] + at);
    hw::Store(a.y, Tag(), rows[1] + at);
    hw::Store(a.z, Tag(), rows[2] + at);
}

// The vertex farthest along a direction, the first of equals.
HWY_INLINE Vec farthest(const SearchHull& hull, const Vec& d) {
    const auto corner = [&](uint32_t i) HWY_ATTR {
        return Vec{Lanes::number(hull.x[i]), Lanes::number(hull.y[i]), Lanes::number(hull.z[i])};
    };
    Vec best = corner(0);
    Number most = dot(best, d);
    for (uint32_t i = 1; i < hull.count; ++i) {
        const Vec p = corner(i);
        const Number along = dot(p, d);
        const Lanes::M better = along > most;
        most = hw::IfThenElse(better, along, most);
        best = Lanes::choose(better, p, best);
    }
    return best;
}

struct Support {
    const SearchHull &a, &b;
    Vec axis[3], offset;
    Number ratio;

    HWY_INLINE Corner<Lanes> operator()(const Vec& d) const {
        const Vec on_a = farthest(a, {hw::Neg(d.x), hw::Neg(d.y), hw::Neg(d.z)});
        const Vec p = farthest(b, {dot(axis[0], d), dot(axis[1], d), dot(axis[2], d)});
        return {on_a - (offset + ratio * (p.x * axis[0] + p.y * axis[1] + p.z * axis[2])), on_a};
    }
};

HWY_INLINE void nearest_of_hulls(const SearchHull& a, const SearchHull& b, SearchBlock& block, size_t at) {
    const Tag d;
    const Support support{a,
                          b,
                          {load(block.axes, at), load(block.axes + 3, at), load(block.axes + 6, at)},
                          load(block.offset, at),
                          hw::Load(d, block.ratio + at)};
    const Closest<Lanes> found = closest<Lanes>(support, load(block.start, at), hw::Load(d, block.enough + at),
                                                hw::Load(d, block.near + at), hw::Load(d, block.tolerance + at));
    store((Lanes::number(1.0f) / found.distance) * found.v, block.normal, at);
    store(found.on_a, block.on_a, at);
    hw::Store(found.distance, d, block.distance + at);
    const Number apart = Lanes::number(SearchBlock::apart), beyond = Lanes::number(SearchBlock::beyond);
    const Number overlap = Lanes::choose(found.overlap, Lanes::number(SearchBlock::overlap), apart);
    hw::Store(Lanes::choose(found.beyond, beyond, overlap), d, block.state + at);
}

// Contacts of two flat cores, apart and not edge-on to each other: where their outlines, seen along the normal, overlap, at most four places. A
// pair per lane. The general way, for one pair of any cores: collision/body_narrow_phase.cpp, whose choice of places this follows.

// The corners of a flat core seen along the normal, and the half planes that its edges bound.
struct Outline {
    uint32_t count;
    Number u[most_outline], v[most_outline];
    Number out_u[most_outline], out_v[most_outline], most[most_outline]; // inside: out . p <= most

    // sense: 1 if the corners are counter-clockwise, else -1. slack: how far beyond an edge is still inside.
    HWY_INLINE void close(Number sense, Number slack) {
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t next = i + 1 < count ? i + 1 : 0;
            const Number du = sense * (u[next] - u[i]), dv = sense * (v[next] - v[i]);
            out_u[i] = dv;
            out_v[i] = hw::Neg(du);
            const Number at = u[i] * dv - v[i] * du;
            most[i] = at + slack * (hw::Abs(du) + hw::Abs(dv));
        }
    }
    HWY_INLINE Number beyond(uint32_t edge, Number at_u, Number at_v) const {
        return out_u[edge] * at_u + out_v[edge] * at_v - most[edge];
    }
};

// A plane above the one normal to the contact.
struct Height {
    Number level, slope_u, slope_v;
    HWY_INLINE Number at(Number u, Number v) const { return level + (slope_u * u + slope_v * v); }
};

// Candidates for contacts: the ends of each edge's part within the other outline. Places outside have gaps that never count.
struct Places {
    uint32_t count = 0;
    Number u[4 * most_outline + 1], v[4 * most_outline + 1], gap[4 * most_outline + 1];

    HWY_INLINE void add(Number at_u, Number at_v, Number its_gap) {
        u[count] = at_u;
        v[count] = at_v;
        gap[count++] = its_gap;
    }
    // Cyrus and Beck 1978.
    HWY_INLINE void add_edges(const Outline& of, const Outline& within, const Height& upper, const Height& lower) {
        const Number zero = Lanes::number(0.0f), one = Lanes::number(1.0f), never = Lanes::number(1e30f);
        Number from[most_outline]; // of the edge's first corner beyond each half plane
        for (uint32_t j = 0; j < within.count; ++j) from[j] = within.beyond(j, of.u[0], of.v[0]);
        for (uint32_t i = 0; i < of.count; ++i) {
            const uint32_t next = i + 1 < of.count ? i + 1 : 0;
            Number begin = zero, end = one;
            Lanes::M outside = Lanes::none();
            for (uint32_t j = 0; j < within.count; ++j) {
                const Number to = within.beyond(j, of.u[next], of.v[next]), sinks = from[j] - to;
                const Number crossing = from[j] / sinks;
                const Lanes::M out_first = from[j] > zero, out_last = to > zero;
                begin = hw::IfThenElse(out_first, hw::Max(begin, crossing), begin);
                end = hw::IfThenElse(out_last, hw::Min(end, crossing), end);
                outside = Lanes::either(outside, Lanes::both(out_first, out_last));
                from[j] = to;
            }
            outside = Lanes::either(outside, Lanes::inverse(begin <= end));
            const Number du = of.u[next] - of.u[i], dv = of.v[next] - of.v[i];
            for (const Number part : {begin, end}) {
                const Number at_u = of.u[i] + part * du, at_v = of.v[i] + part * dv;
                const Number here = upper.at(at_u, at_v) - lower.at(at_u, at_v);
                add(at_u, at_v, hw::IfThenElse(outside, never, here));
            }
        }
    }
    struct Best {
        Number u, v, gap;
        Lanes::M found;
    };
    // The place with the greatest measure above `least` among those with gaps below `limit`; measures within a hundredth are equal.
    template <class Measure> HWY_INLINE Best best(Number least, Number limit, const Measure& measure) const {
        Best out{u[0], v[0], gap[0], Lanes::none()};
        for (uint32_t i = 0; i < count; ++i) {
            const Number value = measure(u[i], v[i]);
            const Lanes::M better = Lanes::both(value > least, gap[i] < limit);
            least = hw::IfThenElse(better, Lanes::number(1.01f) * value, least);
            out.u = hw::IfThenElse(better, u[i], out.u);
            out.v = hw::IfThenElse(better, v[i], out.v);
            out.gap = hw::IfThenElse(better, gap[i], out.gap);
            out.found = Lanes::either(out.found, better);
        }
        return out;
    }
};

HWY_INLINE void plate_manifold(const SearchHull& a, const SearchHull& b, SearchBlock& block, size_t at) {
    const Tag d;
    const Number zero = Lanes::number(0.0f), one = Lanes::number(1.0f), ratio = hw::Load(d, block.ratio + at);
    const Number distance = hw::Load(d, block.distance + at), limit = hw::Load(d, block.enough + at);
    const Number smaller = hw::Load(d, block.smaller + at), left = limit - distance;
    const Vec n = load(block.normal, at), offset = load(block.offset, at), on_a = load(block.on_a, at);
    const Vec axis[3] = {load(block.axes, at), load(block.axes + 3, at), load(block.axes + 6, at)};
    // Two axes across the normal (Duff et al. 2017).
    const Number sign = hw::IfThenElse(n.z < zero, hw::Neg(one), one);
    const Number f = hw::Neg(one / (sign + n.z)), g = n.x * n.y * f;
    const Vec across_u{one + sign * (n.x * n.x) * f, sign * g, hw::Neg(sign * n.x)};
    const Vec across_v{g, sign + n.y * n.y * f, hw::Neg(n.y)};

    const Number up_a = n.z, up_b = dot(axis[2], n);
    const Number edge_on = Lanes::number(plate_edge_on);
    const Lanes::M faces = Lanes::both(hw::Abs(up_a) > edge_on, hw::Abs(up_b) > edge_on);
    const Lanes::M apart = hw::Eq(hw::Load(d, block.state + at), Lanes::number(SearchBlock::apart));
    const Lanes::M here = Lanes::both(faces, apart);
    if (!Lanes::any(here)) {
        hw::Store(Lanes::number(SearchBlock::no_manifold), d, block.count + at);
        return;
    }
    const Height upper{zero, hw::Neg(across_u.z / up_a), hw::Neg(across_v.z / up_a)};
    Height lower{zero, hw::Neg(dot(axis[2], across_u) / up_b), hw::Neg(dot(axis[2], across_v) / up_b)};
    const Number offset_u = dot(across_u, offset), offset_v = dot(across_v, offset);
    lower.level = dot(n, offset) - lower.at(offset_u, offset_v);

    Outline of_a, of_b;
    of_a.count = a.count;
    of_b.count = b.count;
    for (uint32_t i = 0; i < a.count; ++i) {
        const Number x = Lanes::number(a.ring_x[i]), y = Lanes::number(a.ring_y[i]);
        of_a.u[i] = x * across_u.x + y * across_u.y;
        of_a.v[i] = x * across_v.x + y * across_v.y;
    }
    const Number ux = ratio * dot(axis[0], across_u), uy = ratio * dot(axis[1], across_u);
    const Number vx = ratio * dot(axis[0], across_v), vy = ratio * dot(axis[1], across_v);
    for (uint32_t i = 0; i < b.count; ++i) {
        const Number x = Lanes::number(b.ring_x[i]), y = Lanes::number(b.ring_y[i]);
        of_b.u[i] = offset_u + (x * ux + y * uy);
        of_b.v[i] = offset_v + (x * vx + y * vy);
    }
    const Number slack_out = Lanes::number(1e-5f) * smaller;
    of_a.close(hw::IfThenElse(up_a < zero, hw::Neg(one), one), slack_out);
    of_b.close(hw::IfThenElse(up_b < zero, hw::Neg(one), one), slack_out);
    Places places;
    places.add_edges(of_a, of_b, upper, lower);
    places.add_edges(of_b, of_a, upper, lower);

    // The nearest points, unless a place is as deep.
    const Number slack = hw::Max(hw::Min(Lanes::number(0.02f) * left, Lanes::number(2e-3f) * smaller), zero);
    const Number most_gap = Lanes::number(1e29f);
    Number deepest = most_gap, sum_u = zero, sum_v = zero, inside = zero;
    const auto count_in = [&](Number u, Number v, Number gap) HWY_ATTR {
        const Lanes::M in = gap < most_gap;
        deepest = hw::Min(deepest, gap);
        sum_u = sum_u + hw::IfThenElseZero(in, u);
        sum_v = sum_v + hw::IfThenElseZero(in, v);
        inside = inside + hw::IfThenElseZero(in, one);
    };
    for (uint32_t i = 0; i < places.count; ++i) count_in(places.u[i], places.v[i], places.gap[i]);
    const Vec on_b = on_a - distance * n;
    const Number nearest_u = dot(across_u, on_b), nearest_v = dot(across_v, on_b);
    const Lanes::M as_deep = deepest <= distance + slack;
    const Number nearest = hw::IfThenElse(as_deep, Lanes::number(1e30f), distance);
    places.add(nearest_u, nearest_v, nearest);
    count_in(nearest_u, nearest_v, nearest);

    const Number some = hw::Max(inside, one), mid_u = sum_u / some, mid_v = sum_v / some;
    const auto squared = [](Number from_u, Number from_v) HWY_ATTR {
        return [from_u, from_v](Number u, Number v) HWY_ATTR {
            const Number du = u - from_u, dv = v - from_v;
            return du * du + dv * dv;
        };
    };
    const Number same = Lanes::number(plate_same_place) * smaller;
    Places::Best best[4];
    best[0] = places.best(hw::Neg(one), hw::Min(limit, deepest + slack), squared(mid_u, mid_v));
    best[1] = places.best(same * same, limit, squared(best[0].u, best[0].v));
    best[1].found = Lanes::both(best[1].found, best[0].found);
    const Number du = best[1].u - best[0].u, dv = best[1].v - best[0].v;
    const Number least = same * hw::Sqrt(du * du + dv * dv);
    for (uint32_t k = 2; k < 4; ++k) {
        const Number side = k == 2 ? one : hw::Neg(one);
        best[k] = places.best(least, limit, [&](Number u, Number v) HWY_ATTR {
            return side * (du * (v - best[0].v) - dv * (u - best[0].u));
        });
        best[k].found = Lanes::both(best[k].found, best[1].found);
    }
    // The third place can be missing while there is a fourth.
    best[2].u = hw::IfThenElse(best[2].found, best[2].u, best[3].u);
    best[2].v = hw::IfThenElse(best[2].found, best[2].v, best[3].v);
    best[2].gap = hw::IfThenElse(best[2].found, best[2].gap, best[3].gap);
    const Lanes::M third = Lanes::either(best[2].found, best[3].found);
    best[3].found = Lanes::both(best[2].found, best[3].found);
    best[2].found = third;
    Number count = zero;
    for (uint32_t k = 0; k < 4; ++k) {
        const Number u = best[k].u, v = best[k].v;
        store(u * across_u + v * across_v + lower.at(u, v) * n, block.place + 3 * k, at);
        hw::Store(best[k].gap, d, block.place_gap[k] + at);
        count = count + hw::IfThenElseZero(best[k].found, one);
    }
    hw::Store(hw::IfThenElse(here, count, Lanes::number(SearchBlock::no_manifold)), d, block.count + at);
}

constexpr size_t fields_of_box = sizeof(PlacedBox) / sizeof(float);
enum : size_t { at_middle = 0, at_q = 3, at_half = 7, at_shift = 10, at_turns = 13, at_margin = 14, at_alone = 15 };
static_assert(offsetof(PlacedBox, alone) == at_alone * sizeof(float));

struct Boxes {
    Vec middle, half, shift, axis[3]; // columns
    Number turns, margin, alone;

    // number(f): field f of each lane.
    template <class Field> explicit HWY_INLINE Boxes(const Field& number) {
        const auto vector = [&](size_t f) HWY_ATTR { return Vec{number(f), number(f + 1), number(f + 2)}; };
        middle = vector(at_middle), half = vector(at_half), shift = vector(at_shift);
        turns = number(at_turns), margin = number(at_margin), alone = number(at_alone);
        const Vec q = vector(at_q), q2 = Lanes::number(2.0f) * q;
        const Number w = number(at_q + 3), one = Lanes::number(1.0f);
        const Number xx = q2.x * q.x, yy = q2.y * q.y, zz = q2.z * q.z;
        const Number xy = q2.x * q.y, xz = q2.x * q.z, yz = q2.y * q.z;
        const Number wx = q2.x * w, wy = q2.y * w, wz = q2.z * w;
        axis[0] = {one - (yy + zz), xy + wz, xz - wy};
        axis[1] = {xy - wz, one - (xx + zz), yz + wx};
        axis[2] = {xz + wy, yz - wx, one - (xx + yy)};
    }
};

// Boxes are apart if they are along one of fifteen axes (Gottschalk et al. 1996). Cross products are at most 1 long, so these err to the
// near side.
HWY_INLINE hw::Mask<Tag> apart(const Boxes& a, const Boxes& b) {
    const Vec shifted = a.shift - b.shift, way = b.middle - a.middle;
    const auto both = hw::Min(a.alone, b.alone) > Lanes::number(0.0f);
    const Number stopped = hw::IfThenElseZero(both, hw::Max(a.alone, b.alone));
    const Number nearer = hw::Max(hw::Sqrt(dot(shifted, shifted)), stopped);
    const Number within = hw::Min(a.margin, b.margin) + nearer + (a.turns + b.turns);
    const Number half_a[3] = {a.half.x, a.half.y, a.half.z}, half_b[3] = {b.half.x, b.half.y, b.half.z};
    Number along_a[3], turn[3][3], size[3][3];
    for (size_t i = 0; i < 3; ++i) {
        along_a[i] = dot(a.axis[i], way);
        for (size_t k = 0; k < 3; ++k) turn[i][k] = dot(a.axis[i], b.axis[k]), size[i][k] = hw::Abs(turn[i][k]);
    }
    hw::Mask<Tag> out = Lanes::none();
    const auto test = [&](Number distance, Number reach_a, Number reach_b)
                          HWY_ATTR { out = hw::Or(out, hw::Abs(distance) > within + (reach_a + reach_b)); };
    for (size_t i = 0; i < 3; ++i) {
        const Number of_b = half_b[0] * size[i][0] + half_b[1] * size[i][1] + half_b[2] * size[i][2];
        test(along_a[i], half_a[i], of_b);
        const Number of_a = half_a[0] * size[0][i] + half_a[1] * size[1][i] + half_a[2] * size[2][i];
        test(dot(b.axis[i], way), of_a, half_b[i]);
    }
    if (hw::AllTrue(Tag(), out)) return out;
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, l = (i + 2) % 3;
        for (size_t k = 0; k < 3; ++k) {
            const size_t m = (k + 1) % 3, n = (k + 2) % 3;
            test(along_a[l] * turn[j][k] - along_a[j] * turn[l][k], half_a[j] * size[l][k] + half_a[l] * size[j][k],
                 half_b[m] * size[i][n] + half_b[n] * size[i][m]);
        }
    }
    return out;
}
} // namespace search

void search_pairs(const SearchHull& a, const SearchHull& b, uint32_t count, SearchBlock& block) {
    for (size_t at = 0; at < count; at += hwy::HWY_NAMESPACE::Lanes(search::Tag()))
        search::nearest_of_hulls(a, b, block, at);
    for (size_t at = 0; at < count; at += hwy::HWY_NAMESPACE::Lanes(search::Tag()))
        if (a.ring_x && b.ring_x)
            search::plate_manifold(a, b, block, at);
        else
            hwy::HWY_NAMESPACE::Store(search::Lanes::number(SearchBlock::no_manifold), search::Tag(), block.count + at);
}

uint32_t near_boxes(const PlacedBox* boxes, uint32_t one, uint32_t* others, uint32_t count) {
    using namespace search;
    const float* const of_one = boxes[one].middle;
    const Boxes a([&](size_t f) HWY_ATTR { return Lanes::number(of_one[f]); });
    alignas(64) float row[fields_of_box][search_lanes];
    uint32_t kept = 0;
    for (uint32_t first = 0; first < count; first += search_lanes) {
        const uint32_t lanes = HWY_MIN(search_lanes, count - first);
        for (uint32_t lane = 0; lane < search_lanes; ++lane) {
            const float* const from = boxes[others[first + (lane < lanes ? lane : 0)]].middle;
            for (size_t f = 0; f < fields_of_box; ++f) row[f][lane] = from[f];
        }
        for (size_t at = 0; at < lanes; at += hw::Lanes(Tag())) {
            const auto away = apart(a, Boxes([&](size_t f) HWY_ATTR { return hw::Load(Tag(), row[f] + at); }));
            uint8_t bits[8] = {};
            hw::StoreMaskBits(Tag(), away, bits);
            for (size_t lane = 0; lane < hw::Lanes(Tag()) && at + lane < lanes; ++lane)
                if ((bits[lane / 8] >> lane % 8 & 1u) == 0) others[kept++] = others[first + at + lane];
        }
    }
    return kept;
}
} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
