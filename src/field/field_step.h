// Bodies through a slice of a step in a wind field: wind at a block of bodies, then that block's substep.
#pragma once

#include "field/contact_run.h"
#include "field/surface_step.h"
#include "field/wind_field.h"

namespace lr {

struct FieldSlice {
    const KernelTarget* target;
    WindField* field;
    StepTime time;
    uint32_t first, count;      // substeps of the step
    const SurfaceStep* surface; // null without one
};

// batch: handle, for the caller's own field. live: bodies of the batch; lanes from it on have none. contact: null where
// there is nothing to touch.
void step_in_field(const FieldSlice& slice, const StepInput& in, const ContactRun* contact, const BatchArrays& arrays,
                   lr_batch batch, uint32_t live, uint32_t begin, uint32_t end);

// Velocities at the prepared moment. positions, velocities: x y z of each, may be the same array.
// batch: what the wind callback is told; 0 for points.
void sample_field(const KernelTarget& target, WindField& field, double time, lr_batch batch, const float* positions,
                  uint32_t count, float* velocities);

} // namespace lr
