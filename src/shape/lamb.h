// Added mass of an ellipsoid in closed form. Lamb, Hydrodynamics, art. 114-115; docs/maintainers/physics.md, "Added mass".
#pragma once

#include <array>

namespace lr::shape {

// Carlson's symmetric elliptic integral R_D(x, y, z), x, y >= 0 (at most one zero), z > 0, to double precision.
// Carlson, Numerical Algorithms 10 (1995) 13-26.
double carlson_rd(double x, double y, double z);

struct EllipsoidAddedMass {
    std::array<double, 3> translation; // m^3, along each semi-axis, fluid density 1
    std::array<double, 3> rotation;    // m^5, about each semi-axis
};

// Semi-axes in m, each positive.
EllipsoidAddedMass lamb_added_mass(const std::array<double, 3>& semi_axes);

} // namespace lr::shape
