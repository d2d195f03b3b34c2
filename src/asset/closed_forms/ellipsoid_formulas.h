// Added mass, creeping flow and surface of an ellipsoid, in closed form or by quadrature. Semi-axes in m, positive unless stated otherwise.
#pragma once

#include "asset/closed_forms/aerodynamic_coefficients.h"

#include <array>

namespace lr::shape {

// Carlson's symmetric elliptic integrals R_D(x, y, z), x, y >= 0 (at most one zero), z > 0, and R_F(x, y, z), at most one argument
// zero, to double precision. Carlson, Numerical Algorithms 10 (1995) 13-26.
double carlson_rd(double x, double y, double z);
double carlson_rf(double x, double y, double z);

// Lamb, Hydrodynamics, art. 114-115; docs/maintainers/physics.md, "Added mass".
struct EllipsoidAddedMass {
    std::array<double, 3> translation; // m^3, along each semi-axis, fluid density 1
    std::array<double, 3> rotation;    // m^5, about each semi-axis
};
EllipsoidAddedMass lamb_added_mass(const std::array<double, 3>& semi_axes);

// Oberbeck, J. reine angew. Math. 81 (1876); Jeffery, Proc. R. Soc. A 102 (1922); Happel & Brenner, Low Reynolds Number Hydrodynamics,
// ch. 5. docs/maintainers/physics.md, "Aerodynamic measures of a shape".
struct StokesResistance {
    std::array<double, 3> translation; // m: force over dynamic viscosity and speed, 6 pi a for a sphere
    std::array<double, 3> rotation;    // m^3: moment over dynamic viscosity and angular velocity, 8 pi a^3
};
// One semi-axis can be zero: an elliptic disc. Two zeros become a needle a millionth as thick as long, because a line has no resistance.
StokesResistance stokes_resistance(const std::array<double, 3>& semi_axes);

// Axes of the body, centre of buoyancy at the centre.
AerodynamicGeometry ellipsoid_geometry(const std::array<double, 3>& semi_axes);
} // namespace lr::shape
