// How the bodies of a world are cut into pieces of work.
#pragma once

#include "field/field_step.h"
#include "world/lifecycle.h"
#include "world/world.h"

#include <algorithm>

namespace lr {

// Bodies in a chunk: 64 KiB of state, well inside a second-level cache, and tens of microseconds of work. Tests build it
// with other lengths (-DLR_CHUNK_BODIES): motion must not depend on it.
#if !defined(LR_CHUNK_BODIES)
#define LR_CHUNK_BODIES 1024
#endif
inline constexpr uint32_t chunk_bodies = LR_CHUNK_BODIES;
static_assert(chunk_bodies > 0 && chunk_bodies % lane_block == 0);

inline uint32_t chunk_count(const Batch& batch) {
    return (batch.padded_count() + chunk_bodies - 1) / chunk_bodies;
}

struct StepChunks {
    const lr_world* world;
    uint32_t count;
    const FieldSlice* slice;    // null where there is no wind but a uniform one
    const SurfaceStep* surface; // null without one

    static void run(void* context, uint32_t chunk) {
        const StepChunks& chunks = *static_cast<const StepChunks*>(context);
        const lr_world& w = *chunks.world;
        // The last batch that begins at or before this chunk and has any.
        for (uint32_t i = w.batch_slots; i-- > 0;) {
            const Batch* const batch = w.batches[i].batch;
            if (!batch || batch->first_chunk > chunk || batch->count() == 0) continue;
            const uint32_t begin = (chunk - batch->first_chunk) * chunk_bodies;
            const uint32_t end = std::min(begin + chunk_bodies, batch->padded_count());
            bool last = true;
            const lr_batch handle = pack(BatchHandle{i, w.batches[i].generation});
            if (chunks.slice) {
                step_in_field(*chunks.slice, batch->step, batch->arrays(), handle, batch->count(), begin, end);
                last = chunks.slice->first + chunks.slice->count == chunks.slice->time.substeps;
            } else if (chunks.surface && batch->step.water) {
                step_at_surface(*chunks.surface, batch->step, batch->arrays(), handle, batch->count(), begin, end);
            } else {
                w.target->step(batch->step, batch->arrays(), begin, end);
            }
            // While the chunk is still in the cache.
            if (last && batch->lifecycle()) batch->lifecycle()->judge(w.target->ended, batch->arrays(), begin, end);
            return;
        }
    }
};

} // namespace lr
