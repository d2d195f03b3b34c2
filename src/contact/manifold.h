// Where a body touches a convex collider along a given normal: corners of the one over a side of the other, and crossings
// of their edges.
#pragma once

#include "contact/contact_set.h"
#include "contact/separation.h"

namespace lr {

// Adds the contacts nearer than `margin`.
void add_manifold(const PlacedBody& body, const PlacedCollider& collider, const Separation& along, float margin,
                  ContactSet& set);

} // namespace lr
