// Creeping flow about an ellipsoid in closed form. Oberbeck, J. reine angew. Math. 81 (1876); Jeffery, Proc. R. Soc. A 102
// (1922); Happel & Brenner, Low Reynolds Number Hydrodynamics, ch. 5. docs/maintainers/physics.md, "Aerodynamic measures of a shape".
#pragma once

#include <array>

namespace lr::shape {

// Carlson's symmetric elliptic integral R_F(x, y, z), at most one argument zero, to double precision.
// Carlson, Numerical Algorithms 10 (1995) 13-26.
double carlson_rf(double x, double y, double z);

struct StokesResistance {
    std::array<double, 3> translation; // m: force over dynamic viscosity and speed, 6 pi a for a sphere
    std::array<double, 3> rotation;    // m^3: moment over dynamic viscosity and angular velocity, 8 pi a^3
};

// Semi-axes in m, the two larger ones positive. One that is zero gives an elliptic disc; two are taken for a needle a
// millionth as thick as long, since a line has no resistance.
StokesResistance stokes_resistance(const std::array<double, 3>& semi_axes);

} // namespace lr::shape
