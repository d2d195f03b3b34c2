// A body against a collider, one pair at a time. Everything is in the collider's frame; see docs/maintainers/contact.md.
#pragma once

#include "collision/body_shape.h"
#include "collision/collider_geometry.h"

#include <cstdint>
#include <optional>

namespace lr {

inline constexpr uint32_t most_contacts = 8; // of one pair

struct Triangle;

struct Contact {
    Vector arm;    // m, body frame: the touching point of the body, from its centre of mass, at its true size
    Vector normal; // collider frame, unit: from the collider to the body
    float gap;     // m, along the normal; negative if they overlap
};

// Contacts where the body, `scale` times its shape, touches the collider or is closer than `margin`; for flat ellipsoids on round
// colliders also other rims up to a tenth of the reach and twice the depth farther. Writes at most most_contacts, those that
// hold it best; returns how many. Never misses a pair that overlaps. began: the pose at the beginning of the substep, which tells over which side of
// a box it came.
uint32_t find_contacts(const BodyShape& shape, float scale, const Pose& at, const Geometry& collider, ColliderPart part,
                       float margin, Contact* out, const Pose* began = nullptr);

// The free fraction of the way from one pose to the other, 0 to 1 (position linear, rotation by the normalised linear quaternion): up to there the
// pair is not closer than touching, to a tenth of the body's thickness or a hundredth of its reach. 1 if they do not touch, for planes, and for ways
// shorter than a quarter of the thickness, in which contacts miss nothing. If `from` already overlaps, the middle of the body stops when it has used
// up part of the core's remaining distance. Conservative advancement: the result can be too small.
float free_fraction(const BodyShape& shape, float scale, const Pose& from, const Pose& to, const Geometry& collider,
                    ColliderPart part);

// m: a lower bound of the distance of p from the collider's surface, at most 0 within.
float distance_from(const Geometry& g, Vector p);

// A side of a box or a hull: n . x = offset, with the solid below.
struct FlatSide {
    Vector normal;
    float offset;
};
// The side that is a plane for a body on a way: outside it at first, and over its inside, `far` or more from its edges, at both ends.
std::optional<FlatSide> flat_side(const Geometry& solid, Vector from, Vector to, float far);
// m: from the side to the opposite end of the solid.
float depth_below(const Geometry& solid, const FlatSide& side);

// The triangle of a mesh's part that leaves the least free fraction, the first of equals; free 1: none. Triangles for which skips(context,
// triangle, index) is true are passed over.
struct MetTriangle {
    float free;
    uint32_t index;
};
using SkipTriangle = bool (*)(const void* context, const Triangle& triangle, uint32_t index);
MetTriangle first_triangle(const BodyShape& shape, float scale, const Pose& from, const Pose& to,
                           const MeshGeometry& mesh, ColliderPart part, SkipTriangle skips, const void* context);
} // namespace lr
