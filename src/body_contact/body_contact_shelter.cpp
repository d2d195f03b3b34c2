// Shelter of awake bodies: a body under others feels only a share of the wind.
#include "body_contact/body_contact_step.h"

#include "base/scratch.h"
#include "world/sleep/shelter.h"
#include "world/step/step_in_wind.h"
#include "world/world.h"

#include <algorithm>

namespace lr {
namespace {

// A body's shelter is found in one of so many substeps, by its noise seed, and in the first after it has woken.
constexpr uint32_t turns = 8;

bool asked(const Hidden& hidden) {
    return __atomic_load_n(&hidden.above, __ATOMIC_RELAXED) != BodyContactBuffers::unasked.above;
}
// Bits come from several threads.
void add(Hidden& to, const Hidden& bits) {
    __atomic_fetch_or(&to.above, bits.above, __ATOMIC_RELAXED);
    __atomic_fetch_or(&to.below, bits.below, __ATOMIC_RELAXED);
}
} // namespace

bool BodyContactStep::in_question(const BodyContactBatch& member, uint32_t index, uint32_t substep) const {
    const Batch& batch = *member.item.batch;
    const uint64_t at = batch.step.first_substep + substep + batch.arrays().noise_seed[index];
    return at % turns == 0 || member.run.book.lee[index] < 0.0f;
}

// If the body's shelter is to be found in this substep, and there is wind, it starts as wholly open; else it is not asked for.
void BodyContactStep::ask_for_shelter(const BodyContactBatch& member, uint32_t index, uint32_t substep) {
    Hidden& hidden = buffers_->hidden[member.first + index];
    hidden = BodyContactBuffers::unasked;
    if (!in_question(member, index, substep)) return;
    if (world_->wind.active() || blows(member.item.batch->step))
        hidden = {};
    else
        member.run.book.lee[index] = 0.0f;
}

// For awake bodies whose boxes overlap: which points of each the other covers, as both lay when the substep began.
void BodyContactStep::hide_each_other(uint32_t one, uint32_t other) {
    BodyContactBuffers& c = *buffers_;
    const auto hide_by = [&](uint32_t body, uint32_t by) {
        if (!asked(c.hidden[body])) return;
        const PairBody &own = c.moved[body].body, &cover = c.moved[by].body;
        Hidden hidden;
        hide(*own.shape, own.scale, own.from, *cover.shape, cover.scale, cover.from, hidden);
        if ((hidden.above | hidden.below) != 0) add(c.hidden[body], hidden);
    };
    hide_by(one, other);
    hide_by(other, one);
}

// Sets the share of the wind that bodies lose until their next turn.
void BodyContactStep::find_shelter() {
    BodyContactBuffers& c = *buffers_;
    workers_.run(body_count_, 128, [&](uint32_t begin, uint32_t end) {
        for (uint32_t body = begin; body < end; ++body) {
            if (!asked(c.hidden[body])) continue;
            const BodyContactBatch& member = member_of(body);
            const uint32_t index = body - member.first;
            const float open = open_to_wind(*world_, member.slot, index, began(body), c.hidden[body]);
            member.run.book.lee[index] = 1.0f - felt_wind(open);
        }
    });
}

// Takes all bodies of [begin, end) through a substep, sheltered ones and those beside walls as copies in a wind of their own.
void BodyContactStep::move_sheltered(const BodyContactBatch& member, uint32_t begin, uint32_t end,
                                     uint32_t substep) const {
    const Batch& batch = *member.item.batch;
    const float* const lee = member.run.book.lee;
    const ContactStep& contact = member.run.step;
    const bool walled = contact.settings->layers != 0 && (wet_ || world_->wind.active() || blows(batch.step));
    alignas(64) uint32_t near[cut_bodies];
    if (walled)
        contact.target->near(contact.colliders->near(), contact.shape->reach, static_cast<float>(time_.h), contact.gain,
                             batch.arrays(), begin, end, near);
    const auto felt_by = [&](uint32_t i, FeltFlow& felt) {
        if (lee && lee[i] > 0.0f) felt.share = 1.0f - lee[i];
        if (walled && near[i - begin] != 0)
            felt.walls = walls_near(contact, batch.arrays(), i, (near[i - begin] & near_bits) == 0,
                                    contact_substep(time_, substep, nullptr));
        return felt.share < 1.0f || felt.walls.count != 0;
    };
    const uint32_t live = std::max(std::min(end, batch.awake()), begin) - begin;
    const auto index = [begin](uint32_t k) { return begin + k; };
    const InScratch<StepApart> apart(batch.step, batch.arrays(), live, index, felt_by);
    move_cut(member, begin, end, substep);
    if (!apart->any()) return;
    float* const submerged = wet_ ? buffers_->submerged.data() + member.first + begin : nullptr;
    apart->step(
        {world_->target, &world_->wind, &world_->wind.instant(0), time_, substep, 1, wet_ ? &surface_ : nullptr},
        batch.step, vector_of(world_->gravity), batch.arrays(), member.item.handle, submerged, begin);
}
} // namespace lr
