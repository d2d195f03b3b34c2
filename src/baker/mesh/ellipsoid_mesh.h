// An ellipsoid as triangles, to look at: its numbers are closed forms.
#pragma once

#include "baker/mesh/mesh.h"

#include <array>

namespace lr::baker {

// `origin`: of the mesh, from the centre of the ellipsoid.
Mesh ellipsoid_mesh(const std::array<double, 3>& semi_axes, const std::array<double, 3>& origin);

} // namespace lr::baker
