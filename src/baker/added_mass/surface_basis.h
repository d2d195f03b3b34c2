// Continuous linear elements on a triangle mesh, and what their unknowns are.
#pragma once

#include "baker/mesh/mesh.h"

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

// Unknowns that can grow together, with these signs, and leave the potential constant on each side of every panel.
struct ConstantPotential {
    std::vector<int32_t> unknowns;
    std::vector<double> signs;
};

struct SurfaceBasis {
    bool sheet = false;
    std::size_t unknowns = 0;
    std::vector<std::array<CornerUnknowns, 3>> corners; // of each panel
    std::vector<ConstantPotential> constants;           // independent of each other
};

// One unknown for each vertex, which must belong to a face; one constant for each connected part.
SurfaceBasis closed_basis(const Mesh& mesh);

// Panels without thickness, open or closed, wound in any way, any number of them at an edge. The potential has a value
// for each of the spaces that the panels around a vertex part; it has none at a free rim, where front and back meet.
// One constant for each enclosed chamber. No two panels may lie on each other.
SurfaceBasis sheet_basis(const Mesh& mesh);

} // namespace lr::baker
