#include "world/resting_neighbours.h"

#include "contact/pair_batch.h"
#include "world/world.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

struct Neighbour {
    uint32_t batch, key, index;
    bool operator<(const Neighbour& other) const {
        return batch != other.batch ? batch < other.batch : key != other.key ? key < other.key : index < other.index;
    }
};

bool equal(Vector a, Vector b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

// The first so many by batch and key, each once, whatever the order in which they come.
struct Neighbours {
    Neighbour found[most_resting];
    uint32_t count = 0;

    void take(const Neighbour& one) {
        uint32_t at = count;
        while (at > 0 && one < found[at - 1]) --at;
        if (at > 0 && !(found[at - 1] < one)) return;
        if (at == most_resting) return;
        count = std::min(count + 1, most_resting);
        for (uint32_t i = count - 1; i > at; --i) found[i] = found[i - 1];
        found[at] = one;
    }
};

} // namespace

RestingNeighbours::RestingNeighbours(const lr_world& world, uint32_t slot) : world_(&world), slot_(slot) {
    world.pairs.visit_partners(slot, [&](uint32_t other) {
        const Batch& batch = *world.batches[other].batch;
        any_ = any_ || batch.awake() < batch.count();
    });
}

uint32_t RestingNeighbours::touched_by(uint32_t key, float scale, const Pose& from, const Pose& to, float margin,
                                       RestingTouch (&out)[most_resting]) const {
    const Batch& own = *world_->batches[slot_].batch;
    const PairBody moving = pair_body(own.meeting, scale, from, to);
    const float within = margin + moving.way();
    const Box box = grown(bounds(own.meeting, scale, from), within);
    Neighbours near;
    world_->pairs.visit_partners(slot_, [&](uint32_t other) {
        const Batch& batch = *world_->batches[other].batch;
        batch.look_at_resting(box, [&](uint32_t index) {
            const uint32_t its = batch.arrays().key[index];
            // A copy of a body at rest does not meet that.
            if (other == slot_ && its == key && equal(pose_of(batch.arrays(), index).position, from.position)) return;
            near.take({other, its, index});
        });
    });
    PairBody others[most_resting];
    PairBatch pairs(pair_search(world_->target->simd));
    const auto found = [&](uint32_t n, const WayContact* contacts, uint32_t count) {
        out[n].count = count;
        for (uint32_t k = 0; k < count; ++k) {
            out[n].contact[k] = contacts[k].begin;
            out[n].contact[k].gap = contacts[k].end;
        }
    };
    for (uint32_t n = 0; n < near.count; ++n) {
        const Neighbour& one = near.found[n];
        const Batch& batch = *world_->batches[one.batch].batch;
        const Pose pose = pose_of(batch.arrays(), one.index);
        others[n] = {&batch.meeting, batch.arrays().field[field_scale][one.index], pose, pose, {}, 0.0f};
        pairs.find(moving, others[n], margin, n, found);
    }
    pairs.finish(found);
    uint32_t count = 0;
    for (uint32_t n = 0; n < near.count; ++n) {
        if (out[n].count == 0) continue;
        if (n != count) out[count] = out[n];
        RestingTouch& touch = out[count++];
        const Batch& batch = *world_->batches[near.found[n].batch].batch;
        touch.batch = near.found[n].batch;
        touch.index = near.found[n].index;
        touch.friction = pair_friction(own.contact, batch.contact);
        touch.restitution = pair_restitution(own.contact, batch.contact);
    }
    return count;
}

} // namespace lr
