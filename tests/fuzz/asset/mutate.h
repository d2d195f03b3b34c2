// Changes an asset's fields and packs it again with a correct checksum.
#pragma once

#include "asset/asset_data.h"

#include <cstdint>

namespace fuzz {

// One to four changes drawn by `seed`: invalid numbers, numbers near the present ones, other lengths, other strings, and whole
// bodies made larger, heavier or thinner, which stay physical.
void mutate_asset(lr::AssetData& data, uint32_t seed);

} // namespace fuzz
