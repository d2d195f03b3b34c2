// Shelter of awake bodies: those under others feel only a share of the wind.
#include "body_contact/body_contact_step.h"

#include "world/sleep/shelter.h"
#include "world/step/step_in_wind.h"
#include "world/world.h"

#include <algorithm>

namespace lr {
namespace {

// A body's turn comes in one of so many substeps, by its noise seed; and in the first after it has woken.
constexpr uint32_t turns = 8;

bool blows(const StepInput& in) {
    const auto any = [](const float(&wind)[3]) { return dot(vector_of(wind), vector_of(wind)) > 0.0f; };
    return any(in.wind) || any(in.wind_begin);
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

// Finds how far bodies are sheltered in the next substeps, from where all were as this one began. Awake bodies cover each other where
// their boxes overlap. False when out of memory.
bool BodyContactStep::find_shelter(uint32_t substep) {
    BodyContactBuffers& c = *buffers_;
    if (!grow(world_->allocator, c.hidden, body_count_)) return false;
    const bool field = world_->wind.active();
    bool any = field;
    for (uint32_t m = 0; m < member_count_; ++m) any = any || blows(c.members[m].item.batch->step);
    if (any) std::fill_n(c.hidden.data(), body_count_, Hidden{});
    const auto asks = [&](uint32_t body) {
        const BodyContactBatch& member = member_of(body);
        return (field || blows(member.item.batch->step)) && in_question(member, body - member.first, substep);
    };
    const uint32_t finders = any ? body_count_ : 0; // without wind there is nothing to find
    workers_.run(finders, 128, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = c.first_pair[begin]; i < c.first_pair[end]; ++i) {
            const uint32_t pair[2] = {c.pairs[i].a, c.pairs[i].b};
            for (uint32_t k = 0; k < 2; ++k) {
                if (!asks(pair[k])) continue;
                const PairBody &one = c.moved[pair[k]].body, &other = c.moved[pair[1 - k]].body;
                Hidden hidden;
                hide(*one.shape, one.scale, one.from, *other.shape, other.scale, other.from, hidden);
                if ((hidden.above | hidden.below) != 0) add(c.hidden[pair[k]], hidden);
            }
        }
    });
    workers_.run(body_count_, 128, [&](uint32_t begin, uint32_t end) {
        for (uint32_t body = begin; body < end; ++body) {
            const BodyContactBatch& member = member_of(body);
            const uint32_t index = body - member.first;
            if (index >= member.count || !in_question(member, index, substep)) continue;
            const float open =
                asks(body) ? open_to_wind(*world_, member.slot, index, began(body), c.hidden[body]) : 1.0f;
            member.run.book.lee[index] = 1.0f - felt_wind(open);
        }
    });
    return true;
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
    // In a uniform wind gravity is that of the fluid's frame, which is not theirs.
    if (in.wind_changes) std::copy(world_->gravity, world_->gravity + 3, in.gravity);
    in.wind_changes = false;
    float felt[cut_bodies];
    for (uint32_t i = 0; i < copies.padded; ++i) felt[i] = i < count ? 1.0f - lee[index[i]] : 1.0f;
    BatchArrays arrays = copies.arrays();
    for (size_t f = 0; f < field_count; ++f)
        if (!batch.arrays().field[f]) arrays.field[f] = nullptr;
    const FieldSlice slice{world_->target, &world_->wind, time_, substep, 1, wet_ ? &surface_ : nullptr, felt};
    step_in_field(slice, in, nullptr, arrays, member.item.handle, count, 0, copies.padded);
    copies.put_back(batch.arrays(), at);
}
} // namespace lr
