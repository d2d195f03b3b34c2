// How the bodies of a world are cut into pieces of work.
#pragma once

#include "kernel/step.h"
#include "langevin_rigid.h"

#include <cstdint>

struct lr_world;

namespace lr {

class Batch;
struct FieldSlice;
struct SurfaceStep;
struct ContactRun;

// Tests build it with other lengths (-DLR_CHUNK_BODIES): motion must not depend on it.
#if !defined(LR_CHUNK_BODIES)
#define LR_CHUNK_BODIES 1024
#endif
static_assert(LR_CHUNK_BODIES > 0 && LR_CHUNK_BODIES % lane_block == 0);

// Batches are cut at multiples of this only. Rules note where bodies have ended by such cuts, each written by one thread.
inline constexpr uint32_t cut_bodies = LR_CHUNK_BODIES < 256 ? LR_CHUNK_BODIES : 256;
// Of a chunk in a large world. Shorter ones cost nothing down to a cut, but longer ones would make the caller wait for the
// last of them, the more so if its thread is not alone on its core.
inline constexpr uint32_t most_chunk_bodies = LR_CHUNK_BODIES;
inline constexpr uint32_t most_chunk_work = 8192; // body-substeps
// Body-substeps for which another thread is called: tens of microseconds, when waking it takes up to ten.
inline constexpr uint64_t helper_work = 4096;

// The most bodies, at the end of a batch, for which the narrow target steps fewer lanes.
inline constexpr uint32_t narrow_lanes = 4;

struct StepTime;
// Of a batch in a stretch of `seconds`; nothing is noted of its bodies.
ContactRun contact_run(const lr_world& world, Batch& batch, const SurfaceStep* water, const StepTime& time,
                       float seconds);

inline uint32_t cut_count(uint32_t lanes) {
    return (lanes + cut_bodies - 1) / cut_bodies;
}

// A batch with bodies that move, on the line of all lane blocks of a step.
struct StepItem {
    Batch* batch;
    lr_batch handle;
    uint64_t begin; // its first lane block
};

// Chunks are equal lengths of that line, their ends moved back to the last cut: a chunk is part of a large batch, or many
// small ones.
class StepChunks {
public:
    // work: body-substeps of one run over them.
    StepChunks(const lr_world& world, const StepItem* items, uint32_t item_count, uint64_t lane_blocks, uint64_t work,
               uint32_t helpers);

    const FieldSlice* slice = nullptr;    // null where there is no wind but a uniform one
    const SurfaceStep* surface = nullptr; // null without one; each batch has its own time
    bool colliders = false;               // has the world any?

    uint32_t count() const { return static_cast<uint32_t>((blocks_ + chunk_ - 1) / chunk_); }
    uint32_t helpers() const { return helpers_; } // threads besides the caller that are worth their waking
    static void run(void* chunks, uint32_t chunk);

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
