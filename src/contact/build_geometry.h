// Geometry for colliders from what callers have: done once, when a collider is made. All are pure functions; those that
// return false leave their outputs unspecified. May throw std::bad_alloc.
#pragma once

#include "contact/pose.h"
#include "shape/convex_hull.h"

#include <cstdint>
#include <vector>

namespace lr {

inline constexpr uint32_t most_hull_vertices = 256;

// The convex hull of `count` points (m, 3 floats each): its corners, and its faces as 4 floats each, see HullGeometry. False:
// fewer than 4 or more than most_hull_vertices points, not finite, or flat (thinner than 1e-4 of its largest extent).
bool build_hull(const float* vertices, uint32_t count, std::vector<float>& hull_vertices, std::vector<float>& faces);

// The planes of a hull that is not flat, each once, largest triangle first.
struct HullPlane {
    Double3 normal; // outward, unit
    double offset;  // m: no corner has normal . x over it
};
std::vector<HullPlane> hull_planes(const std::vector<shape::HullPoint>& points, const shape::ConvexHull& hull);

// What MeshGeometry has beside its vertices and triangles: a unit normal for each triangle, zero for those without an area,
// and the edges that nothing can touch alone. False: an index out of range, a vertex that is not finite, or no triangle
// with an area.
bool build_mesh(const float* vertices, uint32_t vertex_count, const uint32_t* indices, uint32_t triangle_count,
                std::vector<float>& normals, std::vector<uint8_t>& hidden_edges);

// The coarse heights of a HeightfieldGeometry. False: fewer than 2 samples along a side, or a height that is not finite.
bool build_coarse(const uint32_t (&counts)[2], const float* heights, std::vector<float>& coarse,
                  uint32_t (&coarse_counts)[2], float& lowest, float& highest);
// The secant of the angle of the steepest triangle, or a little more: along the surface nothing rises faster than the root of its square
// less 1.
float steepest_secant(const uint32_t (&counts)[2], const float (&spacing)[2], const float* heights);

} // namespace lr
