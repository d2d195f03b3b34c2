// What of a batch's bodies can touch: the convex hull of a few points with a rounding around it, or an ellipsoid. At
// scale 1, in the body frame, from the centre of mass.
#pragma once

#include "contact/pose.h"
#include "format/asset_data.h"

#include <array>
#include <cstdint>

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
    // Points that are held against a heightfield: its own, and behind these some on its faces, which a ridge between two slopes would
    // else go through.
    uint32_t sample_count;
    float x[most_shape_samples], y[most_shape_samples], z[most_shape_samples]; // m
    float radius;                                                              // m, around the hull of the points
    uint32_t face_count; // of the hull of the points; a flat one has two
    ShapeFace faces[most_shape_faces];
    uint8_t corners[most_shape_corners]; // of the faces, counter-clockwise seen from outside: places of points
    Vector center;                       // m, of the ellipsoid; else the middle of the points
    Vector semi_axes;                    // m, of the ellipsoid, along the body axes
    float reach;                         // m: no part of it is farther from the centre of mass
    Vector extent;                       // m: nor along the body's axes
    float thickness;                     // m: its smallest width, rounding included
};

// The point of the core that is farthest along a direction, the first of equal ones. x, y, z: `count` > 0 of them.
inline uint32_t farthest_point(const float* x, const float* y, const float* z, uint32_t count, Vector d) {
    uint32_t best = 0;
    float most = d.x * x[0] + d.y * y[0] + d.z * z[0];
    for (uint32_t i = 1; i < count; ++i) {
        const float along = d.x * x[i] + d.y * y[i] + d.z * z[i];
        best = along > most ? i : best;
        most = along > most ? along : most;
    }
    return best;
}

// Of an asset: its hull, reduced to few points; without one an ellipsoid, or a box where the volume says so.
// extents: m, of a body that has no hull, along its axes about its centre of buoyancy; zero where nothing knows them, then
// they are those of the ellipsoid with its inertia. May throw std::bad_alloc.
BodyShape make_body_shape(const AssetData& asset, const std::array<double, 3>& extents = {});

} // namespace lr
