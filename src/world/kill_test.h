// Which bodies have come to their end by a batch's rules.
#pragma once

#include "kernel/batch_arrays.h"
#include "langevin_rigid.h"

#include <cstdint>

namespace lr {

// Why a body ends. Volumes follow, in their order.
enum Cause : uint32_t { cause_none, cause_not_finite, cause_age, cause_volume };
inline constexpr uint32_t cause_count = cause_volume + LR_MAX_KILL_VOLUMES;

// Null when fine, else what is wrong. Of finite numbers only.
const char* wrong_in(const lr_batch_rules& rules);
bool all_finite(const lr_batch_rules& rules);

// Writes the first cause that holds for each body of [begin, end), and returns for how many there is one.
uint32_t find_ended(const lr_batch_rules& rules, const BatchArrays& arrays, size_t begin, size_t end, uint32_t* cause);

} // namespace lr
