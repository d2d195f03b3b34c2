// What of a batch's bodies can touch: the convex hull of a few points with a rounding around it, or an ellipsoid. At
// scale 1, in the body frame, from the centre of mass.
#pragma once

#include "contact/pose.h"
#include "format/asset_data.h"

#include <cstdint>

namespace lr {

inline constexpr uint32_t most_shape_points = 32;

struct BodyShape {
    uint32_t count; // of points; 0: an ellipsoid
    float x[most_shape_points], y[most_shape_points], z[most_shape_points]; // m
    float radius;                                                         // m, around the hull of the points
    Vector center;    // m, of the ellipsoid; else the middle of the points
    Vector semi_axes; // m, of the ellipsoid, along the body axes
    float reach;      // m: no part of it is farther from the centre of mass
    float thickness;  // m: its smallest width, rounding included
};

// Of an asset: its hull, reduced to few points; without one an ellipsoid, or a box where the volume says so.
BodyShape make_body_shape(const AssetData& asset);

} // namespace lr
