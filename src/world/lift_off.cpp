#include "world/lift_off.h"

#include "world/world.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

constexpr uint32_t chunk_bodies = 8 * cut_bodies; // at rest; few of them have their turn
constexpr auto most = static_cast<uint32_t>(field_block), lanes = static_cast<uint32_t>(lane_block);

// What goes is what gains this much of gravity over the substep, in spite of what it touches: more than what lets a body at
// rest stay where it is to the bit, so that nothing wakes only to lie still again.
constexpr float going = 0.05f;

// Copies of bodies at rest.
struct Copies {
    alignas(64) float field[field_count][field_block];
    alignas(64) uint32_t key[field_block];
    alignas(64) float wind[size_t{3} * field_block]; // m/s, x y z of each

    uint32_t take(const BatchArrays& from, const uint32_t* index, uint32_t count) {
        const uint32_t padded = (count + lanes - 1) / lanes * lanes;
        for (size_t f = 0; f < field_count; ++f)
            for (uint32_t i = 0; i < padded && from.field[f]; ++i)
                field[f][i] = from.field[f][index[std::min(i, count - 1)]];
        for (uint32_t i = 0; i < padded; ++i) key[i] = from.key[index[std::min(i, count - 1)]];
        return padded;
    }
    BatchArrays arrays() {
        BatchArrays a{};
        for (size_t f = 0; f < field_count; ++f) a.field[f] = field[f];
        a.key = key;
        return a;
    }
};

Vector wind_of(const Copies& c, uint32_t i) {
    const float* const w = c.wind + size_t{3} * i;
    return {w[0], w[1], w[2]};
}

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
    Copies copies;
    uint32_t padded = copies.take(batch.arrays(), index, count);
    BatchArrays arrays = copies.arrays();
    if (field) {
        for (uint32_t i = 0; i < count; ++i)
            for (size_t k = 0; k < 3; ++k) copies.wind[size_t{3} * i + k] = copies.field[field_x + k][i];
        sample_field(*world_->target, world_->wind, time_.begin + 0.5 * time_.h, item.handle, copies.wind, count,
                     copies.wind);
    } else {
        for (uint32_t i = 0; i < count; ++i) std::copy(in.wind, in.wind + 3, copies.wind + size_t{3} * i);
    }
    alignas(64) uint32_t wet[most] = {};
    if (in.water) {
        const float* const g = world_->gravity;
        world_->target->surface.near(world_->surface.at(time_.begin), world_->surface.highest(), *in.water,
                                     static_cast<float>(time_.h), std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]),
                                     arrays, 0, padded, wet);
    }
    // The velocity of the fluid around a body has no meaning while it lies: there the wind is kept that it has withstood.
    uint32_t tried[most], tried_count = 0;
    Vector wind[most];
    for (uint32_t i = 0; i < count; ++i) {
        const Vector w = wind_of(copies, i);
        const Vector held{copies.field[field_gust_x][i], copies.field[field_gust_y][i], copies.field[field_gust_z][i]};
        if (wet[i] == 0 && (remembers ? withstands(held, w) : dot(w, w) == 0.0f)) continue;
        wind[tried_count] = w;
        tried[tried_count++] = index[i];
    }
    if (tried_count == 0) return;
    padded = copies.take(batch.arrays(), tried, tried_count);
    // In the arrays they are some earlier ones.
    for (uint32_t i = 0; i < padded; ++i)
        batch.resting()->age_of(tried[std::min(i, tried_count - 1)], copies.field[field_age][i],
                                copies.field[field_age_rest][i]);
    for (size_t f = field_gust_x; f <= field_gust_z; ++f) std::fill_n(copies.field[f], padded, 0.0f);
    if (!remembers) arrays.field[field_gust_x] = arrays.field[field_gust_y] = arrays.field[field_gust_z] = nullptr;
    const StepInput one = [&] {
        StepInput s = in;
        s.external.used = 0;
        return s;
    }();
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
        const auto size = [&](size_t f) {
            const Vector v{copies.field[f][i], copies.field[f + 1][i], copies.field[f + 2][i]};
            return length(v);
        };
        const float reach = batch.shape.reach * copies.field[field_scale][i];
        if (size(field_vx) + reach * size(field_wx) > limit) {
            batch.note_rest(tried[i]);
        } else if (remembers) {
            batch.arrays().field[field_gust_x][tried[i]] = wind[i].x;
            batch.arrays().field[field_gust_y][tried[i]] = wind[i].y;
            batch.arrays().field[field_gust_z][tried[i]] = wind[i].z;
        }
    }
}

} // namespace lr
