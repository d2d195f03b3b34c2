// Shelter of awake bodies: a body under others feels only a share of the wind.
#include "body_contact/body_contact_step.h"

#include "world/sleep/shelter.h"
#include "world/step/step_in_wind.h"
#include "world/world.h"

#include <algorithm>

namespace lr {
namespace {

// A body's shelter is found in one of so many substeps, by its noise seed, and in the first after it has woken.
constexpr uint32_t turns = 8;

bool blows(const StepInput& in) {
    const auto any = [](const float(&wind)[3]) { return dot(vector_of(wind), vector_of(wind)) > 0.0f; };
    return any(in.wind) || any(in.wind_begin);
}
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

// Takes all bodies of [begin, end) through a substep, sheltered ones as copies in a weaker wind.
void BodyContactStep::move_sheltered(const BodyContactBatch& member, uint32_t begin, uint32_t end,
                                     uint32_t substep) const {
    const Batch& batch = *member.item.batch;
    const float* const lee = member.run.book.lee;
    uint32_t index[cut_bodies], count = 0;
    for (uint32_t i = begin; i < std::min(end, batch.awake()) && lee; ++i)
        if (lee[i] > 0.0f) index[count++] = i;
    if (count == 0) return move_cut(member, begin, end, substep);
    const auto at = [&](uint32_t i) { return index[i]; };
    StepInput in = batch.step;
    BodyCopies<cut_bodies> copies;
    copies.take(batch.arrays(), count, at);
    copies.take_forces(in.external, at, false);
    move_cut(member, begin, end, substep);
    copies.lend_forces(in.external);
    // In a uniform wind that changes, gravity is that of the fluid's frame. The copies are stepped in a field, in the world's frame.
    if (in.wind_changes) std::copy(world_->gravity, world_->gravity + 3, in.gravity);
    in.wind_changes = false;
    float felt[cut_bodies];
    for (uint32_t i = 0; i < copies.padded; ++i) felt[i] = i < count ? 1.0f - lee[index[i]] : 1.0f;
    BatchArrays arrays = copies.arrays();
    for (size_t f = 0; f < field_count; ++f)
        if (!batch.arrays().field[f]) arrays.field[f] = nullptr;
    float submerged[cut_bodies];
    const FieldSlice slice{world_->target, &world_->wind, time_, substep, 1, wet_ ? &surface_ : nullptr,
                           felt,           submerged};
    step_in_field(slice, in, nullptr, arrays, member.item.handle, count, 0, copies.padded);
    copies.put_back(batch.arrays(), at);
    for (uint32_t i = 0; i < count && wet_ && in.water; ++i)
        buffers_->submerged.data()[member.first + index[i]] = submerged[i];
}
} // namespace lr
