// Refines panels at sharp edges, where the velocity is singular.
#pragma once

#include "baker/mesh/mesh.h"

#include <cstddef>

namespace lr::baker {

struct Refinement {
    std::size_t panels = 2000; // least number before rims are cut into strips
    std::size_t strips = 4;    // between a rim and the adjacent vertices
    bool creases = false;      // of a sheet that bounds solids: its creases are rims too
    // Halving stops at this many panels; the caller then needs a coarser surface.
    std::size_t most_halved = 10000;
};

// Halves the longest edges until the panels are small and uniform, then cuts panels at a free rim into strips along it, at distances proportional to
// the square of their number. The jump of the potential grows as the square root of the distance from the rim; on uniform panels its error would only
// fall in proportion to their size.
Mesh refine_sheet(const Mesh& mesh, const Refinement& how);

// The same for a closed surface, with convex creases as rims, where the potential of a solid is singular. origin: as for refine_curved.
Mesh refine_solid(const Mesh& mesh, const Refinement& how, std::vector<uint32_t>* origin = nullptr);
} // namespace lr::baker
