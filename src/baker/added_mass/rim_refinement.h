// Smaller panels where the flow around a sharp edge asks for them.
#pragma once

#include "baker/mesh/mesh.h"

#include <cstddef>

namespace lr::baker {

struct Refinement {
    std::size_t panels = 2000; // at least so many, before the rims are cut into strips
    std::size_t strips = 4;    // between a rim and the vertices next to it
};

// The same surface with more panels. Longest edges are halved until the panels are small and even enough. Then panels at a free rim are
// cut into strips along it, each strip as far from the rim as the square of its number: the jump of the potential
// grows as the square root of the distance, and linear elements on even panels would miss a share of it that falls only
// as fast as their size.
Mesh refine_sheet(const Mesh& mesh, const Refinement& how);

// The same for a closed surface, with its convex creases for rims: the potential of a solid has a singularity there.
Mesh refine_solid(const Mesh& mesh, const Refinement& how);

} // namespace lr::baker
