// Convex hull of points.
#pragma once

#include "asset/asset_data.h"
#include "baker/mesh/mesh.h"

namespace lr::baker {

struct ConvexHull {
    std::vector<Eigen::Vector3d> vertices; // a subset of the points, in their order
    std::vector<Face> faces;               // outward, closed, manifold
    double slack = 0.0;                    // m, largest distance of a point from the hull, outside it
};

// Flat input (a sheet) gives a two-sided polygon. Faults: fewer than three points, points on one line, points that are not
// finite.
bool compute_convex_hull(const std::vector<Eigen::Vector3d>& points, ConvexHull& out, Faults& faults);

// The hull in the asset's floats. If their rounding makes slivers concave by the asset's rules for a body of that length, the corners are first
// rounded to one spacing, and their exact hull is stored.
HullData store_hull(const ConvexHull& hull, double length);
} // namespace lr::baker
