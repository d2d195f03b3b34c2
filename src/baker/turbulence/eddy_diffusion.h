// Implicit diffusion of a field of a MAC grid with a viscosity that varies in space.
#pragma once

#include "baker/turbulence/mac_grid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lr::baker {

// How much of the way from a sample to the one before it along each axis is barred by a wall halfway, in halves: 0 to 2.
// One per sample; empty: no walls.
using WallShares = std::array<std::vector<uint8_t>, 3>;

// Of the samples on the faces across `axis`, or (3) of a field on the cells.
WallShares find_wall_shares(const MacGrid& grid, size_t axis);

class EddyDiffusion {
public:
    enum class Wall {
        no_slip, // the field is zero on it
        no_flux  // nothing passes it
    };

    // d(field)/dt = div(viscosity grad field) over dt. One viscosity per sample, zero inside solids. Prescribed samples
    // keep their value; the ends of the domain have no flux. One axis after the other, each implicit: stable at any
    // viscosity, and positive fields stay positive.
    void apply(GridField& field, const std::vector<uint8_t>& prescribed, const std::vector<double>& viscosity,
               Wall wall, double dt, const WallShares& walls = {});

    // The same without the error of taking the axes one by one, which grows near edges as the grid is refined: by conjugate
    // gradients from `guess` (which has the prescribed values), until no residual exceeds `tolerance`.
    void apply_unsplit(GridField& field, const std::vector<double>& guess, const std::vector<uint8_t>& prescribed,
                       const std::vector<double>& viscosity, Wall wall, double dt, const WallShares& walls,
                       double tolerance);

private:
    void multiply(const std::vector<double>& x, std::vector<double>& y) const;

    std::vector<double> upper_, link_;
    // Of the whole system, with a layer of zeros before and after it; [a][s] joins sample s to the one before it along a.
    size_t stride_[3] = {0, 0, 0}, first_ = 0, last_ = 0;
    std::array<std::vector<double>, 3> links_;
    std::vector<double> diagonal_, free_, solution_, residual_, direction_, image_;
};

} // namespace lr::baker
