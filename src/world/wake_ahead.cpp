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

// The box of a body's way in the step, if it is fast.
bool way_box(const Batch& batch, uint32_t i, float dt, float still, float (&low)[3], float (&high)[3]) {
    const BatchArrays& a = batch.arrays();
    const auto vector = [&](size_t f) { return Vector{a.field[f][i], a.field[f + 1][i], a.field[f + 2][i]}; };
    const float scale = a.field[field_scale][i], reach = batch.shape.reach * scale;
    const Vector v = vector(field_vx);
    const float turns = reach * length(vector(field_wx));
    if (!(length(v) + turns > hits * still * std::sqrt(reach))) return false;
    const Pose pose = pose_of(a, i);
    const Bounds box = bounds(batch.meeting, scale, pose);
    const Vector way = dt * rotate(pose.rotation, v);
    const float more = std::min(dt * turns, 2.0f * reach) + 0.005f * reach;
    const auto put = [&](size_t k, float from, float to, float by) {
        low[k] = from + std::min(by, 0.0f) - more;
        high[k] = to + std::max(by, 0.0f) + more;
    };
    put(0, box.low.x, box.high.x, way.x);
    put(1, box.low.y, box.high.y, way.y);
    put(2, box.low.z, box.high.z, way.z);
    return true;
}

void note_ahead(lr_world& world, uint32_t slot, uint32_t i, float dt, float still) {
    float low[3], high[3];
    if (!way_box(*world.batches[slot].batch, i, dt, still, low, high)) return;
    world.pairs.visit_partners(slot, [&](uint32_t other) {
        Batch& partner = *world.batches[other].batch;
        partner.look_at_resting(low, high, [&](uint32_t index) { partner.note_rest(index); });
    });
}

} // namespace

void wake_ahead(lr_world& world, float dt, const FloatMode& mode) {
    const Workers workers(world.crew, mode);
    const float* const g = world.gravity;
    const float still = still_speed(std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]));
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
