#include "contact/pair_way.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

// Of the reach: contacts farther out would turn the body without bounds.
constexpr float off_body = 4.0f;

Vector moved(const PairBody& body, Vector arm) {
    return to_outer(body.to, arm) - to_outer(body.from, arm);
}

// The body's point that is farthest along a direction at the end of its way, body frame.
Vector farthest(const PairBody& body, Vector direction) {
    const BodyShape& s = body.shape->shape;
    const Vector d = rotate(inverse(body.to.rotation), direction);
    const uint32_t best = farthest_point(s.x, s.y, s.z, s.count, d);
    return body.scale * (Vector{s.x[best], s.y[best], s.z[best]} + s.radius * d);
}

} // namespace

// Of a rotation by an angle, 2 |sine of half of it| is the chord at distance 1.
PairBody pair_body(const MeetingShape& shape, float scale, const Pose& from, const Pose& to) {
    const Rotation turn = to.rotation * inverse(from.rotation);
    const float reach = scale * shape.shape.reach;
    return {
        &shape, scale, from, to, to.position - from.position, 2.0f * reach * length(Vector{turn.x, turn.y, turn.z})};
}

float near_enough(const PairBody& a, const PairBody& b, float margin) {
    // By no more do any two of their points come nearer to each other.
    return margin + length(a.shift - b.shift) + a.turns + b.turns;
}

uint32_t keep_way_contacts(const PairBody& a, const PairBody& b, float margin,
                           const PairContact (&found)[most_pair_contacts], uint32_t count,
                           WayContact (&out)[most_pair_contacts]) {
    if (count == 0) return 0;
    uint32_t kept = 0;
    float least = margin;
    for (uint32_t k = 0; k < count; ++k) {
        const PairContact& c = found[k];
        const float end = c.gap + dot(c.normal, moved(a, c.arm_a) - moved(b, c.arm_b));
        least = std::min(least, end);
        if (end < margin) out[kept++] = {c, end};
    }
    // The plane between them as the substep begins is between them at its end as well: else what turns fast brings other points
    // through than those that were near.
    const Vector n = found[0].normal;
    const float slop = 1e-3f * std::min(a.scale * a.shape->shape.reach, b.scale * b.shape->shape.reach);
    if (!(found[0].gap > -slop)) return kept;
    const Vector on_a = to_outer(a.to, farthest(a, -n)), on_b = to_outer(b.to, farthest(b, n));
    const float apart = dot(n, on_a - on_b);
    if (!(apart < least - slop)) return kept;
    // On one line, through the point of the one that goes farther: impulses at two that are beside each other would turn both.
    const bool first = a.way() >= b.way();
    const Vector arm_a = to_inner(a.to, first ? on_a : on_b + apart * n);
    const Vector arm_b = to_inner(b.to, first ? on_a - apart * n : on_b);
    // Of a far larger body a point that is nowhere near the other.
    if (length(arm_a) > off_body * a.scale * a.shape->shape.reach) return kept;
    if (length(arm_b) > off_body * b.scale * b.shape->shape.reach) return kept;
    uint32_t at = kept;
    if (kept == most_pair_contacts) {
        at = 0;
        for (uint32_t k = 1; k < kept; ++k) at = out[k].end > out[at].end ? k : at;
    } else {
        ++kept;
    }
    out[at] = {{arm_a, arm_b, n, apart - dot(n, moved(a, arm_a) - moved(b, arm_b))}, apart};
    return kept;
}

} // namespace lr
