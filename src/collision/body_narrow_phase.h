// Narrow phase for two bodies: contacts of rounded convex hulls, most of them thin plates.
#pragma once

#include "collision/body_shape.h"
#include "collision/broad_face.h"

#include <cstdint>

namespace lr {

// The shape of a batch's bodies against other bodies: always a rounded hull of points. Flat ellipsoids become plates, others rounded solids.
struct PairHull {
    static constexpr uint32_t lanes = 4; // points are padded to whole vectors by repeating the first

    uint32_t padded;
    alignas(16) float x[most_shape_points], y[most_shape_points], z[most_shape_points]; // m
    BodyShape shape; // the hull at scale 1, in the body frame; never an ellipsoid

    // Pairs are computed in the hull's own frame: its origin is the middle of the core's box, and a plate lies in z = 0.
    Vector origin;    // m, body frame
    Rotation frame;   // takes vectors from the own frame to the body's
    Vector core_half; // m, of the core's box
    float core_reach; // m, of the core from `origin`
    // Faces of `shape` in m, the inside being normal . p <= offset; padded to whole vectors by repeating the first.
    alignas(16) float face_x[most_shape_faces], face_y[most_shape_faces], face_z[most_shape_faces];
    alignas(16) float face_offset[most_shape_faces];
    bool flat; // a plate: all z are 0
    // Corners of a plate in order, counter-clockwise about z.
    float ring_x[most_shape_points], ring_y[most_shape_points];
    BroadFace face;
    Vector point(uint32_t i) const { return {x[i], y[i], z[i]}; }
    Vector face_normal(uint32_t f) const { return {face_x[f], face_y[f], face_z[f]}; }
};
static_assert(most_shape_points % PairHull::lanes == 0 && most_shape_faces % PairHull::lanes == 0);
// May throw std::bad_alloc.
PairHull make_pair_hull(const BodyShape& shape);

// Limit of lr_batch_contact.min_thickness, as a share of the reach.
inline constexpr double most_thickened = 0.1;
// Thickens a plate to min_thickness (m; 0: by its reach). Thin sheets would pass each other's middle planes before the sweeps part them, and then
// leave on the wrong side.
PairHull thickened(PairHull hull, float min_thickness);

inline constexpr uint32_t most_pair_contacts = 4;
struct PairContact {
    Vector arm_a, arm_b; // m, body frames, true size: points on the surfaces, from the centres of mass
    Vector normal;       // world, unit, from b to a
    float gap;           // m, along the normal; negative: overlap
};

// A body during a substep.
struct PairBody {
    const PairHull* shape;
    float scale;
    Pose from, to;
    // m: displacement of the centre of mass, and of the farthest point about it.
    Vector shift;
    float turns;
    Vector turned[3]{}; // columns: the difference of the rotations at both ends
    // Upper bound of the displacement of any of its points.
    float way() const { return length(shift) + turns; }
    float reach() const { return scale * shape->shape.reach; }
};
PairBody pair_body(const PairHull& shape, float scale, const Pose& from, const Pose& to);

// Box about a placed body.
Box bounds(const PairHull& shape, float scale, const Pose& at);
} // namespace lr
