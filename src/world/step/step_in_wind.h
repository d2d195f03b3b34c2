// Steps bodies in a wind field: for each block of bodies the wind there, then a substep.
#pragma once

#include "environment/wind_field.h"
#include "world/step/step_near_colliders.h"
#include "world/step/step_near_water.h"

namespace lr {

struct FieldSlice {
    const KernelTarget* target;
    WindField* field;
    StepTime time;
    uint32_t first, count;    // substeps of the step to take
    const WaterStep* surface; // null without water
    // By body from `begin` on: share of the wind's speed that it feels. Null: all of it.
    const float* felt = nullptr;
    // By body from `begin` on: receives its share in water after one substep. Null: not wanted.
    float* submerged = nullptr;
};

// batch: handle, passed to the wind callback. live: number of bodies, the lanes after them are empty. contact: null if there is nothing to touch.
void step_in_field(const FieldSlice& slice, const StepInput& in, const ContactRun* contact, const BatchArrays& arrays,
                   lr_batch batch, uint32_t live, uint32_t begin, uint32_t end);

// Velocities at the prepared moment. positions, velocities: x y z each, may be one array. batch: passed to the wind callback; 0 for points.
void sample_field(const KernelTarget& target, WindField& field, double time, lr_batch batch, const float* positions,
                  uint32_t count, float* velocities);
} // namespace lr
