// Memory of steps in which bodies meet each other (world/crowd_step.h): it grows as it is needed, and is kept.
#pragma once

#include "contact/crowd_solver.h"
#include "contact/meeting_grid.h"
#include "contact/pair_way.h"
#include "field/contact_run.h"
#include "world/resting_neighbours.h"
#include "world/step_chunks.h"

#include <cstdint>

namespace lr {

// Of a batch in such a step.
struct CrowdMember {
    StepItem item;
    uint32_t slot;
    uint32_t first, count; // its bodies' indices in the crowd: those of the batch, from `first` on
    uint32_t first_place;  // of those that touch others
    bool own;              // its bodies meet each other
    ContactRun run;
    RestingNeighbours resting;
    CrowdKind kind;
};

struct Crowd {
    explicit Crowd(Allocator& allocator) : solver(allocator) {}

    // With what a body touches that is not moved by it.
    struct Held {
        uint32_t collider; // slot, or ContactGroup::a_body
        ContactGroup::AtRest at_rest;
    };
    // A body in a substep.
    struct Moved {
        PairBody body;
        float margin; // m
        uint32_t member;
    };
    // Two bodies whose boxes overlap.
    struct Pair {
        uint32_t a, b; // bodies, by their indices in the crowd
        uint32_t count;
    };

    Buffer<CrowdMember> members;
    Buffer<float> before; // pose_fields rows of all bodies, as the substep began
    Buffer<Moved> moved;  // by body
    MeetingGrid grid;
    Buffer<uint32_t> first_pair; // by body, and the end: of those that it has found
    // By body: the others whose boxes it has found; of more, the first by batch and key.
    static constexpr uint32_t most_seen = 48;
    Buffer<uint32_t> seen;
    Buffer<Pair> pairs;
    Buffer<CrowdContact> pair_contacts; // block_contacts of each
    Buffer<uint32_t> place;             // by body: among those that touch others; UINT32_MAX
    Buffer<uint64_t> order;             // key and body
    // By place; padding has no body, UINT32_MAX.
    Buffer<uint32_t> body_at, first_held, held_count, first_unit;
    Buffer<uint8_t> touches_body;
    Buffer<Held> held;
    Buffer<CrowdContact> held_contacts;
    Buffer<CrowdUnit> units;
    Buffer<CrowdKind> kinds;
    Buffer<CrowdRange> ranges;
    CrowdSolver solver;
};

} // namespace lr
