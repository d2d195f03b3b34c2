// Contact with colliders as the kernel sees it: the broad phase for bodies, contact slots, and the solver's interface.
#pragma once

#include "base/lane_arrays.h"
#include "kernel/body_constants.h"

#include <cstddef>
#include <cstdint>

namespace lr {

// One level of the broad phase: an unbounded grid, with a bit for the hash of each cell near finite colliders. A body whose centre's cell has no bit
// is farther than `dilation` from all of them.
struct OccupancyLevel {
    float inverse_cell; // 1/m
    float dilation;     // m: largest reach that the bits cover
    const uint32_t* bits;
    uint32_t mask; // words - 1; the number of words is a power of two
};
inline constexpr uint32_t most_occupancy_levels = 8;
inline constexpr float most_cells = 1e9f; // cell numbers are clamped to +- this

// The bit is h & 31 of word (h >> 5) & mask. The kernel computes the same hash in vectors.
constexpr uint32_t cell_hash(int32_t x, int32_t y, int32_t z) {
    uint32_t h = static_cast<uint32_t>(x) * 0x9e3779b1u ^ static_cast<uint32_t>(y) * 0x85ebca77u ^
                 static_cast<uint32_t>(z) * 0xc2b2ae3du;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    return h ^ h >> 13;
}

struct NearPlane {
    float point[3], normal[3]; // where it is nearest to bodies in the step
    float travel;              // m, displacement of the plane in the step
};
// A heightfield's samples in its own frame. heights: null for a plane.
struct HeightGrid {
    const float* heights;
    uint32_t counts[2];
    float inverse_spacing[2]; // 1/m
    float secant;             // of the steepest triangle's angle
};
// A heightfield. Bodies above `coarse`, or farther above it than the slopes can rise within their reach, are far.
struct NearHeightfield {
    float position[3], axes[9]; // rows: its own axes in the world
    float travel;               // m, largest displacement of its points in the step
    float inverse_coarse[2];    // 1/m
    float coarse_size;          // m, shorter side of a square
    uint32_t counts[2];
    const float* coarse;
    float highest, extent[2];
    HeightGrid grid;
};
inline constexpr uint32_t most_near_planes = 16, most_near_heightfields = 16;

// The colliders of a world in a step. If there is no room for one, `everywhere` is set.
struct NearColliders {
    uint32_t level_count, plane_count, heightfield_count;
    bool everywhere; // any body may be near
    OccupancyLevel levels[most_occupancy_levels];
    NearPlane planes[most_near_planes];
    NearHeightfield heightfields[most_near_heightfields];
};

// A body's contact shape at scale 1 (collision/body_shape.h).
struct ShapeConstants {
    uint32_t count, sample_count; // points, 0: an ellipsoid; samples against heightfields, points first
    const float *x, *y, *z;
    float radius;
    float center[3], semi_axes[3];
    float reach;
    float rounding; // rounding_of() of the shape
};

// How an ellipsoid rocks on its broad side. With the radius of curvature R = a^2/c, c the shortest semi-axis, and the radius of gyration k it rocks
// at w^2 = g (R - c)/(k^2 + c^2) about each of the others. Where w h is above 1, a substep would turn it from rim to rim and further with each: it
// needs the points on its other rims.
struct Rocking {
    uint32_t shortest = 0; // axis
    float longest = 0.0f;  // semi-axis
    float most[2] = {};    // scale below which it rocks along the axes shortest + 1 and + 2
    float tilt[2] = {};    // of the normal, for points around the nearest

    // fall: g h^2
    Rocking(const float (&a)[3], float fall) {
        for (uint32_t k = 1; k < 3; ++k) shortest = a[k] < a[shortest] ? k : shortest;
        for (const float axis : a) longest = axis > longest ? axis : longest;
        const float c = a[shortest], flat = 1.0f - c / longest;
        for (uint32_t k = 0; k < 2; ++k) {
            const float b = a[(shortest + 1 + k) % 3], curved = b * b / c;
            most[k] = fall * (curved - c) / (0.2f * (b * b + c * c) + c * c);
            if (flat > 0.8f) most[k] = 1e30f;
            tilt[k] = 0.02f * flat * flat;
            if (tilt[k] * curved < 0.03f * longest) tilt[k] = 0.03f * longest / curved; // less counts as one point
        }
    }
};

inline constexpr size_t most_ground_points = 48;
inline constexpr size_t contact_lanes = lane_block;
inline constexpr uint32_t contact_slots = 16, manifold_slots = 4;
inline constexpr float no_contact = 1e30f; // m, gap of an empty slot

inline constexpr uint32_t sleeping_body = UINT32_MAX - 1; // in place of a collider's slot

using LaneRow = float[contact_lanes];

// Contacts of contact_lanes bodies. A body's contacts need not be in successive slots.
struct ContactSlots {
    uint32_t used; // slots that some body uses
    struct Slot {
        alignas(64) LaneRow arm[3]; // m, body frame, from the centre of mass
        LaneRow normal[3];          // world, unit, from the collider to the body
        LaneRow gap;                // m, at the end of the substep
        LaneRow surface[3];         // m/s, velocity of the collider at the contact
        LaneRow lag[3];             // m, displacement of the collider's point less h times `surface`
        LaneRow friction, restitution;
        LaneRow impulse;                  // out: normal impulse over the mass unit, m/s; negative: no contact
        uint32_t collider[contact_lanes]; // slot of the collider, or sleeping_body
    } slot[contact_slots];
};

// The mesh triangles under each body, seen along its floor's normal: in a frame of the body, y upwards, with the centre of mass as origin.
inline constexpr uint32_t most_floor_faces = 16;
struct FloorLanes {
    uint32_t count = 0;               // the most under any body; the others' last have no place inside
    alignas(64) LaneRow axes[9] = {}; // rows: the frame's axes in the world
    struct Face {
        LaneRow slope[2], height, inverse; // as in GroundSample; `height` at the origin
        LaneRow across[3][2], edge[3];     // inside: across . (x, z) >= edge for each
    } face[most_floor_faces];
};

// A plane (y = 0), a heightfield or floors of a mesh at the end of a substep.
struct GroundSurface {
    float position[3], axes[9];  // rows: its own axes in the world
    float velocity[3], spin[3];  // m/s at `position`; rad/s, world
    float friction, restitution; // of the pair
    uint32_t collider;
    HeightGrid grid;
    const FloorLanes* floor; // null for others; then `axes` do not count
};

// Bodies [0, count) of `arrays` after a substep, with their state before it.
struct ContactBodies {
    const BodyConstants* body;
    ShapeConstants shape;
    float h;       // s, of the substep
    float gravity; // m/s^2, its magnitude
    float rolling; // rolling resistance: couple over normal force and reach
    BatchArrays arrays;
    const LaneRow* before; // position, orientation, velocity and spin before: 13 rows, from field_x on
    size_t count;          // lanes, padded
};
inline constexpr size_t pose_fields = field_scale;

// Marks of bodies near colliders: by the grids, which depend on when these were built; by planes and heightfields; 0: far.
inline constexpr uint32_t near_bits = 1, near_ground = 2;

// For the solver's rows: 16 lanes take most.
struct SolverMemory {
    alignas(64) unsigned char bytes[size_t{128} * 1024];
};

struct ContactTarget {
    // Marks the bodies of [begin, end) that can touch a collider within `dt`. speed: m/s, allowance for speed gained in the step.
    void (*near)(const NearColliders&, float reach, float dt, float speed, const BatchArrays&, size_t begin, size_t end,
                 uint32_t* near);
    // Writes up to manifold_slots contacts of each body with the surface. Returns false and writes nothing if there are none. rough: receives 1 for a
    // body over slopes that differ too much, which needs the narrow phase.
    bool (*ground)(const ContactBodies&, const GroundSurface&, ContactSlots::Slot (&out)[manifold_slots],
                   uint32_t* rough);
    // Solves for positions, then for velocities.
    void (*resolve)(const ContactBodies&, ContactSlots&, SolverMemory&);
};
} // namespace lr
