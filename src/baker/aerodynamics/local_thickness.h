// Rays along normals. Inwards: thickness of a solid under each face, which tells the nut of a winged seed from its wing. Outwards: faces that have
// other parts of the body in front of them.
#pragma once

#include "baker/aerodynamics/surface_parts.h"

#include <utility>

namespace lr::baker {

// Splits a closed surface of this size into the lump and the rest. The lump: faces close together under which the solid is several times thicker than
// elsewhere. Empty if they are few, as at rims.
std::pair<Part, Part> split_lump(const Part& part, double size);

// Sets Facet::open of all faces.
void find_open_sides(Part& part, double size);
} // namespace lr::baker
