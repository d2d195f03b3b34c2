// A triangle mesh as closed faces of a MAC grid.
#pragma once

#include "baker/mesh/mesh.h"
#include "baker/turbulence/mac_grid.h"

#include <array>
#include <cstdint>

namespace lr::baker {

// Closes the face between two cells when the segment between their centres meets the surface: a sheet, a solid thinner than
// a cell and a thick solid are all treated alike, and how thick the body is does not depend on the grid. Any path from
// cell to cell through a continuous surface meets a closed face, so that the inside of a closed one is what a flood from
// outside leaves dry (MacGrid::set_solid), whatever its orientation. Positions are in the grid's frame and unit, and
// finite.
//
// Ties. Triangles count with their boundary, to within 1e-9 of a cell, and a centre on the surface has both its faces closed:
// a segment through an edge or a vertex is never lost between triangles, and a symmetric body stays symmetric.
ClosedFaces voxelise(const Mesh& mesh, const std::array<uint32_t, 3>& cells, const GridPoint& lengths);

} // namespace lr::baker
