// Refines panels at sharp edges, where the velocity is singular.
#pragma once

#include "baker/mesh/mesh.h"

#include <cstddef>

namespace lr::baker {

struct Refinement {
    std::size_t panels = 2000; // least number before rims are cut into strips
    std::size_t strips = 4;    // between a rim and the adjacent vertices
    bool creases = false;      // of a sheet that bounds solids: rims as well
    // Halving long edges stops at this many panels: then the caller needs a coarser surface.
    std::size_t most_halved = 10000;
};

// Refines the surface: halves the longest edges until the panels are small and uniform, then cuts the panels at a free rim into
// strips along it, at distances proportional to the square of their number. The jump of the potential grows as the square root
// of the distance from the rim; with linear elements on uniform panels its error would only be proportional to their size.
Mesh refine_sheet(const Mesh& mesh, const Refinement& how);

// The same for a closed surface, with convex creases as rims: the potential of a solid is singular there. origin: refine_curved.
Mesh refine_solid(const Mesh& mesh, const Refinement& how, std::vector<uint32_t>* origin = nullptr);
} // namespace lr::baker
