// Fewer faces for the same surface.
#pragma once

#include "baker/mesh/mesh.h"

namespace lr::baker {

// Collapses edges, the shortest first, while the surface, its creases and its free rims stay within this distance. Needles side by side, which
// boundary elements cannot use, become a few broad faces. Edges of more than two faces stay, and so do the number of parts and holes. Remaining faces
// keep their order.
Mesh simplified(const Mesh& mesh, double tolerance);
} // namespace lr::baker
