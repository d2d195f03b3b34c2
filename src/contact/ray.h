// Where a ray enters a body's shape or a collider. Everything in double: origins may be far from what they meet.
#pragma once

#include "contact/geometry_store.h"
#include "contact/placed.h"

namespace lr {

struct Ray {
    Double3 origin;    // m
    Double3 direction; // unit
};

struct RayHit {
    double distance; // m, along the ray
    Double3 normal;  // unit, out of what is hit; against the ray where it begins inside, at distance 0
};

// The part of a ray that lies in something convex; it begins with all that there is up to `last`.
struct RayPart {
    double first = 0.0, last = 0.0; // m
    Double3 normal = {};            // of what `first` is on; 0: the ray begins inside

    // Keeps what is in normal . x <= offset. False when nothing is left.
    bool clip(const Ray& ray, Double3 outward, double offset);
    RayHit hit(const Ray& ray) const { return {first, first > 0.0 ? normal : -ray.direction}; }
};

// Whether a ray meets, within `most` (m), what is behind `count` planes: plane(i, outward, offset).
template <class Plane>
bool ray_meets_planes(uint32_t count, const Plane& plane, const Ray& ray, double most, RayHit& hit) {
    RayPart part;
    part.last = most;
    for (uint32_t i = 0; i < count; ++i) {
        Double3 outward;
        double offset = 0.0;
        plane(i, outward, offset);
        if (!part.clip(ray, outward, offset)) return false;
    }
    hit = part.hit(ray);
    return true;
}

// What of the shape, `scale` times, at `at`, a ray meets first within `most` (m). False: nothing.
bool ray_meets_body(const BodyShape& shape, float scale, const Pose& at, const Ray& ray, double most, RayHit& hit);

// The ray is in the collider's frame. shared: null where the collider has none.
bool ray_meets_collider(const Geometry& geometry, const SharedGeometry* shared, const Ray& ray, double most,
                        RayHit& hit);

// Turns between the frame of a pose and the world.
Double3 turned(const Rotation& q, Double3 a);
Ray ray_in(const Pose& frame, const Ray& ray);

} // namespace lr
