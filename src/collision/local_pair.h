// A body and a convex collider as cores with a rounding. Origin: the body's centre of mass; axes: the collider's.
#pragma once

#include "collision/body_shape.h"
#include "collision/collider_geometry.h"

#include <cstdint>

namespace lr {

struct PlacedBody {
    const BodyShape* shape;
    Pose at; // in the collider's frame
    float scale;
    uint32_t count; // of points; 0: an ellipsoid
    float x[most_shape_points], y[most_shape_points], z[most_shape_points];
    float radius;   // around the core
    float reach;    // m, of the core about the centre of mass
    Vector center;  // of the core
    Vector axes[3]; // of an ellipsoid, as long as its semi-axes

    // size: scales the core about the centre of mass; 1 for the body itself.
    PlacedBody(const BodyShape& body, float body_scale, const Pose& pose, float size = 1.0f);

    Vector point(uint32_t i) const { return {x[i], y[i], z[i]}; }
    Double3 support(Double3 direction) const;
    uint32_t face_towards(Vector direction) const; // of bodies with corners
    Vector face_normal(uint32_t face) const { return rotate(at.rotation, shape->faces[face].normal); }
};

// Sizes at which the swept test tries a body's core, down to its centre of mass: the first one that does not overlap must stay in front.
inline constexpr float core_sizes[] = {1.0f, 0.5f, 0.0f};

// A collider's core: up to 3 points, a box or a hull. A capsule is two points with a radius.
struct PlacedCollider {
    uint32_t count = 0; // of points
    Double3 points[3] = {};
    Double3 origin = {}; // of the collider's frame
    Double3 half = {};   // of a box
    const HullGeometry* hull = nullptr;
    double radius = 0.0;

    PlacedCollider(const Geometry& geometry, Vector body_position);
    PlacedCollider(const Vector (&corners)[3], Vector body_position);

    Double3 support(Double3 direction) const;
    Double3 middle() const; // a point inside
};
} // namespace lr
