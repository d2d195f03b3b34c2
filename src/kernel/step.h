// Steps a range of bodies of one batch through all substeps of a step, one body a lane.
#pragma once

#include "kernel/batch_arrays.h"
#include "kernel/constants.h"
#include "kernel/ended.h"

#include <cstdint>

namespace lr {

// Forces over a step, by force_component. The step consumes those of bodies: it leaves zeros behind.
struct ExternalInput {
    bool any;
    float batch[force_components]; // on each body
    float* bodies;                 // on each by itself, force_components arrays
    uint32_t used;                 // a bit for each vector of `bodies`, from component 0 on; the others are 0
    size_t stride;                 // from one of these arrays to the next
};

struct StepInput {
    uint64_t seed;
    uint64_t first_substep; // time index of the noise
    uint32_t substeps;
    float h; // s, one substep
    float sqrt_h, inverse_sqrt_h;
    float gravity[3]; // m/s^2, world
    float wind[3];    // m/s, world
    Loads loads;
    Integrator integrator;
    BodyConstants body;
    TableConstants table;
    ExternalInput external;
};

// begin, end: multiples of lane_block.
using StepFunction = void (*)(const StepInput&, const BatchArrays&, size_t begin, size_t end);

struct KernelTarget {
    int32_t simd; // LR_SIMD_*
    int64_t hwy;  // Highway's bit for it
    StepFunction step;
    EndedFunction ended;
};

// Targets in this build, best first; `count` receives how many.
const KernelTarget* built_targets(size_t& count);

// The best target that this processor runs, or the one asked for (LR_SIMD_*); null when it cannot.
const KernelTarget* find_target(int32_t simd);

} // namespace lr
