// Checks the numbers of a bake before any work is done.
#pragma once

#include "baker/bake.h"

namespace lr::baker {

// Same limits as the turbulence solver, which would report them only after minutes of added mass.
bool check_options(const BakeOptions& options, Faults& faults);
} // namespace lr::baker
