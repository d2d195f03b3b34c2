// Nearest points of two cores by GJK (Gilbert, Johnson and Keerthi 1988), with bounded rounds. L: the number type, of one pair or many.
#if defined(LR_KERNEL_CONTACT_GJK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_CONTACT_GJK_INL_H_
#undef LR_KERNEL_CONTACT_GJK_INL_H_
#else
#define LR_KERNEL_CONTACT_GJK_INL_H_
#endif

#include "hwy/highway.h"

#include <cmath>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// Number type of a single pair. relative: tolerances are shares of the distance and of the cores' size.
template <class Number, class Vector3, bool kRelative, uint32_t kRounds> struct OnePair {
    using V = Number;
    using Vec = Vector3;
    using M = bool;
    static constexpr bool relative = kRelative;
    static constexpr uint32_t most_rounds = kRounds;
    static V number(float a) { return static_cast<V>(a); }
    static V root(V a) { return std::sqrt(a); }
    static M none() { return false; }
    static bool any(M a) { return a; }
    static M both(M a, M b) { return a && b; }
    static M either(M a, M b) { return a || b; }
    static M without(M a, M b) { return a && !b; }
    static M inverse(M a) { return !a; }
    static V choose(M m, V yes, V no) { return m ? yes : no; }
    static Vec choose(M m, const Vec& yes, const Vec& no) { return m ? yes : no; }
};

// A vertex of the Minkowski difference, and the point of the first core in it.
template <class L> struct Corner { typename L::Vec w, on_a; };
template <class L> HWY_INLINE Corner<L> choose(typename L::M m, const Corner<L>& yes, const Corner<L>& no) {
    return {L::choose(m, yes.w, no.w), L::choose(m, yes.on_a, no.on_a)};
}

// The triangle's point nearest to the origin. The newest vertex c always supports it, since without c it was farther; the masks tell which others do.
template <class L> struct Nearby {
    typename L::Vec point, on_a;
    typename L::V square;
    typename L::M by_a, by_b;
};
template <class L> HWY_INLINE Nearby<L> nearest_of(const Corner<L>& a, const Corner<L>& b, const Corner<L>& c) {
    using V = typename L::V;
    using Vec = typename L::Vec;
    using M = typename L::M;
    const V zero = L::number(0.0f), one = L::number(1.0f);
    const Vec ca = a.w - c.w, cb = b.w - c.w, n = cross(ca, cb);
    const V along_a = zero - dot(ca, c.w), along_b = zero - dot(cb, c.w);
    // Areas that the origin spans with the sides at c.
    const V of_a = zero - dot(n, cross(c.w, cb)), of_b = zero - dot(n, cross(ca, c.w));
    const M in_a = of_a > zero, in_b = of_b > zero, inside = L::both(in_a, in_b);
    const M edge_a = L::without(along_a > zero, in_b);
    const M edge_b = L::without(along_b > zero, L::either(in_a, edge_a));
    const V along = L::choose(edge_a, along_a, along_b), square = L::choose(edge_a, dot(ca, ca), dot(cb, cb));
    const V part = L::choose(along < square, along / square, one), inverse = one / dot(n, n);
    const V for_a = L::choose(inside, of_a * inverse, L::choose(edge_a, part, zero));
    const V for_b = L::choose(inside, of_b * inverse, L::choose(edge_b, part, zero));
    Nearby<L> out;
    out.by_a = L::either(inside, edge_a);
    out.by_b = L::either(inside, edge_b);
    out.point = L::choose(inside, (dot(n, c.w) * inverse) * n, c.w + (for_a * ca + for_b * cb));
    out.on_a = c.on_a + (for_a * (a.on_a - c.on_a) + for_b * (b.on_a - c.on_a));
    out.square = dot(out.point, out.point);
    return out;
}

template <class L> struct Closest {
    typename L::M beyond, overlap; // neither: apart. beyond: over `enough`, only `lower` and `normal` are valid
    typename L::V distance, lower; // lower: a lower bound, the separation along `normal`
    typename L::Vec normal;        // unit, towards the first
    typename L::Vec v, on_a;       // v: from the second's nearest point to the first's, which is on_a
};

// support(direction): the vertex farthest against it. start: first guess of the normal, unit. Cores farther apart than `enough` are not refined,
// nearer than `near` they overlap. The newest vertex is last; missing vertices repeat others.
template <class L, class Support>
HWY_INLINE Closest<L> closest(const Support& support, const typename L::Vec& start, typename L::V enough,
                              typename L::V near, typename L::V tolerance) {
    using V = typename L::V;
    using Vec = typename L::Vec;
    using M = typename L::M;
    const V zero = L::number(0.0f), one = L::number(1.0f);
    Corner<L> first = support(start), second = first, third = first;
    Vec v = first.w, on_a = first.on_a, normal = start;
    V square = dot(v, v), lower = dot(start, v), least = near * near;
    if constexpr (L::relative) least = least * square;
    M beyond = lower > enough, overlap = L::none(), three = overlap;
    M live = L::without(square > least, beyond);
    for (uint32_t round = 0; round < L::most_rounds && L::any(live); ++round) {
        const V distance = L::root(square), inverse = one / distance;
        const Corner<L> newest = support(v);
        const V along = dot(v, newest.w) / distance;
        const M higher = L::both(live, along > lower);
        lower = L::choose(higher, along, lower);
        normal = L::choose(higher, inverse * v, normal);
        const M far = L::both(live, lower > enough);
        beyond = L::either(beyond, far);
        const V enough_near = L::relative ? tolerance * distance : tolerance;
        live = L::without(L::without(live, distance - along <= enough_near), far);
        if (!L::any(live)) break;
        if constexpr (L::relative) {
            const V size = near * near * dot(newest.w, newest.w);
            least = L::choose(size > least, size, least);
        }

        Nearby<L> best = nearest_of<L>(first, second, newest);
        Corner<L> a = first, b = second;
        const M four = L::both(live, three);
        if (L::any(four)) {
            const Vec da = first.w - newest.w, db = second.w - newest.w, dc = third.w - newest.w;
            const Vec ab = cross(da, db), bc = cross(db, dc), ca = cross(dc, da);
            const V volume = dot(ab, dc);
            // Faces of the tetrahedron with the origin on their outer side.
            const V out_ab = dot(ab, newest.w) * volume, out_bc = dot(bc, newest.w) * volume;
            const V out_ca = dot(ca, newest.w) * volume;
            M found = L::inverse(out_ab < zero);
            const Corner<L>* const sides[2][2] = {{&second, &third}, {&third, &first}};
            for (uint32_t k = 0; k < 2; ++k) {
                const M side = L::both(four, L::inverse((k == 0 ? out_bc : out_ca) < zero));
                if (!L::any(side)) continue;
                const Corner<L>&e = *sides[k][0], &f = *sides[k][1];
                const Nearby<L> here = nearest_of<L>(e, f, newest);
                const M better = L::both(side, L::either(L::inverse(found), here.square < best.square));
                best.point = L::choose(better, here.point, best.point);
                best.on_a = L::choose(better, here.on_a, best.on_a);
                best.square = L::choose(better, here.square, best.square);
                best.by_a = L::either(L::both(better, here.by_a), L::without(best.by_a, better));
                best.by_b = L::either(L::both(better, here.by_b), L::without(best.by_b, better));
                a = choose<L>(better, e, a);
                b = choose<L>(better, f, b);
                found = L::either(found, side);
            }
            const M inside = L::without(four, found);
            // By rounding a flat simplex seems to contain the origin; a separating plane disproves that.
            overlap = L::either(overlap, L::without(inside, lower > (L::relative ? zero : near)));
            live = L::without(live, inside);
        }
        live = L::both(live, best.square < square);
        v = L::choose(live, best.point, v);
        on_a = L::choose(live, best.on_a, on_a);
        square = L::choose(live, best.square, square);
        live = L::both(live, square > least);
        three = L::both(best.by_a, best.by_b);
        first = choose<L>(best.by_a, a, choose<L>(best.by_b, b, newest));
        second = choose<L>(three, b, newest);
        third = newest;
    }
    overlap = L::without(L::either(overlap, L::inverse(square > least)), beyond);
    return {beyond, overlap, L::root(square), lower, normal, v, on_a};
}
} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
