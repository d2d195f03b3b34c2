// Finds the stationary point or loop of a wake's history.
#pragma once

#include "asset/closed_forms/turbulence_closure.h"

#include <cstddef>
#include <vector>

namespace lr::baker {

enum class WakeEnd {
    unsettled,  // neither of the others by the end of the history
    stationary, // chi and epsilon stay within 2 % over the window
    loop        // vortex shedding: chi is periodic
};

struct WakeSummary {
    WakeEnd end = WakeEnd::unsettled;
    // Samples of the developed wake: [begin, begin + count) of the history. One period of a loop.
    size_t begin = 0, count = 0;
    shape::TurbulenceState mean{0.0, 0.0}; // over them
};

// history: at equal intervals. window: number of last samples that must agree.
bool is_stationary(const std::vector<shape::TurbulenceState>& history, size_t window);

// Period in samples: lag of the first maximum above 0.8 of the autocorrelation of chi (second half of the history, mean removed), at least 8 samples
// and at most half of that stretch. Zero: none.
size_t find_period(const std::vector<shape::TurbulenceState>& history);

WakeSummary summarise_wake(const std::vector<shape::TurbulenceState>& history, size_t window);
} // namespace lr::baker
