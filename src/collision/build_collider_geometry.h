// Builds geometry of colliders from the caller's data, once, when a collider is created. The API has checked that numbers are finite
// and counts and indices in range. All are pure functions; outputs are unspecified if one returns false. May throw std::bad_alloc.
#pragma once

#include "base/convex_hull.h"
#include "collision/collider_geometry.h"

#include <cstdint>
#include <vector>

namespace lr {

// The arrays that HullGeometry points to.
struct BuiltHull {
    std::vector<float> vertices, faces;
    std::vector<uint32_t> corners;

    HullGeometry geometry() const {
        return {static_cast<uint32_t>(vertices.size() / 3), static_cast<uint32_t>(faces.size() / 4), vertices.data(),
                faces.data(), corners.data()};
    }
};
// The convex hull of `count` points (m, 3 floats each). False: flat (thinner than 1e-4 of its largest extent).
bool build_hull(const float* vertices, uint32_t count, BuiltHull& out);

inline Double3 of(const shape::HullPoint& p) {
    return {p[0], p[1], p[2]};
}
// m, the largest along an axis.
double extent_of(const std::vector<shape::HullPoint>& points);
// Orders some of the points, about in a plane, counter-clockwise around its normal; the first stays first.
void put_in_turn(const std::vector<shape::HullPoint>& points, Double3 normal, std::vector<uint32_t>& corners);
// The faces of a hull that is not flat, each once, largest triangle first.
struct HullFace {
    Double3 normal;                // outward, unit
    double offset;                 // m: bound of normal . x over all corners
    double width;                  // m, of the hull along the normal
    std::vector<uint32_t> corners; // indices of the hull's points, counter-clockwise seen from outside
};
std::vector<HullFace> hull_faces(const std::vector<shape::HullPoint>& points, const shape::ConvexHull& hull);

// The rest of a MeshGeometry: a unit normal for each triangle, zero without area, and the hidden edges. False if no triangle has an area.
bool build_mesh(const float* vertices, uint32_t vertex_count, const uint32_t* indices, uint32_t triangle_count,
                std::vector<float>& normals, std::vector<uint8_t>& hidden_edges);

inline constexpr uint32_t most_part_triangles = 8;
// Reorders triangles (3 indices each, in range) so that neighbours are adjacent, and divides them into parts; large ones are alone. Deterministic.
void make_mesh_parts(const float* vertices, uint32_t* indices, uint32_t triangle_count, std::vector<MeshPart>& parts);

// The coarse heights of a HeightfieldGeometry.
void build_coarse(const uint32_t (&counts)[2], const float* heights, std::vector<float>& coarse,
                  uint32_t (&coarse_counts)[2], float& lowest, float& highest);
// The secant of the angle of the steepest triangle, or slightly more: the surface's slope is at most sqrt(secant^2 - 1).
float steepest_secant(const uint32_t (&counts)[2], const float (&spacing)[2], const float* heights);
} // namespace lr
