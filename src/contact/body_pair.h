// Where two bodies touch: pairs of convex hulls with roundings, most of them thin plates.
#pragma once

#include "contact/body_shape.h"

#include <cstdint>

namespace lr {

// What of a batch's bodies other bodies can touch: always the hull of points with a rounding. Ellipsoids become hulls too, flat
// ones plates.
struct MeetingShape {
    static constexpr uint32_t lanes = 4; // points are padded to whole vectors by repeating the first
    static constexpr uint32_t most = most_shape_points;

    BodyShape shape; // the hull at scale 1, in the body frame; never an ellipsoid
    // A box along the body axes that holds core and rounding; from the centre of mass.
    Vector middle, half;

    // The hull's own frame: z is across a plate. What pairs are computed in.
    Vector origin;  // m, body frame: the middle of the core's box
    Rotation frame; // takes vectors from the own frame to the body's
    bool flat;      // all z are 0
    uint32_t padded;
    alignas(16) float x[most], y[most], z[most];
    Vector core_half;                 // of the core's box along the own axes
    float core_reach;                 // m, of the core from `origin`
    Vector normals[most_shape_faces]; // of the faces of `shape`, in the own frame
    float offsets[most_shape_faces];  // m: inside normal . p <= offset
};
// May throw std::bad_alloc.
MeetingShape make_meeting_shape(const BodyShape& shape);

inline constexpr uint32_t most_pair_contacts = 4;
struct PairContact {
    Vector arm_a, arm_b; // m, body frames, true size, from the centres of mass: points of the surfaces
    Vector normal;       // world, unit, from b to a
    float gap;           // m, along the normal; negative: overlap
};

// Contacts nearer than `margin` (m, >= 0): the deepest, then those that hold the pair best. Returns how many. The same with a and
// b swapped, but for the sign of the normal. 0 where anything is not finite.
uint32_t find_pair_contacts(const MeetingShape& a, float scale_a, const Pose& at_a, const MeetingShape& b,
                            float scale_b, const Pose& at_b, float margin, PairContact (&out)[most_pair_contacts]);

struct Bounds {
    Vector low, high; // m
};
// The axis-parallel box about a placed body.
Bounds bounds(const MeetingShape& shape, float scale, const Pose& at);

} // namespace lr
