// Manifold of a body and a collider: collects all contacts, then keeps a few.
#pragma once

#include "collision/collider_narrow_phase.h"
#include "collision/convex_separation.h"

#include <algorithm>

namespace lr {

inline constexpr uint32_t most_found = 48;

class ContactPoints {
public:
    // at: in the collider's frame. near: m, the margin. began: pose at the beginning of the substep, which tells on which side of a triangle the body
    // was; null: unknown. side: MeshFloor::side.
    ContactPoints(const BodyShape& shape, float scale, const Pose& at, float near, const Pose* began = nullptr,
                  int8_t known_side = 0)
        : body(shape, scale, at), margin(near), before(began), side(known_side) {}
    ContactPoints(const ContactPoints&) = delete;
    ContactPoints& operator=(const ContactPoints&) = delete;

    const PlacedBody body;
    const float margin;
    const Pose* const before;
    const int8_t side;
    Vector face{}; // if no side is known: normal of the triangle that the centre was over as the substep began, or 0
    Double3 up{};  // unit: away from what supports the body; zero: nothing does

    // point: m, on the body's surface, from its centre of mass along the collider's axes.
    void add(Vector point, Vector normal, float gap);
    // Adds a core point at `core_gap` from the collider along the normal, if the surface there is within the margin.
    void add_core(Vector point, Vector normal, float core_gap) {
        const float gap = core_gap - body.radius;
        if (gap < margin) add(point - body.radius * normal, normal, gap);
    }
    uint32_t count() const { return count_; }
    // Least gap among contacts from index `from` on; infinite if there are none.
    float least_gap(uint32_t from) const;
    // Keeps at most most_contacts: the deepest, then repeatedly the one farthest from the kept ones in place and direction. loaded_first: the first
    // four span the largest quadrilateral, and contacts that hold the body once it is pushed out count more.
    uint32_t keep(Contact* out, bool loaded_first = false);

private:
    uint32_t choose(Contact* out, bool loaded_first) const;

    uint32_t count_ = 0;
    Contact found_[most_found]; // arms along the collider's axes
};

// The nearest point of a rocking ellipsoid (kernel/contact/collider_contact.h) jumps from rim to rim at the slightest tilt. So, as over ground, these
// points are added: where it would touch if tilted a little, and those on the other rims. None for other bodies. fall: m, in a substep.
struct Rims {
    uint32_t count;
    Vector point[7];
};
Rims rims_of(const PlacedBody& body, Double3 normal, float fall);
// Adds rims near the collider. They count beyond the margin, since pushing out the nearest point, at this gap, can press them in. gap_of(point,
// direction): returns the gap of a rim (m) and sets the normal there.
template <class Gap> void add_rims(ContactPoints& set, Double3 normal, float gap, const Gap& gap_of) {
    const double wide = static_cast<double>(set.margin + 0.1f * set.body.reach + 2.0f * std::max(-gap, 0.0f));
    const Rims rims = rims_of(set.body, normal, set.margin);
    for (uint32_t i = 0; i < rims.count; ++i) {
        Vector direction{};
        const double out = gap_of(rims.point[i], direction);
        if (out < wide) set.add(rims.point[i], direction, static_cast<float>(out));
    }
}

// Adds contacts along a given normal: corners of one over a side of the other, and crossings of edges. For bodies with corners.
void add_patch(ContactPoints& set, const PlacedCollider& collider, const Separation& along);
// The same; adds the nearest point if it is nearer than all of them.
void add_manifold(ContactPoints& set, const PlacedCollider& collider, const Separation& along);
} // namespace lr
