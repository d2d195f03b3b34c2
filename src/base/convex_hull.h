// Convex hulls by quickhull with exact integer orientations: the same bits on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace lr::shape {

using HullPoint = std::array<double, 3>;
using HullTriangle = std::array<uint32_t, 3>;

struct ConvexHull {
    std::vector<uint32_t> points;        // numbers of the input points that are corners, ascending
    std::vector<HullTriangle> triangles; // of corners (places in `points`), closed and wound outward
    bool flat = false;                   // a polygon with two sides
    double slack = 0.0;                  // m, largest distance of an input point from the hull, outside it
};
enum class HullOutcome { done, not_finite, too_few, one_point, one_line, not_closed, too_costly };

// `too_costly` after `most_faces` faces were made: with a flat round side the time grows as the square of its corners.
HullOutcome convex_hull(const std::vector<HullPoint>& points, ConvexHull& out, std::size_t most_faces = SIZE_MAX);

// Without a tolerance, for points that are whole numbers below 2^grid_bits.
using GridPoint = std::array<int64_t, 3>;
inline constexpr int grid_bits = 24;
HullOutcome exact_hull(const std::vector<GridPoint>& points, ConvexHull& out);
} // namespace lr::shape
