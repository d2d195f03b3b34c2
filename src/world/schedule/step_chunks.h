// Divides the bodies of a world into pieces of work.
#pragma once

#include "kernel/integrator/step.h"
#include "langevin_rigid.h"

#include <algorithm>
#include <cstdint>

struct lr_world;

namespace lr {

class Batch;
struct FieldSlice;
struct WaterStep;
struct ContactRun;

// Tests build with other lengths (-DLR_CHUNK_BODIES): motion must not depend on it.
#if !defined(LR_CHUNK_BODIES)
#define LR_CHUNK_BODIES 1024
#endif
static_assert(LR_CHUNK_BODIES > 0 && LR_CHUNK_BODIES % lane_block == 0);

// Batches are cut only at multiples of this. Rules record ended bodies per cut, each written by one thread.
inline constexpr uint32_t cut_bodies = LR_CHUNK_BODIES < 256 ? LR_CHUNK_BODIES : 256;
// Bodies in a chunk of a large world. Shorter chunks cost nothing extra; after longer ones the caller waits for the last.
inline constexpr uint32_t most_chunk_bodies = LR_CHUNK_BODIES;
inline constexpr uint32_t most_chunk_work = 8192; // body-substeps
// Body-substeps with LANGEVIN loads, 8 ns each, that take as long as work that justifies another thread: waking it takes up to ten microseconds.
inline constexpr uint64_t helper_cost = 4096;

// The most bodies at the end of a batch that the narrow target steps.
inline constexpr uint32_t narrow_lanes = 4;

struct StepTime;
// For a batch over `seconds`; records nothing about its bodies.
ContactRun contact_run(const lr_world& world, Batch& batch, const WaterStep* water, const StepTime& time,
                       float seconds);

inline uint32_t cut_count(uint32_t lanes) {
    return (lanes + cut_bodies - 1) / cut_bodies;
}

// A batch with awake bodies, on the line of all lane blocks of a step.
struct StepItem {
    Batch* batch;
    lr_batch handle;
    uint64_t begin; // its first lane block
};

// The last item that begins at or before `at`.
inline const StepItem* item_at(const StepItem* items, uint32_t count, uint64_t at) {
    return std::upper_bound(items, items + count, at, [](uint64_t a, const StepItem& i) { return a < i.begin; }) - 1;
}

// Chunks are equal lengths of that line, with ends moved back to the last cut: part of a large batch, or many small ones.
class StepChunks {
public:
    // work: body-substeps of one run over them; cost: what they take, in those with LANGEVIN loads.
    StepChunks(const lr_world& world, const StepItem* items, uint32_t item_count, uint64_t lane_blocks, uint64_t work,
               uint64_t cost, uint32_t helpers);

    const FieldSlice* slice = nullptr;  // null if there is only uniform wind
    const WaterStep* surface = nullptr; // null without water; each batch has its own time
    bool colliders = false;             // whether the world has any

    uint32_t count() const { return static_cast<uint32_t>((blocks_ + chunk_ - 1) / chunk_); }
    uint32_t helpers() const { return helpers_; } // threads besides the caller that are worth waking
    void run(uint32_t chunk) const;

private:
    void step(const StepItem& item, uint32_t begin, uint32_t end) const;
    void move_bodies(const StepItem& item, uint32_t begin, uint32_t end) const;

    const lr_world* world_;
    const StepItem* items_;
    uint32_t item_count_;
    uint32_t helpers_;
    uint64_t blocks_;
    uint64_t chunk_; // lane blocks in each
};
} // namespace lr
