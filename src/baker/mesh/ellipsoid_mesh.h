// An ellipsoid as triangles, to look at and to put into a stream: its numbers are closed forms.
#pragma once

#include "baker/mesh/mesh.h"

#include <array>

namespace lr::baker {

// 8 * 4^levels triangles, outward. `origin`: of the mesh, from the centre of the ellipsoid. The same bits everywhere.
Mesh ellipsoid_mesh(const std::array<double, 3>& semi_axes, const std::array<double, 3>& origin, int levels);

} // namespace lr::baker
