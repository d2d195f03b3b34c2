// Contacts of one pair as they are found, and the few of them that are kept.
#pragma once

#include "contact/narrow.h"
#include "contact/placed.h"

namespace lr {

inline constexpr uint32_t most_found = 48;

class ContactSet {
public:
    explicit ContactSet(const PlacedBody& body) : body_(&body) {}

    // point: m, of the body's surface, from its centre of mass along the collider's axes.
    void add(Vector point, Vector normal, float gap);
    // The point of the core, `core_gap` from the collider along the normal.
    void add_core(Vector point, Vector normal, float core_gap) {
        add(point - body_->radius * normal, normal, core_gap - body_->radius);
    }
    uint32_t count() const { return count_; }
    // Least of those found since `from`; `otherwise` without any.
    float least_gap(uint32_t from, float otherwise) const;
    // The deepest, then always the one farthest from those taken, in place and direction.
    uint32_t keep(Contact* out);

private:
    uint32_t choose(Contact* out) const;

    const PlacedBody* body_;
    uint32_t count_ = 0;
    Contact found_[most_found]; // arms along the collider's axes
};

} // namespace lr
