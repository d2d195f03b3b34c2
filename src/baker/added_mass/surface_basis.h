// Continuous linear elements on a triangle mesh and their unknowns.
#pragma once

#include "baker/mesh/mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lr::baker {

// The potential (on a sheet: its jump from the back to the front of a panel) at a corner of a panel is unknown[plus] -
// unknown[minus]; index -1 is zero. A closed surface has one unknown for each vertex and no minus.
struct CornerUnknowns {
    int32_t plus = -1, minus = -1;
};

// A combination of unknowns that gives a constant potential on each side of every panel.
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

// Panels without thickness, open or closed, wound in any way, any number at an edge; they must not coincide. Around a vertex the potential has one
// value for each space between panels; its jump is zero at a free rim. One constant for each enclosed chamber.
SurfaceBasis sheet_basis(const Mesh& mesh);
} // namespace lr::baker
