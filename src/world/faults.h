// Bodies that have left physics in a step: frozen where they last were sane, or ended. docs/reference/bodies.md
#pragma once

#include "langevin_rigid.h"

#include <cstdint>

struct lr_world;

namespace lr {

class Batch;

// Of a batch.
struct BodyFaults {
    int32_t policy = LR_FAULT_AUTO;
    uint32_t noted = 0; // of the step: a body has left physics (StepInput::faults)
    uint32_t last = 0;  // bodies, in the last step
    uint64_t total = 0;

    // What a snapshot holds.
    struct Record {
        int32_t policy;
        uint32_t reserved;
        uint64_t total;
    };
    Record record() const { return {policy, 0, total}; }
    static bool consistent(const Record& r) {
        return r.policy >= LR_FAULT_AUTO && r.policy <= LR_FAULT_REMOVE && r.reserved == 0;
    }
    // Some may have left physics since the step before, between two steps.
    void restore(const Record& r) { *this = {r.policy, 1, 0, r.total}; }
    bool in_use() const { return policy != LR_FAULT_AUTO || total != 0; }
};
static_assert(sizeof(BodyFaults::Record) % 8 == 0);

// Those of all batches in a step, for the log.
struct FaultReport {
    uint32_t count = 0;
    lr_batch batch = 0; // of the first, by batches and keys
    uint32_t key = 0;
};

// At the end of a step of the batch, before its rules end bodies.
void settle_faults(lr_world& world, Batch& batch, lr_batch handle, FaultReport& report);
void log_faults(const lr_world& world, const FaultReport& report);

// Whether the states in a snapshot's rows of `stride` words are those of bodies.
bool states_consistent(const unsigned char* rows, uint64_t stride, uint32_t fields, uint32_t count);

} // namespace lr
