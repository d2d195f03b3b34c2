// The mean of k and epsilon around a body and in its near wake.
#pragma once

#include "baker/turbulence/k_epsilon.h"
#include "baker/turbulence/mac_grid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace lr::baker {

// Over the fluid in the body's box, extended downstream by `behind`; an empty box: that of the solid cells. Each cell is weighted by its part of that
// volume, so that the volume depends on the body, not on the grid.
class WakeProbe {
public:
    WakeProbe() = default;
    WakeProbe(const MacGrid& grid, std::array<GridPoint, 2> box, double behind);

    bool empty() const { return cells_.empty(); }
    shape::TurbulenceState mean(const KEpsilon& turbulence) const;

private:
    struct Cell {
        uint32_t i, j, k;
        double share;
    };
    std::vector<Cell> cells_;
    double volume_ = 0.0;
};
} // namespace lr::baker
