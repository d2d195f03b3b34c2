// Checks the numbers of a bake before any work is done.
#pragma once

#include "baker/bake.h"

namespace lr::baker {

// The turbulence solver has the same limits, but would report them only after minutes of work on the added mass.
bool check_options(const BakeOptions& options, Faults& faults);
} // namespace lr::baker
