#include "body_contact/body_contact_step.h"

#include "world/batch/lifecycle.h"
#include "world/sleep/afloat.h"
#include "world/step/step_in_wind.h"
#include "world/world.h"

#include <algorithm>
#include <new>

namespace lr {

BodyContactStep::BodyContactStep(lr_world& world, const StepItem* items, uint32_t count, const WaterStep* surface,
                                 const FloatMode& mode)
    : world_(&world), buffers_(&world.body_contact_buffers), items_(items), workers_(world.step_workers, mode),
      member_count_(count), wet_(surface != nullptr) {
    time_ = items[0].batch->pace.time();
    if (surface) {
        surface_ = *surface;
        surface_.time = time_;
    }
}

bool BodyContactStep::prepare() {
    BodyContactBuffers& c = *buffers_;
    body_count_ = 0;
    for (uint32_t m = 0; m < member_count_; ++m) body_count_ += items_[m].batch->padded_awake();
    if (!grow(world_->allocator, c.members, member_count_) ||
        !grow(world_->allocator, c.before, pose_fields * size_t{body_count_}) ||
        (wet_ && !grow(world_->allocator, c.submerged, body_count_)))
        return false;
    // In the order of batches, not of items.
    uint32_t first = 0;
    for (uint32_t m = 0, slot = 0; m < member_count_; ++slot) {
        const StepItem* const end = items_ + member_count_;
        const StepItem* const item =
            std::find_if(items_, end, [&](const StepItem& i) { return unpack(i.handle).index == slot; });
        if (item == end) continue;
        Batch& batch = *item->batch;
        const auto h = static_cast<float>(time_.h);
        auto* const member = new (&c.members[m++]) BodyContactBatch{
            *item, slot, first, batch.awake(), {}, world_->pairs.has(slot, slot), {}, SleepingNeighbours(*world_, slot),
            {}};
        member->run = contact_run(*world_, batch, wet_ ? &surface_ : nullptr, time_, h);
        member->run.book = batch.contact_cache();
        if (member->sleeping.any()) member->run.step.sleeping = &member->sleeping;
        const WaterBody* const water = batch.step.water;
        for (SolverBodyKind& kind : member->kind)
            kind = {&batch.step.body, batch.asset().shape.reach, batch.pair_hull().shape.radius,
                    rounding_of(batch.asset().shape), rolling_of(batch.contact(), batch.asset().shape)};
        if (water) member->kind[1].body = &water->water;
        first += batch.padded_awake();
    }
    return true;
}

BodyContactBatch& BodyContactStep::member_of(uint32_t body) const {
    BodyContactBatch* at = buffers_->members.data() + member_count_ - 1;
    while (at->first > body) --at;
    return *at;
}

float* BodyContactStep::before(uint32_t body, size_t field) const {
    return buffers_->before.data() + field * body_count_ + body;
}

bool BodyContactStep::wet(const BodyContactBatch& member, uint32_t body) const {
    const WaterBody* const water = member.item.batch->step.water;
    return wet_ && water && water->carries(buffers_->submerged.data()[body]);
}

Pose BodyContactStep::began(uint32_t body) const {
    const auto value = [&](size_t f) { return *before(body, f); };
    return {{value(0), value(1), value(2)}, {value(3), value(4), value(5), value(6)}};
}

void BodyContactStep::move_cut(const BodyContactBatch& member, uint32_t begin, uint32_t end, uint32_t substep) const {
    Batch& batch = *member.item.batch;
    const BatchArrays& arrays = batch.arrays();
    for (size_t f = 0; f < pose_fields; ++f)
        std::copy(arrays.field[f] + begin, arrays.field[f] + end, before(member.first + begin, f));
    float* const submerged = wet_ ? buffers_->submerged.data() + member.first + begin : nullptr;
    if (world_->wind.active()) {
        FieldSlice slice{
            world_->target, &world_->wind, &world_->wind.instant(0), time_, substep, 1, wet_ ? &surface_ : nullptr};
        slice.submerged = submerged;
        step_in_field(slice, batch.step, nullptr, arrays, member.item.handle, batch.awake(), begin, end);
        return;
    }
    step_lanes(*world_->target, wet_ ? &surface_ : nullptr, {time_.begin + substep * time_.h, time_.h, 1},
               substep_of(batch.step, substep), arrays, member.item.handle, batch.awake(), begin, end, submerged);
}

void BodyContactStep::move_alone(uint32_t substep) {
    // For sheltered bodies, a uniform wind is a field too.
    const bool field = world_->wind.active();
    if (field) world_->lap(world_->timings.body_contact);
    world_->wind.prepare(time_, items_[0].batch->pace.wind(world_->wind.uniform), substep, 1, world_->seed);
    if (field) world_->lap(world_->timings.wind);
    each_piece(cut_bodies, 1, [&](const BodyContactBatch& member, uint32_t begin, uint32_t end) {
        move_awake(*member.item.batch, begin, end, [&] { move_sheltered(member, begin, end, substep); });
    });
}

void BodyContactStep::run() {
    for (uint32_t substep = 0; substep < time_.substeps; ++substep) {
        move_alone(substep);
        place_count_ = 0;
        const bool found = find_pairs(substep) && number_touching();
        if (found)
            find_shelter();
        else
            starved_ = true;
        hold(substep, Held::apart);
        const bool solved = place_count_ != 0 && solve();
        if (solved) keep_impulses();
        if (solved && last(substep)) find_carried();
        if (found)
            world_->pair_cache.commit(buffers_->first_pair[body_count_]);
        else
            world_->pair_cache.clear();
        if (place_count_ == 0) continue;
        if (!solved) {
            starved_ = true;
            hold(substep, Held::touching);
            continue;
        }
        workers_.run(place_count_, 256, [&](uint32_t begin, uint32_t end) {
            for (uint32_t place = begin; place < end; ++place) put_back(place, substep);
        });
    }
    each_piece(cut_bodies, 1, [&](const BodyContactBatch& member, uint32_t begin, uint32_t end) {
        Batch& batch = *member.item.batch;
        rest_afloat(*world_, batch, begin, end);
        if (batch.lifecycle()) batch.lifecycle()->judge(world_->target->ended, batch.arrays(), begin, end);
    });
}
} // namespace lr
