#include "collision/pair_contacts.h"

#include "base/pose.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

// Times the reach: impulses at points farther out would spin the body without bounds.
constexpr float off_body = 4.0f;

// The two ends of a substep, as the solver sees them: a rounding does not turn with its body (roll_of in body_contact_solver-inl.h).
struct Moved {
    const PairBody& body;
    Vector roll; // m, body frame: of the surface's point that is farthest against the normal, beside the body's
    Moved(const PairBody& of, Vector normal)
        : body(of), roll(of.scale * of.shape->shape.radius *
                         (rotate(inverse(of.from.rotation), normal) - rotate(inverse(of.to.rotation), normal))) {}

    Vector operator()(Vector arm) const {
        const Vector turned = arm.x * body.turned[0] + arm.y * body.turned[1] + arm.z * body.turned[2];
        return body.shift + (turned + rotate(body.to.rotation, roll));
    }
};

// The body's point farthest along a direction at the end of the substep, body frame.
Vector farthest(const PairBody& body, Vector direction) {
    const BodyShape& s = body.shape->shape;
    const Vector d = rotate(inverse(body.to.rotation), direction);
    return body.scale * (s.point(farthest_point(s.x, s.y, s.z, s.count, d)) + s.radius * d);
}
// Solids that fall together meet if the ground stops the lower one. Sheets do not count: in gales their planes would hold them in the air.
bool solids(const PairBody& a, const PairBody& b) {
    return !a.shape->flat && !b.shape->flat;
}

// Whether a body that goes on alone meets the other one.
bool meets(Vector way, const PairContact& c, float margin, float beside) {
    const float along = dot(c.normal, way);
    return c.gap + along < margin && length(way - along * c.normal) < beside;
}
} // namespace

float near_enough(const PairBody& a, const PairBody& b, float margin) {
    // Bound of the approach of any two of their points.
    float way = length(a.shift - b.shift);
    if (solids(a, b)) way = std::max({way, length(a.shift), length(b.shift)});
    return margin + way + a.turns + b.turns;
}

PlacedBox placed_box(const PairBody& body, float margin) {
    const PairHull& hull = *body.shape;
    const Vector middle = body.from.position + body.scale * rotate(body.from.rotation, hull.origin);
    const Vector half = body.scale * (hull.core_half + hull.shape.radius * Vector{1.0f, 1.0f, 1.0f});
    const Rotation q = body.from.rotation * hull.frame;
    // Rounding of middles and of turned boxes.
    const float far = std::max({std::abs(middle.x), std::abs(middle.y), std::abs(middle.z)});
    const float slack = 1e-6f * far + 1e-5f * body.reach();
    return {{middle.x, middle.y, middle.z},
            {q.x, q.y, q.z, q.w},
            {half.x, half.y, half.z},
            {body.shift.x, body.shift.y, body.shift.z},
            body.turns,
            margin + slack,
            hull.flat ? 0.0f : length(body.shift)};
}

uint32_t keep_way_contacts(const PairBody& a, const PairBody& b, float margin, const Manifold& found,
                           WayContact (&out)[most_pair_contacts]) {
    if (found.count == 0) return 0;
    uint32_t kept = 0;
    float least = margin, gap = found.contact[0].gap;
    const float beside = solids(a, b) ? 0.25f * std::min(a.reach(), b.reach()) : 0.0f;
    const Vector n = found.contact[0].normal;
    const Moved moved_a(a, n), moved_b(b, -n);
    for (uint32_t k = 0; k < found.count; ++k) {
        const PairContact& c = found.contact[k];
        const Vector of_a = moved_a(c.arm_a), of_b = moved_b(c.arm_b);
        const float end = c.gap + dot(c.normal, of_a - of_b);
        gap = std::min(gap, c.gap);
        least = std::min(least, end);
        if (end < margin || meets(of_a, c, margin, beside) || meets(-of_b, c, margin, beside))
            out[kept++] = {c, end, k, c.arm_a + moved_a.roll};
    }
    if (a.turns + b.turns == 0.0f) return kept;
    // The plane that separates them at the beginning must do so at the end too, since fast rotation brings other points near.
    const float slop = 1e-3f * std::min(a.reach(), b.reach());
    if (!(gap > -slop)) return kept;
    const Vector on_a = to_outer(a.to, farthest(a, -n)), on_b = to_outer(b.to, farthest(b, n));
    const float apart = dot(n, on_a - on_b);
    if (!(apart < least - slop)) return kept;
    // Both points on one line, through the faster body's: impulses at two points side by side would rotate both bodies.
    const bool first = a.way() >= b.way();
    const Vector arm_a = to_inner(a.to, first ? on_a : on_b + apart * n);
    const Vector arm_b = to_inner(b.to, first ? on_a - apart * n : on_b);
    // If a body is far larger, its point can be far from the other body.
    if (length(arm_a) > off_body * a.reach() || length(arm_b) > off_body * b.reach()) return kept;
    uint32_t at = kept;
    if (kept == most_pair_contacts) {
        at = 0;
        for (uint32_t k = 1; k < kept; ++k) at = out[k].end > out[at].end ? k : at;
    } else {
        ++kept;
    }
    const Vector began_a = arm_a - moved_a.roll, began_b = arm_b - moved_b.roll;
    const float before = apart - dot(n, moved_a(began_a) - moved_b(began_b));
    out[at] = {{began_a, began_b, n, before}, apart, WayContact::swept, arm_a};
    return kept;
}

uint32_t PairBatch::search(uint32_t first) {
    if (first == 0)
        for (uint32_t i = 0; i < count_; ++i) order_[i] = i;
    const RelativePair& one = waiting_[order_[first]].near.pair;
    uint32_t lanes = 0;
    for (uint32_t i = first; i < count_ && lanes < search_lanes; ++i) {
        const RelativePair& pair = waiting_[order_[i]].near.pair;
        if (pair.a == one.a && pair.b == one.b) std::swap(order_[first + lanes++], order_[i]);
    }
    for (uint32_t lane = 0; lane < search_lanes; ++lane) {
        // Unused lanes repeat a pair, so that the search ends for them too.
        const NearPair& near = waiting_[order_[first + (lane < lanes ? lane : 0)]].near;
        block_.ratio[lane] = near.pair.ratio;
        put_in(block_.offset, 0, lane, near.pair.offset);
        for (size_t k = 0; k < 3; ++k) put_in(block_.axes, 3 * k, lane, near.pair.axes[k]);
        put_in(block_.start, 0, lane, near.start);
        block_.enough[lane] = near.enough;
        block_.near[lane] = touching_cores * near.pair.size;
        block_.tolerance[lane] = near.tolerance;
        block_.smaller[lane] = std::min(near.pair.a->core_reach, near.pair.ratio * near.pair.b->core_reach);
    }
    const PairHull &a = *one.a, &b = *one.b;
    const auto hull = [](const PairHull& h) {
        return SearchHull{h.x, h.y, h.z, h.shape.count, h.flat ? h.ring_x : nullptr, h.flat ? h.ring_y : nullptr};
    };
    target_(hull(a), hull(b), lanes, block_);
    return lanes;
}

Manifold PairBatch::manifold_at(uint32_t at, uint32_t lane) const {
    Closest closest{};
    closest.state = static_cast<Closest::State>(block_.state[lane]);
    closest.normal = vector_in(block_.normal, 0, lane);
    closest.distance = block_.distance[lane];
    closest.on_a = vector_in(block_.on_a, 0, lane);
    closest.on_b = closest.on_a - closest.distance * closest.normal;
    Manifold found;
    if (const float count = block_.count[lane]; count >= 0.0f) {
        found.count = static_cast<uint32_t>(count);
        const ContactFrame frame(waiting_[order_[at]].near, closest.normal, {});
        for (uint32_t k = 0; k < found.count; ++k)
            found.contact[k] = frame.contact(vector_in(block_.place, size_t{3} * k, lane), block_.place_gap[k][lane]);
        return found;
    }
    found.count = contacts_of(waiting_[order_[at]].near, closest, found.contact);
    return found;
}
} // namespace lr
