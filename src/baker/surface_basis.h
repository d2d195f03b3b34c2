// Continuous linear elements on a triangle mesh, and what their unknowns are.
#pragma once

#include "baker/mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lr::baker {

// The potential (or, on a sheet, its jump from the back to the front of a panel) at a corner of a panel is
// unknown[plus] - unknown[minus]; -1 stands for zero. A closed surface has one unknown for each vertex and no minus.
struct CornerUnknowns {
    int32_t plus = -1, minus = -1;
};

struct SurfaceBasis {
    std::size_t unknowns = 0;
    std::vector<std::array<CornerUnknowns, 3>> corners; // of each panel
};

// One unknown for each vertex.
SurfaceBasis closed_basis(const Mesh& mesh);

} // namespace lr::baker
