// Bodies that would pass through something within a substep.
#include "contact/contact_group.h"

#include <algorithm>

namespace lr {
namespace {

// How far a body reaches below the plane through nothing across n: its least n . x.
float lowest(const BodyShape& s, float scale, const Pose& pose, Vector n) {
    const Vector d = rotate(inverse(pose.rotation), n);
    float least = 0.0f;
    if (s.count == 0) {
        const Vector stretched{s.semi_axes.x * d.x, s.semi_axes.y * d.y, s.semi_axes.z * d.z};
        least = dot(d, s.center) - length(stretched);
    } else {
        least = d.x * s.x[0] + d.y * s.y[0] + d.z * s.z[0];
        for (uint32_t k = 1; k < s.count; ++k) least = std::min(least, d.x * s.x[k] + d.y * s.y[k] + d.z * s.z[k]);
        least -= s.radius;
    }
    return dot(n, pose.position) + scale * least;
}

// Where two convex things meet, a plane lies between them; as long as all of the body stays on its side of that it goes
// through nothing, however far it slides along. Moves `to` out along the normal; false without such a plane.
bool keep_side(const BodyShape& s, float scale, const Pose& met, const Geometry& g, ColliderPart part, Pose& to) {
    Contact contacts[most_contacts];
    const uint32_t count = find_contacts(s, scale, met, g, part, 0.2f * s.reach * scale, contacts);
    if (count == 0) return false;
    const Contact* const nearest =
        std::min_element(contacts, contacts + count, [](const Contact& a, const Contact& b) { return a.gap < b.gap; });
    const Vector n = nearest->normal;
    const float surface = dot(n, to_outer(met, nearest->arm)) - nearest->gap;
    const float below = surface - lowest(s, scale, to, n);
    if (below > 0.0f) to.position = to.position + below * n;
    return true;
}

} // namespace

void ContactGroup::clip(const LaneRow (&before)[pose_fields], float begin, float end) {
    for (uint32_t i = 0; i < count_; ++i) {
        const float scale = arrays_.field[field_scale][i];
        const Pose from{{before[0][i], before[1][i], before[2][i]},
                        {before[3][i], before[4][i], before[5][i], before[6][i]}};
        const Pose to = pose_of(i);
        const Near& near = near_[i];
        const auto free_way = [&](const Pose& a, const Pose& b, uint32_t k) {
            const Candidate& candidate = near.candidate[k];
            const Collider& c = step_->colliders->at(candidate.slot);
            if (c.geometry.kind == ColliderKind::plane) return 1.0f;
            // Solid below, so that only what is thinner than the way could be jumped.
            if (const HeightfieldGeometry* const f = c.geometry.heightfield; f && !c.moves)
                if (length(b.position - a.position) < 0.5f * std::min(f->spacing[0], f->spacing[1])) return 1.0f;
            return free_fraction(*step_->shape, scale, relative(pose_at(c, begin), a), relative(pose_at(c, end), b),
                                 c.geometry, candidate.part);
        };
        float free = 1.0f;
        stopped_[i] = nobody;
        for (uint32_t k = 0; k < near.count; ++k) {
            const float here = free_way(from, to, k);
            if (here >= free) continue;
            free = here;
            stopped_[i] = k;
        }
        if (free >= 1.0f) continue;
        const Candidate& candidate = near.candidate[stopped_[i]];
        const Collider& c = step_->colliders->at(candidate.slot);
        const Pose ends = pose_at(c, end), met = mix(from, to, free);
        Pose last = relative(ends, to);
        bool passes = keep_side(*step_->shape, scale, relative(pose_at(c, begin + free * (end - begin)), met),
                                c.geometry, candidate.part, last);
        const Pose kept{to_outer(ends, last.position), to.rotation};
        for (uint32_t k = 0; k < near.count && passes; ++k)
            passes = k == stopped_[i] || free_way(from, kept, k) >= 1.0f;
        // Between several things it stops where it meets the first.
        set_pose(i, passes ? kept : met);
        if (passes) stopped_[i] = nobody;
    }
}

} // namespace lr
