// Body contact as the kernel sees it: bodies by index, blocks of pairs, a lane each. Pairs of a colour share no body (docs/maintainers/contact.md).
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
    float depth;         // m, of the deepest overlap
    float shallow;       // m, the least gap with a collider at the beginning, at most 0
    float carried;       // m/s, of the fastest surface that it touches
    float touches;       // 1: touches something
    float rolled[3];     // angular impulse against rolling
    float dust;          // m or m/s: smaller changes do not count
    float spare;
};
// The part of a body that sweeps change.
struct alignas(32) SolverTwist {
    float v[3], u[3];
    float load; // normal impulses over its mass unit
    float spare;
};

inline constexpr uint32_t block_contacts = 4;

// Contacts of contact_lanes pairs (a, b). Without a body b, a touches a surface that it cannot move.
struct PairContacts {
    alignas(64) LaneRow arm_a[3]; // m, body frames, from the centres of mass; in the solver over d s
    LaneRow arm_b[3];
    LaneRow normal[3]; // world, unit, from b to a
    LaneRow gap;       // m: between bodies at the beginning of the substep, with colliders at its end; no_contact: none
    LaneRow surface[3], lag[3]; // of an immovable surface, as in ContactSlots
    LaneRow friction, restitution;
    LaneRow solid;    // 1: a collider, which nothing can overlap
    LaneRow pressed;  // out: normal impulse over a's mass unit, m/s; negative: no contact
    LaneRow start[3]; // impulse of the first projection, world, m: a guess, then the result
    // Private to the solver (kernel/contact/body_contact_solver-inl.h).
    LaneRow tangent[3], inverse, to_first, to_second, hold[3], least, target, drift[2], dragged[2];
    LaneRow before, bounce, touching;
    LaneRow came[3];              // relative velocity along normal and tangents, before the velocity projection
    LaneRow change[3], search[3]; // of the impulses: change by the last sweep, and search direction
};
struct PairBlock {
    uint32_t kind_a, kind_b; // the same in all lanes
    uint32_t used;           // contacts of the lane with the most
    uint32_t lanes;          // lanes with a pair; other lanes pair an immovable body with itself
    uint32_t bounces;        // 1: some contact bounces
    alignas(64) uint32_t a[contact_lanes];
    uint32_t b[contact_lanes];
    LaneRow ratio;                      // a's mass unit over b's; 0: b is immovable
    LaneRow turn_a[9], turn_b[9], dust; // rotations as matrices
    LaneRow changed;                    // sum of squares of the last sweep's changes
    PairContacts contact[block_contacts];
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

// Functions of bodies: [begin, begin + contact_lanes) of one kind. Functions of blocks: one block; blocks of a colour can run in parallel.
struct BodyContactTarget {
    void (*begin)(const BodyContactInput&, uint32_t kind, uint32_t begin); // first of all
    void (*way)(const BodyContactInput&, PairBlock&);                      // rows of the first projection
    bool (*sweep)(const BodyContactInput&, PairBlock&);                    // false: nothing has changed
    // After a sweep: moves the impulses on by `part` of the search direction.
    void (*follow)(const BodyContactInput&, PairBlock&, float part);
    bool (*roll)(const BodyContactInput&, uint32_t kind, uint32_t begin);
    void (*move)(const BodyContactInput&, uint32_t kind,
                 uint32_t begin); // applies the displacement's correction; velocities are next
    void (*touch)(const BodyContactInput&, PairBlock&);
    void (*velocity)(const BodyContactInput&, PairBlock&); // rows of the second projection
    bool (*restrain)(const BodyContactInput&, PairBlock&); // true: a bounce would gain energy
    void (*finish)(const BodyContactInput&, uint32_t kind, uint32_t begin);
};
} // namespace lr
