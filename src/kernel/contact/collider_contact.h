// Contact with colliders as the kernel sees it: which bodies can touch a collider within a step, and how contact moves them.
#pragma once

#include "base/lane_arrays.h"
#include "kernel/body_constants.h"

#include <cstddef>
#include <cstdint>

namespace lr {

// A uniform grid without bounds: cells near finite colliders, hashed into bits. A body centred in an unmarked cell touches nothing within `dilation`.
struct OccupancyLevel {
    float inverse_cell; // 1/m
    float dilation;     // m, margin around colliders
    const uint32_t* bits;
    uint32_t mask; // words - 1, a power of two less one
};
inline constexpr uint32_t most_occupancy_levels = 8;
inline constexpr float most_cells = 1e9f; // cell numbers beyond are clamped to this

// Bit h & 31 of word (h >> 5) & mask. The kernel's vectors compute the same hash.
constexpr uint32_t cell_hash(int32_t x, int32_t y, int32_t z) {
    uint32_t h = static_cast<uint32_t>(x) * 0x9e3779b1u ^ static_cast<uint32_t>(y) * 0x85ebca77u ^
                 static_cast<uint32_t>(z) * 0xc2b2ae3du;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    return h ^ h >> 13;
}

struct NearPlane {
    float point[3], normal[3]; // at its nearest to bodies in the step
    float travel;              // m, displacement of the plane in the step
};
// Samples of a heightfield in its own frame. heights: null for a plane.
struct HeightGrid {
    const float* heights;
    uint32_t counts[2];
    float inverse_spacing[2]; // 1/m
    float secant;             // of its steepest slope
};
// A heightfield. Bodies above `coarse`, or farther above it than its slopes can rise, are far.
struct NearHeightfield {
    float position[3], axes[9]; // rows: its own axes in the world
    float travel;               // m, largest displacement of its points in the step
    float inverse_coarse[2];    // 1/m
    float coarse_size;          // m, the smaller side of a square
    uint32_t counts[2];
    const float* coarse;
    float highest, extent[2];
    HeightGrid grid;
};
inline constexpr uint32_t most_near_planes = 16, most_near_heightfields = 16;

// All colliders of a world in a step. Colliders without room here set `everywhere`.
struct NearColliders {
    uint32_t level_count, plane_count, heightfield_count;
    bool everywhere; // every body can be near
    OccupancyLevel levels[most_occupancy_levels];
    NearPlane planes[most_near_planes];
    NearHeightfield heightfields[most_near_heightfields];
};

// The contact shape of a body at scale 1 (collision/body_shape.h).
struct ShapeConstants {
    uint32_t count, sample_count; // number of points, 0: an ellipsoid; of samples against heightfields, points first
    const float *x, *y, *z;
    float radius;
    float center[3], semi_axes[3];
    float reach;
};

// Marks in `near` the bodies of [begin, end) that can touch a collider within `dt`: near_bits by the grids (this depends on when they were built),
// near_ground by planes and heightfields; others get 0. speed: m/s that a body can gain in the step.
inline constexpr uint32_t near_bits = 1, near_ground = 2;
using NearCollidersFunction = void (*)(const NearColliders&, float reach, float dt, float speed, const BatchArrays&,
                                       size_t begin, size_t end, uint32_t* near);

inline constexpr size_t most_ground_points = 48;
inline constexpr size_t contact_lanes = lane_block;
inline constexpr uint32_t contact_slots = 16, manifold_slots = 4;
inline constexpr float no_contact = 1e30f; // m, gap of an empty slot

using LaneRow = float[contact_lanes];

// Contacts of contact_lanes bodies, one slot per body and contact. A body's slots can have gaps between them.
struct ContactSlots {
    uint32_t used; // slots that any body uses
    struct Slot {
        alignas(64) LaneRow arm[3]; // m, body frame, from the centre of mass
        LaneRow normal[3];          // world, unit, from the collider to the body
        LaneRow gap;                // m, at the end of the substep
        LaneRow surface[3];         // m/s, velocity of the collider at the contact
        LaneRow lag[3];             // m, its displacement in the substep less h times `surface`
        LaneRow friction, restitution;
        LaneRow impulse;                  // out: normal impulse over the body's mass unit, m/s; negative: no contact
        uint32_t collider[contact_lanes]; // its slot
    } slot[contact_slots];
};

// A plane (y = 0) or a heightfield at the end of a substep.
struct GroundSurface {
    float position[3], axes[9];  // rows: its own axes in the world
    float velocity[3], spin[3];  // m/s at `position`; rad/s, world
    float friction, restitution; // of the pair
    uint32_t collider;
    HeightGrid grid;
};

// Bodies [0, count) of `arrays` after a substep, and their state before it.
struct ContactBodies {
    const BodyConstants* body;
    ShapeConstants shape;
    float h;       // s, the substep
    float gravity; // m/s^2, its magnitude
    float rolling; // resistance to rolling and spinning: moment over normal force and reach
    BatchArrays arrays;
    const LaneRow* before; // state before: position, orientation, velocity, spin: 13 rows, fields from field_x on
    size_t count;          // of lanes, padded
};
inline constexpr size_t pose_fields = field_scale;

// Writes up to manifold_slots contacts of each body with the surface; returns false, and writes nothing, if there are none. rough: 1 for bodies on
// more than one slope of a heightfield, which need exact contacts.
using GroundFunction = bool (*)(const ContactBodies&, const GroundSurface&, ContactSlots::Slot (&out)[manifold_slots],
                                uint32_t* rough);
// Moves bodies out of overlaps, and applies contact to their velocities.
using ContactFunction = void (*)(const ContactBodies&, ContactSlots&);

struct ContactTarget {
    NearCollidersFunction near;
    GroundFunction ground;
    ContactFunction resolve;
};
} // namespace lr
