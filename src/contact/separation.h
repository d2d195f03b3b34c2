// The direction along which a convex pair is farthest apart, or overlaps least.
#pragma once

#include "contact/distance.h"

namespace lr {

struct Separation {
    Double3 normal;  // unit, from the collider to the body
    double distance; // m, of the cores along it; negative: how deep they are in each other
    bool has_points; // the cores are apart, and these are where they are nearest
    Double3 on_body, on_collider;
};

// Sides of a triangle that can be met: all, or that to which `front` points only.
struct Sides {
    bool one = false;
    Double3 front = {};
};

// enough: m; of pairs known to be farther apart no more is found out.
Separation separate(const PlacedBody& body, const PlacedCollider& collider, double enough, const Sides& sides = {});

// Along the two sides of a triangle only, or the one.
Separation separate_from_plane(const PlacedBody& body, const PlacedCollider& collider, Double3 normal, bool one_sided);

} // namespace lr
