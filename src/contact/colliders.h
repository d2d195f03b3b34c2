// The colliders of a world: what they are, where they go in a step, and which of them are near a body.
#pragma once

#include "contact/geometry.h"
#include "contact/narrow.h"
#include "kernel/contact.h"
#include "langevin_rigid.h"
#include "world/allocator.h"

#include <cstdint>

namespace lr {

struct Collider {
    Geometry geometry;
    Pose begin, end; // of the present step
    float friction, restitution;
    uint32_t layers;
    bool moves; // in this step
};

// A collider, or a part of a mesh, whose box reaches into a body's.
struct Candidate {
    uint32_t slot;
    ColliderPart part;
};
inline constexpr uint32_t most_candidates = 64;

class Colliders {
public:
    explicit Colliders(Allocator& allocator);

    // A step begins: where colliders are at its ends, and what the broad phase needs of it. Allocates nothing. reach: m, of
    // ordinary bodies and their way in the step.
    void begin_step(double dt, float reach);
    // Colliders are at the ends of their ways.
    void end_step();

    bool any() const;
    const NearColliders& near() const; // of the step
    const Collider& at(uint32_t slot) const;
    lr_collider id(uint32_t slot) const;

    // Those whose boxes, over all of the step, reach into [low, high] (m, world) and that are in one of `layers`: in order of
    // slots and parts, each once, at most most_candidates. `missed` counts those without room. Any thread.
    uint32_t candidates(Vector low, Vector high, uint32_t layers, Candidate (&out)[most_candidates],
                        uint32_t& missed) const;
};

} // namespace lr
