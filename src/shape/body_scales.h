// The lengths and the speed that make a body dimensionless; docs/maintainers/physics.md, "Scales".
#pragma once

namespace lr::shape {

struct BodyScales {
    double d;  // m, characteristic length: the largest extent
    double b;  // m, thickness
    double l;  // m, turbulence length: half the depth of the layer of fluid that the body drags along broadside
    double u0; // m/s, speed_scale
};

// largest_extent, smallest_extent: m, along principal axes. projected_area: m^2, the largest over the principal axes.
// broadside_added_mass: m^3, along the axis of that projection, fluid density 1.
BodyScales body_scales(double largest_extent, double smallest_extent, double volume, double projected_area,
                       double broadside_added_mass, double density, double fluid_density);

// m/s, sqrt(|density ratio - 1| g b), paper Eq. 1; at least 1e-6.
double speed_scale(double density, double fluid_density, double thickness);

// m/s^2, standard gravity: only scales use it, motion uses the world's gravity.
inline constexpr double standard_gravity = 9.80665;

} // namespace lr::shape
