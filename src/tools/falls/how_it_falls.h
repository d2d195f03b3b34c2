// One plain sentence about an asset: "falls at about 1.2 m/s, flutters".
#pragma once

#include "tools/falls/fall_measures.h"

namespace lr::falls {

// Drops and measures all bodies. kept: receives the tracks of the first `keep` bodies; may be null.
Falls drop_and_measure(const lr_asset* asset, const Drop& options, std::vector<Fall>& falls, uint32_t keep = 0,
                       std::vector<Track>* kept = nullptr);

// A body that moves less than a fiftieth of its length in a second floats.
std::string sentence(const Falls& falls, const Shape& shape);

// For a random release of 64 bodies in the asset's fluid, from a height at which the speed settles, if 3000 steps suffice.
std::string how_it_falls(const lr_asset* asset);
} // namespace lr::falls
