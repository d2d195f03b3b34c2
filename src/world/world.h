// The world: batches, time, wind, workers. Behind lr_world.
#pragma once

#include "contact/colliders.h"
#include "field/surface.h"
#include "field/wind_field.h"
#include "langevin_rigid.h"
#include "world/allocator.h"
#include "world/batch.h"
#include "world/batch_pairs.h"
#include "world/crew.h"
#include "world/crowd.h"
#include "world/pacing.h"
#include "world/step_chunks.h"
#include "world/use.h"

#include <cstdint>

namespace lr::record {
class Recorder;
}

struct lr_world {
    // Null after an error. The desc has been checked.
    static lr_world* create(const lr_world_desc& desc, lr_status& status);
    static void destroy(lr_world* world);

    lr::Batch* find(lr_batch batch) const; // null for a stale handle
    // The batch and dense index of a living body; null for a stale one.
    lr::Batch* find(lr_body body, uint32_t& index) const;

    lr_status create_batch(const lr_asset& asset, uint32_t capacity, const lr::BatchSettings& settings, lr_batch& out);
    void destroy_batch(lr_batch batch);
    // By slots of batches. A change wakes their bodies. False when out of memory, and then nothing has changed.
    bool set_pair(uint32_t a, uint32_t b, bool on);
    lr_status destroy_bodies(const lr_body* bodies, uint32_t count);

    // All or none: LR_OK, LR_ERROR_STALE_BODY, LR_ERROR_OUT_OF_MEMORY.
    lr_status set_rest(const lr_body* bodies, uint32_t count, bool rest);
    uint32_t wake_box(const lr::Box& box); // how many
    // A body goes away or elsewhere: what may lie on it is woken by wake_left().
    void leave(const lr::Batch& batch, uint32_t index);
    void wake_left();
    // meets(slot): whether bodies of that batch will meet others. False when out of memory.
    template <class Meets> bool reserve_left(const Meets& meets) {
        size_t count = 0; // their bodies are in memory
        for (uint32_t i = 0; i < batch_slots; ++i)
            if (batches[i].batch && meets(i)) count += batches[i].batch->capacity();
        return lr::grow(allocator, left, count);
    }
    void set_gravity(const float (&to)[3]); // wakes all where it changes

    uint32_t take_key(); // that tells the next body from all others

    // mode: what the caller's floating-point mode is kept in. False where bodies went through each other for want of memory: the
    // step has been taken all the same.
    bool step(float dt, uint32_t substeps, const lr::FloatMode& mode);
    void sample_wind(const float* positions, uint32_t count, float* velocities) const;
    uint64_t hash() const;

    // Bodies at rest at a collider, over its way in the step.
    void wake_at(uint32_t collider);
    bool any_resting() const;
    // capacity 0 ends them.
    lr_status set_contact_events(uint32_t capacity, uint32_t kinds);
    void recheck_contacts();             // colliders have been destroyed
    void resume_contact_events();        // what there is has been restored: no events
    bool reserve_contact();              // of all batches; false when out of memory
    float contact_reach(float dt) const; // m, for the broad phase
    // m/s that the bodies of a batch may gain in so long beside what they have: how far they look for what they may touch.
    float contact_gain(const lr::Batch& batch, float dt) const;

    void log(int32_t level, const char* function, const char* message) const;

    lr::Crew crew; // first: it is aligned to cache lines
    mutable lr::Allocator allocator;
    const lr::KernelTarget* target = nullptr;
    const lr::ContactTarget* contact = nullptr; // of the same instruction set
    const lr::KernelTarget* narrow = nullptr;   // for the last few bodies of a batch; null: they go with the others
    uint64_t seed = 0;
    mutable lr::WindField wind{allocator}; // sampling prepares an instant
    lr::Surface surface;
    lr::Colliders colliders{allocator};
    lr::BatchPairs pairs;
    lr::Crowd crowd{allocator}; // whose bodies meet each other
    lr::EventList contact_events;
    uint64_t step_count = 0, substep_count = 0;
    double time = 0.0; // s
    lr::Pacing pacing;

    struct BatchSlot {
        lr::Batch* batch;
        uint32_t generation;      // of the batch in it, or of the next
        uint32_t body_generation; // that bodies of the next batch begin with
    };
    lr::Buffer<BatchSlot> batches;
    lr::Buffer<lr::StepItem> items; // room for as many, for the length of a step

    // Where bodies were that others may have lain on. Room for each of those that meet others: one leaves once in a call.
    struct Left {
        uint32_t slot; // of the batch
        lr::Box box;
    };
    lr::Buffer<Left> left;

    mutable lr::Use use;
    lr::record::Recorder* recorder = nullptr; // while there is a recording

    lr_log_fn log_callback = nullptr;
    void* log_user = nullptr;

    float gravity[3] = {0.0f, 0.0f, 0.0f}; // m/s^2
    float fluid_density = 0.0f;            // kg/m^3; 0: each asset's own
    float fluid_viscosity = 0.0f;          // m^2/s; 0: each asset's own
    uint32_t next_key = 1;
    uint32_t batch_slots = 0; // used part of `batches`
    uint32_t left_count = 0;  // and of `left`

private:
    // Of the last substep's length: a few per cent of the step of one body.
    struct Roots {
        double h;
        float sqrt, inverse_sqrt;
    };
    Roots roots{0.0, 0.0f, 0.0f};

    void pace_batches(float dt, uint32_t substeps);
    void fill_input(lr::Batch& batch, float dt, bool& unfit);
    void run(lr::StepItem* items, uint32_t count, const lr::SurfaceStep* at_surface, const lr::FloatMode& mode);
    void run_alone(lr::StepItem* items, uint32_t count, const lr::SurfaceStep* at_surface, const lr::FloatMode& mode);
    bool run_crowds(lr::StepItem* items, uint32_t count, const lr::SurfaceStep* at_surface, const lr::FloatMode& mode);
    void finish_batches(double dt);
    explicit lr_world(const lr::Allocator& from) : allocator(from) {}
    ~lr_world();
    bool grow_batches();
};
