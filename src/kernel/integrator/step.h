// Steps a range of bodies of one batch through all substeps of a step, a body in each lane.
#pragma once

#include "base/lane_arrays.h"
#include "kernel/body_constants.h"
#include "kernel/contact/body_contact.h"
#include "kernel/contact/gjk_pairs.h"
#include "kernel/water/water_loads.h"
#include "kernel/wind/sample_wind.h"
#include "langevin_rigid.h"

#include <cstdint>

struct lr_body_loads;

namespace lr {

// External forces over a step, by force_component. The step clears those on single bodies.
struct ExternalInput {
    bool any;
    float batch[force_components]; // on each body
    float* bodies;                 // on single bodies, force_components arrays
    uint32_t used;                 // a bit for each vector of `bodies` in use, from component 0 on
    size_t stride;                 // from one of these arrays to the next
    bool clear = true;             // forces on single bodies are for this call alone
};

struct StepInput {
    uint64_t seed;
    uint64_t first_substep; // time index of the noise
    uint32_t substeps;
    uint32_t motions; // AERODYNAMIC loads: motions in a substep; the wake takes one step
    float h;          // s, one substep
    float sqrt_h, inverse_sqrt_h;
    float gravity[3];    // m/s^2, world, less the uniform wind's acceleration
    float wind_begin[3]; // m/s, world: uniform wind at the beginning of the step,
    float wind[3];       // and at its end; linear between
    bool wind_changes;
    Loads loads;
    Clock clock;
    Integrator integrator;
    float variation = 0.0f; // lr_batch_desc.variation
    BodyConstants body;
    SheetConstants sheet; // AERODYNAMIC loads: the same body in a sheet's frame, if it is a sheet
    TableConstants table;
    ExternalInput external;
    const WaterBody* water;     // null without water
    uint32_t* faults = nullptr; // set when a body diverges (kernel/divergence.h); null: not wanted
};

// begin: a multiple of lane_block; end: of the target's lanes.
using StepFunction = void(const StepInput&, const BatchArrays&, size_t begin, size_t end);
// The paper's scheme is only a reference: compiled for one instruction set, used by all with the same bits.
StepFunction step_rk4;

// The fluid's loads on the body that fills the first vector of the arrays. fluid: its velocity, m/s, world. body: constants in that fluid.
void loads_on_body(const StepInput& in, const BodyConstants& body, const BatchArrays& arrays, const float (&fluid)[3],
                   lr_body_loads& out);

// Causes for a body's end; the kill volumes follow in order.
enum Cause : uint32_t { cause_none, cause_not_finite, cause_age, cause_volume };
inline constexpr uint32_t cause_count = cause_volume + LR_MAX_KILL_VOLUMES;
// Writes for each body of [begin, end), multiples of lane_block, its first cause. Returns whether any body ends.
using EndedFunction = bool(const lr_batch_rules&, const BatchArrays&, size_t begin, size_t end, uint32_t* cause);

// Positions and velocities of bodies in the middle of a substep, world axes.
using PredictFunction = void(const BatchArrays&, size_t begin, size_t end, float h, FieldBlock* out);
// Winds at the positions of `count` bodies.
using EvaluateFunction = void(const FieldInstant&, size_t count, FieldBlock* blocks);

// Writes `count` elements in a known LR_TRANSFORM_* format, `stride` bytes apart, with the same bits on all targets. Arrays are readable in whole lane
// blocks, and aligned to vectors. ahead: s by which bodies move on with their velocities.
using TransformFunction = void(const BatchArrays&, uint32_t count, float ahead, int32_t format, void* to,
                               uint64_t stride);

struct KernelTarget {
    int32_t simd; // LR_SIMD_*
    int64_t hwy;  // Highway's bit for it
    StepFunction* splitting;
    StepFunction* aerodynamic; // splitting scheme too
    EndedFunction* ended;
    PredictFunction* predict;
    EvaluateFunction* evaluate;
    SurfaceTarget surface;
    TransformFunction* write_transforms;
    const ContactTarget* contact;
    const BodyContactTarget* body_contact;
    PairSearch* search_pairs;
    NearBoxes* near_boxes;

    void step(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) const {
        const auto scheme = in.loads == Loads::aerodynamic ? aerodynamic : splitting;
        (in.integrator == Integrator::rk4 ? &step_rk4 : scheme)(in, a, begin, end);
    }
};

// Bytes of one element of an LR_TRANSFORM_* format; 0 for an unknown one.
uint32_t transform_bytes(int32_t format);

// Targets of this build, best first; `count` receives their number.
const KernelTarget* built_targets(size_t& count);

// The best target for this processor, or the requested one (LR_SIMD_*); null if the processor lacks it.
const KernelTarget* find_target(int32_t simd);
} // namespace lr
