// Fewer faces for the same surface.
#pragma once

#include "baker/mesh/mesh.h"

namespace lr::baker {

// Moves vertices onto neighbours, across the shortest edges first, as long as the surface, its creases and its free rims stay within
// this distance of where they were. Needles side by side, which boundary elements cannot use, become a few broad faces. Edges of more
// than two faces stay as they are, and so does the number of parts and holes. The faces that stay keep their order.
Mesh simplified(const Mesh& mesh, double tolerance);
} // namespace lr::baker
