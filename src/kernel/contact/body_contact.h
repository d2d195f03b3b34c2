// Body contact as the kernel sees it: bodies by index, blocks of pairs, a lane each. Pairs of a block share no body (docs/maintainers/contact.md).
#pragma once

#include "kernel/contact/collider_contact.h"

namespace lr {

// A body during a substep.
struct alignas(64) SolverBody {
    float x[3], q[4];   // m; world: at the end of the substep
    float x0[3], q0[4]; // at its beginning
    float v[3], w[3];   // m/s, rad/s, body frame: at its end
    float v0[3], w0[3];
    float scale;
    // Results of contact.
    float way[6]; // displacement, twist (v, d s w) times seconds; in the second projection: the velocity before it
    float correction[6]; // of the displacement
    float shallow;       // m, the least gap at the beginning, with a body g h^2/2 more, at most 0
    float carried;       // m/s, of the fastest surface that it touches
    float touches;       // 1: touches something
    float rolled[3];     // angular impulse against rolling
    float dust;          // m or m/s: smaller changes do not count
    float share;         // of the path's impulses, for the next substep's start
};
// The part of a body that sweeps change.
struct alignas(32) SolverTwist {
    float v[3], u[3];
    float load; // normal impulses over its mass unit
    float spare;
};

// Beside the twists of a projection: as they were before the last sweep, and the direction of search.
struct SolverSearch {
    SolverTwist *before, *direction; // of each body
};

inline constexpr uint32_t block_contacts = 4;

// Units of contact_lanes pairs (a, b), each with contacts of one normal. Without a body b, a touches a surface that it cannot move.
// A contact frame's axes are the normal and two tangents; in it a unit is the relative twist of the bodies at the middle of its contacts.
struct PairBlock {
    // A contact as sweeps read it.
    struct Row {
        alignas(64) LaneRow along[2]; // from the middle, along the tangents, over a's d s
        LaneRow inverse;              // 1 over the gain of normal velocity by a unit impulse; 0: no contact
        LaneRow target;               // least normal velocity or displacement
        LaneRow pressed;              // normal impulse over a's mass unit
        LaneRow change, search;       // of the impulse: change by the last sweep, and search direction
    };
    // Friction of a unit: along the tangents, and a couple about the normal.
    struct Friction {
        alignas(64) LaneRow most,
            radius; // of the impulse over the sum of normal ones; of the couple over that, a's d s
        LaneRow hold[3], least, hold_spin; // inverses of the gains
        LaneRow drift[2];                  // of the surface
        LaneRow dragged[3], change[3], search[3];
    };
    // A contact's own data.
    struct Place {
        alignas(64) LaneRow arm_a[3], arm_b[3]; // m, body frames, from the centres of mass
        LaneRow gap; // m: between bodies at the beginning of the substep, with colliders at its end; no_contact: none
        LaneRow before, bounce, touching;
        LaneRow start; // m: impulse of the path projection: a guess, then the result
        LaneRow came;  // m/s, normal, before the velocity projection
    };

    uint32_t kind_a, kind_b; // the same in all lanes
    uint32_t used;           // contacts of the lane with the most
    uint32_t lanes;          // lanes with a pair; other lanes pair an immovable body with itself
    uint32_t bounces;        // 1: some contact bounces
    alignas(64) uint32_t a[contact_lanes];
    uint32_t b[contact_lanes];
    LaneRow ratio;                    // a's mass unit over b's; 0: b is immovable, in all lanes or in none
    LaneRow lengths;                  // a's d s over b's
    LaneRow dust;                     // smaller changes do not count
    LaneRow axes_a[9], axes_b[9];     // of the contact frame, in body frames
    LaneRow middle_a[3], middle_b[3]; // from the centres of mass, along the contact frame, over d s
    // Of the relative twist by unit impulses: upper triangle of (force, couples) along normal and tangents; of that row by row by (forces,
    // couple) along tangents and normal; upper triangle of these.
    LaneRow press_press[6], press_drag[9], drag_drag[6];
    Friction friction;
    Row row[block_contacts];
    LaneRow changed; // sum of squares of the last sweep's changes
    // The path's impulses times the velocities that they have to stop, m^2/s, then the velocity projection's start over them, 1/s; and times
    // the displacement that they made, m^2.
    LaneRow start, moving;

    // Read and written outside sweeps alone.
    LaneRow normal[3];          // world, unit, from b to a
    LaneRow surface[3], lag[3]; // of an immovable surface, as in ContactSlots
    LaneRow restitution;
    LaneRow solid; // 1: a collider, which nothing can overlap
    // Friction of the path projection, m: along the world's axes and about the normal; a guess, then the result.
    LaneRow start_drag[3], start_spin;
    LaneRow came[3]; // relative velocity along the tangents and spin, before the velocity projection
    Place place[block_contacts];
};

// Bodies of one kind belong to one batch.
struct SolverBodyKind {
    const BodyConstants* body;
    float reach;   // m, at scale 1
    float rolling; // ContactBodies::rolling
};
struct BodyContactInput {
    float h, gravity;
    const SolverBodyKind* kinds;
    SolverBody* bodies;
    SolverTwist* twists;
};

// Functions of bodies: [begin, begin + contact_lanes) of one kind. Functions of blocks: one block; blocks that share no body can run in parallel.
struct BodyContactTarget {
    void (*begin)(const BodyContactInput&, uint32_t kind, uint32_t begin); // first of all
    void (*way)(const BodyContactInput&, PairBlock&);                      // rows of the first projection
    // First moves the impulses on by `part` of the search direction, as follow() has moved the bodies. False: nothing has changed.
    bool (*sweep)(const BodyContactInput&, PairBlock&, float part);
    void (*follow)(const BodyContactInput&, const SolverSearch&, uint32_t begin, uint32_t end,
                   float part); // after a sweep: bodies [begin, end)
    bool (*roll)(const BodyContactInput&, uint32_t kind, uint32_t begin);
    void (*move)(const BodyContactInput&, uint32_t kind,
                 uint32_t begin); // applies the displacement's correction; velocities are next
    void (*touch)(const BodyContactInput&, PairBlock&);
    void (*velocity)(const BodyContactInput&, PairBlock&); // rows of the second projection
    bool (*restrain)(const BodyContactInput&, PairBlock&); // true: a bounce would gain energy
    void (*finish)(const BodyContactInput&, uint32_t kind, uint32_t begin);
};
} // namespace lr
