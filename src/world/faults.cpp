#include "world/faults.h"

#include "kernel/faults.h"
#include "kernel/limits.h"
#include "world/lifecycle.h"
#include "world/world.h"

#include <algorithm>
#include <bit>
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
    constexpr uint32_t infinite = 0x7f800000u, minus = 0x80000000u;
    const auto word = [&](size_t f, uint32_t i) {
        uint32_t v;
        std::memcpy(&v, rows + 4 * (f * stride + i), 4);
        return v;
    };
    // Column by column and without branches: in vectors. Velocities are as callers have made them, and a step judges them.
    uint32_t bad = 0;
    for (size_t f = 0; f < fields; ++f)
        for (uint32_t i = 0; i < count; ++i) bad |= (word(f, i) & infinite) == infinite ? 1u : 0u;
    for (size_t f = field_x; f <= field_z; ++f)
        for (uint32_t i = 0; i < count; ++i)
            bad |= (word(f, i) & ~minus) > std::bit_cast<uint32_t>(farthest_place) ? 1u : 0u;
    for (uint32_t i = 0; i < count; ++i) {
        const auto square = [&](size_t f) {
            const float v = std::bit_cast<float>(word(f, i));
            return v * v;
        };
        const float turn = square(field_qx) + square(field_qy) + square(field_qz) + square(field_qw);
        bad |= turn >= shortest_turn && turn <= longest_turn ? 0u : 1u;
    }
    for (uint32_t i = 0; i < count; ++i) {
        const float scale = std::bit_cast<float>(word(field_scale, i)), age = std::bit_cast<float>(word(field_age, i)),
                    rest = std::bit_cast<float>(word(field_age_rest, i));
        const auto bit = [](bool b) { return b ? 1u : 0u; };
        // Less than the age's last digit; of a body that has left physics a mark.
        const uint32_t remainder =
            bit(std::abs(rest) <= 0x1p-23f * age) | bit(rest == held_mark) | bit(rest == fault_mark);
        bad |= 1u ^ (bit(scale >= least_scale) & bit(scale <= most_scale) & bit(age >= 0.0f) & bit(age <= most_age) &
                     remainder);
    }
    return bad == 0;
}

} // namespace lr
