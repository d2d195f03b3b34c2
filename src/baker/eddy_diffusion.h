// Implicit diffusion of a field of a MAC grid with a viscosity that varies in space.
#pragma once

#include "baker/mac_grid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lr::baker {

class EddyDiffusion {
public:
    enum class Wall {
        no_slip, // the field has the value of the solid at it
        no_flux  // nothing passes into the solid
    };

    // d(field)/dt = div(viscosity grad field) over dt. One viscosity per sample, zero inside solids. Prescribed samples
    // keep their value; the ends of the domain have no flux. One axis after the other, each implicit: stable at any
    // viscosity, and positive fields stay positive.
    void apply(GridField& field, const std::vector<uint8_t>& prescribed, const std::vector<double>& viscosity,
               Wall wall, double dt);

private:
    std::vector<double> link_, upper_, right_;
};

} // namespace lr::baker
