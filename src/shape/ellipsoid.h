// A whole asset for a solid ellipsoid from closed forms, without mesh or file.
#pragma once

#include "format/asset_data.h"
#include "format/fault.h"

#include <array>

namespace lr::shape {

struct EllipsoidSpec {
    std::array<double, 3> semi_axes{};      // m
    double density = 0.0;                   // kg/m^3
    double fluid_density = 1.2;             // kg/m^3
    double fluid_viscosity = 1.5e-5;        // m^2/s
    double intensity = 1.0;                 // of the turbulence in k0 = 3/2 (I U0)^2
    std::array<double, 3> center_of_mass{}; // m, from the centre of the ellipsoid
};

// Mass, inertia, added mass, lengths, scales and hull; the turbulence table is left empty.
// False when a value is out of range, with a numbered fault for each.
bool ellipsoid_body(const EllipsoidSpec& spec, AssetData& out, Faults& faults);

// Lengths, silhouette and speed scale of a body as large as this ellipsoid. added_mass: m^3, along its axes, fluid density
// 1. Needs volume, density and fluid.
void set_scales(const std::array<double, 3>& semi_axes, const std::array<double, 3>& added_mass, AssetData& asset);

// The decay of k and epsilon in a uniform stream, closed form (docs/maintainers/physics.md, "Turbulence tables"): what the MAC grid
// computes for an empty stream. Needs lengths, u0 and fluid.
TurbulenceData decay_table(const AssetData& asset, double intensity);

} // namespace lr::shape
