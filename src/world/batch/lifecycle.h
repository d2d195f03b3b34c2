// Spawning and ending of a batch's bodies after each step, by emitter and rules.
#pragma once

#include "base/allocator.h"
#include "base/pose.h"
#include "kernel/integrator/step.h"
#include "langevin_rigid.h"
#include "world/batch/batch.h"

#include <cstdint>

namespace lr {

Outcome check(const lr_batch_rules& rules);
Outcome check(const lr_emitter_desc& desc);

// Distributions of spawned bodies, from an lr_emitter_desc.
class Emitter {
public:
    Emitter() = default;
    explicit Emitter(const lr_emitter_desc& desc); // checked

    // Draws a body at age 0. Depends only on seed, noise seed and life, so the result is the same whenever and wherever it is drawn.
    BodyState draw(uint64_t seed, uint32_t noise_seed, uint32_t life) const;

private:
    lr_emitter_desc desc_{};
    Quaternion<double> orientation_{}, pose_{}; // of the shape; of bodies, if fixed
    Double3 axis_{};                            // of the cone of velocities,
    RightAngles across_{};                      // and across it
    double cone_ = 0.0;                         // 1 - cos(spread)
};

class Lifecycle {
public:
    bool allocate(Allocator& allocator, uint32_t lanes);

    void set_rules(const lr_batch_rules* rules);      // null removes them
    void set_emitter(const lr_emitter_desc* emitter); // null removes it; a pending fraction of a body is kept
    bool has_rules() const { return state_.has_rules != 0; }
    bool has_emitter() const { return state_.has_emitter != 0; }
    bool respawns() const { return has_rules() && state_.rules.action == LR_END_RESPAWN; }

    // In each step: judge() for awake bodies in whole cuts (world/schedule/step_chunks.h), on any thread; then judge_sleep() and finish() once.
    void judge(EndedFunction ended, const BatchArrays& arrays, uint32_t begin, uint32_t end);
    // Checks sleeping bodies, if the answer can have changed for any.
    void judge_sleep(EndedFunction ended, Batch& batch);
    void finish(Batch& batch, lr_world& world, double dt);
    // Between judge() and finish(): ends an awake body that diverged, whatever the rules; and asks whether a body ends.
    void end_diverged(uint32_t index);
    bool ends(uint32_t index) const;
    // For a world step in which the batch waits.
    void pass();

    // Spawns at most `count` bodies, as many as have room, and returns their number.
    uint32_t emit(Batch& batch, lr_world& world, uint32_t count, lr_body* out_ids);
    void count_spawned(uint32_t count) { state_.spawned += count; } // for spawn_in()

    void report(lr_batch_counts& out) const;
    // Kind of event for the bodies that the rules ended in this step.
    int32_t ended_kind() const { return ended_respawned_ ? LR_EVENT_RESPAWNED : LR_EVENT_KILLED; }

    // Saved in snapshots; how often each body respawned is a column.
    struct State {
        uint32_t has_rules, has_emitter;
        lr_batch_rules rules;
        lr_emitter_desc emitter;
        uint32_t padding;
        double due, burst_clock; // bodies; s since the last burst
        uint64_t spawned, destroyed, respawned, missed;
    };
    const State& state() const { return state_; }
    // Whether a snapshot has anything to save. Totals count too.
    bool in_use() const {
        const State& s = state_;
        return has_rules() || has_emitter() || (s.spawned | s.destroyed | s.respawned | s.missed) != 0;
    }
    static bool consistent(const State& state);
    void restore(const State& state);

private:
    void end_bodies(Batch& batch, lr_world& world);
    void respawn(Batch& batch, const lr_world& world, uint32_t index);
    template <class Function> void for_ended(uint32_t begin, uint32_t end, Function&& function);
    void spawn_due(Batch& batch, lr_world& world, double dt);

    State state_{};
    Emitter emitter_;
    bool sleep_judged_ = false; // in this step
    bool faulted_ = false;      // a diverged body ends in this step, whatever the rules
    Buffer<uint32_t> cause_;    // by dense index, in this step
    Buffer<uint8_t> cut_has_ended_;
    // Of the last step.
    uint32_t ended_ = 0, spawned_ = 0, missed_ = 0;
    bool ended_respawned_ = false;
    uint32_t by_cause_[cause_count] = {};
};

// Spawns `count` bodies in a box, like an emitter of that shape. There must be room.
void spawn_in(const Box& box, Batch& batch, lr_world& world, uint32_t count, lr_body* out_ids);

// Bodies of all batches that diverged in a step, for the log.
struct FaultReport {
    uint32_t count = 0;
    lr_batch batch{}; // of the first, by batch and noise seed
    uint32_t noise_seed = 0;
};

// Called at the end of a batch's step, before its rules end bodies.
void settle_diverged(lr_world& world, Batch& batch, lr_batch handle, FaultReport& report);
void log_diverged(const lr_world& world, const FaultReport& report);
} // namespace lr
