// Implicit diffusion of a field on a MAC grid with variable viscosity.
#pragma once

#include "baker/turbulence/mac_grid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lr::baker {

// For each sample, the share of the link to the sample before it along each axis that a wall halfway blocks: 0 to 2 halves. Empty: no walls.
using WallShares = std::array<std::vector<uint8_t>, 3>;

// For samples on the faces normal to `axis`, or (3) for a field on the cells.
WallShares find_wall_shares(const MacGrid& grid, size_t axis);

class EddyDiffusion {
public:
    enum class Wall {
        no_slip, // the field is zero on it
        no_flux  // the field does not flow through it
    };

    // Integrates d(field)/dt = div(viscosity grad field) over dt. One viscosity per sample, zero inside solids. Prescribed samples keep their value;
    // no flux at the ends of the domain. Implicit along one axis after another: stable at any viscosity, and positive fields stay positive.
    void apply(GridField& field, const std::vector<uint8_t>& prescribed, const std::vector<double>& viscosity,
               Wall wall, double dt, const WallShares& walls = {});

    // Without the splitting error, which grows near edges as the grid is refined: conjugate gradients from `guess` (which has the prescribed values)
    // until all residuals are at most `tolerance`.
    void apply_unsplit(GridField& field, const std::vector<double>& guess, const std::vector<uint8_t>& prescribed,
                       const std::vector<double>& viscosity, Wall wall, double dt, const WallShares& walls,
                       double tolerance);

private:
    void multiply(const std::vector<double>& x, std::vector<double>& y) const;

    std::vector<double> upper_, link_;
    // The system matrix, with a layer of zeros before and after it; [a][s] links sample s to the sample before it along a.
    size_t stride_[3] = {0, 0, 0}, first_ = 0, last_ = 0;
    std::array<std::vector<double>, 3> links_;
    std::vector<double> diagonal_, free_, solution_, residual_, direction_, image_;
};
} // namespace lr::baker
