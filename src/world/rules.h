// What an lr_batch_rules may hold.
#pragma once

#include "langevin_rigid.h"

namespace lr {

// Null when fine, else what is wrong. Of finite numbers only.
const char* wrong_in(const lr_batch_rules& rules);
bool all_finite(const lr_batch_rules& rules);

} // namespace lr
