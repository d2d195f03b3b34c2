// Steps bodies near water: copies them out of their block, steps them apart from the others, puts them back.
#pragma once

#include "collision/near_walls.h"
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
    // Bodies among [begin, end), at most field_block, that can touch water within `dt`. live: bodies of the batch. reach: m, allowance beyond their
    // displacement by velocity and gravity. forget: forces on single bodies act only in the substeps that follow.
    NearBodies(const WaterStep& step, const StepInput& in, const BatchArrays& from, uint32_t live, uint32_t begin,
               uint32_t end, double dt, double reach, bool forget);

    bool any() const { return count_ != 0; }
    const uint32_t* marks() const { return near_; } // for each body from `begin` on: 0 if it is far

    // Sets the upper fluid's wind at bodies [begin, end). felt: by body from `begin` on, for the walls that turn the water's flow; null: none.
    void set_wind(const float (&wind)[3][field_block], const FeltFlow* felt);
    // Runs `count` substeps from `first` on, in uniform wind unless set_wind() was called.
    void run(const StepInput& in, lr_batch batch, uint32_t first, uint32_t count);
    // submerged: receives the shares in water, by body from `begin` on; null: not wanted.
    void put_back(const BatchArrays& to, float* submerged) const;

private:
    // The surface at `time` where the bodies are after `h`.
    void sample(double time, float h, lr_batch batch, const WaterBody& body, SurfaceInstant& plane,
                SurfaceBlock& block);

    const WaterStep* step_;
    uint32_t begin_, count_ = 0;
    bool windy_ = false;
    const FeltFlow* felt_ = nullptr;
    alignas(64) uint32_t near_[field_block];
    BodyCopies<field_block> copies_;
    alignas(64) float wind_[3][field_block];
    alignas(64) float fraction_[field_block];
};

// Steps bodies [begin, end) through a step in uniform wind. surface: null without water; its time is not read. submerged: receives shares in water at
// the end, by body from `begin` on; null: not wanted.
void step_lanes(const KernelTarget& target, const WaterStep* surface, const StepTime& time, const StepInput& in,
                const BatchArrays& arrays, lr_batch batch, uint32_t live, uint32_t begin, uint32_t end,
                float* submerged = nullptr);
} // namespace lr
