// Sheets that are modelled twice, as a front and a back.
#pragma once

#include "baker/mesh/mesh.h"

#include <vector>

namespace lr::baker {

// Smooth patches that face opposite ways, cover each other, and are at most a hundredth of the sheet's length or its thickness apart are one sheet if
// they belong to different parts or are the two sides of a closed surface. Two real layers on each other are joined at a fold, or face the same way;
// layers joined at a fold stay, with a warning. A side has several patches where it is creased; the other side need not be. Removes from `sheets` the
// side of less area and the rim of a closed surface, with a warning that has the numbers. strict: an error and false instead.
bool take_double_sheets_once(const Mesh& mesh, double thickness, bool strict, std::vector<Face>& sheets,
                             Faults& faults);

// Whether a solid is no more than two such sides and their rim; `side` is then one of them.
bool find_one_side(const Mesh& solid, Mesh& side);
} // namespace lr::baker
