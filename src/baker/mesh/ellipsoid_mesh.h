// A mesh of an ellipsoid for plots and the wake; its mass and added mass come from closed forms.
#pragma once

#include "baker/mesh/mesh.h"

#include <array>

namespace lr::baker {

// 8 * 4^levels triangles, outward. origin: of the mesh, relative to the ellipsoid's centre. The same bits on every machine.
Mesh ellipsoid_mesh(const std::array<double, 3>& semi_axes, const std::array<double, 3>& origin, int levels);
} // namespace lr::baker
