// Converts a triangle mesh to closed faces of a MAC grid.
#pragma once

#include "baker/mesh/mesh.h"
#include "baker/turbulence/mac_grid.h"

#include <array>
#include <cstdint>

namespace lr::baker {

// Closes the face between two cells if the segment between their centres meets the surface. Sheets, thin and thick solids are treated alike, and the
// body's thickness does not depend on the grid. Every path from cell to cell through a continuous surface crosses a closed face, so a flood from
// outside does not reach the inside of a closed surface of any orientation (MacGrid::set_solid). Positions must be finite, in the grid's frame and
// unit.
//
// Ties: triangles include their boundary, within 1e-9 of a cell, and a centre on the surface closes the faces on both sides. So no segment passes
// between triangles at an edge or vertex, and a symmetric body stays symmetric.
ClosedFaces voxelise(const Mesh& mesh, const std::array<uint32_t, 3>& cells, const GridPoint& lengths);
} // namespace lr::baker
