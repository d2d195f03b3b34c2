// Repairs cracks: vertices on an edge of a face that does not use them.
#pragma once

#include "baker/mesh/mesh.h"

#include <cstddef>

namespace lr::baker {

// A crack is a vertex of a boundary edge closer to the inside of another boundary edge than `tolerance` times the mesh's largest extent: it looks
// closed, but fluid would pass. Splits the faces of such edges at the vertex; returns the number of inserted vertices. Faces must have three
// different corners.
std::size_t close_cracks(Mesh& mesh, double tolerance);
} // namespace lr::baker
