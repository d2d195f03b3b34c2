// Convex hull of points.
#pragma once

#include "baker/mesh/mesh.h"

namespace lr::baker {

struct ConvexHull {
    std::vector<Eigen::Vector3d> vertices; // a subset of the points, in their order
    std::vector<Face> faces;               // outward, closed, manifold
    double slack = 0.0;                    // m: no point lies further outside than this
};

// Flat input (a sheet) gives a two-sided polygon. False with a fault for fewer than three points, points on one line
// or non-finite points.
bool compute_convex_hull(const std::vector<Eigen::Vector3d>& points, ConvexHull& out, Faults& faults);

} // namespace lr::baker
