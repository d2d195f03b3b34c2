// libccd's portal refinement for a convex pair whose cores overlap: it needs no memory, unlike libccd's other answer.
#pragma once

#include "contact/placed.h"

namespace lr {

// A direction in which the body comes out of the collider, unit; not always that of least depth. False: libccd did not come to an
// end, or says that they do not overlap.
bool ccd_direction(const PlacedBody& body, const PlacedCollider& collider, Double3& direction);

} // namespace lr
