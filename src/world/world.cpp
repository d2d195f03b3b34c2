#include "world/world.h"

#include "base/bit_cast.h"
#include "base/counter_random.h"
#include "base/last_error.h"
#include "world/batch/lifecycle.h"
#include "world/sleep/wake.h"
#include "world/snapshot/snapshot_bytes.h"
#include "world/step/step_in_wind.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lr {

lr_status enter(const lr_world& world, const char* function) {
    const lr_status status = world.call_guard.enter(function);
    if (status == LR_OK || !world.call_guard.begin_telling()) return status;
    const char* const other = world.call_guard.function();
    char why[192];
    std::snprintf(why, sizeof why,
                  status == LR_ERROR_REENTRANT
                      ? "called from a callback of %s, which is still inside the same world"
                      : "called while %s is inside the same world, on another thread or in one of its callbacks",
                  other ? other : "another function");
    world.log(LR_LOG_ERROR, function, why);
    world.call_guard.end_telling();
    return status;
}
} // namespace lr

using namespace lr;

namespace {

// Calls run(items, count) for each group of items with the same times.
template <class Run> void by_time(StepItem* some, uint32_t count, const Run& run) {
    for (StepItem* const end = some + count; some != end;) {
        const BatchClock& first = some->batch->pace;
        StepItem* const to =
            std::partition(some, end, [&](const StepItem& item) { return item.batch->pace.at_same_time(first); });
        run(some, static_cast<uint32_t>(to - some));
        some = to;
    }
}
} // namespace

lr_world* lr_world::create(const lr_world_desc& desc, lr_status& status) {
    const KernelTarget* const target = find_target(desc.simd_target);
    Allocator allocator(desc.allocator);
    lr_world* const world = target ? allocator.make<lr_world>(allocator) : nullptr;
    status = target ? LR_ERROR_OUT_OF_MEMORY : LR_ERROR_UNSUPPORTED;
    if (!world) return nullptr;
    world->target = target;
    // Four lanes take two thirds of the time of the 16 or 32 that AVX2 and AVX-512 take together.
    if (desc.simd_target == LR_SIMD_AUTO && (target->simd == LR_SIMD_AVX512 || target->simd == LR_SIMD_AVX2))
        world->narrow = find_target(LR_SIMD_SSE4);
    world->seed = desc.seed;
    std::copy(desc.gravity, desc.gravity + 3, world->gravity);
    world->fluid_density = desc.fluid_density;
    world->fluid_viscosity = desc.fluid_viscosity;
    world->log_callback = desc.log;
    world->log_user = desc.log_user;
    world->call_guard.check(desc.checks);
    uint32_t workers = desc.worker_count;
    if (desc.jobs.enqueue && workers == 0) {
        workers = std::clamp<uint32_t>(hardware_threads(), 2, WorkerPool::max_workers + 1) - 1;
        world->log(LR_LOG_WARNING, "lr_world_create",
                   "worker_count is 0: assuming one thread less than this machine has for the job system");
    }
    status = world->step_workers.start(workers, desc.jobs) ? LR_OK : LR_ERROR_THREADS;
    if (status == LR_OK) return world;
    destroy(world);
    return nullptr;
}

void lr_world::destroy(lr_world* world) {
    Allocator allocator = world->allocator; // it must outlive the world
    allocator.end(world);
}

lr_world::~lr_world() {
    step_workers.stop();
    each_batch([](Batch& batch, uint32_t) { Batch::destroy(&batch); });
}

Batch* lr_world::find(lr_batch batch) const {
    const BatchHandle h = unpack(batch);
    if (h.index >= batch_slots || batches[h.index].generation != h.generation) return nullptr;
    return batches[h.index].batch;
}

Batch* lr_world::find(lr_body body, uint32_t& index) const {
    const BodyHandle h = unpack(body);
    if (h.batch >= batch_slots) return nullptr;
    Batch* const batch = batches[h.batch].batch;
    return batch && batch->find(body, index) ? batch : nullptr;
}

lr_status lr_world::create_batch(const lr_asset& asset, uint32_t capacity, const BatchSettings& settings,
                                 lr_batch& out) {
    uint32_t at = 0;
    while (at < batch_slots && batches[at].batch) ++at;
    if (at == max_batches) return LR_ERROR_CAPACITY;
    const size_t room = at < batches.size() ? batches.size() : std::max<size_t>(8, 2 * batches.size());
    if (!pacing.reserve(allocator, room) || !enlarge(allocator, items, room, 0) ||
        !enlarge(allocator, batches, room, batch_slots))
        return LR_ERROR_OUT_OF_MEMORY;
    BatchSlot slot = at < batch_slots ? batches[at] : BatchSlot{nullptr, 1, 1};
    lr_status status = LR_OK;
    slot.batch = Batch::create(allocator, asset, capacity, settings, at, slot.body_generation, status);
    if (!slot.batch) return status;
    if ((colliders.any() && !slot.batch->reserve_contact()) || (events.on() && !slot.batch->reserve_events())) {
        Batch::destroy(slot.batch);
        return LR_ERROR_OUT_OF_MEMORY;
    }
    slot.batch->enter(*this);
    batches[at] = slot;
    batch_slots = std::max(batch_slots, at + 1);
    out = pack(BatchHandle{at, slot.generation});
    return LR_OK;
}

void lr_world::destroy_batch(lr_batch batch) {
    const uint32_t at = unpack(batch).index;
    pairs.visit_partners(at, [&](uint32_t other) {
        if (other == at) return;
        batches[other].batch->wake_all();
        if (pairs.partners(other) == 1) batches[other].batch->forget_touched_bodies();
    });
    pairs.remove(at);
    pair_cache.forget(at);
    BatchSlot& slot = batches[at];
    slot.body_generation = next_generation(std::max(slot.body_generation, slot.batch->last_generation()));
    slot.generation = slot.generation == max_batch_generation ? 1 : slot.generation + 1;
    Batch::destroy(slot.batch);
    slot.batch = nullptr;
}

bool lr_world::set_pair(uint32_t a, uint32_t b, bool on) {
    if (pairs.has(a, b) == on) return true;
    if (on && (!reserve_scratch() || !batches[a].batch->reserve_contact() || !batches[b].batch->reserve_contact() ||
               !reserve_left([&](uint32_t slot) { return slot == a || slot == b || pairs.has_contact(slot); })))
        return false;
    if (!pairs.set(allocator, a, b, on)) return false;
    for (uint32_t slot : {a, b}) {
        batches[slot].batch->wake_all();
        if (!pairs.has_contact(slot)) batches[slot].batch->forget_touched_bodies();
    }
    return true;
}

void lr_world::leave(const Batch& batch, uint32_t index) {
    const uint32_t slot = unpack(batch.ids()[index]).batch;
    if (!pairs.has_contact(slot)) return;
    const double reach = batch.reach() * static_cast<double>(batch.arrays().field[field_scale][index]);
    const Double3 x = to_double(vector_in(batch.arrays().field, field_x, index)), half{reach, reach, reach};
    left[left_count++] = {slot, {to_float(x - half), to_float(x + half)}};
}

void lr_world::wake_left() {
    for (uint32_t i = 0; i < left_count; ++i)
        pairs.visit_partners(left[i].slot, [&](uint32_t other) { batches[other].batch->wake_on(left[i].box); });
    left_count = 0;
}

uint32_t lr_world::take_key() {
    const uint32_t noise_seed = next_noise_seed;
    next_noise_seed = noise_seed == UINT32_MAX ? 1 : noise_seed + 1;
    return noise_seed;
}

void lr_world::schedule_batches(float dt, uint32_t substeps) {
    const StepScheduler::Step step{step_count, substeps, wide(dt) / substeps};
    pacing.begin();
    each_batch([&](Batch& batch, uint32_t slot) {
        if (batch.awake() == 0) {
            // The time that the batch is behind passes for sleeping bodies too.
            if (batch.count() != 0) batch.sleeping()->pass(batch.pace.behind(), 0);
            return batch.pace.skip();
        }
        batch.pace.wait(wide(dt), substeps, time, substep_count, wind.uniform);
        batch.external.forget_zeros(batch.awake());
        pacing.ask(batch, slot, step, colliders);
    });
    pacing.decide(step);
}

void lr_world::fill_input(Batch& batch, const StepTime& t, uint64_t first_substep, const float (&begin)[3],
                          bool& unfit) {
    if (t.h != roots.h) {
        const double sqrt_h = std::sqrt(t.h);
        roots = {t.h, static_cast<float>(sqrt_h), static_cast<float>(1.0 / sqrt_h)};
    }
    const float(&end)[3] = wind.uniform.wind;
    StepInput& in = batch.step;
    in.seed = seed;
    in.first_substep = first_substep;
    in.substeps = t.substeps;
    in.h = static_cast<float>(t.h);
    in.sqrt_h = roots.sqrt;
    in.inverse_sqrt_h = roots.inverse_sqrt;
    std::copy(gravity, gravity + 3, in.gravity);
    in.motions = in.loads == Loads::aerodynamic ? motions_in_substep(in.body, length(vector_of(gravity)), in.h) : 1;
    batch.external.fill(in.external);
    in.water = surface.present() ? batch.water_body(surface.desc(), unfit) : nullptr;
    std::copy(begin, begin + 3, in.wind_begin);
    std::copy(end, end + 3, in.wind);
    in.wind_changes = !wind.active() && !std::equal(end, end + 3, begin);
}

void lr_world::fill_step(Batch& batch, float dt, bool& unfit) {
    const BatchClock& pace = batch.pace;
    const bool made_up = pace.behind() != wide(dt); // several steps, or a part of this one
    const auto seconds = static_cast<float>(pace.behind());
    if (made_up && batch.external.pending()) batch.external.spread(dt / seconds, batch.awake());
    StepInput& in = batch.step;
    fill_input(batch, pace.time(), pace.record().first_substep, pace.record().wind, unfit);
    // In accelerating air a body sees gravity less the air's acceleration. Clamped, since steps of microseconds could overflow.
    for (size_t k = 0; k < 3 && in.wind_changes; ++k)
        in.gravity[k] -= std::clamp((in.wind[k] - in.wind_begin[k]) / seconds, -1e9f, 1e9f);
}

bool lr_world::step(float dt, uint32_t substeps, const FloatMode& mode) {
    // A change of the uniform wind is spread over the step; before the first one there is none.
    if (substep_count == 0) std::copy(wind.uniform.wind, wind.uniform.wind + 3, wind.uniform.before);
    events.begin_step();
    lap(timings.total);
    timings = {};
    const auto began = lapped;
    if (pairs.any() && any_asleep()) wake_before_hit(*this, dt, mode);
    if (colliders.any()) {
        const bool sleeping = any_asleep();
        colliders.for_fresh([&](uint32_t slot) {
            if (sleeping) wake_at(slot);
        });
        colliders.begin_step(wide(dt), contact_reach(dt));
        if (sleeping) colliders.for_moving([&](uint32_t slot) { wake_at(slot); });
    }
    // Phases with nothing to do are not timed: reading the clock is a tenth of the step of a single body.
    if (colliders.any() || pairs.any()) lap(timings.colliders);
    schedule_batches(dt, substeps); // so that bodies that woke are stepped
    uint32_t item_count = 0;
    bool unfit = false;
    each_batch([&](Batch& batch, uint32_t slot) {
        if (batch.awake() == 0 || batch.pace.granted() == 0) return;
        items[item_count++] = {&batch, handle(slot), 0};
        fill_step(batch, dt, unfit);
        if (batch.events()) batch.events()->begin_step(batch, colliders);
    });
    const WaterStep at_surface{target, &surface, {}, gravity};
    const WaterStep* const water = surface.present() ? &at_surface : nullptr;
    // Batches with body contact take each substep together.
    StepItem* const with_body_contact =
        std::partition(items.data(), items.data() + item_count,
                       [&](const StepItem& item) { return !pairs.has_contact(unpack(item.handle).index); });
    const auto alone = static_cast<uint32_t>(with_body_contact - items.data());
    const auto run_here = [&](StepItem* some, uint32_t count) { run(some, count, water, mode); };
    // A wind field is prepared for moments, which these groups share.
    if (wind.active())
        by_time(items.data(), alone, run_here);
    else
        run_here(items.data(), alone);
    lap(timings.motion);
    bool met = true;
    by_time(with_body_contact, item_count - alone, [&](StepItem* some, uint32_t count) {
        BodyContactStep together(*this, some, count, water, mode);
        const bool ready = together.prepare();
        ready ? together.run() : run_here(some, count);
        met = met && ready && !together.starved();
    });
    if (alone < item_count) lap(timings.body_contact);
    if (wind.active() && wind.take_blame())
        log(LR_LOG_WARNING, "wind callback", "a result was not finite or too large, and was taken as 0");
    if (flow_may_wake()) {
        WakeByFlow(*this, items.data(), {time, wide(dt) / substeps, 1}).run(mode);
        lap(timings.wake);
    }
    wind.end_step(dt);
    if (colliders.any()) colliders.end_step();
    if (unfit)
        log(LR_LOG_WARNING, "water", "a batch's mass matrix would be singular in water: it stays in its own fluid");
    if (surface.present() && surface.take_blame())
        log(LR_LOG_WARNING, "water callback", "a result was invalid, and was replaced by the plane's");
    ++step_count;
    substep_count += substeps;
    time += wide(dt);
    finish_batches(wide(dt));
    wake_left(); // before events, which report it in this step
    if (events.on()) lap(timings.emit_and_rules);
    each_batch([&](Batch& batch, uint32_t slot) {
        const int32_t ended = batch.lifecycle() ? batch.lifecycle()->ended_kind() : LR_EVENT_KILLED;
        if (batch.events())
            batch.events()->tell(batch, handle(slot), colliders, batch.pace.granted() != 0, ended, events);
    });
    lap(events.on() ? timings.events : timings.emit_and_rules);
    // Rounded up, so that the sum of the phases is never more.
    timings.total = (lapped - began) * (1.0 + 1e-12);
    return met;
}

// About the time of a body's substep, in units of one with LANGEVIN loads in still air.
static uint64_t cost_of(const StepInput& in, bool field) {
    const uint64_t loads = in.loads != Loads::aerodynamic ? 1 : in.body.stations.count != 0 ? 8 : 3;
    return loads * in.motions + (field ? 3 : 0);
}

// In a wind field all items must have the same times.
void lr_world::run(StepItem* some, uint32_t count, const WaterStep* at_surface, const FloatMode& mode) {
    const bool field = wind.active();
    uint64_t blocks = 0, work = 0, cost = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const Batch& batch = *some[i].batch;
        some[i].begin = blocks;
        blocks += batch.padded_awake() / lane_block;
        // In a wind field the workers are called for each slice of the step.
        const uint32_t at_a_time = field ? std::min(batch.step.substeps, WindField::slice) : batch.step.substeps;
        const uint64_t here = uint64_t{batch.padded_awake()} * at_a_time;
        work += here;
        cost += here * cost_of(batch.step, field);
    }
    StepChunks chunks(*this, some, count, blocks, work, cost, step_workers.helpers());
    chunks.surface = at_surface;
    chunks.colliders = colliders.any();
    const auto run_chunks = [&] {
        step_workers.run(
            chunks.count(), chunks.helpers(), [&](uint32_t chunk) { chunks.run(chunk); }, mode);
    };
    if (!field || count == 0) return run_chunks();
    const BatchClock& pace = some[0].batch->pace;
    const StepTime t = pace.time();
    const UniformWind uniform = pace.wind(wind.uniform);
    WaterStep here{};
    if (at_surface) {
        here = *at_surface;
        here.time = t;
    }
    FieldSlice slice{target, &wind, &wind.instant(0), t, 0, 0, at_surface ? &here : nullptr};
    chunks.slice = &slice;
    for (; slice.first < t.substeps; slice.first += slice.count) {
        slice.count = std::min(WindField::slice, t.substeps - slice.first);
        lap(timings.motion);
        wind.prepare(t, uniform, slice.first, slice.count, seed);
        lap(timings.wind);
        run_chunks();
    }
}

void lr_world::lap(double& phase) {
    const double last = std::exchange(lapped, clock_seconds());
    phase += lapped - last;
}

// Reach of the largest bodies at scale 1, and their path in a step at typical speeds of flutter plus the wind.
float lr_world::contact_reach(float dt) const {
    float most = 0.0f;
    each_batch([&](const Batch& batch, uint32_t) { most = std::max(most, batch.asset().shape.reach); });
    const float pull = length(vector_of(gravity)), blow = wind.fastest();
    return 1.5f * most + dt * (4.5f + 2.5f * blow + 2.0f * dt * pull);
}

void lr_world::wake_at(uint32_t collider) {
    const Box box = colliders.box_of(collider);
    each_batch([&](Batch& batch, uint32_t) { batch.wake_on(box); });
}

bool lr_world::any_asleep() const {
    bool any = false;
    each_batch([&](const Batch& batch, uint32_t) { any = any || batch.awake() < batch.count(); });
    return any;
}

bool lr_world::reserve_contact() {
    bool enough = reserve_scratch();
    each_batch([&](Batch& batch, uint32_t) { enough = enough && batch.reserve_contact(); });
    return enough;
}

void lr_world::finish_batches(double dt) {
    FaultReport faults;
    each_batch([&](Batch& batch, uint32_t slot) {
        // As at the beginning of the step: bodies may wake at its end.
        const bool still = !batch.pace.waits(), waits = !still && batch.pace.granted() == 0;
        Lifecycle* const lifecycle = batch.lifecycle();
        if (waits) {
            batch.wake_noted();
            batch.faults.last = 0;
            if (lifecycle) lifecycle->pass();
        } else {
            const double seconds = still ? dt : batch.pace.behind();
            const uint32_t steps = still ? 1 : batch.pace.record().steps;
            batch.external.stepped();
            batch.grow_older(seconds);
            batch.pace.stepped(batch.awake());
            const bool turn = batch.awake() < batch.count() && batch.sleeping()->pass(seconds, steps);
            if (lifecycle && turn) lifecycle->judge_sleep(target->ended, batch);
            settle_diverged(*this, batch, handle(slot), faults);
            if (lifecycle) lifecycle->finish(batch, *this, seconds);
            batch.wake_noted(); // the rules have not checked these as awake
            batch.settle_noted();
        }
    });
    log_diverged(*this, faults);
}

void lr_world::sample_wind(const float* positions, uint32_t count, float* velocities) const {
    wind.prepare_now(time, seed);
    sample_field(*target, wind, time, {}, positions, count, velocities);
}

uint64_t lr_world::hash() const {
    uint64_t result = mix64(substep_count + 0x9e3779b97f4a7c15ull);
    bool paced = false;
    const auto mix = [&result](uint64_t word) { result = mix64(result ^ word); };
    each_batch([&](const Batch& batch, uint32_t slot) {
        mix(mix64(slot));
        result += batch.columns().hash(batch.awake(), batch.count());
        if (const lr_batch_contact& c = batch.contact(); !same(c, initial_contact)) {
            mix(c.layers);
            for (float v : {c.friction, c.restitution, c.rolling_resistance, c.ground_effect})
                mix(bit_cast<uint32_t>(v));
            mix(may_sleep(c));
            if (c.min_thickness != 0.0f) mix(bit_cast<uint32_t>(c.min_thickness));
        }
        if (batch.options.divergence_policy != LR_DIVERGENCE_AUTO)
            mix(static_cast<uint32_t>(batch.options.divergence_policy));
        if (batch.awake() < batch.count()) {
            const SleepingBodies::State& sleep = batch.sleeping()->state();
            mix(bit_cast<uint64_t>(sleep.clock));
            mix(sleep.steps | uint64_t{sleep.unjudged} << 32);
        }
        batch.pace.hash(mix);
        paced = paced || !batch.pace.plain();
        if (batch.lifecycle() && batch.lifecycle()->has_emitter()) {
            mix(next_noise_seed);
            mix(bit_cast<uint64_t>(batch.lifecycle()->state().due));
            mix(bit_cast<uint64_t>(batch.lifecycle()->state().burst_clock));
        }
    });
    // The step's number decides whose turn a trial is.
    if (paced || pacing.limited() || flow_may_wake()) mix(step_count);
    pacing.hash(mix);
    for (uint64_t word : {wind.hash(time), surface.hash(), colliders.hash()})
        if (word != 0) mix(word);
    pairs.visit([&](uint32_t low, uint32_t high) { mix(low | uint64_t{high} << 32); });
    if (const uint64_t word = pair_cache.hash(); word != 0) mix(word);
    return result;
}

void lr_world::log(int32_t level, const char* function, const char* message) const {
    if (log_callback) {
        char text[256];
        std::snprintf(text, sizeof text, "%s: %s", function, message);
        log_callback(log_user, level, text);
    }
    if (level == LR_LOG_ERROR) note_error(function, message); // last, since the callback may have failed elsewhere
}
