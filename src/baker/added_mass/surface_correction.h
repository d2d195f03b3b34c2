// Restores the volume that flat triangles cut off a curved surface.
#pragma once

#include "baker/mesh/mesh.h"

#include <array>

namespace lr::baker {

// Faces whose normals differ by a larger angle form a crease, not one curved surface. 66 degrees: the rim of a 1:10 ellipsoid of 1280 triangles
// counts as curved, a box does not, and no regular prism or polyhedron is near enough for rounding to decide.
constexpr double crease_cosine = 0.407;

// The shortest motion with offset s along each normal n, in the least squares sense: normal_matrix = sum n n^T, right = sum n s. Zero in directions
// that the normals hardly determine.
Eigen::Vector3d least_motion(const Eigen::Matrix3d& normal_matrix, const Eigen::Vector3d& right);

// Normals of the curved surface that a mesh samples, from the faces around a vertex.
struct CornerNormal {
    Eigen::Vector3d round; // exact for constant curvature (weights of Max 1999, J. Graphics Tools 4)
    Eigen::Vector3d broad; // weighted by area: near that of the larger faces
    double smooth = 1.0;   // 0: facets, 1: a sample of a curved surface
};

// Normals at the corners of each face, shared at a vertex except across a crease.
std::vector<std::array<CornerNormal, 3>> corner_normals(const Mesh& mesh);

// For each side of a face, from corner k to the next: the change of the normal along it, times the side, or eight times the height of the curve above
// its midpoint. Limited where the two ends, or the faces around one end, disagree, because the mesh then does not define where the surface turns.
struct FaceBends {
    std::array<double, 3> used{}; // of the surface that is solved
    // Possible difference from `used`: as a facet without any bend, or as a smooth surface to the degree that it is one.
    std::array<double, 3> doubtful{};
};
FaceBends bends_of(const Mesh& mesh, const Face& face, const std::array<CornerNormal, 3>& normals);

struct CurvedSurface {
    Mesh mesh;
    std::vector<double> gap;   // of each face: mean distance of the curved surface from the triangle, along its normal
    std::vector<double> doubt; // of each face: uncertainty of `gap`
    // Of each face: mean square of the uncertainty of its slope, in its plane.
    std::vector<Eigen::Matrix3d> tilt;
    std::vector<double> turn; // of each face: largest change of the normal between its corners, in radians if small
};

// Triangles with corners on a smooth convex surface are inside it: a sphere of 1280 triangles lacks 0.9 % of the volume. Moves each vertex along the
// normal so that the triangles cross the sampled surface, with equal volume on both sides to second order in the turn. Flat faces and real edges
// (cube, box) stay unchanged.
CurvedSurface restore_curved_volume(const Mesh& mesh);
} // namespace lr::baker
