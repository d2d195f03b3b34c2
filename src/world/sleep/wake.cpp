#include "world/sleep/wake.h"

#include "base/scratch.h"
#include "base/step_workers.h"
#include "world/sleep/afloat.h"
#include "world/sleep/shelter.h"
#include "world/world.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lr {
namespace {

constexpr uint32_t chunk_bodies = 8 * cut_bodies; // of sleeping bodies, few of which have their turn
constexpr auto most = static_cast<uint32_t>(field_block);

// A body wakes if it gains this share of gravity in spite of its contacts. That is above the static lock's limit, or it would lie still again.
constexpr float going = 0.05f;

// Share of the reach: a sleeping body stays though the sleeping ones below it have sunk by so little. Falls by less would wake the bodies above, one
// after another, for as long as a heap is high.
constexpr float sagged = 0.005f;

constexpr uint32_t grain = 256; // bodies
// Times still_speed: the speed of a fall by a tenth of the reach. Slower bodies, as in a settling heap, wake only bodies that they touch.
constexpr float hits = 100.0f, near_path = 0.005f; // share of the reach

// The first cut that has sleeping bodies.
uint32_t first_cut(const Batch& batch) {
    return batch.awake() / cut_bodies * cut_bodies;
}

// Notes the sleeping bodies that a fast body will touch in this step if it goes on as it moves.
void note_ahead(lr_world& world, const SleepingNeighbours& neighbours, const Batch& batch, uint32_t i, float dt,
                float still) {
    const BatchArrays& a = batch.arrays();
    const float scale = a.field[field_scale][i], reach = batch.asset().shape.reach * scale;
    const Vector v = vector_in(a.field, field_vx, i), w = vector_in(a.field, field_wx, i);
    if (!(length(v) + reach * length(w) > hits * still * std::sqrt(reach))) return;
    const Pose from = pose_of(a, i);
    const Vector half = 0.5f * dt * w, way = dt * (rotate(from.rotation, v) + 0.5f * dt * vector_of(world.gravity));
    const Pose to{from.position + way, normalised(from.rotation * Rotation{half.x, half.y, half.z, 1.0f})};
    SleepingTouch touches[most_sleeping];
    const uint32_t count = neighbours.touched_by(a.noise_seed[i], scale, from, to, near_path * reach, touches);
    for (uint32_t n = 0; n < count; ++n) world.batches[touches[n].batch].batch->note_sleep(touches[n].index);
}
} // namespace

WakeByFlow::WakeByFlow(lr_world& world, StepItem* items, const StepTime& time)
    : world_(&world), items_(items), time_(time), surface_{world.target, &world.surface, time, world.gravity} {
    world.each_batch([&](Batch& batch, uint32_t slot) {
        if (batch.awake() == batch.count() || !batch.columns().has(part_contact)) return;
        if (batch.contact().layers == 0 && !world.pairs.has_contact(slot)) return;
        if (!world.wind.active() && !world.surface.present() && batch.sleeping()->withstood(world.wind.uniform.wind))
            return;
        items_[item_count_++] = {&batch, world.handle(slot), chunks_};
        chunks_ += (batch.count() - first_cut(batch) + chunk_bodies - 1) / chunk_bodies;
    });
}

void WakeByFlow::run(const FloatMode& mode) {
    if (chunks_ == 0) return;
    for (uint32_t i = 0; i < item_count_; ++i) {
        bool unfit = false;
        StepInput& in = items_[i].batch->step;
        world_->fill_input(*items_[i].batch, time_, world_->substep_count, world_->wind.uniform.wind, unfit);
        in.sqrt_h = std::sqrt(in.h);
        in.inverse_sqrt_h = 1.0f / in.sqrt_h;
    }
    // All trials are at one moment, so the field is prepared once. Uniform wind is that at the step's end; for sheltered bodies it is a field.
    UniformWind uniform = world_->wind.uniform;
    if (!world_->wind.active()) std::copy(uniform.wind, uniform.wind + 3, uniform.before);
    world_->wind.prepare(time_, uniform, 0, 1, world_->seed);
    const uint64_t bodies = uint64_t{chunks_} * chunk_bodies / turns;
    const auto helpers =
        static_cast<uint32_t>(std::min<uint64_t>(world_->step_workers.helpers(), bodies / helper_cost));
    const auto try_chunk = [this](uint32_t chunk) {
        const StepItem& item = *item_at(items_, item_count_, chunk);
        const Batch& batch = *item.batch;
        const uint32_t begin = first_cut(batch) + (chunk - static_cast<uint32_t>(item.begin)) * chunk_bodies;
        try_range(item, std::max(begin, batch.awake()), std::min(begin + chunk_bodies, batch.count()));
    };
    world_->step_workers.run(chunks_, helpers, try_chunk, mode);
}

// Bodies that touch nothing stay asleep: the caller put them to sleep.
void WakeByFlow::try_range(const StepItem& item, uint32_t begin, uint32_t end) {
    const Batch& batch = *item.batch;
    const uint32_t* const noise_seed = batch.arrays().noise_seed;
    const uint32_t* const touching = batch.columns().row<uint32_t>(column_touching);
    if (!touching) return; // a batch that can touch nothing is not among the items
    const auto turn = static_cast<uint32_t>(world_->step_count % turns);
    uint32_t index[most], count = 0;
    for (uint32_t i = begin; i < end; ++i) {
        if (noise_seed[i] % turns != turn || touching[i] == 0) continue;
        if (touching[i] == touching_water && !world_->wind.active()) {
            if (wakes_afloat(*world_, batch, i, vector_of(world_->wind.uniform.wind))) item.batch->note_sleep(i);
            continue;
        }
        index[count++] = i;
        if (count < most) continue;
        try_bodies(item, index, count);
        count = 0;
    }
    if (count != 0) try_bodies(item, index, count);
}

void WakeByFlow::try_bodies(const StepItem& item, const uint32_t* index, uint32_t count) {
    Batch& batch = *item.batch;
    const StepInput& in = batch.step;
    const bool field = world_->wind.active(), remembers = in.loads == Loads::aerodynamic;
    const InScratch<BodyCopies<field_block>> in_scratch;
    BodyCopies<field_block>& copies = *in_scratch;
    copies.take(batch.arrays(), count, [&](uint32_t i) { return index[i]; });
    BatchArrays arrays = copies.arrays();
    float winds[3 * field_block]; // m/s, x y z each
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
    uint32_t tried[most], tried_count = 0;
    Vector wind[most];
    for (uint32_t i = 0; i < count; ++i) {
        const Vector w = vector_of(winds + size_t{3} * i), held = vector_in(copies.field, field_gust_x, i);
        if (batch.columns().row<uint32_t>(column_touching)[index[i]] == touching_water) {
            if (wakes_afloat(*world_, batch, index[i], w)) batch.note_sleep(index[i]);
            continue;
        }
        if (wet[i] == 0 && !batch.doubted(index[i]) && (remembers ? withstands(held, w) : dot(w, w) == 0.0f)) continue;
        wind[tried_count] = w;
        tried[tried_count++] = index[i];
    }
    if (tried_count == 0) return;
    const SleepingNeighbours neighbours(*world_, unpack(item.handle).index, sagged);
    bool moves[most];
    take_substep(item, neighbours, tried, tried_count, nullptr, moves);
    // The open wind would move them; those in shelter take a second trial in weaker wind.
    uint32_t sheltered[most], in_tried[most], sheltered_count = 0;
    const InScratch<std::array<FeltFlow, most>> own;
    FeltFlow* const felt = own->data();
    for (uint32_t i = 0; i < tried_count; ++i) {
        batch.set_lee(tried[i], 0.0f);
        if (!moves[i]) {
            if (remembers) batch.store_wind(tried[i], wind[i], false);
            continue;
        }
        const float open = neighbours.any() ? open_to_wind(*world_, unpack(item.handle).index, tried[i],
                                                           pose_of(batch.arrays(), tried[i]), {})
                                            : 1.0f;
        if (open == 1.0f) {
            batch.note_sleep(tried[i]);
            continue;
        }
        felt[sheltered_count] = {felt_wind(open), {0, {}}};
        in_tried[sheltered_count] = i;
        sheltered[sheltered_count++] = tried[i];
    }
    if (sheltered_count == 0) return;
    take_substep(item, neighbours, sheltered, sheltered_count, felt, moves);
    for (uint32_t i = 0; i < sheltered_count; ++i) {
        if (moves[i])
            batch.note_sleep(sheltered[i]);
        else if (remembers)
            batch.store_wind(sheltered[i], wind[in_tried[i]], true);
    }
}

void WakeByFlow::take_substep(const StepItem& item, const SleepingNeighbours& neighbours, const uint32_t* index,
                              uint32_t count, const FeltFlow* felt, bool* moves) {
    Batch& batch = *item.batch;
    const InScratch<BodyCopies<field_block>> in_scratch;
    BodyCopies<field_block>& copies = *in_scratch;
    copies.take(batch.arrays(), count, [&](uint32_t i) { return index[i]; });
    BatchArrays arrays = copies.arrays();
    const uint32_t padded = copies.padded;
    // The arrays are not updated for sleeping bodies.
    for (uint32_t i = 0; i < padded; ++i)
        batch.sleeping()->age_of(index[std::min(i, count - 1)], copies.field[field_age][i],
                                 copies.field[field_age_remainder][i]);
    for (size_t f = field_gust_x; f < field_count; ++f) std::fill_n(copies.field[f], padded, 0.0f);
    if (batch.step.loads != Loads::aerodynamic)
        for (size_t f = field_gust_x; f < field_count; ++f) arrays.field[f] = nullptr;
    StepInput one = batch.step;
    one.external.used = 0;
    const WaterStep* const surface = world_->surface.present() ? &surface_ : nullptr;
    ContactRun run = contact_run(*world_, batch, surface, time_, static_cast<float>(time_.h));
    if (neighbours.any()) run.step.sleeping = &neighbours;
    float fall[most];
    std::fill_n(fall, count, run.step.gravity);
    run.fall = fall;
    if (world_->wind.active() || felt)
        step_in_field({world_->target, &world_->wind, &world_->wind.instant(0), time_, 0, 1, surface, felt}, one, &run,
                      arrays, item.handle, count, 0, padded);
    else
        step_near_colliders(run, one, arrays, item.handle, count, 0, padded);
    const float limit = going * run.step.gravity * one.h;
    for (uint32_t i = 0; i < count; ++i) {
        const auto size = [&](size_t f) { return length(vector_in(copies.field, f, i)); };
        const float reach = batch.asset().shape.reach * copies.field[field_scale][i];
        // In water a body may fall with less than that share of gravity: half of its own fall shows that it has no support.
        const Vector v = rotate(pose_of(arrays, i).rotation, vector_in(copies.field, field_vx, i));
        moves[i] = size(field_vx) + reach * size(field_wx) > limit ||
                   std::abs(dot(v, vector_of(world_->gravity))) > 0.5f * fall[i] * run.step.gravity * one.h;
    }
}

void wake_before_hit(lr_world& world, float dt, const FloatMode& mode) {
    const Workers workers(world.step_workers, mode);
    const float still = still_speed(length(vector_of(world.gravity)));
    bool any = false;
    world.each_batch([&](const Batch& batch, uint32_t slot) {
        const SleepingNeighbours neighbours(world, slot);
        if (batch.awake() == 0 || !neighbours.any()) return;
        any = true;
        workers.run(batch.awake(), grain, [&](uint32_t begin, uint32_t end) {
            for (uint32_t i = begin; i < end; ++i) note_ahead(world, neighbours, batch, i, dt, still);
        });
    });
    world.each_batch([&](Batch& batch, uint32_t slot) {
        if (any && world.pairs.has_contact(slot)) batch.wake_noted();
    });
}
} // namespace lr
