#include "world/wake_ahead.h"

#include "world/resting_neighbours.h"
#include "world/workers.h"
#include "world/world.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

constexpr uint32_t grain = 256; // bodies
// Of the speed of what lies still: that of a fall by a tenth of the reach. Slower ones, as all in a heap that settles, do no more
// than wake what they touch.
constexpr float hits = 100.0f;

void note_ahead(lr_world& world, uint32_t slot, uint32_t i, float dt, float still) {
    const Batch& batch = *world.batches[slot].batch;
    const BatchArrays& a = batch.arrays();
    const float scale = a.field[field_scale][i], reach = batch.shape.reach * scale;
    const Vector v = vector_in(a.field, field_vx, i);
    const float turns = reach * length(vector_in(a.field, field_wx, i));
    if (!(length(v) + turns > hits * still * std::sqrt(reach))) return;
    // Of its way in the step.
    const Pose pose = pose_of(a, i);
    const Box box = bounds(batch.meeting, scale, pose);
    const Vector way = dt * rotate(pose.rotation, v), none{0.0f, 0.0f, 0.0f};
    const Box around = grown({box.low + low_of(way, none), box.high + high_of(way, none)},
                             std::min(dt * turns, 2.0f * reach) + 0.005f * reach);
    world.pairs.visit_partners(slot, [&](uint32_t other) {
        Batch& partner = *world.batches[other].batch;
        partner.look_at_resting(around, [&](uint32_t index) { partner.note_rest(index); });
    });
}

} // namespace

void wake_ahead(lr_world& world, float dt, const FloatMode& mode) {
    const Workers workers(world.crew, mode);
    const float still = still_speed(length(vector_of(world.gravity)));
    bool any = false;
    for (uint32_t slot = 0; slot < world.batch_slots; ++slot) {
        const Batch* const batch = world.batches[slot].batch;
        if (!batch || batch->awake() == 0 || !RestingNeighbours(world, slot).any()) continue;
        any = true;
        workers.run(batch->awake(), grain, [&](uint32_t begin, uint32_t end) {
            for (uint32_t i = begin; i < end; ++i) note_ahead(world, slot, i, dt, still);
        });
    }
    for (uint32_t slot = 0; slot < world.batch_slots && any; ++slot)
        if (world.batches[slot].batch && world.pairs.meets(slot)) world.batches[slot].batch->wake_noted();
}

} // namespace lr
