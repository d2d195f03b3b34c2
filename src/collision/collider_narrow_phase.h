// Narrow phase: a body against a collider, one pair at a time, in the collider's frame. docs/maintainers/contact.md, section 3.
#pragma once

#include "collision/body_shape.h"
#include "collision/collider_geometry.h"

#include <cstdint>
#include <optional>

namespace lr {

inline constexpr uint32_t most_contacts = 8; // of one pair

struct Triangle;

struct Contact {
    Vector arm;    // m, body frame, true size: the body's touching point, from its centre of mass
    Vector normal; // collider frame, unit: from the collider to the body
    float gap;     // m, along the normal; negative if they overlap
};

// Finds contacts closer than `margin`; never misses a pair that overlaps. On round colliders a flat ellipsoid also gets contacts on its other rims,
// up to a tenth of the reach and twice the depth farther. Writes at most most_contacts, those that hold the body best, and returns their number.
// began: the pose at the beginning of the substep, to keep the body on its side of a thin thing. lift: away from what supports the body, collider frame;
// zero: nothing. Overlapping cores do not part against it.
// Not for meshes.
uint32_t find_contacts(const BodyShape& shape, float scale, const Pose& at, const Geometry& collider, float margin,
                       Contact* out, const Pose* began = nullptr, Vector lift = {});

// Swept test by conservative advancement: the fraction of the path, 0 to 1, up to which the pair stays apart, to a tenth of the body's thickness or a
// hundredth of its reach. Never too large, may be too small. Position is linear, rotation the normalised linear quaternion. 1 for planes, and for
// paths below a quarter of the thickness, on which nothing is jumped. If `from` overlaps, the core or a shrunk core keeps a part of its distance. Not
// for meshes.
float free_fraction(const BodyShape& shape, float scale, const Pose& from, const Pose& to, const Geometry& collider);

// m: lower bound of the distance between p and the surface; not positive inside.
float distance_from(const Geometry& g, Vector p);

// A side of a box or a hull, n . x = offset, solid below.
struct FlatSide {
    Vector normal;
    float offset;
};
// The side that acts as a plane for a body outside it at first, if the whole path lies over the side, at least `far` from its edges.
std::optional<FlatSide> flat_side(const Geometry& solid, Vector from, Vector to, float far);
// The triangle of a mesh part that leaves the least free fraction, the first among equals; free 1: none. Triangles with skips(context, triangle,
// index) are left out.
struct MetTriangle {
    float free;
    uint32_t index;
};
using SkipTriangle = bool (*)(const void* context, const Triangle& triangle, uint32_t index);
MetTriangle first_triangle(const BodyShape& shape, float scale, const Pose& from, const Pose& to,
                           const MeshGeometry& mesh, ColliderPart part, SkipTriangle skips, const void* context);
} // namespace lr
