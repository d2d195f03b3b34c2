// A body against a collider, one pair at a time. Everything is in the collider's frame; see docs/maintainers/contact.md.
#pragma once

#include "contact/body_shape.h"
#include "contact/geometry.h"

#include <cstdint>

namespace lr {

inline constexpr uint32_t most_contacts = 8; // of one pair

struct Contact {
    Vector arm;    // m, body frame: the body's point that touches, from its centre of mass, at its true size
    Vector normal; // collider frame, unit: from the collider to the body
    float gap;     // m, along the normal; negative where they overlap
};

// Part of a mesh: triangles [first, first + count). Other kinds have none.
struct ColliderPart {
    uint32_t first, count;
};

// Where the body, `scale` times its shape, touches the collider or is nearer to it than `margin`; of flat ellipsoids on what is
// round also other rims up to a tenth of the reach and twice the depth farther. Writes at most
// most_contacts of them, those that hold it best; returns how many. Never misses a pair that overlaps.
uint32_t find_contacts(const BodyShape& shape, float scale, const Pose& at, const Geometry& collider, ColliderPart part,
                       float margin, Contact* out);

// How much of the way from one pose to the other is free, 0 to 1: at that fraction (position linear, rotation by the
// normalised linear quaternion) the pair is not nearer than touching, and at no time before, to a tenth of the body's
// thickness or a hundredth of its reach. 1 where they do not meet, for planes, and for ways shorter than a quarter of the thickness, in
// which contacts miss nothing. Where `from` overlaps already it says how far the middle of the body stays on its side: until it
// has used up a part of what is left of the core's distance. Conservative advancement: it may say less than there is.
float free_fraction(const BodyShape& shape, float scale, const Pose& from, const Pose& to, const Geometry& collider,
                    ColliderPart part);

} // namespace lr
