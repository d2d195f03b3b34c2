// Rays along normals. Inwards: how thick a solid is under each of its faces, to tell the nut of a winged seed from its wing. Outwards: which faces have other
// parts of the body before them.
#pragma once

#include "baker/aerodynamics/surface_parts.h"

#include <utility>

namespace lr::baker {

// The lump and the rest of a closed surface of this size: faces under which the solid is several times thicker than elsewhere, and close together.
// No lump (first empty) if they are few, as rims are.
std::pair<Part, Part> split_lump(const Part& part, double size);

// Sets Facet::open.
void find_open_sides(Part& part, double size);
} // namespace lr::baker
