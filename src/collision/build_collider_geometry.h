// Builds collider geometry from the caller's data, once, when a collider is created. The API has checked that numbers are finite and indices in
// range. Pure functions: if one returns false its outputs are unspecified. May throw std::bad_alloc.
#pragma once

#include "base/convex_hull.h"
#include "collision/collider_geometry.h"

#include <cstdint>
#include <vector>

namespace lr {

// Storage of a HullGeometry.
struct BuiltHull {
    std::vector<float> vertices, faces;
    std::vector<uint32_t> corners;

    HullGeometry geometry() const {
        return {static_cast<uint32_t>(vertices.size() / 3), static_cast<uint32_t>(faces.size() / 4), vertices.data(),
                faces.data(), corners.data()};
    }
};
// Convex hull of `count` points (m, 3 floats each). False if it is flat: thinner than 1e-4 of its largest extent.
bool build_hull(const float* vertices, uint32_t count, BuiltHull& out);

inline Double3 of(const shape::HullPoint& p) {
    return {p[0], p[1], p[2]};
}
// m, the largest extent along an axis.
double extent_of(const std::vector<shape::HullPoint>& points);
// Orders coplanar points counter-clockwise around the normal, beginning with the first.
void put_in_turn(const std::vector<shape::HullPoint>& points, Double3 normal, std::vector<uint32_t>& corners);
// The faces of a solid hull. Coplanar triangles are one face; faces with the largest triangles come first.
struct HullFace {
    Double3 normal;                // outward, unit
    double offset;                 // m: greatest normal . x over all corners
    double width;                  // m, of the hull along the normal
    std::vector<uint32_t> corners; // indices of the hull's points, counter-clockwise seen from outside
};
std::vector<HullFace> hull_faces(const std::vector<shape::HullPoint>& points, const shape::ConvexHull& hull);

// Completes a MeshGeometry: unit normals (zero for triangles without area) and hidden edges. False if no triangle has an area.
bool build_mesh(const float* vertices, uint32_t vertex_count, const uint32_t* indices, uint32_t triangle_count,
                std::vector<float>& normals, std::vector<uint8_t>& hidden_edges);

inline constexpr uint32_t most_part_triangles = 8;
// Reorders triangles (3 indices each) so that neighbours are adjacent, and divides them into parts; large triangles are parts of their own.
void make_mesh_parts(const float* vertices, uint32_t* indices, uint32_t triangle_count, std::vector<MeshPart>& parts);

void build_coarse(const uint32_t (&counts)[2], const float* heights, std::vector<float>& coarse,
                  uint32_t (&coarse_counts)[2], float& lowest, float& highest);
// Secant of the steepest triangle's angle, rounded up: the surface's slope is at most sqrt(secant^2 - 1).
float steepest_secant(const uint32_t (&counts)[2], const float (&spacing)[2], const float* heights);
} // namespace lr
