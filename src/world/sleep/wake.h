// Wakes sleeping bodies that are about to be hit, or that wind or water would move. docs/maintainers/contact.md, sections 5 and 14.
#pragma once

#include "base/float_mode.h"
#include "world/schedule/step_chunks.h"
#include "world/step/step_in_wind.h"
#include "world/step/step_near_colliders.h"

#include <cstdint>

struct lr_world;

namespace lr {

class SleepingNeighbours;

// Wakes bodies that a fast one would hit in the coming step of dt (s), so that they take the blow awake.
void wake_before_hit(lr_world& world, float dt, const FloatMode& mode);

// Wakes bodies that wind or water would move. The trial: a copy of the body takes one substep.
class WakeByFlow {
public:
    // A body's turn comes once in this many world steps, by its noise seed.
    static constexpr uint32_t turns = 16;

    // items: room for all batches of the world. time: of the step, for the length of a substep.
    WakeByFlow(lr_world& world, StepItem* items, const StepTime& time);

    // Marks the bodies that would move, for Batch::wake_noted().
    void run(const FloatMode& mode);

private:
    void try_range(const StepItem& item, uint32_t begin, uint32_t end);
    void try_bodies(const StepItem& item, const uint32_t* index, uint32_t count);
    // moves: receives whether each body does. felt: the share of the wind's speed that each feels; null: all.
    void take_substep(const StepItem& item, const SleepingNeighbours& neighbours, const uint32_t* index, uint32_t count,
                      const FeltFlow* felt, bool* moves);

    lr_world* world_;
    StepItem* items_;
    uint32_t item_count_ = 0;
    uint32_t chunks_ = 0;
    StepTime time_; // one substep
    WaterStep surface_;
};
} // namespace lr
