// Geometry of a mesh for the quasi-steady loads; docs/maintainers/physics.md, "Aerodynamic measures of a shape".
#pragma once

#include "asset/closed_forms/aerodynamic_coefficients.h"
#include "baker/mesh/mesh.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace lr::baker {

// The mesh must be closed. axes: rows, unit vectors (shape::principal_axes); centre: of buoyancy, in the frame of the mesh. Silhouettes are exact
// also for bodies that hide parts of themselves. The caller sets the volume.
shape::AerodynamicGeometry mesh_geometry(const Mesh& mesh, const std::array<double, 9>& axes,
                                         const Eigen::Vector3d& centre);

// For a sheet of this thickness: both sides of the faces, and a rim along free edges. The first `solid_faces` faces bound solids and have one side.
shape::AerodynamicGeometry sheet_geometry(const Mesh& mesh, double thickness, const std::array<double, 9>& axes,
                                          const Eigen::Vector3d& centre, std::size_t solid_faces = 0);
} // namespace lr::baker
