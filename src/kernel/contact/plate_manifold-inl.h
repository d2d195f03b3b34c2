// Contacts of two flat cores, apart and not edge-on to each other: where their outlines, seen along the normal, overlap, at most four places. A
// pair per lane. The general way, for one pair of any cores: collision/body_narrow_phase.cpp, whose choice of places this follows.
#if defined(LR_KERNEL_CONTACT_PLATE_MANIFOLD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_CONTACT_PLATE_MANIFOLD_INL_H_
#undef LR_KERNEL_CONTACT_PLATE_MANIFOLD_INL_H_
#else
#define LR_KERNEL_CONTACT_PLATE_MANIFOLD_INL_H_
#endif

#include "kernel/contact/search_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {
namespace search {

// The corners of a flat core seen along the normal, and the half planes that its edges bound.
struct Outline {
    uint32_t count;
    Number u[most_outline], v[most_outline];
    Number out_u[most_outline], out_v[most_outline], most[most_outline]; // inside: out . p <= most

    // sense: 1 if the corners are counter-clockwise, else -1. slack: how far beyond an edge is still inside.
    HWY_INLINE void close(Number sense, Number slack) {
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t next = i + 1 < count ? i + 1 : 0;
            const Number du = hw::Mul(sense, hw::Sub(u[next], u[i])), dv = hw::Mul(sense, hw::Sub(v[next], v[i]));
            out_u[i] = dv;
            out_v[i] = hw::Neg(du);
            const Number at = hw::Sub(hw::Mul(u[i], dv), hw::Mul(v[i], du));
            most[i] = hw::Add(at, hw::Mul(slack, hw::Add(hw::Abs(du), hw::Abs(dv))));
        }
    }
    HWY_INLINE Number beyond(uint32_t edge, Number at_u, Number at_v) const {
        return hw::Sub(hw::Add(hw::Mul(out_u[edge], at_u), hw::Mul(out_v[edge], at_v)), most[edge]);
    }
};

// A plane above the one normal to the contact.
struct Height {
    Number level, slope_u, slope_v;
    HWY_INLINE Number at(Number u, Number v) const {
        return hw::Add(level, hw::Add(hw::Mul(slope_u, u), hw::Mul(slope_v, v)));
    }
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
                const Number to = within.beyond(j, of.u[next], of.v[next]), sinks = hw::Sub(from[j], to);
                const Number crossing = hw::Div(from[j], sinks);
                const Lanes::M out_first = hw::Gt(from[j], zero), out_last = hw::Gt(to, zero);
                begin = hw::IfThenElse(out_first, hw::Max(begin, crossing), begin);
                end = hw::IfThenElse(out_last, hw::Min(end, crossing), end);
                outside = Lanes::either(outside, Lanes::both(out_first, out_last));
                from[j] = to;
            }
            outside = Lanes::either(outside, Lanes::inverse(begin <= end));
            const Number du = hw::Sub(of.u[next], of.u[i]), dv = hw::Sub(of.v[next], of.v[i]);
            for (const Number part : {begin, end}) {
                const Number at_u = hw::Add(of.u[i], hw::Mul(part, du)), at_v = hw::Add(of.v[i], hw::Mul(part, dv));
                const Number here = hw::Sub(upper.at(at_u, at_v), lower.at(at_u, at_v));
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
            const Lanes::M better = Lanes::both(hw::Lt(gap[i], limit), hw::Gt(value, least));
            least = hw::IfThenElse(better, hw::Mul(Lanes::number(1.01f), value), least);
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
    const Number smaller = hw::Load(d, block.smaller + at), left = hw::Sub(limit, distance);
    const Vec n = load(block.normal, at), offset = load(block.offset, at), on_a = load(block.on_a, at);
    const Vec axis[3] = {load(block.axes, at), load(block.axes + 3, at), load(block.axes + 6, at)};
    // Two axes across the normal (Duff et al. 2017).
    const Number sign = hw::IfThenElse(hw::Lt(n.z, zero), hw::Neg(one), one);
    const Number f = hw::Neg(hw::Div(one, hw::Add(sign, n.z))), g = hw::Mul(hw::Mul(n.x, n.y), f);
    const Vec across_u{hw::Add(one, hw::Mul(hw::Mul(sign, hw::Mul(n.x, n.x)), f)), hw::Mul(sign, g),
                       hw::Neg(hw::Mul(sign, n.x))};
    const Vec across_v{g, hw::Add(sign, hw::Mul(hw::Mul(n.y, n.y), f)), hw::Neg(n.y)};

    const Number up_a = n.z, up_b = dot(axis[2], n);
    const Number edge_on = Lanes::number(plate_edge_on);
    const Lanes::M faces = Lanes::both(hw::Gt(hw::Abs(up_a), edge_on), hw::Gt(hw::Abs(up_b), edge_on));
    const Lanes::M apart = hw::Eq(hw::Load(d, block.state + at), Lanes::number(SearchBlock::apart));
    const Lanes::M here = Lanes::both(faces, apart);
    if (!Lanes::any(here)) {
        hw::Store(Lanes::number(SearchBlock::no_manifold), d, block.count + at);
        return;
    }
    const Height upper{zero, hw::Neg(hw::Div(across_u.z, up_a)), hw::Neg(hw::Div(across_v.z, up_a))};
    Height lower{zero, hw::Neg(hw::Div(dot(axis[2], across_u), up_b)), hw::Neg(hw::Div(dot(axis[2], across_v), up_b))};
    const Number offset_u = dot(across_u, offset), offset_v = dot(across_v, offset);
    lower.level = hw::Sub(dot(n, offset), lower.at(offset_u, offset_v));

    Outline of_a, of_b;
    of_a.count = a.count;
    of_b.count = b.count;
    for (uint32_t i = 0; i < a.count; ++i) {
        const Number x = Lanes::number(a.ring_x[i]), y = Lanes::number(a.ring_y[i]);
        of_a.u[i] = hw::Add(hw::Mul(x, across_u.x), hw::Mul(y, across_u.y));
        of_a.v[i] = hw::Add(hw::Mul(x, across_v.x), hw::Mul(y, across_v.y));
    }
    const Number ux = hw::Mul(ratio, dot(axis[0], across_u)), uy = hw::Mul(ratio, dot(axis[1], across_u));
    const Number vx = hw::Mul(ratio, dot(axis[0], across_v)), vy = hw::Mul(ratio, dot(axis[1], across_v));
    for (uint32_t i = 0; i < b.count; ++i) {
        const Number x = Lanes::number(b.ring_x[i]), y = Lanes::number(b.ring_y[i]);
        of_b.u[i] = hw::Add(offset_u, hw::Add(hw::Mul(x, ux), hw::Mul(y, uy)));
        of_b.v[i] = hw::Add(offset_v, hw::Add(hw::Mul(x, vx), hw::Mul(y, vy)));
    }
    const Number slack_out = hw::Mul(Lanes::number(1e-5f), smaller);
    of_a.close(hw::IfThenElse(hw::Lt(up_a, zero), hw::Neg(one), one), slack_out);
    of_b.close(hw::IfThenElse(hw::Lt(up_b, zero), hw::Neg(one), one), slack_out);
    Places places;
    places.add_edges(of_a, of_b, upper, lower);
    places.add_edges(of_b, of_a, upper, lower);

    // The nearest points, unless a place is as deep.
    const Number slack =
        hw::Max(hw::Min(hw::Mul(Lanes::number(0.02f), left), hw::Mul(Lanes::number(2e-3f), smaller)), zero);
    const Number most_gap = Lanes::number(1e29f);
    Number deepest = most_gap, sum_u = zero, sum_v = zero, inside = zero;
    const auto count_in = [&](Number u, Number v, Number gap) HWY_ATTR {
        const Lanes::M in = hw::Lt(gap, most_gap);
        deepest = hw::Min(deepest, gap);
        sum_u = hw::Add(sum_u, hw::IfThenElseZero(in, u));
        sum_v = hw::Add(sum_v, hw::IfThenElseZero(in, v));
        inside = hw::Add(inside, hw::IfThenElseZero(in, one));
    };
    for (uint32_t i = 0; i < places.count; ++i) count_in(places.u[i], places.v[i], places.gap[i]);
    const Vec on_b = on_a - distance * n;
    const Number nearest_u = dot(across_u, on_b), nearest_v = dot(across_v, on_b);
    const Lanes::M as_deep = hw::Le(deepest, hw::Add(distance, slack));
    const Number nearest = hw::IfThenElse(as_deep, Lanes::number(1e30f), distance);
    places.add(nearest_u, nearest_v, nearest);
    count_in(nearest_u, nearest_v, nearest);

    const Number some = hw::Max(inside, one), mid_u = hw::Div(sum_u, some), mid_v = hw::Div(sum_v, some);
    const auto squared = [](Number from_u, Number from_v) HWY_ATTR {
        return [from_u, from_v](Number u, Number v) HWY_ATTR {
            const Number du = hw::Sub(u, from_u), dv = hw::Sub(v, from_v);
            return hw::Add(hw::Mul(du, du), hw::Mul(dv, dv));
        };
    };
    const Number same = hw::Mul(Lanes::number(plate_same_place), smaller);
    Places::Best best[4];
    best[0] = places.best(hw::Neg(one), hw::Min(limit, hw::Add(deepest, slack)), squared(mid_u, mid_v));
    best[1] = places.best(hw::Mul(same, same), limit, squared(best[0].u, best[0].v));
    best[1].found = Lanes::both(best[1].found, best[0].found);
    const Number du = hw::Sub(best[1].u, best[0].u), dv = hw::Sub(best[1].v, best[0].v);
    const Number least = hw::Mul(same, hw::Sqrt(hw::Add(hw::Mul(du, du), hw::Mul(dv, dv))));
    for (uint32_t k = 2; k < 4; ++k) {
        const Number side = k == 2 ? one : hw::Neg(one);
        best[k] = places.best(least, limit, [&](Number u, Number v) HWY_ATTR {
            return hw::Mul(side, hw::Sub(hw::Mul(du, hw::Sub(v, best[0].v)), hw::Mul(dv, hw::Sub(u, best[0].u))));
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
        count = hw::Add(count, hw::IfThenElseZero(best[k].found, one));
    }
    hw::Store(hw::IfThenElse(here, count, Lanes::number(SearchBlock::no_manifold)), d, block.count + at);
}
} // namespace search
} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
