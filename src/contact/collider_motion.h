// Where a collider goes in a step, and a box around all of its way.
#pragma once

#include "contact/geometry_store.h"

namespace lr {

// A box in a collider's own frame, with a rounding around it.
struct LocalBounds {
    Box box;
    float round; // m
};

LocalBounds bounds_of(const Geometry& geometry, const SharedGeometry* shared);

// Around all poses between two, as Colliders interpolates them.
Box swept_box(const LocalBounds& local, const Pose& begin, const Pose& end, bool moves);

// m: no point within `local` is ever farther than this from where it is at the beginning.
float most_travel(const Box& local, const Pose& begin, const Pose& end);

// After dt at these velocities. rest: what rounding has taken from the position, here and so far.
Pose advanced(const Pose& from, Vector linear, Vector angular, double dt, Vector& rest);

// The same orientation by the quaternion that is nearer to `to`.
Rotation nearer_to(const Rotation& to, const Rotation& q);

} // namespace lr
