// Divides the bodies of a step into chunks for the workers.
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

// Tests build with other lengths (-DLR_CHUNK_BODIES), since results must not depend on it.
#if !defined(LR_CHUNK_BODIES)
#define LR_CHUNK_BODIES 1024
#endif
static_assert(LR_CHUNK_BODIES > 0 && LR_CHUNK_BODIES % lane_block == 0);

// Batches are cut only at multiples of this. Ended bodies are recorded by cut, and only one thread writes each.
inline constexpr uint32_t cut_bodies = LR_CHUNK_BODIES < 256 ? LR_CHUNK_BODIES : 256;
// Bodies in a chunk of a large world. Shorter chunks cost nothing extra; with longer ones the caller waits for the last.
inline constexpr uint32_t most_chunk_bodies = LR_CHUNK_BODIES;
inline constexpr uint32_t most_chunk_work = 8192; // body-substeps
// Work that is worth another thread, in body-substeps with LANGEVIN loads of 8 ns each: waking a thread takes up to 10 us.
inline constexpr uint64_t helper_cost = 4096;

// A batch's last bodies, if at most this many, are stepped by the narrow target.
inline constexpr uint32_t narrow_lanes = 4;

struct StepTime;
// For a step of `seconds` of the batch. Records nothing about its bodies.
ContactRun contact_run(const lr_world& world, Batch& batch, const WaterStep* water, const StepTime& time,
                       float seconds);

inline uint32_t cut_count(uint32_t lanes) {
    return (lanes + cut_bodies - 1) / cut_bodies;
}

// A batch with awake bodies. The lane blocks of all items of a step form one line.
struct StepItem {
    Batch* batch;
    lr_batch handle;
    uint64_t begin; // its first block on that line
};

// The last item that begins at or before `at`.
inline const StepItem* item_at(const StepItem* items, uint32_t count, uint64_t at) {
    return std::upper_bound(items, items + count, at, [](uint64_t a, const StepItem& i) { return a < i.begin; }) - 1;
}

// Chunks are equal parts of that line, moved back to the last cut: a part of a large batch, or several small ones.
class StepChunks {
public:
    // work: body-substeps of one run; cost: the same, weighted by loads in units of LANGEVIN's.
    StepChunks(const lr_world& world, const StepItem* items, uint32_t item_count, uint64_t lane_blocks, uint64_t work,
               uint64_t cost, uint32_t helpers);

    const FieldSlice* slice = nullptr;  // null if there is only uniform wind
    const WaterStep* surface = nullptr; // null without water; each batch has its own time
    bool colliders = false;             // whether the world has any

    uint32_t count() const { return static_cast<uint32_t>((blocks_ + chunk_ - 1) / chunk_); }
    uint32_t helpers() const { return helpers_; } // threads worth waking besides the caller
    void run(uint32_t chunk) const;

private:
    void step(const StepItem& item, uint32_t begin, uint32_t end) const;
    void move_bodies(const StepItem& item, uint32_t begin, uint32_t end) const;

    const lr_world* world_;
    const StepItem* items_;
    uint32_t item_count_;
    uint32_t helpers_;
    uint64_t blocks_;
    uint64_t chunk_; // lane blocks in a chunk
};
} // namespace lr
