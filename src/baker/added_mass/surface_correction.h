// The volume that flat triangles cut off a curved surface.
#pragma once

#include "baker/mesh/mesh.h"

namespace lr::baker {

// Faces that meet at a larger turn than this are two surfaces with an edge between them, not one curved surface. 66
// degrees: the rim of a 1:10 ellipsoid of 1280 triangles still counts as curved, a box does not, and no regular prism
// or polyhedron lies so close that rounding would decide.
constexpr double crease_cosine = 0.407;

// The shortest motion that moves each normal n by the offset s asked of it, in the least squares sense:
// normal_matrix = sum n n^T, right = sum n s. None in directions in which the normals say next to nothing.
Eigen::Vector3d least_motion(const Eigen::Matrix3d& normal_matrix, const Eigen::Vector3d& right);

// Of the curved surface that a mesh samples, from the faces around a vertex.
struct CornerNormal {
    Eigen::Vector3d round; // exact where the curvature is even (weights of Max 1999, J. Graphics Tools 4)
    Eigen::Vector3d broad; // near to that of the larger faces (weighted by area)
};

// At the corners of each face; corners at one vertex that no crease parts have the same.
std::vector<std::array<CornerNormal, 3>> corner_normals(const Mesh& mesh);

// The change of the normal along an edge, times the edge: eight times the height of the curve above its middle. Limited
// where the ends disagree, or the faces around one of them: there the mesh does not say how the turn is shared out.
double bend(const CornerNormal& from, const CornerNormal& to, const Eigen::Vector3d& along);

struct CurvedSurface {
    Mesh mesh;
    std::vector<double> gap; // of each face: mean distance of the curved surface from the triangle, along its normal
    std::vector<double>
        turn; // of each face: largest change of the normal between its corners, in radians for small ones
};

// Triangles whose corners lie on a smooth convex surface lie inside it: 0.9 % of the volume is missing from a sphere of
// 1280 triangles. Moves each vertex along the normal so that the triangles cross the surface they sample, with equal
// volume on both sides to second order in the turn. Flat faces and real edges (cube, box) stay as they are.
CurvedSurface restore_curved_volume(const Mesh& mesh);

} // namespace lr::baker
