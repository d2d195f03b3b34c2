// Positions of a batch's sleeping bodies in an unbounded grid of hashed cells, in levels by size.
#pragma once

#include "base/allocator.h"
#include "collision/hashed_cells.h"

#include <cstdint>

namespace lr {

// The first of bodies [from, to), by position and scale, whose box, position +- reach times scale, overlaps `box`; `to` if none does.
uint32_t next_in(const Box& box, float* const* position, const float* scale, float reach, uint32_t from, uint32_t to);

class SleepingGrid {
public:
    // Each level's cells are four times as wide as those before: eleven levels span all scales.
    static constexpr uint32_t level_count = 11;
    // A search also finds bodies within this share of their reach beyond their boxes.
    static constexpr double room = 0.02;

    // reach: m, at scale 1. False when out of memory.
    bool create(Allocator& allocator, uint32_t capacity, double reach);

    // By body slot.
    void insert(uint32_t slot, Vector position, float scale);
    void remove(uint32_t slot);
    void clear();

    // Calls fn(slot) for all bodies whose box, position +- reach, overlaps `box`, and for some near it, some more than once, in no order. fn may
    // remove its body. Returns false without a call if testing `all` bodies one by one is cheaper.
    template <class Function> bool visit(const Box& box, uint32_t all, Function&& fn) const {
        double cells = 0.0;
        for (uint32_t level = 0; level < level_count; ++level)
            if (population_[level] != 0) cells += cells_about(box, width_[level]).count();
        if (cells > static_cast<double>(all)) return false;
        for (uint32_t level = 0; level < level_count; ++level) {
            if (population_[level] == 0) continue;
            cells_about(box, width_[level]).visit([&](CellAt at) {
                for (uint32_t slot = heads_[cell_hash(at, level) & mask_]; slot != none;) {
                    const uint32_t next = next_[slot];
                    fn(slot);
                    slot = next;
                }
            });
        }
        return true;
    }

private:
    static constexpr uint32_t none = UINT32_MAX;
    static constexpr uint32_t head_bit = 1u << 31; // above every slot

    uint32_t level_of(float scale) const;

    double reach_ = 0.0;
    float width_[level_count] = {}; // m, of cells
    uint32_t population_[level_count] = {};
    uint32_t mask_ = 0;
    Buffer<uint32_t> heads_;
    Buffer<uint32_t> next_, previous_; // by slot; previous: of a bucket's first, head_bit and the bucket
    Buffer<uint8_t> level_;            // by slot
};
} // namespace lr
