// Changes an asset's fields and packs it again with a right checksum.
#pragma once

#include "asset/asset_data.h"

#include <cstdint>

namespace fuzz {

// One to four changes drawn by `seed`: numbers that none may be, numbers near those that are there, other lengths, other
// strings, and whole bodies made larger, heavier or thinner, which stay physical.
void mutate_asset(lr::AssetData& data, uint32_t seed);

} // namespace fuzz
