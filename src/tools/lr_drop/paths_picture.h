// The picture of lr_drop: falls from the side, landings from above, shares of the motions.
#pragma once

#include "tools/lr_drop/report.h"

namespace lr::tools {

inline constexpr uint32_t pictured_falls = 14;

// A PNG. Uses `each` and the first tracks of the results.
std::vector<uint8_t> draw_paths(const DropCommand& command, const Results& results);
} // namespace lr::tools
