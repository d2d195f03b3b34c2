// Whether the kernel marks a body at rest as possibly touching a collider.
#pragma once

#include "base/pose.h"
#include "kernel/contact/collider_contact.h"
#include "kernel/integrator/step.h"

#include <algorithm>

namespace test {

// reach: m, the largest distance from `at`.
inline bool marked(const lr::NearColliders& near, lr::Vector at, float reach) {
    alignas(64) static float fields[lr::field_count][lr::lane_block];
    lr::BatchArrays arrays{};
    for (size_t f = 0; f < lr::field_count; ++f) {
        std::fill_n(fields[f], lr::lane_block, 0.0f);
        arrays.field[f] = fields[f];
    }
    lr::put_in(fields, lr::field_x, 0, at);
    alignas(64) uint32_t mark[lr::lane_block];
    static const lr::ContactTarget& target = *lr::find_target(LR_SIMD_AUTO)->contact;
    target.near(near, 0.0f, 1.0f, reach, arrays, 0, lr::lane_block, mark);
    return mark[0] != 0;
}

} // namespace test
