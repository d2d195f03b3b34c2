// Is a mesh the boundary of a solid, or a sheet? Repairs what can be repaired without guessing, names the rest.
#pragma once

#include "baker/mesh/mesh.h"

namespace lr::baker {

// On success the mesh is finite, closed, edge-manifold, consistently wound, outward, of positive volume, without
// degenerate or duplicate faces and without unused vertices. Every change is a warning, so are
// faces of one part that cross each other; everything else is an error.
bool check_and_repair(Mesh& mesh, Faults& faults);

// On success the mesh is finite, without degenerate faces, doubled ones (from either side) or unused vertices. Edges may
// be open or have any number of faces, wound in any way.
bool check_sheet(Mesh& mesh, Faults& faults);

// On success the mesh is finite and without degenerate faces. Faces may lie on each other, each a layer of its own.
bool check_layers(Mesh& mesh, Faults& faults);

} // namespace lr::baker
