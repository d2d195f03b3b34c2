// Bodies that may touch the lower fluid: taken out of a block, stepped by themselves, and put back.
#pragma once

#include "field/body_copies.h"
#include "field/surface.h"
#include "field/wind_field.h"
#include "kernel/step.h"

namespace lr {

struct SurfaceStep {
    const KernelTarget* target;
    Surface* surface;
    StepTime time;
    const float* gravity; // m/s^2, the world's
};

class NearBodies {
public:
    // Those of [begin, end), field_block at most, that may touch the lower fluid within `dt`. live: the batch's bodies.
    // forget: their forces are for what follows alone.
    NearBodies(const SurfaceStep& step, const StepInput& in, const BatchArrays& from, uint32_t live, uint32_t begin,
               uint32_t end, double dt, bool forget);

    bool any() const { return count_ != 0; }
    // Is there a body in this lane block, `begin` and its end within the range, that stays above?
    bool others(uint32_t begin) const;

    // Wind of the upper fluid at all of [begin, end).
    void set_wind(const float (&wind)[3][field_block]);
    // Substeps first to first + count of the step. Uniform wind unless one has been set.
    void run(const StepInput& in, lr_batch batch, uint32_t first, uint32_t count);
    void put_back(const BatchArrays& to) const;

private:
    void sample(double time, lr_batch batch, SurfaceInstant& plane, SurfaceBlock& block);

    const SurfaceStep* step_;
    uint32_t begin_, live_;
    uint32_t count_ = 0;
    bool windy_ = false;
    alignas(64) uint32_t near_[field_block];
    uint32_t index_[field_block];
    BodyCopies<field_block> copies_;
    alignas(64) float wind_[3][field_block];
    alignas(64) float fraction_[field_block];
};

// [begin, end) through all substeps of a step in a uniform wind. surface: null without one; its time is not read.
void step_lanes(const KernelTarget& target, const SurfaceStep* surface, const StepTime& time, const StepInput& in,
                const BatchArrays& arrays, lr_batch batch, uint32_t live, uint32_t begin, uint32_t end);

} // namespace lr
