// What the quasi-steady loads need to know of a mesh; docs/maintainers/physics.md, "Aerodynamic measures of a shape".
#pragma once

#include "asset/closed_forms/aerodynamic_coefficients.h"
#include "baker/mesh/mesh.h"

#include <Eigen/Core>

#include <array>

namespace lr::baker {

// axes: rows, unit vectors (shape::principal_axes); centre: of buoyancy, in the frame of the mesh. Silhouettes are true
// ones, also of bodies that hide parts of themselves. The volume is left to the caller.
// The mesh must be closed.
shape::AerodynamicGeometry mesh_geometry(const Mesh& mesh, const std::array<double, 9>& axes,
                                         const Eigen::Vector3d& centre);

// A sheet of this thickness about the mesh: both sides of its faces, and a rim along free edges.
shape::AerodynamicGeometry sheet_geometry(const Mesh& mesh, double thickness, const std::array<double, 9>& axes,
                                          const Eigen::Vector3d& centre);

} // namespace lr::baker
