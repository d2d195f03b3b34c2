// Lanes that vectors step along with those of bodies that move.
#pragma once

#include "world/batch.h"

#include <algorithm>

namespace lr {

// Bodies at rest in the lanes behind the last that moves, which vectors step along with it.
class KeptLanes {
public:
    KeptLanes(const Batch& batch, uint32_t first, uint32_t last) : first_(first), count_(last - first) {
        for (size_t f = 0; f < batch.fields(); ++f) std::copy_n(batch.arrays().field[f] + first, count_, lanes_[f]);
    }
    void put_back(const Batch& batch) const {
        for (size_t f = 0; f < batch.fields(); ++f) std::copy_n(lanes_[f], count_, batch.arrays().field[f] + first_);
    }

private:
    uint32_t first_, count_;
    float lanes_[field_count][lane_block];
};

} // namespace lr
