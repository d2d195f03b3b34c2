// Checks that a mesh is the boundary of a solid, or a sheet. Repairs unambiguous defects, reports the others.
#pragma once

#include "baker/mesh/mesh.h"

namespace lr::baker {

// On success the mesh is finite, closed, edge-manifold, consistently wound, outward, of positive volume, without degenerate or duplicate faces and
// unused vertices. Repairs are warnings, and so are faces of one part that cross each other; other defects are errors.
bool check_and_repair(Mesh& mesh, Faults& faults);

// Twice a face's area over its longest side squared; 0 if that side is 0. Scaled before multiplying, so that tiny bodies do not underflow.
double face_shape(const Mesh& mesh, const Face& face);
// Triangles of a smaller shape have no usable normal.
constexpr double degenerate_shape = 1e-9;

// On success the mesh is finite, without degenerate faces, duplicates (with either winding) or unused vertices. Edges can be
// open or have any number of faces, wound in any way.
bool check_sheet(Mesh& mesh, Faults& faults);

// On success the mesh is finite and without degenerate faces. Coincident faces are separate layers.
bool check_layers(Mesh& mesh, Faults& faults);
} // namespace lr::baker
