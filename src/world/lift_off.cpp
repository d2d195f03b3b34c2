#include "world/lift_off.h"

#include "world/world.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

constexpr uint32_t chunk_bodies = 8 * cut_bodies; // at rest; few of them have their turn
constexpr auto most = static_cast<uint32_t>(field_block);

// What goes is what gains this much of gravity over the substep, in spite of what it touches: more than what lets a body at
// rest stay where it is to the bit, so that nothing wakes only to lie still again.
constexpr float going = 0.05f;

} // namespace

LiftOff::LiftOff(lr_world& world, StepItem* items, const StepTime& time) : world_(&world), items_(items), time_(time) {
    for (uint32_t i = 0; i < world.batch_slots; ++i) {
        Batch* const batch = world.batches[i].batch;
        if (!batch || batch->awake() == batch->count()) continue;
        if (batch->contact.layers == 0 && !world.pairs.meets(i)) continue;
        if (!batch->contact_arrays().rest_time) continue;
        if (!world.wind.active() && !world.surface.present() && batch->resting()->withstood(world.wind.uniform.wind))
            continue;
        const uint32_t first = batch->awake() / cut_bodies * cut_bodies;
        items_[item_count_++] = {batch, pack(BatchHandle{i, world.batches[i].generation}), chunks_};
        chunks_ += (batch->count() - first + chunk_bodies - 1) / chunk_bodies;
    }
    surface_ = {world.target, &world.surface, time, world.gravity};
}

void LiftOff::run(const FloatMode& mode) {
    if (chunks_ == 0) return;
    for (uint32_t i = 0; i < item_count_; ++i) {
        Batch& batch = *items_[i].batch;
        bool unfit = false;
        StepInput& in = batch.step;
        in.seed = world_->seed;
        in.first_substep = world_->substep_count;
        in.substeps = 1;
        in.h = static_cast<float>(time_.h);
        in.sqrt_h = std::sqrt(in.h);
        in.inverse_sqrt_h = 1.0f / in.sqrt_h;
        std::copy(world_->gravity, world_->gravity + 3, in.gravity);
        std::copy(world_->wind.uniform.wind, world_->wind.uniform.wind + 3, in.wind_begin);
        std::copy(world_->wind.uniform.wind, world_->wind.uniform.wind + 3, in.wind);
        in.wind_changes = false;
        batch.external.fill(in.external);
        in.water = world_->surface.present() ? batch.water_body(world_->surface.desc(), unfit) : nullptr;
    }
    // Each at the one moment: the field is prepared for it once.
    if (world_->wind.active()) world_->wind.prepare(time_, world_->wind.uniform, 0, 1, world_->seed);
    const uint64_t bodies = uint64_t{chunks_} * chunk_bodies / turns;
    const auto helpers = static_cast<uint32_t>(std::min<uint64_t>(world_->crew.helpers(), bodies / helper_work));
    world_->crew.run(chunks_, helpers, &LiftOff::run_chunk, this, mode);
}

void LiftOff::run_chunk(void* context, uint32_t chunk) {
    LiftOff& all = *static_cast<LiftOff*>(context);
    const StepItem* const end = all.items_ + all.item_count_;
    const StepItem* const item = std::upper_bound(static_cast<const StepItem*>(all.items_), end, uint64_t{chunk},
                                                  [](uint64_t at, const StepItem& i) { return at < i.begin; }) -
                                 1;
    const Batch& batch = *item->batch;
    const uint32_t first = batch.awake() / cut_bodies * cut_bodies;
    const uint32_t begin = first + (chunk - static_cast<uint32_t>(item->begin)) * chunk_bodies;
    all.try_range(*item, std::max(begin, batch.awake()), std::min(begin + chunk_bodies, batch.count()));
}

// Bodies that lie on nothing were put to rest by the caller, and stay.
void LiftOff::try_range(const StepItem& item, uint32_t begin, uint32_t end) {
    const Batch& batch = *item.batch;
    const uint32_t* const key = batch.arrays().key;
    const uint32_t* const touching = batch.contact_arrays().touching[0];
    if (!touching) return; // not of a batch that is among the items
    const auto turn = static_cast<uint32_t>(world_->step_count % turns);
    uint32_t index[most], count = 0;
    for (uint32_t i = begin; i < end; ++i) {
        if (key[i] % turns != turn || touching[i] == 0) continue;
        index[count++] = i;
        if (count < most) continue;
        try_bodies(item, index, count);
        count = 0;
    }
    if (count != 0) try_bodies(item, index, count);
}

void LiftOff::try_bodies(const StepItem& item, const uint32_t* index, uint32_t count) {
    Batch& batch = *item.batch;
    const StepInput& in = batch.step;
    const bool field = world_->wind.active(), remembers = in.loads == Loads::aerodynamic;
    BodyCopies<field_block> copies;
    copies.take(batch.arrays(), count, [&](uint32_t i) { return index[i]; });
    BatchArrays arrays = copies.arrays();
    float winds[3 * field_block]; // m/s, x y z of each
    for (uint32_t i = 0; i < count; ++i)
        put(field ? vector_in(copies.field, field_x, i) : vector_of(in.wind), winds + size_t{3} * i);
    if (field)
        sample_field(*world_->target, world_->wind, time_.begin + 0.5 * time_.h, item.handle, winds, count, winds);
    alignas(64) uint32_t wet[most] = {};
    if (in.water) {
        world_->target->surface.near(world_->surface.at(time_.begin), world_->surface.highest(), *in.water,
                                     static_cast<float>(time_.h), length(vector_of(world_->gravity)), arrays, 0,
                                     copies.padded, wet);
    }
    // The velocity of the fluid around a body has no meaning while it lies: there the wind is kept that it has withstood.
    uint32_t tried[most], tried_count = 0;
    Vector wind[most];
    for (uint32_t i = 0; i < count; ++i) {
        const Vector w = vector_of(winds + size_t{3} * i), held = vector_in(copies.field, field_gust_x, i);
        if (wet[i] == 0 && (remembers ? withstands(held, w) : dot(w, w) == 0.0f)) continue;
        wind[tried_count] = w;
        tried[tried_count++] = index[i];
    }
    if (tried_count == 0) return;
    copies.take(batch.arrays(), tried_count, [&](uint32_t i) { return tried[i]; });
    const uint32_t padded = copies.padded;
    // In the arrays they are some earlier ones.
    for (uint32_t i = 0; i < padded; ++i)
        batch.resting()->age_of(tried[std::min(i, tried_count - 1)], copies.field[field_age][i],
                                copies.field[field_age_rest][i]);
    for (size_t f = field_gust_x; f <= field_gust_z; ++f) std::fill_n(copies.field[f], padded, 0.0f);
    if (!remembers) arrays.field[field_gust_x] = arrays.field[field_gust_y] = arrays.field[field_gust_z] = nullptr;
    StepInput one = in;
    one.external.used = 0;
    const SurfaceStep* const surface = world_->surface.present() ? &surface_ : nullptr;
    ContactRun run = contact_run(*world_, batch, surface, time_, static_cast<float>(time_.h));
    const RestingNeighbours neighbours(*world_, unpack_batch(item.handle).index);
    if (neighbours.any()) run.step.resting = &neighbours;
    if (field)
        step_in_field({world_->target, &world_->wind, time_, 0, 1, surface}, one, &run, arrays, item.handle,
                      tried_count, 0, padded);
    else
        step_near_colliders(run, one, arrays, item.handle, tried_count, 0, padded);
    const float limit = going * run.step.gravity * in.h;
    for (uint32_t i = 0; i < tried_count; ++i) {
        const auto size = [&](size_t f) { return length(vector_in(copies.field, f, i)); };
        const float reach = batch.shape.reach * copies.field[field_scale][i];
        if (size(field_vx) + reach * size(field_wx) > limit) {
            batch.note_rest(tried[i]);
        } else if (remembers) {
            put_in(batch.arrays().field, field_gust_x, tried[i], wind[i]);
        }
    }
}

} // namespace lr
