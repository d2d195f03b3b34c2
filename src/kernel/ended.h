// Why bodies end, and the function that finds out for a range of them.
#pragma once

#include "kernel/batch_arrays.h"

#include <cstdint>

struct lr_batch_rules;

namespace lr {

inline constexpr uint32_t most_kill_volumes = 8;

// Volumes follow, in their order.
enum Cause : uint32_t { cause_none, cause_not_finite, cause_age, cause_volume };
inline constexpr uint32_t cause_count = cause_volume + most_kill_volumes;

// Writes the first cause that holds for each body of [begin, end), multiples of lane_block. Returns whether there is any.
using EndedFunction = bool (*)(const lr_batch_rules&, const BatchArrays&, size_t begin, size_t end, uint32_t* cause);

} // namespace lr
