// Distances of convex hulls, compiled once for each instruction set. As contact/closest_points.cpp, of many pairs side by side: what a
// lane finds does not depend on the others.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/pair_search.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "kernel/pair_search.h"

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {
namespace search {

namespace hw = hwy::HWY_NAMESPACE;
using Tag = hw::CappedTag<float, search_lanes>;
using V = hw::Vec<Tag>;
using M = hw::Mask<Tag>;

constexpr uint32_t most_rounds = 24;

struct Vec {
    V x, y, z;
};
HWY_INLINE V all(float a) {
    return hw::Set(Tag(), a);
}
HWY_INLINE V dot(const Vec& a, const Vec& b) {
    return hw::Add(hw::Add(hw::Mul(a.x, b.x), hw::Mul(a.y, b.y)), hw::Mul(a.z, b.z));
}
HWY_INLINE Vec sub(const Vec& a, const Vec& b) {
    return {hw::Sub(a.x, b.x), hw::Sub(a.y, b.y), hw::Sub(a.z, b.z)};
}
HWY_INLINE Vec add(const Vec& a, const Vec& b) {
    return {hw::Add(a.x, b.x), hw::Add(a.y, b.y), hw::Add(a.z, b.z)};
}
HWY_INLINE Vec times(V s, const Vec& a) {
    return {hw::Mul(s, a.x), hw::Mul(s, a.y), hw::Mul(s, a.z)};
}
HWY_INLINE Vec cross(const Vec& a, const Vec& b) {
    return {hw::Sub(hw::Mul(a.y, b.z), hw::Mul(a.z, b.y)), hw::Sub(hw::Mul(a.z, b.x), hw::Mul(a.x, b.z)),
            hw::Sub(hw::Mul(a.x, b.y), hw::Mul(a.y, b.x))};
}
HWY_INLINE Vec choose(M m, const Vec& yes, const Vec& no) {
    return {hw::IfThenElse(m, yes.x, no.x), hw::IfThenElse(m, yes.y, no.y), hw::IfThenElse(m, yes.z, no.z)};
}
HWY_INLINE Vec load(const SearchBlock::Row* rows, size_t at) {
    return {hw::Load(Tag(), rows[0] + at), hw::Load(Tag(), rows[1] + at), hw::Load(Tag(), rows[2] + at)};
}
HWY_INLINE void store(const Vec& a, SearchBlock::Row* rows, size_t at) {
    hw::Store(a.x, Tag(), rows[0] + at);
    hw::Store(a.y, Tag(), rows[1] + at);
    hw::Store(a.z, Tag(), rows[2] + at);
}

// The corner farthest along a direction, the first of equal ones.
HWY_INLINE Vec farthest(const SearchHull& hull, const Vec& d) {
    Vec best{all(hull.x[0]), all(hull.y[0]), all(hull.z[0])};
    V most = dot(best, d);
    for (uint32_t i = 1; i < hull.count; ++i) {
        const Vec p{all(hull.x[i]), all(hull.y[i]), all(hull.z[i])};
        const V along = dot(p, d);
        const M better = hw::Gt(along, most);
        most = hw::IfThenElse(better, along, most);
        best = choose(better, p, best);
    }
    return best;
}

// Of the difference of a and b, and where on a.
struct Corner {
    Vec w, on_a;
};
HWY_INLINE Corner choose(M m, const Corner& yes, const Corner& no) {
    return {choose(m, yes.w, no.w), choose(m, yes.on_a, no.on_a)};
}

struct Placed {
    Vec axis[3];
    Vec offset;
    V ratio;
};
HWY_INLINE Corner support(const SearchHull& a, const SearchHull& b, const Placed& pair, const Vec& d) {
    const Vec on_a = farthest(a, {hw::Neg(d.x), hw::Neg(d.y), hw::Neg(d.z)});
    const Vec p = farthest(b, {dot(pair.axis[0], d), dot(pair.axis[1], d), dot(pair.axis[2], d)});
    const Vec turned = add(add(times(p.x, pair.axis[0]), times(p.y, pair.axis[1])), times(p.z, pair.axis[2]));
    return {sub(on_a, add(pair.offset, times(pair.ratio, turned))), on_a};
}

// The point of a triangle nearest to the origin, where the newest corner, c, holds it, and which others do.
struct Nearest {
    Vec point, on_a;
    V square;
    M by_a, by_b;
};
HWY_INLINE Nearest nearest_of(const Corner& a, const Corner& b, const Corner& c) {
    const V zero = hw::Zero(Tag()), one = all(1.0f);
    const Vec ca = sub(a.w, c.w), cb = sub(b.w, c.w), n = cross(ca, cb);
    const V along_a = hw::Neg(dot(ca, c.w)), along_b = hw::Neg(dot(cb, c.w));
    // Parts of the triangle that the origin spans with the sides at c.
    const V of_a = hw::Neg(dot(n, cross(c.w, cb))), of_b = hw::Neg(dot(n, cross(ca, c.w)));
    const M in_a = hw::Gt(of_a, zero), in_b = hw::Gt(of_b, zero), inside = hw::And(in_a, in_b);
    const M edge_a = hw::AndNot(in_b, hw::Gt(along_a, zero));
    const M edge_b = hw::AndNot(hw::Or(in_a, edge_a), hw::Gt(along_b, zero));
    const V along = hw::IfThenElse(edge_a, along_a, along_b);
    const V square = hw::IfThenElse(edge_a, dot(ca, ca), dot(cb, cb));
    const V part = hw::IfThenElse(hw::Lt(along, square), hw::Div(along, square), one);
    const V inverse = hw::Div(one, dot(n, n));
    Nearest out;
    out.by_a = hw::Or(inside, edge_a);
    out.by_b = hw::Or(inside, edge_b);
    const V for_a = hw::IfThenElse(inside, hw::Mul(of_a, inverse), hw::IfThenElse(edge_a, part, zero));
    const V for_b = hw::IfThenElse(inside, hw::Mul(of_b, inverse), hw::IfThenElse(edge_b, part, zero));
    const Vec on_edge = add(c.w, add(times(for_a, ca), times(for_b, cb)));
    out.point = choose(inside, times(hw::Mul(dot(n, c.w), inverse), n), on_edge);
    out.on_a = add(c.on_a, add(times(for_a, sub(a.on_a, c.on_a)), times(for_b, sub(b.on_a, c.on_a))));
    out.square = dot(out.point, out.point);
    return out;
}

// Gilbert, Johnson and Keerthi 1988, bounded in work. Simplices have their newest corner last; missing ones repeat others.
HWY_INLINE void nearest_of_hulls(const SearchHull& a, const SearchHull& b, SearchBlock& block, size_t at) {
    const Tag d;
    const V zero = hw::Zero(d);
    const Placed pair{{load(block.axes, at), load(block.axes + 3, at), load(block.axes + 6, at)},
                      load(block.offset, at),
                      hw::Load(d, block.ratio + at)};
    const V enough = hw::Load(d, block.enough + at), near = hw::Load(d, block.near + at);
    const V tolerance = hw::Load(d, block.tolerance + at);
    const Vec start = load(block.start, at);
    Corner first = support(a, b, pair, start), second = first, third = first;
    Vec v = first.w, on_a = first.on_a;
    V square = dot(v, v), lower = dot(start, v);
    M beyond = hw::Gt(lower, enough), overlap = hw::Lt(zero, zero), three = overlap;
    M live = hw::AndNot(beyond, hw::Gt(square, hw::Mul(near, near)));
    for (uint32_t round = 0; round < most_rounds && !hw::AllFalse(d, live); ++round) {
        const V distance = hw::Sqrt(square);
        const Corner newest = support(a, b, pair, v);
        const V along = hw::Div(dot(v, newest.w), distance);
        lower = hw::IfThenElse(hw::And(live, hw::Gt(along, lower)), along, lower);
        const M far = hw::And(live, hw::Gt(lower, enough));
        beyond = hw::Or(beyond, far);
        live = hw::AndNot(far, hw::AndNot(hw::Le(hw::Sub(distance, along), tolerance), live));
        if (hw::AllFalse(d, live)) break;

        Nearest best = nearest_of(first, second, newest);
        Corner one = first, two = second;
        const M four = hw::And(live, three);
        if (!hw::AllFalse(d, four)) {
            const Vec da = sub(first.w, newest.w), db = sub(second.w, newest.w), dc = sub(third.w, newest.w);
            const Vec ab = cross(da, db), bc = cross(db, dc), ca = cross(dc, da);
            const V volume = dot(ab, dc);
            // Of a tetrahedron the sides on whose outer side the origin is.
            const auto outside = [&](const Vec& n) HWY_ATTR {
                return hw::Not(hw::Gt(hw::Neg(hw::Mul(dot(n, newest.w), volume)), zero));
            };
            const M by_ab = outside(ab), by_bc = outside(bc), by_ca = outside(ca);
            M found = by_ab;
            const auto offer = [&](const Nearest& here, M side, const Corner& e, const Corner& f) HWY_ATTR {
                const M better = hw::And(hw::And(four, side), hw::Or(hw::Not(found), hw::Lt(here.square, best.square)));
                best.point = choose(better, here.point, best.point);
                best.on_a = choose(better, here.on_a, best.on_a);
                best.square = hw::IfThenElse(better, here.square, best.square);
                best.by_a = hw::Or(hw::And(better, here.by_a), hw::AndNot(better, best.by_a));
                best.by_b = hw::Or(hw::And(better, here.by_b), hw::AndNot(better, best.by_b));
                one = choose(better, e, one);
                two = choose(better, f, two);
                found = hw::Or(found, side);
            };
            offer(nearest_of(second, third, newest), by_bc, second, third);
            offer(nearest_of(third, first, newest), by_ca, third, first);
            const M inside = hw::AndNot(found, four);
            // Flat simplices look as if the origin were inside; a plane between the two says that it is not.
            overlap = hw::Or(overlap, hw::AndNot(hw::Gt(lower, near), inside));
            live = hw::AndNot(inside, live);
        }
        live = hw::And(live, hw::Lt(best.square, square));
        v = choose(live, best.point, v);
        on_a = choose(live, best.on_a, on_a);
        square = hw::IfThenElse(live, best.square, square);
        live = hw::And(live, hw::Gt(square, hw::Mul(near, near)));
        three = hw::And(best.by_a, best.by_b);
        first = choose(best.by_a, one, choose(best.by_b, two, newest));
        second = choose(three, two, newest);
        third = newest;
    }
    const V distance = hw::Sqrt(square);
    overlap = hw::AndNot(beyond, hw::Or(overlap, hw::Not(hw::Gt(distance, near))));
    store(times(hw::Div(all(1.0f), distance), v), block.normal, at);
    store(on_a, block.on_a, at);
    hw::Store(distance, d, block.distance + at);
    hw::Store(
        hw::IfThenElse(beyond, all(SearchBlock::beyond), hw::IfThenElse(overlap, all(SearchBlock::overlap), zero)), d,
        block.state + at);
}

} // namespace search

void search_pairs(const SearchHull& a, const SearchHull& b, uint32_t count, SearchBlock& block) {
    for (size_t at = 0; at < count; at += hwy::HWY_NAMESPACE::Lanes(search::Tag()))
        search::nearest_of_hulls(a, b, block, at);
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "kernel/built_targets.h"

namespace lr {

PairSearch pair_search(int32_t simd) {
    struct Target {
        int32_t simd;
        PairSearch search;
    };
#define LR_TARGET(simd, target) {simd, &N_##target::search_pairs},
    static constexpr Target targets[] = {LR_FOR_BUILT_TARGETS(LR_TARGET)};
#undef LR_TARGET
    for (const Target& t : targets)
        if (t.simd == simd) return t.search;
    return targets[sizeof targets / sizeof targets[0] - 1].search;
}

} // namespace lr
#endif
