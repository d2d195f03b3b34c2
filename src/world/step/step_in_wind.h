// Steps bodies through a slice of a step in a wind field: wind at a block of bodies, then that block's substep.
#pragma once

#include "environment/wind_field.h"
#include "world/step/step_near_colliders.h"
#include "world/step/step_near_water.h"

namespace lr {

struct FieldSlice {
    const KernelTarget* target;
    WindField* field;
    StepTime time;
    uint32_t first, count;    // substeps of the step
    const WaterStep* surface; // null without water
    // By body from `begin` on: the share of the wind's speed that it feels. Null: all of it.
    const float* felt = nullptr;
    // Likewise: receives their parts in water after one substep, if there is water. Null: not asked.
    float* submerged = nullptr;
};

// batch: handle, for the caller's own field. live: bodies of the batch; later lanes are empty. contact: null if there is nothing to touch.
void step_in_field(const FieldSlice& slice, const StepInput& in, const ContactRun* contact, const BatchArrays& arrays,
                   lr_batch batch, uint32_t live, uint32_t begin, uint32_t end);

// Velocities at the prepared moment. positions, velocities: x y z of each, can be the same array. batch: passed to the wind callback; 0 for points.
void sample_field(const KernelTarget& target, WindField& field, double time, lr_batch batch, const float* positions,
                  uint32_t count, float* velocities);
} // namespace lr
