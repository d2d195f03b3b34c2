// What the history of a wake comes to: a stationary point or a loop.
#pragma once

#include "asset/closed_forms/turbulence_closure.h"

#include <cstddef>
#include <vector>

namespace lr::baker {

enum class WakeEnd {
    unsettled,  // neither, by the end of the history
    stationary, // chi and epsilon stay within 2 % over the window
    loop        // vortex shedding: chi repeats itself
};

struct WakeSummary {
    WakeEnd end = WakeEnd::unsettled;
    // The samples that stand for the wake for ever: [begin, end) of the history. A loop's are one period.
    size_t begin = 0, count = 0;
    shape::TurbulenceState mean{0.0, 0.0}; // over them
};

// `history`: at equal intervals. `window`: how many of the last samples must agree.
bool is_stationary(const std::vector<shape::TurbulenceState>& history, size_t window);

// The last samples that repeat: the lag of the first maximum of the autocorrelation of chi (of the second half of
// the history, mean removed) above 0.8, at least 8 samples, at least twice in that half. Zero: none.
size_t find_period(const std::vector<shape::TurbulenceState>& history);

WakeSummary summarise_wake(const std::vector<shape::TurbulenceState>& history, size_t window);

} // namespace lr::baker
