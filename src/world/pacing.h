// Which batches a step of the world steps, and with how many substeps: by their rates, and by a budget.
#pragma once

#include "langevin_rigid.h"
#include "world/allocator.h"

#include <bit>
#include <cstdint>

namespace lr {

class Batch;

// Null when fine, else what is wrong. Of finite numbers only.
const char* wrong_in(const lr_budget& budget);

class Pacing {
public:
    Pacing();

    // Room for so many batches. False when out of memory; nothing has then changed.
    bool reserve(Allocator& allocator, size_t batches);

    void set_budget(const lr_budget& budget);

    struct Step {
        uint64_t number;
        uint32_t substeps;
        double h; // s
    };
    // A step begins: nobody has been asked.
    void begin();
    // A batch with bodies that move, each once, its pace told of the step.
    void ask(Batch& batch, uint32_t slot, const Step& step);
    // Grants substeps to all that were asked.
    void decide(const Step& step);

    bool limited() const { return budget_.kind != LR_BUDGET_NONE; }
    // Words that matter for what comes.
    template <class Take> void hash(Take&& take) const {
        if (!limited()) return;
        take(static_cast<uint64_t>(budget_.kind));
        take(budget_.body_substeps);
        take(std::bit_cast<uint64_t>(budget_.seconds));
        take(std::bit_cast<uint64_t>(saved_));
    }
    bool timed() const { return budget_.kind == LR_BUDGET_TIME; }
    // What the step took on the wall, of which batches had Batch::spent: for the prices of the next.
    void learn(double seconds);

    const lr_step_report& report() const { return report_; }

    // What a snapshot holds.
    struct Record {
        lr_budget budget;
        double saved;
    };
    Record record() const { return {budget_, saved_}; }
    static bool consistent(const Record& record);
    void restore(const Record& record);

private:
    struct Claim {
        Batch* batch;
        uint32_t slot;
        uint32_t bodies;
        uint32_t divisor; // its own,
        uint32_t largest; // and up to which it keeps to its longest substep
        uint32_t wanted, granted;
        bool due, forced; // forced: by forces on its bodies
        double price;     // of a substep of all its bodies, in units of the budget
        double urgency;
    };
    // What the budget does to divisors: they grow by a factor, up to the largest each, or beyond.
    struct Coarsening {
        double factor;
        bool beyond;
    };
    static double divisor(const Claim& claim, const Coarsening& coarse);
    Coarsening coarsening(double amount, uint32_t substeps) const;
    void share(double amount, const Coarsening& coarse);

    lr_budget budget_;
    double saved_ = 0.0; // of earlier steps, for a batch that one step's budget does not reach for
    Buffer<Claim> claims_;
    uint32_t count_ = 0;
    lr_step_report report_;
};
static_assert(sizeof(Pacing::Record) % 8 == 0);

} // namespace lr
