// Finds panels so close to each other that their integrals need closed forms.
#pragma once

#include "baker/added_mass/panel_integrals.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lr::baker {

struct NearPair {
    uint32_t panel;
    bool touching;       // the circles around both panels intersect
    double single_layer; // double integral of 1/r, outer rule on the row's panel
};

// pairs[t]: panels near t, ascending. level[t]: refinement level of the outer rule on t, which must resolve the hat functions of much finer
// neighbours. False, with invalid results, if there are more than `most` pairs.
bool find_near_panels(const std::vector<Panel>& panels, std::size_t most, std::vector<std::vector<NearPair>>& pairs,
                      std::vector<std::size_t>& level);
} // namespace lr::baker
