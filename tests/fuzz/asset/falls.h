// Requirements for every asset that loads.
#pragma once

#include "langevin_rigid.h"

#include <cstdint>

namespace fuzz {

// Steps it 100 times with `variant`'s model, clock, scale and surroundings: wind, water, a plane to land on, other bodies of
// its kind. Ends the program if a number is not finite.
void fall(const lr_asset* asset, uint32_t variant);

} // namespace fuzz
