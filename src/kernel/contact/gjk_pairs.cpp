// Distances of convex hulls, many pairs side by side, compiled once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/contact/gjk_pairs.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "kernel/contact/gjk_pairs.h"

#include "hwy/highway.h"
#include "kernel/contact/gjk-inl.h"

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
    return {hw::Add(a.x, b.x), hw::Add(a.y, b.y), hw::Add(a.z, b.z)};
}
HWY_INLINE Vec operator-(const Vec& a, const Vec& b) {
    return {hw::Sub(a.x, b.x), hw::Sub(a.y, b.y), hw::Sub(a.z, b.z)};
}
HWY_INLINE Vec operator*(Number s, const Vec& a) {
    return {hw::Mul(s, a.x), hw::Mul(s, a.y), hw::Mul(s, a.z)};
}
HWY_INLINE Number dot(const Vec& a, const Vec& b) {
    return hw::Add(hw::Add(hw::Mul(a.x, b.x), hw::Mul(a.y, b.y)), hw::Mul(a.z, b.z));
}
HWY_INLINE Vec cross(const Vec& a, const Vec& b) {
    return {hw::Sub(hw::Mul(a.y, b.z), hw::Mul(a.z, b.y)), hw::Sub(hw::Mul(a.z, b.x), hw::Mul(a.x, b.z)),
            hw::Sub(hw::Mul(a.x, b.y), hw::Mul(a.y, b.x))};
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
        const Lanes::M better = hw::Gt(along, most);
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
    store(hw::Div(Lanes::number(1.0f), found.distance) * found.v, block.normal, at);
    store(found.on_a, block.on_a, at);
    hw::Store(found.distance, d, block.distance + at);
    const Number apart = Lanes::number(SearchBlock::apart), beyond = Lanes::number(SearchBlock::beyond);
    const Number overlap = Lanes::choose(found.overlap, Lanes::number(SearchBlock::overlap), apart);
    hw::Store(Lanes::choose(found.beyond, beyond, overlap), d, block.state + at);
}
} // namespace search

void search_pairs(const SearchHull& a, const SearchHull& b, uint32_t count, SearchBlock& block) {
    for (size_t at = 0; at < count; at += hwy::HWY_NAMESPACE::Lanes(search::Tag()))
        search::nearest_of_hulls(a, b, block, at);
}
} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
