// The world behind lr_world: batches, time, wind, workers.
#pragma once

#include "base/allocator.h"
#include "base/step_workers.h"
#include "body_contact/batch_pairs.h"
#include "body_contact/body_contact_step.h"
#include "collision/colliders.h"
#include "environment/water.h"
#include "environment/wind_field.h"
#include "langevin_rigid.h"
#include "world/batch/batch.h"
#include "world/schedule/step_chunks.h"

#include <atomic>
#include <cstdint>

namespace lr::recording {
class Recorder;
}

struct lr_world;
namespace lr {

// Knows which call is inside a world, to detect use from two threads or from callbacks, if the world is checked.
class CallGuard {
public:
    // Before the world is used.
    void check(uint32_t checks) { checked_ = (checks & LR_CHECK_THREADS) != 0; }
    bool checked() const { return checked_; }

    // LR_OK: the thread owns the world until leave(). Else LR_ERROR_CONCURRENT_USE or LR_ERROR_REENTRANT.
    lr_status enter(const char* function) {
        ThreadId owner = nullptr;
        const ThreadId self = this_thread();
        if (!owner_.compare_exchange_strong(owner, self, std::memory_order_acquire, std::memory_order_relaxed))
            return owner == self ? LR_ERROR_REENTRANT : LR_ERROR_CONCURRENT_USE;
        function_.store(function, std::memory_order_relaxed);
        return LR_OK;
    }
    void leave() {
        function_.store(nullptr, std::memory_order_relaxed);
        owner_.store(nullptr, std::memory_order_release);
    }
    const char* function() const { return function_.load(std::memory_order_relaxed); } // null: between two calls

    // A refusal is logged once, since the log callback may call the library again and be refused again.
    bool begin_telling() { return !telling_.exchange(true, std::memory_order_relaxed); }
    void end_telling() { telling_.store(false, std::memory_order_relaxed); }

private:
    bool checked_ = false;
    std::atomic<ThreadId> owner_{nullptr};
    std::atomic<const char*> function_{nullptr};
    std::atomic<bool> telling_{false};
};

// CallGuard::enter for checked worlds; logs a refusal.
lr_status enter(const lr_world& world, const char* function);
} // namespace lr

struct lr_world {
    // The desc must be valid. Null on failure.
    static lr_world* create(const lr_world_desc& desc, lr_status& status);
    static void destroy(lr_world* world);

    lr::Batch* find(lr_batch batch) const; // null if stale
    // The batch and dense index of a body; null if stale.
    lr::Batch* find(lr_body body, uint32_t& index) const;

    // Calls fn(batch, its slot).
    template <class Function> void each_batch(Function&& function) const {
        for (uint32_t i = 0; i < batch_slots; ++i)
            if (batches[i].batch) function(*batches[i].batch, i);
    }
    lr_batch handle(uint32_t slot) const { return lr::pack(lr::BatchHandle{slot, batches[slot].generation}); }
    lr_status create_batch(const lr_asset& asset, uint32_t capacity, const lr::BatchSettings& settings, lr_batch& out);
    void destroy_batch(lr_batch batch);
    // Switches body contact between two batches, by slot; a change wakes their bodies. Returns false and changes nothing when out of memory.
    bool set_pair(uint32_t a, uint32_t b, bool on);
    // Called before a body is removed or placed elsewhere: wake_left() then wakes the bodies that may lie on it.
    void leave(const lr::Batch& batch, uint32_t index);
    void wake_left();
    // meets(slot): whether the batch has, or will have, body contact. False when out of memory.
    template <class Meets> bool reserve_left(const Meets& meets) {
        size_t count = 0; // bodies that need room
        each_batch([&](const lr::Batch& batch, uint32_t slot) { count += meets(slot) ? batch.capacity() : 0; });
        return lr::grow(allocator, left, count);
    }

    uint32_t take_key(); // the noise seed of the next body

    // mode: holds the caller's floating-point mode. False if memory was short and bodies may have passed through each other; the step was taken.
    bool step(float dt, uint32_t substeps, const lr::FloatMode& mode);
    void sample_wind(const float* positions, uint32_t count, float* velocities) const;
    uint64_t hash() const;

    // Wakes sleeping bodies on a collider's path in the step.
    void wake_at(uint32_t collider);
    // Whether wind or water may wake any body.
    bool flow_may_wake() const { return (colliders.any() || pairs.any() || surface.present()) && any_asleep(); }
    bool any_asleep() const;
    bool reserve_contact(); // of all batches; false when out of memory
    // Needed for steps with colliders, body contact or water, and of bodies that touched something. False when out of memory.
    bool reserve_scratch() { return step_workers.reserve_scratch(allocator); }
    float contact_reach(float dt) const; // m, for the broad phase

    // For substeps in uniform wind, `begin` at their beginning. unfit: set if a batch cannot be in the water.
    void fill_input(lr::Batch& batch, const lr::StepTime& time, uint64_t first_substep, const float (&begin)[3],
                    bool& unfit);

    void lap(double& phase); // adds the time since the last lap to that phase of `timings`

    // An error becomes the calling thread's last one too.
    void log(int32_t level, const char* function, const char* message) const;

    lr::StepWorkers step_workers; // first, for its alignment to cache lines
    mutable lr::Allocator allocator;
    const lr::KernelTarget* target = nullptr;
    const lr::KernelTarget* narrow = nullptr; // for a batch's last few bodies; null: no need
    uint64_t seed = 0;
    mutable lr::WindField wind{allocator}; // mutable: sampling prepares it for a moment
    mutable lr::Water surface;             // mutable: counts faulty answers of the callback
    lr::Colliders colliders{allocator};
    lr::BatchPairs pairs;
    lr::PairCache pair_cache;
    lr::BodyContactBuffers body_contact_buffers{allocator}; // of batches with body contact
    lr::EventList events;
    lr_timings timings{}; // of the last step
    double lapped = 0.0;  // s
    uint64_t step_count = 0, substep_count = 0;
    double time = 0.0; // s
    lr::StepScheduler pacing;

    struct BatchSlot {
        lr::Batch* batch;
        uint32_t generation;      // of its batch, or of the next one
        uint32_t body_generation; // first one of bodies of the next batch
    };
    lr::Buffer<BatchSlot> batches;
    lr::Buffer<lr::StepItem> items; // scratch of a step, with room for all batches

    // Places that bodies have left, where others may lie on them. Each body leaves at most once per call, so there is room for all with body contact.
    struct Left {
        uint32_t slot; // of the batch
        lr::Box box;
    };
    lr::Buffer<Left> left;

    mutable lr::CallGuard call_guard;
    lr::recording::Recorder* recorder = nullptr; // while there is a recording

    lr_log_fn log_callback = nullptr;
    void* log_user = nullptr;

    float gravity[3] = {0.0f, 0.0f, 0.0f}; // m/s^2
    float fluid_density = 0.0f;            // kg/m^3; 0: each asset's own
    float fluid_viscosity = 0.0f;          // m^2/s; 0: each asset's own
    uint32_t next_noise_seed = 1;
    uint32_t batch_slots = 0; // used part of `batches`
    uint32_t left_count = 0;  // used part of `left`

private:
    friend class lr::Allocator;
    // For the last length of substep: saves a few per cent of a step of one body.
    struct Roots {
        double h;
        float sqrt, inverse_sqrt;
    };
    Roots roots{0.0, 0.0f, 0.0f};

    void schedule_batches(float dt, uint32_t substeps);
    void fill_step(lr::Batch& batch, float dt, bool& unfit);
    void run(lr::StepItem* items, uint32_t count, const lr::WaterStep* at_surface, const lr::FloatMode& mode);
    void finish_batches(double dt);
    explicit lr_world(const lr::Allocator& from) : allocator(from) {}
    ~lr_world();
};

namespace lr {

// Snapshots are checked as a whole before anything is restored.
uint64_t snapshot_size(const lr_world& world);
lr_status snapshot_save(const lr_world& world, void* memory, uint64_t size, uint64_t* written);
// Whether the memory begins with a whole, undamaged snapshot; snapshot_bytes() is then at most `size`.
bool snapshot_is_whole(const void* memory, uint64_t size);
uint64_t snapshot_bytes(const void* memory);
// After snapshot_is_whole().
lr_status snapshot_restore(lr_world& world, const void* memory);

// Queries; the arguments must be valid. only: bodies of this batch; null: all bodies.
lr_ray_hit cast_ray(const lr_world& world, const lr_ray& ray, const Batch* only);

// Returns the number of overlapping bodies; writes up to `capacity` ids, sorted if there is room for all.
uint32_t find_overlaps(const lr_world& world, const lr_overlap_desc& desc, const Batch* only, lr_body* bodies,
                       uint32_t capacity);

// Constants of body `i` in the fluid around its centre. stream: receives the velocity of the water there, if it is water.
const BodyConstants& constants_at(const lr_world& world, Batch& batch, uint32_t i, float (&stream)[3]);
// The fluid's loads on body `i` now; sets all but `struct_size`.
void find_loads(const lr_world& world, Batch& batch, uint32_t i, lr_body_loads& out);
} // namespace lr
