// Rays against bodies and colliders. In double, since origins can be far away.
#pragma once

#include "collision/geometry_store.h"
#include "collision/local_pair.h"

namespace lr {

struct Ray {
    Double3 origin;    // m
    Double3 direction; // unit
};

struct RayHit {
    double distance; // m, along the ray
    Double3 normal;  // unit, outward; if the ray begins inside: against the ray, at distance 0
};

// The first hit within `most` (m) of the ray with the shape, `scale` times, at `at`. False if there is none.
bool ray_hits_body(const BodyShape& shape, float scale, const Pose& at, const Ray& ray, double most, RayHit& hit);

// The ray is in the collider's frame. shared: null if the collider has none.
bool ray_hits_collider(const Geometry& geometry, const SharedGeometry* shared, const Ray& ray, double most,
                       RayHit& hit);

bool ray_hits_part(const MeshGeometry& mesh, const ColliderPart& part, const Ray& ray, double most, RayHit& hit);

Ray ray_in(const Pose& frame, const Ray& ray);
} // namespace lr
