// The asset of a solid ellipsoid from closed forms, without mesh or file.
#pragma once

#include "asset/asset_data.h"
#include "asset/input_faults.h"

#include <array>

namespace lr::shape {

// Lengths and speed that make a body dimensionless; docs/maintainers/physics.md, "Scales".
struct BodyScales {
    double d;  // m, characteristic length: the largest extent
    double b;  // m, thickness
    double l;  // m, turbulence length: half the depth of the fluid carried along broadside
    double u0; // m/s, speed_scale
};

// largest_extent, smallest_extent: m, along principal axes. projected_area: m^2, the largest over the principal axes.
// broadside_added_mass: m^3, along the axis of that projection, fluid density 1.
BodyScales body_scales(double largest_extent, double smallest_extent, double volume, double projected_area,
                       double broadside_added_mass, double density, double fluid_density);

// m/s, sqrt(|density ratio - 1| g b), paper Eq. 1; at least 1e-6.
double speed_scale(double density, double fluid_density, double thickness);

// Whether low <= value <= high; if not, a numbered fault that names the field.
bool in_range(double value, double low, double high, const char* name, Faults& faults);

struct EllipsoidSpec {
    std::array<double, 3> semi_axes{};      // m
    double density = 0.0;                   // kg/m^3
    double fluid_density = 1.2;             // kg/m^3
    double fluid_viscosity = 1.5e-5;        // m^2/s
    double intensity = 1.0;                 // of the turbulence in k0 = 3/2 (I U0)^2
    std::array<double, 3> center_of_mass{}; // m, from the centre of the ellipsoid
};

// Mass, inertia, added mass, lengths, scales and hull; no turbulence table. False if a value is out of range, with a numbered fault for each.
bool ellipsoid_body(const EllipsoidSpec& spec, AssetData& out, Faults& faults);

// Lengths, silhouette and speed scale of a body as large as this ellipsoid. Needs volume, density, fluid. added_mass: m^3, fluid density 1.
void set_scales(const std::array<double, 3>& semi_axes, const std::array<double, 3>& added_mass, AssetData& asset);

// The decay of k and epsilon in a uniform stream (docs/maintainers/physics.md, "Turbulence tables"). Needs lengths, u0 and fluid.
TurbulenceData decay_table(const AssetData& asset, double intensity);
} // namespace lr::shape
