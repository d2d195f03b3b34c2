#include "world/lifecycle.h"

#include "world/step_chunks.h"
#include "world/world.h"

#include <algorithm>
#include <cmath>
#include <new>

namespace lr {

Lifecycle* Lifecycle::create(Allocator& allocator, uint32_t capacity, uint32_t lanes) {
    void* const memory = allocator.allocate(sizeof(Lifecycle));
    if (!memory) return nullptr;
    auto* const made = new (memory) Lifecycle();
    if (made->cause_.allocate(allocator, lanes) && made->cut_has_ended_.allocate(allocator, cut_count(lanes)) &&
        made->life_.allocate(allocator, capacity) && made->ended_ids_.allocate(allocator, capacity) &&
        made->born_ids_.allocate(allocator, capacity)) {
        std::fill_n(made->life_.data(), capacity, 0u);
        return made;
    }
    destroy(allocator, made);
    return nullptr;
}

void Lifecycle::destroy(Allocator& allocator, Lifecycle* lifecycle) {
    if (!lifecycle) return;
    lifecycle->~Lifecycle();
    allocator.release(lifecycle, sizeof(Lifecycle));
}

void Lifecycle::set_rules(const lr_batch_rules* rules) {
    has_rules_ = rules != nullptr;
    rules_ = {};
    if (!rules) return;
    rules_ = *rules;
    std::fill(rules_.volumes + rules_.volume_count, rules_.volumes + LR_MAX_KILL_VOLUMES, lr_kill_volume{});
}

void Lifecycle::set_emitter(const lr_emitter_desc* emitter) {
    has_emitter_ = emitter != nullptr;
    if (!emitter) {
        emitter_ = Emitter();
        due_ = burst_clock_ = 0.0;
        return;
    }
    emitter_ = Emitter(*emitter);
}

void Lifecycle::judge(EndedFunction ended, const BatchArrays& arrays, uint32_t begin, uint32_t end) {
    if (!has_rules_) return;
    for (uint32_t at = begin; at < end; at += cut_bodies)
        cut_has_ended_[at / cut_bodies] =
            ended(rules_, arrays, at, std::min(at + cut_bodies, end), cause_.data()) ? 1 : 0;
}

void Lifecycle::finish(Batch& batch, lr_world& world, double dt) {
    pass();
    ended_respawned_ = respawns();
    if (has_rules_ || faulted_) end_bodies(batch, world);
    if (has_emitter_) bear(batch, world, dt);
}

bool Lifecycle::ends(uint32_t index) const {
    return has_rules_ && cut_has_ended_[index / cut_bodies] != 0 && cause_[index] != cause_none;
}

void Lifecycle::end_for_fault(uint32_t index) {
    if (!has_rules_ && !faulted_) std::fill_n(cut_has_ended_.data(), cut_has_ended_.size(), uint8_t{0});
    faulted_ = true;
    uint8_t& any = cut_has_ended_[index / cut_bodies];
    if (any == 0) {
        const uint32_t begin = index / cut_bodies * cut_bodies;
        std::fill_n(cause_.data() + begin, std::min<size_t>(cut_bodies, cause_.size() - begin), uint32_t{cause_none});
    }
    any = 1;
    cause_[index] = cause_not_finite;
}

void Lifecycle::judge_rest(EndedFunction ended, Batch& batch) {
    Resting* const resting = batch.resting();
    if (!has_rules_ || !resting->in_question(rules_.max_age)) return;
    batch.make_ages_exact();
    // With them those that move in the first one's cut: they have been judged alike.
    judge(ended, batch.arrays(), batch.awake() / cut_bodies * cut_bodies, batch.padded_count());
    resting->answered(batch.awake(), batch.count(), rules_.max_age);
    rest_judged_ = true;
}

// From the last to the first of [begin, end).
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
    if (batch.rests(index)) index = batch.wake(index);
    batch.write(index, emitter_.draw(world.seed, batch.arrays().key[index], ++life_[index]));
    if (batch.resting()) batch.resting()->forget(index);
    if (batch.events()) batch.events()->clear(unpack(batch.ids()[index]).slot);
}

// A body that moves into the place of one that ends has been judged already. What becomes of a body depends on its key and
// life alone, so that the order does not matter.
void Lifecycle::end_bodies(Batch& batch, lr_world& world) {
    const uint32_t awake = batch.awake(), count = batch.count();
    const auto note = [&](uint32_t i) {
        ++by_cause_[cause_[i]];
        ended_ids_[ended_++] = batch.ids()[i];
        world.leave(batch, i);
        if (!batch.events()) return;
        const BatchArrays& a = batch.arrays();
        batch.events()->note_killed(batch.ids()[i], a.key[i],
                                    {a.field[field_x][i], a.field[field_y][i], a.field[field_z][i]},
                                    cause_[i] == cause_not_finite);
    };
    if (ended_respawned_) {
        for_ended(0, awake, [&](uint32_t i) { note(i), respawn(batch, world, i); });
        // From the first to the last: one that wakes changes places with one before it.
        for (uint32_t i = rest_judged_ ? awake : count; i < count; ++i)
            if (cause_[i] != cause_none) note(i), respawn(batch, world, i);
    } else {
        const auto end = [&](uint32_t i) { note(i), batch.remove(batch.ids()[i]); };
        if (rest_judged_) for_ended(awake, count, end);
        for_ended(0, awake, end);
    }
    rest_judged_ = faulted_ = false;
    (ended_respawned_ ? total_respawned_ : total_destroyed_) += ended_;
}

void Lifecycle::bear(Batch& batch, lr_world& world, double dt) {
    const lr_emitter_desc& d = emitter_.desc();
    due_ += static_cast<double>(d.rate) * dt;
    double births = std::floor(due_);
    due_ -= births;
    if (d.burst_count != 0) {
        const double interval = static_cast<double>(d.burst_interval);
        burst_clock_ += dt;
        const double bursts = std::floor(burst_clock_ / interval);
        burst_clock_ = std::max(burst_clock_ - bursts * interval, 0.0);
        births += bursts * static_cast<double>(d.burst_count);
    }
    // Who finds no room is not born later either: a full batch must not burst when a place comes free.
    const uint32_t wanted = static_cast<uint32_t>(std::min(births, 4294967295.0));
    born_ = emit(batch, world, wanted, born_ids_.data());
    missed_ = wanted - born_;
    total_missed_ += missed_;
}

uint32_t Lifecycle::emit(Batch& batch, lr_world& world, uint32_t count, lr_body* out_ids) {
    count = std::min(count, batch.capacity() - batch.count());
    for (uint32_t i = 0; i < count; ++i) {
        const lr_body id = batch.add(emitter_.draw(world.seed, world.take_key(), 0));
        if (out_ids) out_ids[i] = id;
    }
    total_born_ += count;
    return count;
}

void Lifecycle::move(uint32_t from, uint32_t to) {
    life_[to] = life_[from];
    life_[from] = 0;
}

void Lifecycle::report(lr_batch_events& out) const {
    out.born = born_;
    out.destroyed = ended_respawned_ ? 0 : ended_;
    out.respawned = ended_respawned_ ? ended_ : 0;
    out.missed = missed_;
    out.by_age = by_cause_[cause_age];
    out.by_not_finite = by_cause_[cause_not_finite];
    std::copy(by_cause_ + cause_volume, by_cause_ + cause_count, out.by_volume);
    out.total_born = total_born_;
    out.total_destroyed = total_destroyed_;
    out.total_respawned = total_respawned_;
    out.total_missed = total_missed_;
    out.ended_ids = ended_ids_.data();
    out.born_ids = born_ids_.data();
}

Lifecycle::Record Lifecycle::record() const {
    Record r{};
    r.has_rules = has_rules_ ? 1 : 0;
    r.has_emitter = has_emitter_ ? 1 : 0;
    r.rules = rules_;
    r.emitter = emitter_.desc();
    r.due = due_;
    r.burst_clock = burst_clock_;
    const uint64_t totals[4] = {total_born_, total_destroyed_, total_respawned_, total_missed_};
    std::copy(totals, totals + 4, r.totals);
    return r;
}

bool Lifecycle::consistent(const Record& r) {
    if (r.has_rules > 1 || r.has_emitter > 1) return false;
    if (!(r.due >= 0.0 && r.due < 1.0) || !(r.burst_clock >= 0.0 && r.burst_clock <= 1e9)) return false;
    if (r.has_rules && (!all_finite(r.rules) || wrong_in(r.rules))) return false;
    if (r.has_emitter && (!all_finite(r.emitter) || wrong_in(r.emitter))) return false;
    return r.has_emitter || !r.has_rules || r.rules.action != LR_END_RESPAWN;
}

void Lifecycle::restore(const Record& r, uint32_t count) {
    set_rules(r.has_rules ? &r.rules : nullptr);
    set_emitter(r.has_emitter ? &r.emitter : nullptr);
    due_ = r.due;
    burst_clock_ = r.burst_clock;
    total_born_ = r.totals[0];
    total_destroyed_ = r.totals[1];
    total_respawned_ = r.totals[2];
    total_missed_ = r.totals[3];
    pass();
    std::fill(life_.data() + count, life_.data() + life_.size(), 0u);
}

} // namespace lr
