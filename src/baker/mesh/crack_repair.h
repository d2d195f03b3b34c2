// Vertices that lie on an edge of a face that does not use them.
#pragma once

#include "baker/mesh/mesh.h"

#include <cstddef>

namespace lr::baker {

// A vertex of a boundary edge within `tolerance` times the mesh's largest extent of the inside of another boundary edge looks joined
// and is not: a crack, through which fluid would pass. Splits the faces of such edges there; returns how many vertices
// were worked in. Faces must have three different corners.
std::size_t close_cracks(Mesh& mesh, double tolerance);

} // namespace lr::baker
