#include "world/schedule/step_chunks.h"

#include "world/batch/batch.h"
#include "world/batch/lifecycle.h"
#include "world/sleep/afloat.h"
#include "world/step/step_in_wind.h"
#include "world/world.h"

namespace lr {
namespace {

constexpr uint64_t cut_blocks = cut_bodies / lane_block;
constexpr uint64_t chunks_a_thread = 8; // short enough that no thread waits long for the last
constexpr uint64_t most_chunks = 1u << 24;
} // namespace

StepChunks::StepChunks(const lr_world& world, const StepItem* items, uint32_t item_count, uint64_t lane_blocks,
                       uint64_t work, uint64_t cost, uint32_t helpers)
    : world_(&world), items_(items), item_count_(item_count), blocks_(lane_blocks) {
    helpers_ = static_cast<uint32_t>(std::min<uint64_t>(helpers, cost / helper_cost));
    if (helpers_ == 0) {
        chunk_ = std::max<uint64_t>(lane_blocks, 1);
        return;
    }
    const uint64_t even = lane_blocks / (chunks_a_thread * (helpers_ + 1)) / cut_blocks * cut_blocks;
    const uint64_t substeps = std::max<uint64_t>(work / (lane_blocks * lane_block), 1);
    const uint64_t most_bodies = std::clamp<uint64_t>(most_chunk_work / substeps, cut_bodies, most_chunk_bodies);
    chunk_ = std::max(std::clamp(even, cut_blocks, most_bodies / lane_block / cut_blocks * cut_blocks),
                      lane_blocks / most_chunks);
}

void StepChunks::run(uint32_t chunk) const {
    const uint64_t from = chunk * chunk_, to = std::min(from + chunk_, blocks_);
    const StepItem* const end = items_ + item_count_;
    const StepItem* item = item_at(items_, item_count_, from);
    const auto cut = [](uint64_t blocks) { return static_cast<uint32_t>(blocks / cut_blocks * cut_bodies); };
    for (; item != end && item->begin < to; ++item) {
        const uint32_t lanes = item->batch->padded_awake();
        const uint32_t first = from <= item->begin ? 0 : cut(from - item->begin);
        const uint32_t last = to - item->begin >= lanes / lane_block ? lanes : cut(to - item->begin);
        if (first != last) step(*item, first, last);
    }
}

ContactRun contact_run(const lr_world& world, Batch& batch, const WaterStep* water, const StepTime& time,
                       float seconds) {
    const Vector weight = vector_of(world.gravity);
    const float gravity = length(weight);
    // m/s: speed gained in the step, which widens the search for contacts. Twice gravity, to allow for other loads; the wind, which light bodies take
    // on within a step; much for external forces.
    const float forced = batch.step.external.any ? 50.0f : 0.0f;
    const float gain = 2.0f * seconds * gravity + world.wind.fastest() + forced;
    const ContactStep step{world.target->contact,
                           &world.colliders,
                           &batch.asset().shape,
                           &batch.contact(),
                           weight,
                           gravity,
                           static_cast<float>(batch.settings().fluid_density),
                           seconds,
                           gain};
    return {step, world.target, water, time, {}, still_speed(gravity)};
}

void StepChunks::step(const StepItem& item, uint32_t begin, uint32_t end) const {
    Batch& batch = *item.batch;
    move_awake(batch, begin, end, [&] { move_bodies(item, begin, end); });
    // Here the bodies are still in the cache.
    if (slice && slice->first + slice->count != slice->time.substeps) return;
    rest_afloat(*world_, batch, begin, end);
    if (batch.lifecycle()) batch.lifecycle()->judge(world_->target->ended, batch.arrays(), begin, end);
}

void StepChunks::move_bodies(const StepItem& item, uint32_t begin, uint32_t end) const {
    Batch& batch = *item.batch;
    const BatchArrays& arrays = batch.arrays();
    const bool touching = colliders && batch.contact().layers != 0;
    const auto contact_here = [&](const WaterStep* water) {
        ContactRun run = contact_run(*world_, batch, water, batch.pace.time(), static_cast<float>(batch.pace.behind()));
        run.book = batch.contact_cache();
        return run;
    };
    if (slice) {
        const ContactRun run = touching ? contact_here(slice->surface) : ContactRun{};
        step_in_field(*slice, batch.step, touching ? &run : nullptr, arrays, item.handle, batch.awake(), begin, end);
    } else if (touching) {
        step_near_colliders(contact_here(surface), batch.step, arrays, item.handle, batch.awake(), begin, end);
    } else if (surface && batch.step.water) {
        step_lanes(*world_->target, surface, batch.pace.time(), batch.step, arrays, item.handle, batch.awake(), begin,
                   end);
    } else {
        const uint32_t alive = std::min(end, batch.awake()), whole = alive - alive % uint32_t{lane_block};
        const bool few = world_->narrow && alive > whole && alive - whole <= narrow_lanes;
        if (!few || whole > begin) world_->target->step(batch.step, arrays, begin, few ? whole : end);
        if (few) world_->narrow->step(batch.step, arrays, whole, whole + narrow_lanes);
    }
}
} // namespace lr
