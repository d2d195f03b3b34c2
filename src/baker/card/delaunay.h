// Delaunay triangulation of points on an integer grid, where every predicate is exact.
#pragma once

#include "baker/mesh/mesh.h"

#include <cstdint>
#include <vector>

namespace lr::baker {

struct GridPoint {
    int32_t x, y; // within +-2^29, so that products of differences fit
    bool operator==(const GridPoint&) const = default;
};

constexpr int32_t max_grid_coordinate = 1 << 29;

// Twice the signed area of a triangle.
int64_t doubled_area(const GridPoint& a, const GridPoint& b, const GridPoint& c);

// points: distinct, not all on one line. Returns counter-clockwise faces that fill the convex hull, except for slivers of collinear points.
std::vector<Face> delaunay(const std::vector<GridPoint>& points);
} // namespace lr::baker
