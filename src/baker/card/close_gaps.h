// Narrow gaps in a mask, closed.
#pragma once

#include "baker/card/alpha_mask.h"

namespace lr::baker {

// Where no disc of `reach` pixels fits between opaque pixels, all are opaque (a morphological closing). opaque: least opacity of such pixels, 0 to 1.
AlphaMask close_gaps(const AlphaMask& mask, double opaque, std::size_t reach);
} // namespace lr::baker
