// The births and ends of a batch's bodies at the end of each step, by its rules and its emitter.
#pragma once

#include "kernel/ended.h"
#include "langevin_rigid.h"
#include "world/allocator.h"
#include "world/emitter.h"
#include "world/rules.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace lr {

class Batch;

class Lifecycle {
public:
    // Null when out of memory.
    static Lifecycle* create(Allocator& allocator, uint32_t capacity, uint32_t lanes);
    static void destroy(Allocator& allocator, Lifecycle* lifecycle);

    void set_rules(const lr_batch_rules* rules);      // null ends them
    void set_emitter(const lr_emitter_desc* emitter); // null ends it; what is due to be born stays due
    bool has_rules() const { return has_rules_; }
    bool has_emitter() const { return has_emitter_; }
    bool respawns() const { return has_rules_ && rules_.action == LR_END_RESPAWN; }

    // A step: judge() for all bodies that move, from any threads, each for whole cuts (world/step_chunks.h); then judge_rest(),
    // and finish() once.
    void judge(EndedFunction ended, const BatchArrays& arrays, uint32_t begin, uint32_t end);
    // Those at rest, where the rules may have something new to say about them.
    void judge_rest(EndedFunction ended, Batch& batch);
    void finish(Batch& batch, lr_world& world, double dt);
    // Between these: a body that moves ends for having left physics, whatever the rules; and whether it ends by them.
    void end_for_fault(uint32_t index);
    bool ends(uint32_t index) const;
    // A step of the world in which the batch waits.
    void pass() { ended_ = born_ = missed_ = 0, std::fill_n(by_cause_, cause_count, 0u); }

    // Births of at most `count` bodies; the number of those that there was room for.
    uint32_t emit(Batch& batch, lr_world& world, uint32_t count, lr_body* out_ids);

    uint32_t life(uint32_t index) const { return life_[index]; }
    // As in ExternalForces.
    void move(uint32_t from, uint32_t to);
    void swap(uint32_t a, uint32_t b) { std::swap(life_[a], life_[b]); }

    // `out` has the size of this library.
    void report(lr_batch_events& out) const;

    // Whether anything here matters for what comes.
    bool in_use() const { return has_rules_ || has_emitter_ || total_born_ + total_destroyed_ + total_respawned_ != 0; }

    // What a snapshot holds, beside the lives.
    struct Record {
        uint32_t has_rules, has_emitter;
        lr_batch_rules rules;
        lr_emitter_desc emitter;
        uint32_t padding;
        double due, burst_clock;
        uint64_t totals[4];
    };
    Record record() const;
    static bool consistent(const Record& record);
    void restore(const Record& record, uint32_t count);
    uint32_t* lives() { return life_.data(); }
    double due() const { return due_; }
    double burst_clock() const { return burst_clock_; }

private:
    Lifecycle() = default;
    void end_bodies(Batch& batch, lr_world& world);
    void respawn(Batch& batch, const lr_world& world, uint32_t index);
    template <class Function> void for_ended(uint32_t begin, uint32_t end, Function&& function);
    void bear(Batch& batch, lr_world& world, double dt);

    bool has_rules_ = false, has_emitter_ = false;
    bool rest_judged_ = false; // in this step
    bool faulted_ = false;     // some end in it whatever the rules
    lr_batch_rules rules_{};
    Emitter emitter_;
    double due_ = 0.0, burst_clock_ = 0.0; // bodies; s since the last burst
    Buffer<uint32_t> cause_;               // by dense index, of the step
    Buffer<uint8_t> cut_has_ended_;
    Buffer<uint32_t> life_;     // by dense index: how often a body has respawned
    Buffer<lr_body> ended_ids_; // of the last step
    Buffer<lr_body> born_ids_;
    uint32_t ended_ = 0, born_ = 0, missed_ = 0;
    bool ended_respawned_ = false;
    uint32_t by_cause_[cause_count] = {};
    uint64_t total_born_ = 0, total_destroyed_ = 0, total_respawned_ = 0, total_missed_ = 0;
};

} // namespace lr
