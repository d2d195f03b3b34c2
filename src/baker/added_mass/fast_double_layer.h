// sum_doublets (panel_kernels.h) by multipole expansions.
#pragma once

#include "baker/added_mass/panel_kernels.h"

#include <functional>

namespace lr::baker {

// For the first `count` points. Same bits for any number of threads.
void sum_doublets_fast(DoubletArrays& arrays, std::size_t count, unsigned threads,
                       const std::function<void(double)>& progress);
} // namespace lr::baker
