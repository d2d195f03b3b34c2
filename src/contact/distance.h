// The distance between convex cores and where they are nearest (Gilbert, Johnson and Keerthi 1988), bounded in work.
#pragma once

#include "contact/placed.h"

namespace lr {

struct Nearest {
    bool overlap;                 // of the cores; nothing below is set then
    double distance;              // m, no less than `lower`, which is sure
    double lower;                 // m: along the normal the cores are this far apart
    Double3 normal;               // unit, from the collider to the body
    Double3 on_body, on_collider; // of the cores
};

// enough: m; stops as soon as the cores are known to be farther apart, and only `lower` and `normal` count then.
Nearest nearest_points(const PlacedBody& body, const PlacedCollider& collider, double enough);

// How far apart the cores are along a unit normal; negative where they overlap.
inline double separation_along(const PlacedBody& body, const PlacedCollider& collider, Double3 normal) {
    return dot(normal, body.support(-normal) - collider.support(normal));
}

} // namespace lr
