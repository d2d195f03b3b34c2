// Where two bodies touch: pairs of convex hulls with roundings, most of them thin plates.
#pragma once

#include "contact/body_shape.h"

#include <cstdint>

namespace lr {

// What of a batch's bodies other bodies can touch: always the hull of points with a rounding. Ellipsoids become hulls too, flat
// ones plates.
struct MeetingShape {
    static constexpr uint32_t lanes = 4; // points are padded to whole vectors by repeating the first
    static constexpr uint32_t room = most_shape_points + lanes;

    uint32_t padded;                                                 // points, and room for the ends of the last edges
    alignas(16) float x[room], y[room], z[room];                     // m; counter-clockwise about z where flat
    alignas(16) float edge_x[room], edge_y[room], edge_offset[room]; // where flat: inside edge . p <= offset, edge unit
    // Of a plate: at most coarse_most points of the outline, between which contacts are spread.
    static constexpr uint32_t coarse_most = 8, coarse_room = coarse_most + 2 * lanes;
    alignas(16) float coarse_x[coarse_room], coarse_y[coarse_room];
    BodyShape shape; // the hull at scale 1, in the body frame; never an ellipsoid
    // A box along the body axes that holds core and rounding; from the centre of mass.
    Vector middle, half;

    // The hull's own frame, in which pairs are computed: its origin in the middle of the core's box, a plate in z = 0,
    // x along the box of least area about it.
    Vector origin;    // m, body frame
    Rotation frame;   // takes vectors from the own frame to the body's
    Vector center;    // m, mean of the points
    Vector core_half; // m, of the core's box
    float core_reach; // m, of the core from `origin`
    // Of the faces of `shape`, m: inside normal . p <= offset; padded to whole vectors by repeating the first.
    alignas(16) float face_x[most_shape_faces], face_y[most_shape_faces], face_z[most_shape_faces];
    alignas(16) float face_offset[most_shape_faces];
    uint32_t coarse_count;
    bool flat; // a plate: all z are 0
    Vector face_normal(uint32_t f) const { return {face_x[f], face_y[f], face_z[f]}; }
};
static_assert(most_shape_faces % MeetingShape::lanes == 0);
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

// About a placed body.
Box bounds(const MeetingShape& shape, float scale, const Pose& at);

} // namespace lr
