// Body contact as the kernel sees it: bodies by index, and blocks of units, one unit a lane. Units of a block share no body
// (docs/maintainers/contact.md).
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
    // The substep's displacement, as a twist (v, d s w) times seconds. In the second projection: the velocity before it.
    float way[6];
    float correction[6]; // of the displacement, by the first projection
    // m, the least gap of touching contacts at the beginning, at most 0; gaps to other bodies count g h^2/2 more.
    float shallow;
    float carried;   // m/s, of the fastest surface that it touches
    float touches;   // 1: touches something
    float rolled[3]; // angular impulse against rolling
    float dust;      // m or m/s: smaller changes are ignored
    float share;     // the share of the path's impulses that warm-starts the next substep
    float acted[6];  // sum over the short steps of the displacements by contacts
    float spare[3];
};
// The part of a body that sweeps change: its twist, displacement or velocity.
struct alignas(32) SolverTwist {
    float v[3], u[3];
    float load; // sum of normal impulses of colliders over its mass unit
    float spare;
};

// The path of a substep is solved in so many short steps. Each begins with this share of the impulses of the one before: with more, motions that
// sweeps correct slowly grow (docs/maintainers/contact.md, 13).
inline constexpr uint32_t short_steps = 6;
inline constexpr float short_kept = 0.5f;
// Displacements of a body in short steps: in the present one, if no contact acted in it; the growth of these by loads and weight; from the beginning
// of the substep to the end of the present one, likewise; by contacts in all before.
struct alignas(16) SolverSteps {
    float step[6], growth[6], end[6], acted[6];
};

// Of the conjugate gradients, beside the twists of a projection: twists before the last sweep, and the search direction.
struct SolverSearch {
    SolverTwist *before, *direction; // of each body
};

inline constexpr uint32_t block_contacts = 4;

// contact_lanes units: pairs (a, b), each with contacts of one normal. Without a body b, a touches a fixed surface. The axes of a contact
// frame are the normal and two tangents. A unit sees the relative twist of its bodies in that frame, at the middle of its contacts.
struct PairBlock {
    // A contact as sweeps read it.
    struct Row {
        alignas(64) LaneRow along[2]; // from the middle, along the tangents, over a's d s
        LaneRow inverse;              // 1 over the gain of normal velocity by a unit impulse; 0: no contact
        LaneRow target;               // least normal velocity or displacement
        LaneRow push;                 // as in Row; only where b is immovable
        LaneRow pressed;              // normal impulse over a's mass unit
        LaneRow change, search;       // of the impulse: its change in the last sweep, and its search direction
    };
    // Friction of a unit: a force along the tangents, and a couple about the normal.
    struct Friction {
        // Limits: of the force over the sum of normal impulses; of the couple over the force's limit, in a's d s.
        alignas(64) LaneRow most, radius;
        // Inverses: of the 2x2 gain of the force; of its largest value; of the couple's gain.
        LaneRow hold[3], least, hold_spin;
        // Of the surface: tangential velocity or displacement, and spin; in a short step also that of the unit before it.
        LaneRow drift[3];
        LaneRow path[2]; // displacement of the surface in a short step
        LaneRow sum[3];  // impulses of all short steps
        LaneRow dragged[3], change[3], search[3];
    };
    // A contact's own data.
    struct Place {
        // As in BodyContactPoint, then from set_gaps() on without the rounding.
        alignas(64) LaneRow arm_a[3], arm_b[3];
        LaneRow gap; // m: given as in BodyContactPoint, then at the end of the substep; no_contact: none
        LaneRow before, bounce, touching;
        LaneRow start; // m: impulse of the last short step: its warm start, then the result
        LaneRow sum;   // m: impulses of all short steps
        LaneRow came;  // m/s, along the normal, before the velocity projection
    };

    uint32_t kind_a, kind_b; // the same in all lanes
    uint32_t used;           // contacts of the lane with the most
    uint32_t lanes;          // lanes with a unit; the others pair an immovable body with itself
    uint32_t bounces;        // 1: some contact bounces
    alignas(64) uint32_t a[contact_lanes];
    uint32_t b[contact_lanes];
    LaneRow ratio;                    // a's mass unit over b's; 0: b is immovable, in all lanes or in none
    LaneRow lengths;                  // a's d s over b's
    LaneRow dust;                     // smaller changes are ignored
    LaneRow axes_a[9], axes_b[9];     // of the contact frame, in body frames
    LaneRow middle_a[3], middle_b[3]; // from the centres of mass, along the contact frame, over d s
    // Gains of the relative twist by unit impulses. A unit's impulses are of two kinds: press (force along the normal, couples about the
    // tangents) and drag (forces along the tangents, couple about the normal). Upper triangles for each kind alone; rows for both.
    LaneRow press_press[6], press_drag[9], drag_drag[6];
    Friction friction;
    Row row[block_contacts];
    LaneRow changed; // sum of squares of the last sweep's changes
    // start: the path's impulses times the velocities that they have to stop, m^2/s; then the factor from these impulses to the start of the
    // velocity projection, 1/s. moving: the path's impulses times the displacements that they made, m^2.
    LaneRow start, moving;

    // Used only outside of sweeps.
    LaneRow normal[3];          // world, unit, from b to a
    LaneRow surface[3], lag[3]; // of an immovable surface, as in ContactSlots
    LaneRow restitution;
    LaneRow solid; // 1: a collider, which nothing can overlap
    // Friction of a short step, m: force in the world frame, couple about the normal; the warm start, then the result.
    LaneRow start_drag[3], start_spin;
    LaneRow came[3]; // relative velocity along the tangents and spin, before the velocity projection
    Place place[block_contacts];
};

// Bodies of one kind belong to one batch.
struct SolverBodyKind {
    const BodyConstants* body;
    float reach;                  // m, at scale 1
    float rounding, own_rounding; // m, at scale 1: against other bodies, and against colliders
    float rolling;                // ContactBodies::rolling
};
struct BodyContactInput {
    float h, gravity;
    const SolverBodyKind* kinds;
    SolverBody* bodies;
    SolverTwist* twists;
    SolverSteps* steps;
};

// Functions with `kind` take bodies [begin, begin + contact_lanes), all of that kind. Functions with a block take one; blocks that share no
// body can run in parallel.
struct BodyContactTarget {
    void (*begin)(const BodyContactInput&, uint32_t kind, uint32_t begin); // first of all
    void (*way)(const BodyContactInput&, PairBlock&);                      // rows of the first projection
    void (*short_step)(const BodyContactInput&, uint32_t kind, uint32_t begin, bool first);
    void (*end_short_step)(const BodyContactInput&, PairBlock&, uint32_t ended); // ended: how many have
    // First moves the impulses by `part` of their search direction, as follow() has moved the bodies. False: nothing has changed.
    bool (*sweep)(const BodyContactInput&, PairBlock&, float part);
    void (*follow)(const BodyContactInput&, const SolverSearch&, uint32_t begin, uint32_t end,
                   float part); // after a sweep: moves bodies [begin, end) along the search direction
    bool (*roll)(const BodyContactInput&, uint32_t kind, uint32_t begin);
    void (*move)(const BodyContactInput&, uint32_t kind,
                 uint32_t begin); // applies the correction of the displacement; from then on twists are velocities
    void (*touch)(const BodyContactInput&, PairBlock&);
    void (*velocity)(const BodyContactInput&, PairBlock&); // rows of the second projection
    bool (*restrain)(const BodyContactInput&, PairBlock&); // true: a bounce would gain energy
    void (*finish)(const BodyContactInput&, uint32_t kind, uint32_t begin);
};
} // namespace lr
