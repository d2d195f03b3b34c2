// Steps a range of bodies of one batch through all substeps of a step, one body a lane.
#pragma once

#include "base/lane_arrays.h"
#include "kernel/body_constants.h"
#include "kernel/contact/body_contact.h"
#include "kernel/contact/gjk_pairs.h"
#include "kernel/water/water_loads.h"
#include "kernel/wind/sample_wind.h"

#include <cstdint>

struct lr_batch_rules;
struct lr_body_loads;

namespace lr {

// External forces over a step, by force_component. The step consumes those of single bodies: it leaves zeros behind.
struct ExternalInput {
    bool any;
    float batch[force_components]; // on each body
    float* bodies;                 // on single bodies, force_components arrays
    uint32_t used;                 // a bit for each vector of `bodies` in use, from component 0 on; the others are 0
    size_t stride;                 // from one of these arrays to the next
    bool clear = true;             // forces on bodies are for this call alone
};

struct StepInput {
    uint64_t seed;
    uint64_t first_substep; // time index of the noise
    uint32_t substeps;
    uint32_t motions; // AERODYNAMIC loads: steps of the motion in a substep, with one of the wake
    float h;          // s, one substep
    float sqrt_h, inverse_sqrt_h;
    float gravity[3];    // m/s^2, world, less the acceleration of the uniform wind
    float wind_begin[3]; // m/s, world: the uniform wind as the step begins,
    float wind[3];       // and as it ends; linear between
    bool wind_changes;
    Loads loads;
    Clock clock;
    Integrator integrator;
    float variation = 0.0f; // lr_batch_desc.variation
    BodyConstants body;
    SheetConstants sheet; // AERODYNAMIC loads: the same body, if it is one
    TableConstants table;
    ExternalInput external;
    const WaterBody* water;     // null without water
    uint32_t* faults = nullptr; // set when a body diverges (kernel/divergence.h); null: not needed
};

// begin: a multiple of lane_block; end: of the target's lanes.
using StepFunction = void(const StepInput&, const BatchArrays&, size_t begin, size_t end);
// The paper's scheme is a reference, which need not be fast: compiled for one instruction set and used by all, with the same bits.
StepFunction step_rk4;

// The flow's loads on the body that fills the first vector of the arrays, in a fluid with this velocity (m/s, world). body: its constants in that fluid.
void loads_on_body(const StepInput& in, const BodyConstants& body, const BatchArrays& arrays, const float (&fluid)[3],
                   lr_body_loads& out);

inline constexpr uint32_t most_kill_volumes = 8;
// Why bodies end. Volumes follow, in their order.
enum Cause : uint32_t { cause_none, cause_not_finite, cause_age, cause_volume };
inline constexpr uint32_t cause_count = cause_volume + most_kill_volumes;
// Writes the first cause that holds for each body of [begin, end), multiples of lane_block. Returns whether any body ends.
using EndedFunction = bool(const lr_batch_rules&, const BatchArrays&, size_t begin, size_t end, uint32_t* cause);

// Positions (and velocities) of bodies in the middle of a substep, world axes.
using PredictFunction = void(const BatchArrays&, size_t begin, size_t end, float h, FieldBlock* out);
// Winds at the positions of `count` bodies.
using EvaluateFunction = void(const FieldInstant&, size_t count, FieldBlock* blocks);
// Bodies at `first` and after, before and after a substep in a wind field.
using EnterWindFunction = void(const StepInput&, const WindAlong&, uint32_t substep, size_t first, size_t lanes,
                               BodiesInWind& bodies);
using LeaveWindFunction = void(const StepInput&, const WindAlong&, size_t first, size_t lanes, BodiesInWind& bodies);

struct KernelTarget {
    int32_t simd; // LR_SIMD_*
    int64_t hwy;  // Highway's bit for it
    StepFunction* splitting;
    StepFunction* aerodynamic; // of the splitting scheme too
    EndedFunction* ended;
    PredictFunction* predict;
    EvaluateFunction* evaluate;
    SurfaceTarget surface;
    const ContactTarget* contact;
    const BodyContactTarget* body_contact;
    PairSearch* search_pairs;
    NearBoxes* near_boxes;

    void step(const StepInput& in, const BatchArrays& a, size_t begin, size_t end) const {
        const auto scheme = in.loads == Loads::aerodynamic ? aerodynamic : splitting;
        (in.integrator == Integrator::rk4 ? &step_rk4 : scheme)(in, a, begin, end);
    }
};

// Targets in this build, best first; `count` receives how many.
const KernelTarget* built_targets(size_t& count);

// The best target that this processor runs, or the requested one (LR_SIMD_*); null if it cannot run that.
const KernelTarget* find_target(int32_t simd);
} // namespace lr
