// Whether a body's motion along and about its axes falls apart into single axes.
#pragma once

#include "format/asset_data.h"

namespace lr {

// The largest entry off the diagonals of inertia and added mass, over the geometric mean of what it couples, or the
// offset of buoyancy or of the quasi-steady loads over the length d.
double largest_coupling(const AssetData& asset);

// A mesh that is symmetric by design is not so to the last bit: what is below a millionth is taken for zero.
inline bool is_diagonal(const AssetData& asset) {
    return largest_coupling(asset) <= 1e-6;
}

} // namespace lr
