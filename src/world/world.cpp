#include "world/world.h"

#include "field/field_step.h"
#include "world/crowd_step.h"
#include "world/lifecycle.h"
#include "world/lift_off.h"
#include "world/mix.h"
#include "world/wake_ahead.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <new>

using lr::Batch;

namespace {

// Those that go through the same times as the first, before the others. Returns where they end.
lr::StepItem* same_time(lr::StepItem* begin, lr::StepItem* end) {
    if (begin == end) return end;
    const lr::Pace& first = begin->batch->pace;
    return std::partition(begin, end, [&](const lr::StepItem& item) { return item.batch->pace.at_same_time(first); });
}

} // namespace

lr_world* lr_world::create(const lr_world_desc& desc, lr_status& status) {
    const lr::KernelTarget* const target = lr::find_target(desc.simd_target);
    if (!target) {
        status = LR_ERROR_UNSUPPORTED;
        return nullptr;
    }
    lr::Allocator allocator(desc.allocator);
    void* const memory = allocator.allocate(sizeof(lr_world));
    if (!memory) {
        status = LR_ERROR_OUT_OF_MEMORY;
        return nullptr;
    }
    lr_world* const world = new (memory) lr_world(allocator);
    world->target = target;
    world->contact = &lr::contact_target(target->simd);
    // Four lanes take two thirds of the time of the 16 or 32 that AVX2 and AVX-512 take together.
    if (desc.simd_target == LR_SIMD_AUTO && (target->simd == LR_SIMD_AVX512 || target->simd == LR_SIMD_AVX2))
        world->narrow = lr::find_target(LR_SIMD_SSE4);
    world->seed = desc.seed;
    std::copy(desc.gravity, desc.gravity + 3, world->gravity);
    world->fluid_density = desc.fluid_density;
    world->fluid_viscosity = desc.fluid_viscosity;
    world->log_callback = desc.log;
    world->log_user = desc.log_user;
    world->use.check(desc.checks);
    uint32_t workers = desc.worker_count;
    if (desc.jobs.enqueue && workers == 0) {
        workers = lr::Crew::usual_helpers();
        world->log(LR_LOG_WARNING, "lr_world_create",
                   "jobs without a worker_count, and how many threads they have is not known: one less than this "
                   "machine's is taken");
    }
    if (!world->crew.start(workers, desc.jobs)) {
        status = LR_ERROR_THREADS;
        destroy(world);
        return nullptr;
    }
    status = LR_OK;
    return world;
}

void lr_world::destroy(lr_world* world) {
    if (!world) return;
    lr::Allocator allocator = world->allocator;
    world->~lr_world();
    allocator.release(world, sizeof(lr_world));
}

lr_world::~lr_world() {
    crew.stop();
    for (uint32_t i = 0; i < batch_slots; ++i) Batch::destroy(batches[i].batch);
}

Batch* lr_world::find(lr_batch batch) const {
    const lr::BatchHandle h = lr::unpack_batch(batch);
    if (h.index >= batch_slots || batches[h.index].generation != h.generation) return nullptr;
    return batches[h.index].batch;
}

Batch* lr_world::find(lr_body body, uint32_t& index) const {
    const lr::BodyHandle h = lr::unpack(body);
    if (h.batch >= batch_slots) return nullptr;
    Batch* const batch = batches[h.batch].batch;
    return batch && batch->find(body, index) ? batch : nullptr;
}

bool lr_world::grow_batches() {
    lr::Buffer<BatchSlot> larger;
    lr::Buffer<lr::StepItem> more_items;
    const size_t size = std::max<size_t>(8, 2 * batches.size());
    if (!larger.allocate(allocator, size) || !more_items.allocate(allocator, size) || !pacing.reserve(allocator, size))
        return false;
    std::copy(batches.data(), batches.data() + batch_slots, larger.data());
    batches.swap(larger);
    items.swap(more_items);
    return true;
}

lr_status lr_world::create_batch(const lr_asset& asset, uint32_t capacity, const lr::BatchSettings& settings,
                                 lr_batch& out) {
    uint32_t at = 0;
    while (at < batch_slots && batches[at].batch) ++at;
    if (at == lr::max_batches) return LR_ERROR_CAPACITY;
    if (at == batches.size() && !grow_batches()) return LR_ERROR_OUT_OF_MEMORY;
    BatchSlot slot = at < batch_slots ? batches[at] : BatchSlot{nullptr, 1, 1};
    lr_status status = LR_OK;
    slot.batch = Batch::create(allocator, asset, capacity, settings, at, slot.body_generation, status);
    if (!slot.batch) return status;
    if (colliders.any() && !slot.batch->reserve_contact()) {
        Batch::destroy(slot.batch);
        return LR_ERROR_OUT_OF_MEMORY;
    }
    if (contact_events.on() && !slot.batch->reserve_events()) {
        Batch::destroy(slot.batch);
        return LR_ERROR_OUT_OF_MEMORY;
    }
    batches[at] = slot;
    batch_slots = std::max(batch_slots, at + 1);
    out = lr::pack(lr::BatchHandle{at, slot.generation});
    return LR_OK;
}

void lr_world::destroy_batch(lr_batch batch) {
    const uint32_t at = lr::unpack_batch(batch).index;
    pairs.visit_partners(at, [&](uint32_t other) {
        if (other == at) return;
        batches[other].batch->wake_all();
        if (pairs.partners(other) == 1) batches[other].batch->forget_touched_bodies();
    });
    pairs.remove(at);
    BatchSlot& slot = batches[at];
    slot.body_generation = lr::next_generation(std::max(slot.body_generation, slot.batch->last_generation()));
    slot.generation = slot.generation == lr::max_batch_generation ? 1 : slot.generation + 1;
    Batch::destroy(slot.batch);
    slot.batch = nullptr;
}

bool lr_world::set_pair(uint32_t a, uint32_t b, bool on) {
    if (pairs.has(a, b) == on) return true;
    if (on && (!batches[a].batch->reserve_contact() || !batches[b].batch->reserve_contact() ||
               !reserve_left([&](uint32_t slot) { return slot == a || slot == b || pairs.meets(slot); })))
        return false;
    if (!pairs.set(allocator, a, b, on)) return false;
    for (uint32_t slot : {a, b}) {
        batches[slot].batch->wake_all();
        if (!pairs.meets(slot)) batches[slot].batch->forget_touched_bodies();
    }
    return true;
}

lr_status lr_world::destroy_bodies(const lr_body* bodies, uint32_t count) {
    // All or none: every body is marked first, and one that is stale or marked already ends it.
    uint32_t index = 0, marked = 0;
    for (; marked < count; ++marked) {
        Batch* const batch = find(bodies[marked], index);
        if (!batch || !batch->mark(index)) break;
    }
    for (uint32_t i = 0; i < marked; ++i) {
        Batch* const batch = find(bodies[i], index);
        batch->unmark(index);
    }
    if (marked < count) return LR_ERROR_STALE_BODY;
    for (uint32_t i = 0; i < count; ++i) {
        Batch& batch = *find(bodies[i], index);
        leave(batch, index);
        batch.remove(bodies[i]);
    }
    wake_left();
    return LR_OK;
}

lr_status lr_world::set_rest(const lr_body* bodies, uint32_t count, bool rest) {
    uint32_t index = 0;
    for (uint32_t i = 0; i < count; ++i)
        if (!find(bodies[i], index)) return LR_ERROR_STALE_BODY;
    for (uint32_t i = 0; i < count && rest; ++i)
        if (!find(bodies[i], index)->reserve_rest()) return LR_ERROR_OUT_OF_MEMORY;
    for (uint32_t i = 0; i < count; ++i) {
        Batch& batch = *find(bodies[i], index);
        if (batch.rests(index) == rest) continue;
        if (!rest) {
            batch.wake(index);
            continue;
        }
        index = batch.rest(index);
        if (batch.events()) batch.events()->take_back_woke(lr::unpack(batch.ids()[index]).slot);
        batch.resting()->ask_again(); // it has perhaps never been in a step
    }
    return LR_OK;
}

uint32_t lr_world::wake_box(const lr::Box& box) {
    uint32_t woken = 0;
    for (uint32_t i = 0; i < batch_slots; ++i) {
        Batch* const batch = batches[i].batch;
        if (!batch) continue;
        woken -= batch->awake();
        batch->visit_resting(box, [&](uint32_t index) { batch->wake(index); });
        woken += batch->awake();
    }
    return woken;
}

void lr_world::leave(const Batch& batch, uint32_t index) {
    const uint32_t slot = lr::unpack(batch.ids()[index]).batch;
    if (!pairs.meets(slot)) return;
    const double reach = 1.01 * batch.reach() * static_cast<double>(batch.arrays().field[lr::field_scale][index]);
    const lr::Double3 x = to_double(lr::vector_in(batch.arrays().field, lr::field_x, index)), half{reach, reach, reach};
    left[left_count++] = {slot, {to_float(x - half), to_float(x + half)}};
}

void lr_world::wake_left() {
    for (uint32_t i = 0; i < left_count; ++i)
        pairs.visit_partners(left[i].slot, [&](uint32_t other) {
            Batch& partner = *batches[other].batch;
            partner.visit_resting(left[i].box, [&](uint32_t index) { partner.wake(index); });
        });
    left_count = 0;
}

void lr_world::set_gravity(const float (&to)[3]) {
    if (std::equal(to, to + 3, gravity)) return;
    std::copy(to, to + 3, gravity);
    for (uint32_t i = 0; i < batch_slots; ++i)
        if (batches[i].batch) batches[i].batch->wake_all();
}

uint32_t lr_world::take_key() {
    const uint32_t key = next_key;
    next_key = key == UINT32_MAX ? 1 : key + 1;
    return key;
}

void lr_world::pace_batches(float dt, uint32_t substeps) {
    const lr::Pacing::Step step{step_count, substeps, static_cast<double>(dt) / substeps};
    pacing.begin();
    for (uint32_t i = 0; i < batch_slots; ++i) {
        Batch* const batch = batches[i].batch;
        if (!batch) continue;
        if (batch->awake() == 0) {
            // What the batch had still to make up for passes for those at rest as well.
            if (batch->count() != 0) batch->resting()->pass(batch->pace.behind(), 0);
            batch->pace.rest();
            continue;
        }
        batch->pace.wait(static_cast<double>(dt), substeps, time, substep_count, wind.uniform);
        pacing.ask(*batch, i, step);
    }
    pacing.decide(step);
}

void lr_world::fill_input(Batch& batch, float dt, bool& unfit) {
    const lr::Pace& pace = batch.pace;
    const lr::StepTime t = pace.time();
    const float(&begin)[3] = pace.record().wind;
    const float(&end)[3] = wind.uniform.wind;
    const bool made_up = pace.behind() != static_cast<double>(dt); // with earlier steps, or less of this one
    const auto seconds = static_cast<float>(pace.behind());
    if (t.h != roots.h) {
        const double sqrt_h = std::sqrt(t.h);
        roots = {t.h, static_cast<float>(sqrt_h), static_cast<float>(1.0 / sqrt_h)};
    }
    lr::StepInput& in = batch.step;
    in.seed = seed;
    in.first_substep = pace.record().first_substep;
    in.substeps = t.substeps;
    in.h = static_cast<float>(t.h);
    in.sqrt_h = roots.sqrt;
    in.inverse_sqrt_h = roots.inverse_sqrt;
    std::copy(gravity, gravity + 3, in.gravity);
    if (made_up && batch.external.pending()) batch.external.spread(dt / seconds, batch.awake());
    batch.external.fill(in.external);
    in.water = surface.present() ? batch.water_body(surface.desc(), unfit) : nullptr;
    std::copy(begin, begin + 3, in.wind_begin);
    std::copy(end, end + 3, in.wind);
    in.wind_changes = !wind.active() && !std::equal(end, end + 3, begin);
    if (!in.wind_changes) return;
    // In a fluid that accelerates as a whole, bodies move as if gravity were less by it. Above the limit, which only
    // steps of microseconds reach, the product with the step could overflow.
    for (size_t k = 0; k < 3; ++k) in.gravity[k] -= std::clamp((end[k] - begin[k]) / seconds, -1e9f, 1e9f);
}

bool lr_world::step(float dt, uint32_t substeps, const lr::FloatMode& mode) {
    // A change of the uniform wind is spread over the step; there is nothing to change before the first one.
    if (substep_count == 0) std::copy(wind.uniform.wind, wind.uniform.wind + 3, wind.uniform.before);
    contact_events.begin_step();
    if (pairs.any() && any_resting()) lr::wake_ahead(*this, dt, mode);
    if (colliders.any()) {
        const bool resting = any_resting();
        colliders.for_fresh([&](uint32_t slot) {
            if (resting) wake_at(slot);
        });
        colliders.begin_step(static_cast<double>(dt), contact_reach(dt));
        if (resting) colliders.for_moving([&](uint32_t slot) { wake_at(slot); });
    }
    pace_batches(dt, substeps); // so that those that have woken are stepped
    uint32_t item_count = 0;
    bool unfit = false;
    for (uint32_t i = 0; i < batch_slots; ++i) {
        Batch* const batch = batches[i].batch;
        if (!batch || batch->awake() == 0 || batch->pace.granted() == 0) continue;
        items[item_count++] = {batch, lr::pack(lr::BatchHandle{i, batches[i].generation}), 0};
        fill_input(*batch, dt, unfit);
        if (batch->events()) batch->events()->begin_step(colliders.any() && batch->contact.layers != 0);
    }
    const lr::SurfaceStep at_surface{target, &surface, {}, gravity};
    const lr::SurfaceStep* const water = surface.present() ? &at_surface : nullptr;
    // Bodies that meet others go through the step together.
    lr::StepItem* const crowds = std::partition(items.data(), items.data() + item_count, [&](const lr::StepItem& item) {
        return !pairs.meets(lr::unpack_batch(item.handle).index);
    });
    const auto alone = static_cast<uint32_t>(crowds - items.data());
    run_alone(items.data(), alone, water, mode);
    const bool met = run_crowds(crowds, item_count - alone, water, mode);
    if (wind.active() && wind.take_blame())
        log(LR_LOG_WARNING, "wind callback", "a value was not finite or too large, and counted as 0");
    const bool lift_off = (colliders.any() || pairs.any()) && any_resting();
    if (lift_off) lr::LiftOff(*this, items.data(), {time, static_cast<double>(dt) / substeps, 1}).run(mode);
    wind.end_step(dt);
    if (colliders.any()) colliders.end_step();
    if (unfit)
        log(LR_LOG_WARNING, "surface", "a batch's mass matrix is singular in its fluid, which is not there for it");
    if (surface.present() && surface.take_blame())
        log(LR_LOG_WARNING, "surface callback", "a value was no surface's, and the plane was taken instead");
    ++step_count;
    substep_count += substeps;
    time += static_cast<double>(dt);
    finish_batches(static_cast<double>(dt));
    return met;
}

void lr_world::run_alone(lr::StepItem* some, uint32_t count, const lr::SurfaceStep* at_surface,
                         const lr::FloatMode& mode) {
    if (!wind.active()) return run(some, count, at_surface, mode);
    // The field is prepared for moments in time: those that go through the same ones, together.
    for (lr::StepItem* const end = some + count; some != end;) {
        lr::StepItem* const to = same_time(some, end);
        run(some, static_cast<uint32_t>(to - some), at_surface, mode);
        some = to;
    }
}

bool lr_world::run_crowds(lr::StepItem* some, uint32_t count, const lr::SurfaceStep* at_surface,
                          const lr::FloatMode& mode) {
    bool met = true;
    for (lr::StepItem* const end = some + count; some != end;) {
        lr::StepItem* const to = same_time(some, end);
        const auto here = static_cast<uint32_t>(to - some);
        lr::CrowdStep step(*this, some, here, at_surface, mode);
        const bool ready = step.prepare();
        if (ready)
            step.run();
        else
            run(some, here, at_surface, mode);
        met = met && ready && !step.starved();
        some = to;
    }
    return met;
}

// All of one time, where there is a field.
void lr_world::run(lr::StepItem* some, uint32_t count, const lr::SurfaceStep* at_surface, const lr::FloatMode& mode) {
    const bool field = wind.active();
    uint64_t blocks = 0, work = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const Batch& batch = *some[i].batch;
        some[i].begin = blocks;
        blocks += batch.padded_awake() / lr::lane_block;
        // In a field the workers are called for each slice of the step.
        const uint32_t at_a_time = field ? std::min(batch.step.substeps, lr::WindField::slice) : batch.step.substeps;
        work += uint64_t{batch.padded_awake()} * at_a_time;
    }
    lr::StepChunks chunks(*this, some, count, blocks, work, crew.helpers());
    chunks.surface = at_surface;
    chunks.colliders = colliders.any();
    if (!field || count == 0) {
        crew.run(chunks.count(), chunks.helpers(), &lr::StepChunks::run, &chunks, mode);
        return;
    }
    const lr::Pace& pace = some[0].batch->pace;
    const lr::StepTime t = pace.time();
    const lr::UniformWind uniform = pace.wind(wind.uniform);
    lr::SurfaceStep here{};
    if (at_surface) {
        here = *at_surface;
        here.time = t;
    }
    lr::FieldSlice slice{target, &wind, t, 0, 0, at_surface ? &here : nullptr};
    chunks.slice = &slice;
    for (; slice.first < t.substeps; slice.first += slice.count) {
        slice.count = std::min(lr::WindField::slice, t.substeps - slice.first);
        wind.prepare(t, uniform, slice.first, slice.count, seed);
        crew.run(chunks.count(), chunks.helpers(), &lr::StepChunks::run, &chunks, mode);
    }
}

// Of the largest bodies of scale 1 and their way in a step, at the speeds of things that flutter and what the wind adds.
float lr_world::contact_reach(float dt) const {
    float most = 0.0f;
    for (uint32_t i = 0; i < batch_slots; ++i)
        if (batches[i].batch) most = std::max(most, batches[i].batch->shape.reach);
    const float(&g)[3] = gravity, (&w)[3] = wind.uniform.wind;
    const float pull = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    const float blow = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    return 1.5f * most + dt * (4.5f + 2.5f * blow + 2.0f * dt * pull);
}

void lr_world::wake_at(uint32_t collider) {
    wake_box(colliders.box_of(collider));
}

bool lr_world::any_resting() const {
    for (uint32_t i = 0; i < batch_slots; ++i)
        if (batches[i].batch && batches[i].batch->awake() < batches[i].batch->count()) return true;
    return false;
}

bool lr_world::reserve_contact() {
    for (uint32_t i = 0; i < batch_slots; ++i)
        if (batches[i].batch && !batches[i].batch->reserve_contact()) return false;
    return true;
}

// Gravity twice, for what else pulls; part of the wind, which light bodies take on within a step; and much for forces from
// outside, which may be anything.
float lr_world::contact_gain(const Batch& batch, float dt) const {
    const auto size = [](const float(&v)[3]) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); };
    const float forced = batch.step.external.any ? 50.0f : 0.0f;
    return 2.0f * dt * size(gravity) + 0.5f * size(wind.uniform.wind) + forced;
}

void lr_world::finish_batches(double dt) {
    lr::FaultReport faults;
    for (uint32_t i = 0; i < batch_slots; ++i) {
        Batch* const batch = batches[i].batch;
        if (!batch) continue;
        // Since the step began; some may wake at its end.
        const bool still = !batch->pace.waits(), waits = !still && batch->pace.granted() == 0;
        lr::Lifecycle* const lifecycle = batch->lifecycle();
        const lr_batch handle = lr::pack(lr::BatchHandle{i, batches[i].generation});
        if (waits) {
            batch->wake_noted();
            batch->faults.last = 0;
            if (lifecycle) lifecycle->pass();
            if (batch->events()) batch->events()->tell(*batch, handle, colliders, false, contact_events);
            continue;
        }
        const double seconds = still ? dt : batch->pace.behind();
        const uint32_t steps = still ? 1 : batch->pace.record().steps;
        batch->external.stepped();
        batch->grow_older(seconds);
        batch->pace.stepped(batch->awake());
        const bool turn = batch->awake() < batch->count() && batch->resting()->pass(seconds, steps);
        if (lifecycle && turn) lifecycle->judge_rest(target->ended, *batch);
        lr::settle_faults(*this, *batch, handle, faults);
        if (lifecycle) lifecycle->finish(*batch, *this, seconds);
        batch->wake_noted(); // rules have not judged them as bodies that move
        batch->settle_noted();
        if (batch->events()) batch->events()->tell(*batch, handle, colliders, !still, contact_events);
    }
    lr::log_faults(*this, faults);
    wake_left();
}

void lr_world::sample_wind(const float* positions, uint32_t count, float* velocities) const {
    wind.prepare_now(time, seed);
    lr::sample_field(*target, wind, time, 0, positions, count, velocities);
}

uint64_t lr_world::hash() const {
    uint64_t result = lr::mix64(substep_count + 0x9e3779b97f4a7c15ull);
    bool paced = false;
    for (uint32_t b = 0; b < batch_slots; ++b) {
        if (!batches[b].batch) continue;
        const Batch& batch = *batches[b].batch;
        // A sum over bodies, so that their order in memory does not matter.
        uint64_t sum = 0;
        for (uint32_t i = 0; i < batch.count(); ++i) {
            const bool rests = batch.rests(i);
            uint64_t body = lr::mix64(batch.arrays().key[i] + 1ull);
            for (size_t f = 0; f < (rests ? lr::field_age : lr::field_age_rest); ++f)
                body = lr::mix64(body ^ (std::bit_cast<uint32_t>(batch.arrays().field[f][i]) + (uint64_t{f} << 32)));
            // What most bodies do not have goes in only where it is.
            const auto rare = [&](uint64_t tag, uint32_t bits) {
                if (bits != 0) body = lr::mix64(body ^ (bits + (tag << 32)));
            };
            if (rests)
                body = lr::mix64(body ^ lr::mix64(std::bit_cast<uint64_t>(batch.resting()->birth(i)) + 1ull));
            else
                rare(lr::field_age_rest, std::bit_cast<uint32_t>(batch.arrays().field[lr::field_age_rest][i]));
            if (batch.step.loads == lr::Loads::aerodynamic)
                for (size_t f : {lr::field_gust_x, lr::field_gust_y, lr::field_gust_z})
                    body =
                        lr::mix64(body ^ (std::bit_cast<uint32_t>(batch.arrays().field[f][i]) + (uint64_t{f} << 32)));
            if (batch.lifecycle()) rare(lr::field_count, batch.lifecycle()->life(i));
            if (batch.external.pending())
                for (size_t c = 0; c < lr::force_components; ++c)
                    rare(64 + c, std::bit_cast<uint32_t>(batch.external.bodies()[c * batch.external.stride() + i]));
            if (const lr::ContactArrays noted = batch.contact_arrays(); noted.rest_time) {
                rare(128, std::bit_cast<uint32_t>(noted.rest_time[i]));
                for (size_t k = 0; k < lr::most_touched; ++k) rare(129 + k, noted.touching[k][i]);
                for (size_t k = 0; k < lr::stay_rows; ++k) rare(136 + k, std::bit_cast<uint32_t>(noted.stay[k][i]));
            }
            sum += body;
        }
        result = lr::mix64(result ^ lr::mix64(b)) + sum;
        if (const lr::ContactSettings& c = batch.contact; !(c == lr::ContactSettings{}))
            for (uint32_t word :
                 {c.layers, std::bit_cast<uint32_t>(c.friction), std::bit_cast<uint32_t>(c.restitution),
                  std::bit_cast<uint32_t>(c.rolling), std::bit_cast<uint32_t>(c.ground_effect), c.may_rest ? 1u : 0u})
                result = lr::mix64(result ^ word);
        if (batch.faults.policy != LR_FAULT_AUTO)
            result = lr::mix64(result ^ static_cast<uint32_t>(batch.faults.policy));
        if (batch.awake() < batch.count()) {
            const lr::Resting::Record rest = batch.resting()->record(batch.awake());
            for (uint64_t word : {std::bit_cast<uint64_t>(rest.clock), rest.steps | uint64_t{rest.unjudged} << 32})
                result = lr::mix64(result ^ word);
        }
        batch.pace.hash([&](uint64_t word) { result = lr::mix64(result ^ word); });
        paced = paced || !batch.pace.plain();
        if (batch.lifecycle() && batch.lifecycle()->has_emitter())
            for (uint64_t word : {uint64_t{next_key}, std::bit_cast<uint64_t>(batch.lifecycle()->due()),
                                  std::bit_cast<uint64_t>(batch.lifecycle()->burst_clock())})
                result = lr::mix64(result ^ word);
    }
    // Whose turn it is to be tried by the wind.
    if (paced || pacing.limited() || ((colliders.any() || pairs.any()) && any_resting()))
        result = lr::mix64(result ^ step_count);
    pacing.hash([&](uint64_t word) { result = lr::mix64(result ^ word); });
    if (const uint64_t sources = wind.hash(time)) result = lr::mix64(result ^ sources);
    if (const uint64_t water = surface.hash()) result = lr::mix64(result ^ water);
    if (const uint64_t solid = colliders.hash()) result = lr::mix64(result ^ solid);
    pairs.visit([&](uint32_t low, uint32_t high) { result = lr::mix64(result ^ (low | uint64_t{high} << 32)); });
    return result;
}

void lr_world::log(int32_t level, const char* function, const char* message) const {
    if (!log_callback) return;
    char text[256];
    std::snprintf(text, sizeof text, "%s: %s", function, message);
    log_callback(log_user, level, text);
}
