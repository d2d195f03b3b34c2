// Convex pairs: distance and nearest points of their cores, and the direction of largest separation or least depth.
#pragma once

#include "collision/local_pair.h"

namespace lr {

struct Nearest {
    bool overlap;                 // of the cores; then nothing below is set
    double distance;              // m, at least `lower`
    double lower;                 // m, certain: separation of the cores along the normal
    Double3 normal;               // unit, from the collider to the body
    Double3 on_body, on_collider; // of the cores
};

// GJK (Gilbert, Johnson and Keerthi 1988), bounded. enough: m; stops once the cores are farther apart; then only `lower` and `normal` are valid.
// guess: of the normal, unit; null: from the middle of the collider to that of the body.
Nearest nearest_points(const PlacedBody& body, const PlacedCollider& collider, double enough,
                       const Double3* guess = nullptr);

// Separation of the cores along a unit normal; negative if they overlap.
inline double separation_along(const PlacedBody& body, const PlacedCollider& collider, Double3 normal) {
    return dot(normal, body.support(-normal) - collider.support(normal));
}

struct Separation {
    Double3 normal;  // unit, from the collider to the body
    double distance; // m, of the cores along the normal; negative: penetration depth
    bool has_points; // the cores are apart, and their nearest points follow
    Double3 on_body, on_collider;
};

// Directions along which cores that overlap may part: normal . front > least, and normal . up > into_support. Without a restriction all. For a side of
// a triangle least is 0; then cores that do not overlap must part along them too.
struct Sides {
    Double3 front = {};
    double least = -1.0;
    Double3 up = {}; // away from what supports the body; zero: nothing does
};
inline constexpr double into_support = -0.7;
inline Double3 direction_of(Vector v) {
    const float size = length(v);
    return size > 0.0f ? 1.0 / static_cast<double>(size) * to_double(v) : Double3{};
}

Separation separate(const PlacedBody& body, const PlacedCollider& collider, const Nearest& nearest, const Sides& sides);
// enough: m; stops once the pair is known to be farther apart.
inline Separation separate(const PlacedBody& body, const PlacedCollider& collider, double enough,
                           const Sides& sides = {}) {
    return separate(body, collider, nearest_points(body, collider, enough), sides);
}

// Along the normals of the triangle's two sides, or of one only.
Separation separate_from_plane(const PlacedBody& body, const PlacedCollider& collider, Double3 normal, bool one_sided);
} // namespace lr
