// Broad phase for pairs of awake bodies: their boxes in hashed cells of several sizes. Rebuilt for each substep in linear time.
#pragma once

#include "base/allocator.h"
#include "base/float4.h"
#include "collision/hashed_cells.h"

#include <cstdint>

namespace lr {

struct BodyBox {
    Box box;
    // Set by build(): the level that fits the box's size, and the hash of level and cell.
    uint32_t level, cell;
};

class BodyBroadPhase {
public:
    // Makes room for `count` boxes. Returns false and changes nothing when out of memory.
    bool reserve(Allocator& allocator, uint32_t count);
    BodyBox* boxes() { return boxes_.data(); }
    const BodyBox& box(uint32_t i) const { return boxes_[i]; }
    // Builds the grid from boxes(). Boxes that are not finite, or as large as a world, are left out and overlap nothing.
    void build(uint32_t count);

    // Boxes in the grid, sorted by cell. Searching for neighbours in this order is kindest to the cache.
    uint32_t placed() const { return placed_; }
    uint32_t placed(uint32_t i) const { return index_[i]; }

    // Calls fn(i, mutual), in no order, for boxes that overlap `around`, itself included. So that pairs are found once, the smaller of two levels
    // finds the larger; on the same level the box in the first of the two cells finds the other. mutual: both are in one cell, so the other box finds
    // `around` too.
    template <class Function> void visit(const BodyBox& around, Function&& function) const {
        if (around.cell == nowhere) return;
        for (uint32_t level = around.level; level < levels; ++level) {
            if ((populated_ >> level & 1u) == 0) continue;
            const auto [first, last] = cells_about(around.box, width_of(level));
            const CellAt own = cell_of(around.box, level);
            const bool half = level == around.level;
            for (int32_t x = half ? own.x : first.x; x <= last.x; ++x) {
                const bool at_x = half && x == own.x;
                for (int32_t y = at_x ? own.y : first.y; y <= last.y; ++y) {
                    const bool at_y = at_x && y == own.y;
                    for (int32_t z = at_y ? own.z : first.z; z <= last.z; ++z) {
                        const bool mutual = at_y && z == own.z;
                        look_in(around.box, level, {x, y, z}, [&](uint32_t box) { function(box, mutual); });
                    }
                }
            }
        }
    }

private:
    template <class Function>
    void look_in(const Box& around, uint32_t level, CellAt at, const Function& function) const {
        const uint32_t id = hash(level, at), bucket = id & mask_, end = first_[bucket + 1];
        const Float4 low[3] = {all(around.low.x), all(around.low.y), all(around.low.z)};
        const Float4 high[3] = {all(around.high.x), all(around.high.y), all(around.high.z)};
        for (uint32_t i = first_[bucket]; i < end; i += lanes) {
            // Four boxes at once. A bucket's last vector may read into the next bucket or into padding.
            Int4 in = (load(row(0) + i) <= high[0]) & (load(row(3) + i) >= low[0]);
            for (size_t k = 1; k < 3; ++k) in &= (load(row(k) + i) <= high[k]) & (load(row(k + 3) + i) >= low[k]);
            if (!any(in)) continue;
            for (uint32_t lane = 0; lane < lanes && i + lane < end; ++lane) {
                if (in[lane] == 0 || cells_[i + lane] != id) continue;
                // Several cells can share a hash, so a box counts only if this is its own cell; else it would be reported twice.
                const auto number = [&](size_t k) { return row(k)[i + lane]; };
                const Box box{{number(0), number(1), number(2)}, {number(3), number(4), number(5)}};
                if (cell_of(box, level) == at) function(index_[i + lane]);
            }
        }
    }

    static constexpr uint32_t levels = 32, nowhere = UINT32_MAX;
    static constexpr float smallest = 1.0f / (1 << 14); // m, cells of the first level; each level doubles the width

    // Powers of two: products with them and with their inverses are exact.
    static float width_of(uint32_t level) { return static_cast<float>(uint32_t{1} << level) * smallest; }
    static CellAt cell_of(const Box& box, uint32_t level) { return cell_at(middle_of(box), 1.0f / width_of(level)); }
    // Never equal to `nowhere`.
    static uint32_t hash(uint32_t level, CellAt at) {
        const uint32_t h = cell_hash(at, level);
        return h == nowhere ? 0 : h;
    }
    // Low and high bounds along each axis, bucket after bucket.
    const float* row(size_t k) const { return rows_.data() + k * room_; }

    static constexpr uint32_t lanes = 4;
    uint32_t populated_ = 0, mask_ = 0, placed_ = 0;
    size_t room_ = 0;
    Buffer<BodyBox> boxes_;
    Buffer<float> rows_;     // six rows of room_
    Buffer<uint32_t> index_; // index in boxes(), in the order of rows_
    Buffer<uint32_t> cells_; // hash of level and cell, in the same order
    Buffer<uint32_t> first_; // first entry of each bucket, then the end
};
} // namespace lr
