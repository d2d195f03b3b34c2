#include "world/faults.h"

#include "kernel/faults.h"
#include "world/lifecycle.h"
#include "world/world.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

namespace lr {

void settle_faults(lr_world& world, Batch& batch, lr_batch handle, FaultReport& report) {
    batch.faults.last = 0;
    if (std::exchange(batch.faults.noted, 0u) == 0) return;
    const BatchArrays& a = batch.arrays();
    Lifecycle* const lifecycle = batch.lifecycle();
    const bool ruled = lifecycle && lifecycle->has_rules();
    const bool ends = batch.faults.policy == LR_FAULT_REMOVE || (batch.faults.policy == LR_FAULT_AUTO && ruled);
    uint32_t first_key = UINT32_MAX;
    for (uint32_t i = 0; i < batch.awake(); ++i) {
        if (a.field[field_age_rest][i] != fault_mark) continue;
        ++batch.faults.last;
        first_key = std::min(first_key, a.key[i]);
        a.field[field_age_rest][i] = held_mark;
        batch.external.clear(i);
        if (batch.resting()) batch.resting()->forget(i);
        if (lifecycle && (ends || lifecycle->ends(i))) {
            lifecycle->end_for_fault(i);
            continue;
        }
        world.leave(batch, i); // nothing touches it any more
        if (batch.events()) batch.events()->note_fault(unpack(batch.ids()[i]).slot);
    }
    if (batch.faults.last == 0) return; // a lane without a body
    batch.faults.total += batch.faults.last;
    if (report.count == 0) report.batch = handle, report.key = first_key;
    report.count += batch.faults.last;
}

void log_faults(const lr_world& world, const FaultReport& report) {
    if (report.count == 0) return;
    char text[160];
    std::snprintf(text, sizeof text, "%u %s left physics; the first: key %u of batch %u", report.count,
                  report.count == 1 ? "body has" : "bodies have", report.key, report.batch);
    world.log(LR_LOG_WARNING, "lr_world_step", text);
}

bool states_consistent(const unsigned char* rows, uint64_t stride, uint32_t fields, uint32_t count) {
    const auto value = [&](size_t f, uint32_t i) {
        float v;
        std::memcpy(&v, rows + 4 * (f * stride + i), 4);
        return v;
    };
    bool good = true;
    for (uint32_t i = 0; i < count; ++i) {
        // Velocities are as callers have made them, and a step judges them.
        for (size_t f = 0; f < fields; ++f) good = good && std::isfinite(value(f, i));
        for (size_t f = field_x; f <= field_z; ++f) good = good && std::abs(value(f, i)) <= farthest_place;
        float turn = 0.0f;
        for (size_t f = field_qx; f <= field_qw; ++f) turn += value(f, i) * value(f, i);
        good = good && turn >= shortest_turn && turn <= longest_turn;
        good = good && value(field_scale, i) > 0.0f && value(field_age, i) >= 0.0f;
    }
    return good;
}

} // namespace lr
