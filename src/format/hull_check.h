// Whether the triangles of a file's hull bound a convex body.
#pragma once

#include "format/asset_data.h"

namespace lr {

enum class HullFlaw { none, open, dented, inside_out };

// Of triangles whose indices are in range and whose vertices are finite. Open: an edge without its neighbour, or with more than
// one. Dented: a neighbour rises over a face by more than a ten thousandth of `length`. `triangle`: where. Hulls without a volume, as
// of flat bodies, have no inside out.
HullFlaw find_flaw(const HullData& hull, double length, size_t& triangle);

} // namespace lr
