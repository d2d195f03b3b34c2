// The clock of a batch: how far it is behind its world, and when it catches up.
#pragma once

#include "base/allocator.h"
#include "base/bit_cast.h"
#include "environment/wind_field.h"
#include "langevin_rigid.h"

#include <algorithm>
#include <cstdint>

namespace lr {

class Batch;

class BatchClock {
public:
    static constexpr uint32_t largest_of_all = 1024;

    // length: of the bodies, m.
    explicit BatchClock(double length);

    // Saved in snapshots.
    struct Record {
        uint32_t divisor;
        uint32_t steps;         // since it was last stepped,
        uint64_t substeps;      // of the world in those steps
        uint64_t first_substep; // of the world, the first of them
        double begin, behind;   // s: world time at their beginning, and their total length
        double lost;            // s, in all
        uint64_t taken;         // body-substeps, in all
        double drift[3];        // m, way of the uniform wind at their beginning
        float wind[3];          // m/s, the uniform wind at their beginning
        uint32_t passed_over;   // how many of the last steps the budget skipped
    };
    static bool consistent(const Record& record, double time, uint64_t substep_count);
    const Record& record() const { return record_; }
    void restore(const Record& record);

    // At the world's full rate, and not behind.
    bool plain() const { return !waits() && record_.divisor == 1; }
    // Words that affect future steps; none while it is plain.
    template <class Take> void hash(Take&& take) const {
        if (plain()) return;
        const Record& r = record_;
        take(r.divisor | uint64_t{r.passed_over} << 32);
        if (!waits()) return;
        take(r.substeps);
        take(r.first_substep);
        for (double v : {r.begin, r.behind, r.drift[0], r.drift[1], r.drift[2]}) take(bit_cast<uint64_t>(v));
        for (float v : r.wind) take(bit_cast<uint32_t>(v));
    }

    void set_divisor(uint32_t divisor) { record_.divisor = divisor; }

    // A step of the world begins: its `dt` is added to the time that the batch is behind.
    void wait(double dt, uint32_t substeps, double time, uint64_t substep_count, const UniformWind& wind);
    // The batch has no awake bodies, so nothing waits.
    void skip();

    // The divisor, reduced so that no substep exceeds the longest permitted; `h`: s, the world's substep.
    uint32_t divisor(double h) const;
    // Whether a batch of this phase is due in the world's step of this number: in every step, unless `divisor` exceeds the substeps of a step.
    bool due(uint32_t divisor, uint32_t substeps, uint64_t step, uint32_t phase) const;
    // The fewest substeps that catch up, none longer than the longest permitted or the world's;
    uint32_t least() const;
    // and with none longer than `divisor` of the world's.
    uint32_t wanted(uint32_t divisor) const;

    // Sets the outcome; 0 substeps: the batch keeps waiting. h: s, the world's substep.
    void grant(uint32_t substeps, bool passed_over, double h);
    uint32_t granted() const { return granted_; }
    double lost_now() const { return lost_now_; } // s, in this step
    void stepped(uint32_t bodies);

    bool waits() const { return record_.steps != 0; }
    bool passed_over() const { return record_.passed_over != 0; }
    double behind() const { return record_.behind; }
    bool at_same_time(const BatchClock& other) const;
    StepTime time() const { return {record_.begin, h_, granted_}; }
    UniformWind wind(const UniformWind& now) const; // over the time being caught up

private:
    void caught_up();
    uint32_t most() const { return static_cast<uint32_t>(std::min<uint64_t>(record_.substeps, LR_MAX_SUBSTEPS)); }

    Record record_;
    double longest_;        // s, substep
    double h_ = 0.0;        // s, of the substeps granted
    double lost_now_ = 0.0; // s
    uint32_t granted_ = 0;
};
static_assert(sizeof(BatchClock::Record) % 8 == 0);

// Decides which batches a step of the world steps, and with how many substeps, by divisors and budget.
class StepScheduler {
public:
    static constexpr uint64_t largest_budget = uint64_t{1} << 48;

    // Makes room for so many batches. False when out of memory; nothing has then changed.
    bool reserve(Allocator& allocator, size_t batches) { return grow(allocator, claims_, batches); }

    // Body-substeps per step; 0: no limit.
    void set_budget(uint64_t body_substeps) { record_ = {body_substeps, 0}; }

    struct Step {
        uint64_t number;
        uint32_t substeps;
        double h; // s
    };
    void begin() { count_ = 0, report_ = {}; }
    // Registers a batch with awake bodies, once per step, after its wait().
    void ask(Batch& batch, uint32_t slot, const Step& step);
    // Grants substeps to all registered batches.
    void decide(const Step& step);

    bool limited() const { return record_.budget != 0; }
    // Words that affect future steps.
    template <class Take> void hash(Take&& take) const {
        if (!limited()) return;
        take(record_.budget);
        take(record_.saved);
    }

    const lr_step_report& report() const { return report_; }

    // Saved in snapshots.
    struct Record {
        uint64_t budget; // body-substeps
        uint64_t saved;  // from earlier steps, for a batch that exceeds one step's budget
    };
    const Record& record() const { return record_; }
    static bool consistent(const Record& r) { return r.budget <= largest_budget && r.saved <= 2 * largest_budget; }
    void restore(const Record& record) {
        record_ = record;
        begin();
    }

private:
    struct Claim {
        Batch* batch;
        uint32_t bodies;
        uint32_t wanted, granted; // substeps
        bool due, forced;         // forced: by forces on its bodies
        double urgency;
        uint64_t turn; // order among equally urgent batches
    };
    void share(uint64_t step);

    Record record_{};
    Buffer<Claim> claims_;
    uint32_t count_ = 0;
    lr_step_report report_{};
};
static_assert(sizeof(StepScheduler::Record) % 8 == 0);
} // namespace lr
