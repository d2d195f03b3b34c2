// Bodies that touch each other as the kernel sees them: bodies by index, and blocks of pairs, a lane each, no two of
// which in a colour share a body. Method: docs/maintainers/contact.md.
#pragma once

#include "kernel/contact/collider_contact.h"

namespace lr {

// A body through a substep.
struct alignas(64) SolverBody {
    float x[3], q[4];   // m; world: at its end
    float x0[3], q0[4]; // and as it began
    float v[3], w[3];   // m/s, rad/s, body frame: at its end
    float v0[3], w0[3];
    float scale;
    // What contact makes of it.
    float way[6];        // twist (v, d s w) times s; of the second projection: the velocity before it
    float correction[6]; // of the way
    float depth;         // m, of the deepest overlap
    float shallow;       // m, of the gaps with colliders that the substep began with the least, or 0
    float carried;       // m/s, the fastest surface that it touches
    float touches;       // 1: it touches something
    float rolled[3];     // impulse couple against rolling
    float dust;          // m or m/s: spins that do not count
};
// What sweeps change of it.
struct alignas(32) SolverTwist {
    float v[3], u[3];
    float load; // impulses along normals, over its mass unit
    float spare;
};

inline constexpr uint32_t block_contacts = 4;

// Of contact_lanes pairs (a, b). Where b is nobody, a touches what is not moved by it.
struct PairContacts {
    alignas(64) LaneRow arm_a[3]; // m, body frames, from the centres of mass; in the solver over d s
    LaneRow arm_b[3];
    LaneRow normal[3];          // world, unit, from b to a
    LaneRow gap;                // m: of pairs as the substep began, with colliders at its end; no_contact: none
    LaneRow surface[3], lag[3]; // of what is not moved: as ContactSlots
    LaneRow friction, restitution;
    LaneRow solid;   // 1: a collider, that nothing may overlap
    LaneRow pressed; // out: impulse along the normal over a's mass unit, m/s; negative: do not touch
    // The solver's own; kernel/contact/body_contact_solver-inl.h.
    LaneRow tangent[3], inverse, to_first, to_second, hold[3], least, target, drift[2], dragged[2];
    LaneRow before, bounce, touching;
    LaneRow came[3];              // along normal and tangents, against the surface, before the velocity projection
    LaneRow change[3], search[3]; // of the impulses: by the last sweep, and the direction in which they go on
};
struct PairBlock {
    uint32_t kind_a, kind_b; // of all lanes
    uint32_t used;           // contacts that any lane has
    uint32_t lanes;          // that are pairs; the others are pairs of nobody with itself
    uint32_t bounces;        // 1: some do
    alignas(64) uint32_t a[contact_lanes];
    uint32_t b[contact_lanes];
    LaneRow ratio;                      // of a's mass unit to b's; 0: b is not moved
    LaneRow turn_a[9], turn_b[9], dust; // rotations as matrices
    LaneRow changed;                    // sum of squares of the last sweep's changes
    PairContacts contact[block_contacts];
};

// Bodies of one kind are of one batch.
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

// Of bodies: [begin, begin + contact_lanes) of one kind. Of blocks: one block; those of a colour may go side by side.
struct BodyContactTarget {
    void (*begin)(const BodyContactInput&, uint32_t kind, uint32_t begin); // before all else
    void (*way)(const BodyContactInput&, PairBlock&);                      // rows of the first projection
    bool (*sweep)(const BodyContactInput&, PairBlock&);                    // false: nothing has changed
    // After a sweep: goes on in the direction of the sweeps before, `part` of them.
    void (*follow)(const BodyContactInput&, PairBlock&, float part);
    bool (*roll)(const BodyContactInput&, uint32_t kind, uint32_t begin);
    void (*move)(const BodyContactInput&, uint32_t kind,
                 uint32_t begin); // the way's correction is made, and velocities are next
    void (*touch)(const BodyContactInput&, PairBlock&);
    void (*velocity)(const BodyContactInput&, PairBlock&); // rows of the second projection
    bool (*restrain)(const BodyContactInput&, PairBlock&); // true: some would bounce by more than they have lost
    void (*finish)(const BodyContactInput&, uint32_t kind, uint32_t begin);
};

} // namespace lr
