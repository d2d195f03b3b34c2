// The contact shape of a batch's bodies: a rounded convex hull or an ellipsoid. At scale 1, body frame, from the centre of mass.
#pragma once

#include "asset/asset_data.h"
#include "base/convex_hull.h"
#include "base/pose.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace lr {

inline constexpr uint32_t most_shape_points = 32, most_shape_samples = most_shape_points + 16;
inline constexpr uint32_t most_shape_faces = 2 * most_shape_points - 4;
inline constexpr uint32_t most_shape_corners = 6 * most_shape_points - 12;

struct ShapeFace {
    Vector normal; // outward, unit
    float offset;  // m: inside normal . x <= offset
    uint8_t first, count;
};

struct BodyShape {
    uint32_t count; // of points; 0: an ellipsoid
    // Points tested against a heightfield: the hull's, then some on its faces, since a ridge between two slopes would pass between the corners.
    uint32_t sample_count;
    float x[most_shape_samples], y[most_shape_samples], z[most_shape_samples]; // m
    float radius;                                                              // m, around the hull of the points
    uint32_t face_count; // of the hull of the points; a flat hull has two
    ShapeFace faces[most_shape_faces];
    uint8_t corners[most_shape_corners]; // of the faces, counter-clockwise seen from outside: indices of points
    Vector center;                       // m, of the ellipsoid; else the middle of the points
    Vector semi_axes;                    // m, of the ellipsoid, along the body axes
    float reach;                         // m: greatest distance of the surface from the centre of mass
    Vector extent;                       // m: the same along each body axis
    float thickness;                     // m: smallest width, rounding included

    Vector point(uint32_t i) const { return {x[i], y[i], z[i]}; }
    Vector corner(const ShapeFace& face, uint32_t k) const { return point(corners[face.first + k]); }
    // Twice the face's area, along its normal.
    Vector doubled_area(const ShapeFace& face) const {
        const Vector first = corner(face, 0);
        Vector sum{0.0f, 0.0f, 0.0f};
        for (uint32_t k = 1; k + 1u < face.count; ++k)
            sum = sum + cross(corner(face, k) - first, corner(face, k + 1) - first);
        return sum;
    }
};

// m: of a hull, or the least radius of curvature of an ellipsoid. About a core so much smaller the shape can turn without a change of its surface there.
inline float rounding_of(const BodyShape& shape) {
    if (shape.count != 0) return shape.radius;
    const auto [least, most] = std::minmax({shape.semi_axes.x, shape.semi_axes.y, shape.semi_axes.z});
    return least * (least / most);
}

// The point farthest along a direction, the first among equals. x, y, z: `count` > 0 points, kStride apart.
template <size_t kStride = 1>
uint32_t farthest_point(const float* x, const float* y, const float* z, uint32_t count, Vector d) {
    uint32_t best = 0;
    float most = d.x * x[0] + d.y * y[0] + d.z * z[0];
    for (uint32_t i = 1; i < count; ++i) {
        const float along = d.x * x[i * kStride] + d.y * y[i * kStride] + d.z * z[i * kStride];
        best = along > most ? i : best;
        most = along > most ? along : most;
    }
    return best;
}

// Makes a solid hull of at most most_shape_points points. False if the points are flat.
bool set_hull(BodyShape& shape, const std::vector<shape::HullPoint>& points);
// Drops corners that stand out by at most `enough` (m), or by more while more than `most` are left.
void drop_corners(const std::vector<shape::HullPoint>& points, std::vector<uint32_t>& corners, double enough,
                  size_t most);
// Makes a plate: corners in its middle plane, counter-clockwise about the normal, and a rounding.
void set_outline(BodyShape& shape, const std::vector<shape::HullPoint>& corners, Double3 normal, double radius);

// Reduces the asset's hull to few points. Without a hull the shape is an ellipsoid, or a box if the volume nearly fills it. extents: m, of such a
// body, along its axes about its centre of buoyancy; zero: unknown, those of the ellipsoid with its inertia. May throw std::bad_alloc.
BodyShape make_body_shape(const AssetData& asset, const std::array<double, 3>& extents = {});
} // namespace lr
