// Which batches a step of the world steps, and with how many substeps: by their divisors, and by a budget.
#pragma once

#include "langevin_rigid.h"
#include "world/allocator.h"

#include <cstdint>

namespace lr {

class Batch;

class Pacing {
public:
    static constexpr uint64_t largest_budget = uint64_t{1} << 48;

    Pacing();

    // Room for so many batches. False when out of memory; nothing has then changed.
    bool reserve(Allocator& allocator, size_t batches);

    // Body-substeps a step; 0: as many as the batches want.
    void set_budget(uint64_t body_substeps);

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

    bool limited() const { return record_.budget != 0; }
    // Words that matter for what comes.
    template <class Take> void hash(Take&& take) const {
        if (!limited()) return;
        take(record_.budget);
        take(record_.saved);
    }

    const lr_step_report& report() const { return report_; }

    // What a snapshot holds.
    struct Record {
        uint64_t budget; // body-substeps
        uint64_t saved;  // of earlier steps, for a batch that one step's budget does not reach for
    };
    const Record& record() const { return record_; }
    static bool consistent(const Record& record);
    void restore(const Record& record);

private:
    struct Claim {
        Batch* batch;
        uint32_t bodies;
        uint32_t wanted, granted; // substeps
        bool due, forced;         // forced: by forces on its bodies
        double urgency;
        uint64_t turn; // among those of the same urgency
    };
    void share(uint64_t step);

    Record record_{};
    Buffer<Claim> claims_;
    uint32_t count_ = 0;
    lr_step_report report_;
};
static_assert(sizeof(Pacing::Record) % 8 == 0);

} // namespace lr
