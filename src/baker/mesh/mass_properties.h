// Exact integrals over a uniform solid bounded by triangles, or over a sheet of triangles.
#pragma once

#include "baker/mesh/mesh.h"

namespace lr::baker {

// For density 1; multiply the inertia by the density.
struct MassProperties {
    double volume = 0.0;             // m^3
    double area = 0.0;               // m^2, of the surface
    Eigen::Vector3d centroid;        // m
    Eigen::Matrix3d inertia;         // m^5, about the centroid, axes of the mesh
    Eigen::Vector3d principal;       // m^5, ascending
    Eigen::Matrix3d axes;            // columns: principal axes, right-handed, in the order of `principal`
    Eigen::Vector3d extents;         // m, size along each principal axis
    Eigen::Vector3d projected_areas; // m^2, 1/2 sum |n.a| A along each principal axis (exact for convex bodies)
    double max_projected_area = 0.0; // m^2
};

// The mesh must be closed and outward (check_and_repair).
MassProperties compute_mass_properties(const Mesh& mesh);

// Each triangle is a plate of this thickness about its plane. `area` is that of one side; the projected areas are exact
// if no part of the sheet hides another; the extents are those of the middle surface.
MassProperties compute_sheet_mass_properties(const Mesh& mesh, double thickness);

// Of a body whose first `solid_faces` faces bound solids and whose other faces are sheets, from its moments about the mesh's origin.
MassProperties combined_mass_properties(const Mesh& mesh, std::size_t solid_faces, double volume,
                                        const Eigen::Vector3d& first, const Eigen::Matrix3d& second);
} // namespace lr::baker
