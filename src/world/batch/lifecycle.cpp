#include "world/batch/lifecycle.h"

#include "kernel/divergence.h"
#include "kernel/limits.h"
#include "world/schedule/step_chunks.h"
#include "world/world.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace lr {

namespace {

// Numbers must be finite. Null if valid, else the reason.
const char* wrong_in(const lr_batch_rules& r) {
    if (r.action != LR_END_DESTROY && r.action != LR_END_RESPAWN) return "unknown action";
    if (!(r.max_age >= 0.0f && r.max_age <= most_age)) return "max_age is negative or too large";
    if (r.volume_count > LR_MAX_KILL_VOLUMES) return "more than LR_MAX_KILL_VOLUMES volumes";
    for (uint32_t k = 0; k < r.volume_count; ++k) {
        const lr_kill_volume& v = r.volumes[k];
        if (v.shape < LR_VOLUME_PLANE || v.shape > LR_VOLUME_SPHERE) return "unknown shape of a volume";
        if (v.side != LR_KILL_INSIDE && v.side != LR_KILL_OUTSIDE) return "unknown side of a volume";
        if (!within(v.center, most_place) || !within(v.size, most_place)) return "a volume is over 1e9 m away or large";
        for (size_t i = 0; i < 3; ++i) {
            if (v.shape != LR_VOLUME_PLANE && v.size[i] < 0.0f) return "a volume's size is negative";
        }
        const bool flat = v.size[0] == 0.0f && v.size[1] == 0.0f && v.size[2] == 0.0f;
        if (v.shape == LR_VOLUME_PLANE && flat) return "a plane's normal is 0";
    }
    return nullptr;
}

void spawn(const Emitter& emitter, Batch& batch, lr_world& world, uint32_t count, lr_body* out_ids) {
    for (uint32_t i = 0; i < count; ++i) {
        const lr_body id = batch.add(emitter.draw(world.seed, world.take_key(), 0));
        if (out_ids) out_ids[i] = id;
        if (batch.events()) batch.events()->note(unpack(id).slot, noted_spawn);
    }
}
} // namespace

Outcome check(const lr_batch_rules& r) {
    bool numbers = finite(r.max_age);
    for (uint32_t k = 0; k < std::min(r.volume_count, LR_MAX_KILL_VOLUMES); ++k)
        numbers = numbers && finite(r.volumes[k].center, r.volumes[k].size);
    return numbers ? invalid(wrong_in(r)) : LR_ERROR_NOT_FINITE;
}

bool Lifecycle::allocate(Allocator& allocator, uint32_t lanes) {
    return cause_.allocate(allocator, lanes) && cut_has_ended_.allocate(allocator, cut_count(lanes));
}

void Lifecycle::set_rules(const lr_batch_rules* rules) {
    state_.has_rules = rules ? 1 : 0;
    lr_batch_rules& r = state_.rules;
    r = rules ? *rules : lr_batch_rules{};
    std::fill(r.volumes + r.volume_count, r.volumes + LR_MAX_KILL_VOLUMES, lr_kill_volume{});
}

void Lifecycle::set_emitter(const lr_emitter_desc* emitter) {
    state_.has_emitter = emitter ? 1 : 0;
    state_.emitter = emitter ? *emitter : lr_emitter_desc{};
    emitter_ = emitter ? Emitter(*emitter) : Emitter();
    if (!emitter) state_.due = state_.burst_clock = 0.0;
}

void Lifecycle::pass() {
    ended_ = spawned_ = missed_ = 0;
    std::fill_n(by_cause_, cause_count, 0u);
}

void Lifecycle::judge(EndedFunction ended, const BatchArrays& arrays, uint32_t begin, uint32_t end) {
    if (!has_rules()) return;
    for (uint32_t at = begin; at < end; at += cut_bodies)
        cut_has_ended_[at / cut_bodies] =
            ended(state_.rules, arrays, at, std::min(at + cut_bodies, end), cause_.data()) ? 1 : 0;
}

void Lifecycle::finish(Batch& batch, lr_world& world, double dt) {
    pass();
    ended_respawned_ = respawns();
    if (has_rules() || faulted_) end_bodies(batch, world);
    if (has_emitter()) spawn_due(batch, world, dt);
}

bool Lifecycle::ends(uint32_t index) const {
    return has_rules() && cut_has_ended_[index / cut_bodies] != 0 && cause_[index] != cause_none;
}

void Lifecycle::end_diverged(uint32_t index) {
    if (!has_rules() && !faulted_) std::fill_n(cut_has_ended_.data(), cut_has_ended_.size(), uint8_t{0});
    faulted_ = true;
    uint8_t& any = cut_has_ended_[index / cut_bodies];
    if (any == 0) {
        const uint32_t begin = index / cut_bodies * cut_bodies;
        std::fill_n(cause_.data() + begin, std::min<size_t>(cut_bodies, cause_.size() - begin), uint32_t{cause_none});
    }
    any = 1;
    cause_[index] = cause_not_finite;
}

void Lifecycle::judge_sleep(EndedFunction ended, Batch& batch) {
    SleepingBodies* const sleeping = batch.sleeping();
    if (!has_rules() || !sleeping->in_question(state_.rules.max_age)) return;
    batch.make_ages_exact();
    // From the start of a cut: judging its awake bodies again gives the same answer.
    judge(ended, batch.arrays(), batch.awake() / cut_bodies * cut_bodies, batch.padded_count());
    sleeping->answered(batch.awake(), batch.count(), state_.rules.max_age);
    sleep_judged_ = true;
}

// Backwards over [begin, end).
template <class Function> void Lifecycle::for_ended(uint32_t begin, uint32_t end, Function&& function) {
    for (uint32_t cut = cut_count(end); cut-- > begin / cut_bodies;) {
        if (cut_has_ended_[cut] == 0) continue;
        const uint32_t first = std::max(begin, cut * cut_bodies);
        for (uint32_t i = std::min((cut + 1) * cut_bodies, end); i-- > first;) {
            if (cause_[i] == cause_none) continue;
            function(i);
        }
    }
}

void Lifecycle::respawn(Batch& batch, const lr_world& world, uint32_t index) {
    if (batch.asleep(index)) index = batch.wake(index);
    batch.write(index, emitter_.draw(world.seed, batch.arrays().noise_seed[index],
                                     ++batch.columns().row<uint32_t>(column_life)[index]));
    batch.forget(index);
    if (batch.events()) batch.events()->clear(unpack(batch.ids()[index]).slot);
}

// Backwards, so that the body that fills an ended one's place has been judged. Results depend on noise seed and life, not on the order.
void Lifecycle::end_bodies(Batch& batch, lr_world& world) {
    const uint32_t awake = batch.awake(), count = batch.count();
    const auto note = [&](uint32_t i) {
        ++by_cause_[cause_[i]];
        ++ended_;
        world.leave(batch, i);
        if (batch.events()) batch.events()->note_ended(batch, i, cause_[i] == cause_not_finite);
    };
    if (ended_respawned_) {
        for_ended(0, awake, [&](uint32_t i) { note(i), respawn(batch, world, i); });
        // Forwards, since a waking body swaps places with one before it.
        for (uint32_t i = sleep_judged_ ? awake : count; i < count; ++i)
            if (cause_[i] != cause_none) note(i), respawn(batch, world, i);
    } else {
        const auto end = [&](uint32_t i) { note(i), batch.remove(batch.ids()[i]); };
        if (sleep_judged_) for_ended(awake, count, end);
        for_ended(0, awake, end);
    }
    sleep_judged_ = faulted_ = false;
    (ended_respawned_ ? state_.respawned : state_.destroyed) += ended_;
}

void Lifecycle::spawn_due(Batch& batch, lr_world& world, double dt) {
    const lr_emitter_desc& d = state_.emitter;
    state_.due += wide(d.rate) * dt;
    double births = std::floor(state_.due);
    state_.due -= births;
    if (d.burst_count != 0) {
        const double interval = wide(d.burst_interval);
        state_.burst_clock += dt;
        const double bursts = std::floor(state_.burst_clock / interval);
        state_.burst_clock = std::max(state_.burst_clock - bursts * interval, 0.0);
        births += bursts * static_cast<double>(d.burst_count);
    }
    // Spawns without room are dropped: kept ones would burst out as soon as places become free.
    const uint32_t wanted = static_cast<uint32_t>(std::min(births, 4294967295.0));
    spawned_ = emit(batch, world, wanted, nullptr);
    missed_ = wanted - spawned_;
    state_.missed += missed_;
}

uint32_t Lifecycle::emit(Batch& batch, lr_world& world, uint32_t count, lr_body* out_ids) {
    count = std::min(count, batch.capacity() - batch.count());
    spawn(emitter_, batch, world, count, out_ids);
    count_spawned(count);
    return count;
}

void spawn_in(const Box& box, Batch& batch, lr_world& world, uint32_t count, lr_body* out_ids) {
    lr_emitter_desc desc = LR_EMITTER_DESC_INIT;
    desc.shape = LR_EMIT_BOX;
    put(0.5f * (box.low + box.high), desc.position);
    put(0.5f * (box.high - box.low), desc.size);
    spawn(Emitter(desc), batch, world, count, out_ids);
    if (Lifecycle* const l = batch.lifecycle(); l && (l->has_rules() || l->has_emitter())) l->count_spawned(count);
}

void Lifecycle::report(lr_batch_counts& out) const {
    out.spawned = spawned_;
    out.destroyed = ended_respawned_ ? 0 : ended_;
    out.respawned = ended_respawned_ ? ended_ : 0;
    out.missed = missed_;
    out.by_age = by_cause_[cause_age];
    out.by_divergence = by_cause_[cause_not_finite];
    std::copy(by_cause_ + cause_volume, by_cause_ + cause_count, out.by_volume);
    out.total_spawned = state_.spawned;
    out.total_destroyed = state_.destroyed;
    out.total_respawned = state_.respawned;
    out.total_missed = state_.missed;
}

bool Lifecycle::consistent(const State& s) {
    if (s.has_rules > 1 || s.has_emitter > 1) return false;
    if (!(s.due >= 0.0 && s.due < 1.0) || !in_range(s.burst_clock, 0.0, 1e9)) return false;
    if ((s.has_rules && check(s.rules).refused()) || (s.has_emitter && check(s.emitter).refused())) return false;
    return s.has_emitter || !s.has_rules || s.rules.action != LR_END_RESPAWN;
}

void Lifecycle::restore(const State& state) {
    state_ = state;
    set_rules(state.has_rules ? &state.rules : nullptr);
    set_emitter(state.has_emitter ? &state.emitter : nullptr);
    pass();
}

void settle_diverged(lr_world& world, Batch& batch, lr_batch handle, FaultReport& report) {
    batch.faults.last = 0;
    if (std::exchange(batch.faults.noted, 0u) == 0) return;
    const BatchArrays& a = batch.arrays();
    Lifecycle* const lifecycle = batch.lifecycle();
    const bool ruled = lifecycle && lifecycle->has_rules();
    const bool ends = batch.options.divergence_policy == LR_DIVERGENCE_REMOVE ||
                      (batch.options.divergence_policy == LR_DIVERGENCE_AUTO && ruled);
    uint32_t first_noise_seed = UINT32_MAX;
    for (uint32_t i = 0; i < batch.awake(); ++i) {
        if (a.field[field_age_remainder][i] != diverged_mark) continue;
        ++batch.faults.last;
        first_noise_seed = std::min(first_noise_seed, a.noise_seed[i]);
        a.field[field_age_remainder][i] = held_mark;
        batch.forget(i);
        if (lifecycle && (ends || lifecycle->ends(i))) {
            lifecycle->end_diverged(i);
            continue;
        }
        world.leave(batch, i); // it touches nothing from now on
        if (batch.events()) batch.events()->note(unpack(batch.ids()[i]).slot, noted_divergence);
    }
    if (batch.faults.last == 0) return; // a lane without a body diverged
    batch.faults.total += batch.faults.last;
    if (report.count == 0) report.batch = handle, report.noise_seed = first_noise_seed;
    report.count += batch.faults.last;
}

void log_diverged(const lr_world& world, const FaultReport& report) {
    if (report.count == 0) return;
    char text[160];
    std::snprintf(text, sizeof text, "%u %s diverged; the first has noise seed %u in batch %u", report.count,
                  report.count == 1 ? "body" : "bodies", report.noise_seed, report.batch.id);
    world.log(LR_LOG_WARNING, "lr_world_step", text);
}
} // namespace lr
