// Merges details of a sheet that cost more than the added mass gains by them: dense needles, layers close to each other.
#pragma once

#include "baker/mesh/mesh.h"

namespace lr::baker {

// Vertices within one cell of a cubic grid become one, at their mean; faces without area and second copies of faces go. Layers closer than a cell
// become one. A strip narrower than a cell vanishes unless it crosses into the next, and is a cell wide then: on average its area stays.
Mesh merge_cells(const Mesh& mesh, double cell);

// Whether the boundary elements of these panels take some seconds and less than a gigabyte at most: pairs of close panels times the points of
// their quadrature.
bool is_cheap_sheet(const Mesh& mesh);
} // namespace lr::baker
