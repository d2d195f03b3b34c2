// Sheets that are modelled twice: as a front and a back face.
#pragma once

#include "baker/mesh/mesh.h"

#include <vector>

namespace lr::baker {

// Smooth patches that look opposite ways, cover each other and are at most a hundredth of the sheet's length or its thickness apart are
// one sheet, if they are parts of different sheets, or the two sides of a closed surface: two real layers that lie on each other are
// joined at a fold, or look the same way. A side has several patches where it is creased; the other side need not be. Takes the side of
// less area out of `sheets`, and the walls of a closed surface around its rim, with a warning that has the numbers; strict: false, and
// an error. Layers that are joined at a fold stay, with a warning.
bool take_double_sheets_once(const Mesh& mesh, double thickness, bool strict, std::vector<Face>& sheets,
                             Faults& faults);

// If a solid is no more than two such sides and their rim: one of them.
bool find_one_side(const Mesh& solid, Mesh& side);
} // namespace lr::baker
