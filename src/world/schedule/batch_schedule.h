// Clock of a batch: how far it is behind the world, and when it catches up. docs/reference/stepping.md
#pragma once

#include "base/allocator.h"
#include "base/bit_cast.h"
#include "environment/wind_field.h"
#include "langevin_rigid.h"

#include <algorithm>
#include <cstdint>

namespace lr {

class Batch;
class Colliders;

class BatchClock {
public:
    static constexpr uint32_t largest_of_all = 1024;

    // length: m, of the bodies; limits their substeps.
    explicit BatchClock(double length);

    // Saved in snapshots.
    struct Record {
        uint32_t divisor;
        uint32_t steps;         // of the world since the batch's last step
        uint64_t substeps;      // of the world in those steps
        uint64_t first_substep; // number of the first of them
        double begin, behind;   // s: world time when they began, and their length
        double lost;            // s, total
        uint64_t taken;         // body-substeps, total
        double drift[3];        // m, displacement of the uniform wind when they began
        float wind[3];          // m/s, uniform wind when they began
        uint32_t passed_over;   // 1: the budget had nothing for it in the last step
    };
    static bool consistent(const Record& record, double time, uint64_t substep_count);
    const Record& record() const { return record_; }
    void restore(const Record& record);

    // At the world's full rate, and up to date.
    bool plain() const { return !waits() && record_.divisor == 1; }
    // Numbers that affect future steps; none while plain().
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

    // A world step begins: the batch falls behind by dt.
    void wait(double dt, uint32_t substeps, double time, uint64_t substep_count, const UniformWind& wind);
    // Without awake bodies there is nothing to catch up.
    void skip();

    // The divisor, limited so that no substep gets too long. h: s, the world's substep.
    uint32_t divisor(double h) const;
    // Whether the batch is due in this world step. It always is, unless the divisor exceeds the substeps of a step; phases spread batches over steps.
    bool due(uint32_t divisor, uint32_t substeps, uint64_t step, uint32_t phase) const;
    // The fewest substeps that catch up, none longer than the longest allowed, or than the world's if that is longer.
    uint32_t least() const;
    // The same with substeps of at most `divisor` of the world's.
    uint32_t wanted(uint32_t divisor) const;

    // Sets the result; with 0 substeps the batch waits on. h: s, the world's substep.
    void grant(uint32_t substeps, bool passed_over, double h);
    uint32_t granted() const { return granted_; }
    double lost_now() const { return lost_now_; } // s, in this step
    void stepped(uint32_t bodies);

    bool waits() const { return record_.steps != 0; }
    bool passed_over() const { return record_.passed_over != 0; }
    double behind() const { return record_.behind; }
    bool at_same_time(const BatchClock& other) const;
    StepTime time() const { return {record_.begin, h_, granted_}; }
    UniformWind wind(const UniformWind& now) const; // over the time to catch up

private:
    void caught_up();
    uint32_t most() const { return static_cast<uint32_t>(std::min<uint64_t>(record_.substeps, LR_MAX_SUBSTEPS)); }

    Record record_;
    double longest_;        // s, of a substep
    double h_ = 0.0;        // s, of granted substeps
    double lost_now_ = 0.0; // s
    uint32_t granted_ = 0;
};
static_assert(sizeof(BatchClock::Record) % 8 == 0);

// Decides which batches take part in a world step, and with how many substeps, from divisors and budget.
class StepScheduler {
public:
    static constexpr uint64_t largest_budget = uint64_t{1} << 48;

    // Makes room for `batches`. Returns false and changes nothing when out of memory.
    bool reserve(Allocator& allocator, size_t batches) { return grow(allocator, claims_, batches); }

    // Body-substeps per step; 0: no limit.
    void set_budget(uint64_t body_substeps) { record_ = {body_substeps, 0}; }

    struct Step {
        uint64_t number;
        uint32_t substeps;
        double h; // s
    };
    void begin() { count_ = 0, report_ = {}; }
    // Asks for a batch with awake bodies, once per step, after its wait().
    // A collider that moves among a batch's bodies ends its wait: they would meet its last step alone.
    void ask(Batch& batch, uint32_t slot, const Step& step, const Colliders& colliders);
    // Grants substeps to all batches that asked.
    void decide(const Step& step);

    bool limited() const { return record_.budget != 0; }
    // Numbers that affect future steps.
    template <class Take> void hash(Take&& take) const {
        if (!limited()) return;
        take(record_.budget);
        take(record_.saved);
    }

    const lr_step_report& report() const { return report_; }

    // Saved in snapshots.
    struct Record {
        uint64_t budget; // body-substeps
        uint64_t saved;  // left over by earlier steps, for a batch that costs more than one step's budget
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
        bool due, forced;         // forced: forces wait on its bodies
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
