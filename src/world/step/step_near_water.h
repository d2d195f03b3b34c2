// Bodies that can touch the water: copied out of a block, stepped separately, and put back.
#pragma once

#include "environment/water.h"
#include "environment/wind_field.h"
#include "kernel/body_copies.h"
#include "kernel/integrator/step.h"

namespace lr {

struct WaterStep {
    const KernelTarget* target;
    Water* surface;
    StepTime time;
    const float* gravity; // m/s^2, the world's
};

class NearBodies {
public:
    // The bodies of [begin, end), at most field_block, that can touch the water within `dt`. live: the batch's bodies.
    // reach: m, how much farther than at their velocity and by gravity they can get in that time. forget: their forces apply to the following substeps only.
    NearBodies(const WaterStep& step, const StepInput& in, const BatchArrays& from, uint32_t live, uint32_t begin,
               uint32_t end, double dt, double reach, bool forget);

    bool any() const { return count_ != 0; }
    const uint32_t* marks() const { return near_; } // of each body from `begin` on: 0 if it is not among them

    // Sets the wind of the upper fluid at all of [begin, end).
    void set_wind(const float (&wind)[3][field_block]);
    // Runs substeps first to first + count of the step, in uniform wind unless set_wind() was called.
    void run(const StepInput& in, lr_batch batch, uint32_t first, uint32_t count);
    // submerged: receives the parts in water of those of [begin, end) that are here, by body from `begin` on; or null.
    void put_back(const BatchArrays& to, float* submerged) const;

private:
    void sample(double time, lr_batch batch, SurfaceInstant& plane, SurfaceBlock& block);

    const WaterStep* step_;
    uint32_t begin_, count_ = 0;
    bool windy_ = false;
    alignas(64) uint32_t near_[field_block];
    uint32_t index_[field_block];
    BodyCopies<field_block> copies_;
    alignas(64) float wind_[3][field_block];
    alignas(64) float fraction_[field_block];
};

// Steps [begin, end) through all substeps of a step in a uniform wind. surface: null without water; its time is not read. submerged: receives each
// body's part in water at the end, by body from `begin` on, if there is water; or null.
void step_lanes(const KernelTarget& target, const WaterStep* surface, const StepTime& time, const StepInput& in,
                const BatchArrays& arrays, lr_batch batch, uint32_t live, uint32_t begin, uint32_t end,
                float* submerged = nullptr);
} // namespace lr
