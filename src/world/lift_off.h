// Bodies at rest that wind or water would move: each is tried in turn, by a substep of a copy, and woken if it goes.
#pragma once

#include "field/contact_run.h"
#include "field/field_step.h"
#include "kernel/float_mode.h"
#include "world/step_chunks.h"

#include <cstdint>

struct lr_world;

namespace lr {

class LiftOff {
public:
    // A body's turn comes in one of so many steps of the world, by its key.
    static constexpr uint32_t turns = 16;

    // items: room for as many as the world has batches. h: s, a substep of the step.
    LiftOff(lr_world& world, StepItem* items, const StepTime& time);

    // Notes those that go, to be woken by Batch::wake_noted().
    void run(const FloatMode& mode);

private:
    static void run_chunk(void* context, uint32_t chunk);
    void try_range(const StepItem& item, uint32_t begin, uint32_t end);
    void try_bodies(const StepItem& item, const uint32_t* index, uint32_t count);

    lr_world* world_;
    StepItem* items_;
    uint32_t item_count_ = 0;
    uint32_t chunks_ = 0;
    StepTime time_; // one substep
    SurfaceStep surface_{};
};

} // namespace lr
