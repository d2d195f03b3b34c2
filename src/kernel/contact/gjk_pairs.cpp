// Distances of convex hulls, many pairs side by side, compiled once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/contact/gjk_pairs.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "kernel/contact/gjk_pairs.h"

#include "hwy/highway.h"
#include "kernel/contact/gjk-inl.h"
#include "kernel/contact/plate_manifold-inl.h"
#include "kernel/contact/search_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {
namespace search {

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
    for (size_t at = 0; at < count; at += hwy::HWY_NAMESPACE::Lanes(search::Tag()))
        if (a.ring_x && b.ring_x)
            search::plate_manifold(a, b, block, at);
        else
            hwy::HWY_NAMESPACE::Store(search::Lanes::number(SearchBlock::no_manifold), search::Tag(), block.count + at);
}
} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
