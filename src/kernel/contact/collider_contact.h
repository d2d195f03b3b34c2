// Contact as the kernel sees it: which bodies may touch a collider within a step, and what contacts do to them.
#pragma once

#include "base/lane_arrays.h"
#include "kernel/body_constants.h"

#include <cstddef>
#include <cstdint>

namespace lr {

// Cells of a lattice that finite colliders reach into, hashed into bits: a uniform grid without bounds. A body whose
// centre's cell is not marked touches nothing on this level within `dilation`.
struct OccupancyLevel {
    float inverse_cell; // 1/m
    float dilation;     // m, by which colliders were made larger when they were entered
    const uint32_t* bits;
    uint32_t mask; // words - 1, a power of two less one
};
inline constexpr uint32_t most_occupancy_levels = 8;
inline constexpr float most_cells = 1e9f; // cell numbers beyond are clamped to this

// Bit h & 31 of word (h >> 5) & mask. The same in the kernel's vectors.
constexpr uint32_t cell_hash(int32_t x, int32_t y, int32_t z) {
    uint32_t h = static_cast<uint32_t>(x) * 0x9e3779b1u ^ static_cast<uint32_t>(y) * 0x85ebca77u ^
                 static_cast<uint32_t>(z) * 0xc2b2ae3du;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    return h ^ h >> 13;
}

struct NearPlane {
    float point[3], normal[3]; // where it is nearest to bodies in the step
    float travel;              // m, of the plane in the step
};
// Of a heightfield: heights in its own frame; null for a plane.
struct HeightGrid {
    const float* heights;
    uint32_t counts[2];
    float inverse_spacing[2]; // 1/m
    float secant;             // of its steepest slope
};
// A heightfield: bodies above `coarse`, or farther above it than its slopes could rise, are far.
struct NearHeightfield {
    float position[3], axes[9]; // rows: its own axes in the world
    float travel;               // m, of any of its points in the step
    float inverse_coarse[2];    // 1/m
    float coarse_size;          // m, the smaller side of a square
    uint32_t counts[2];
    const float* coarse;
    float highest, extent[2];
    HeightGrid grid;
};
inline constexpr uint32_t most_near_planes = 16, most_near_heightfields = 16;

// Everything solid in a world, in a step. Colliders that find no room here make `everywhere` true.
struct NearColliders {
    uint32_t level_count, plane_count, heightfield_count;
    bool everywhere; // each body may be near
    OccupancyLevel levels[most_occupancy_levels];
    NearPlane planes[most_near_planes];
    NearHeightfield heightfields[most_near_heightfields];
};

// What of a body can touch, at scale 1 (collision/body_shape.h).
struct ShapeConstants {
    uint32_t count, sample_count; // of points, 0: an ellipsoid; against heightfields, of which the first are the points
    const float *x, *y, *z;
    float radius;
    float center[3], semi_axes[3];
    float reach;
};

// Marks in `near` the bodies of [begin, end) that may touch a collider within `dt`: near_bits by the bits, which depend on when grids
// were built, near_ground by planes and heightfields, which do not; others get 0. speed: m/s that they may gain beside what they have.
inline constexpr uint32_t near_bits = 1, near_ground = 2;
using NearCollidersFunction = void (*)(const NearColliders&, float reach, float dt, float speed, const BatchArrays&,
                                       size_t begin, size_t end, uint32_t* near);

inline constexpr size_t most_ground_points = 48;
inline constexpr size_t contact_lanes = lane_block;
inline constexpr uint32_t contact_slots = 16, manifold_slots = 4;
inline constexpr float no_contact = 1e30f; // m, gap of a slot that is empty

using LaneRow = float[contact_lanes];

// Contacts of as many bodies, a slot each. Slots of one body need not be filled from the first on.
struct ContactSlots {
    uint32_t used; // slots that any body has
    struct Slot {
        alignas(64) LaneRow arm[3]; // m, body frame, from the centre of mass
        LaneRow normal[3];          // world, unit, from the collider to the body
        LaneRow gap;                // m, at the end of the substep
        LaneRow surface[3];         // m/s, velocity of the collider there
        LaneRow lag[3];             // m, its way in the substep less h times that
        LaneRow friction, restitution;
        LaneRow impulse; // out: along the normal, over the body's mass unit, m/s; negative where they do not touch
        uint32_t collider[contact_lanes]; // slot of it
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

// Bodies [0, count) of `arrays` after a substep, and where they were before it.
struct ContactBodies {
    const BodyConstants* body;
    ShapeConstants shape;
    float h;       // s, the substep
    float gravity; // m/s^2, its magnitude
    float rolling; // resistance to rolling and spinning: moment over normal force and reach
    BatchArrays arrays;
    const LaneRow* before; // position, orientation, velocity, spin: 13 rows, fields from field_x on
    size_t count;          // of lanes, padded
};
inline constexpr size_t pose_fields = field_scale;

// Writes up to manifold_slots contacts of each body with the surface. Returns whether there are any, and if not writes
// nothing. rough: 1 for bodies that touch more than one slope of a heightfield, which need a closer look.
using GroundFunction = bool (*)(const ContactBodies&, const GroundSurface&, ContactSlots::Slot (&out)[manifold_slots],
                                uint32_t* rough);
// Moves bodies out of what they touch, and changes their velocities as contact does.
using ContactFunction = void (*)(const ContactBodies&, ContactSlots&);

struct ContactTarget {
    NearCollidersFunction near;
    GroundFunction ground;
    ContactFunction resolve;
};

} // namespace lr
