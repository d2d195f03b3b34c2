// Boxes of awake bodies in hashed cells of several sizes, to find pairs that can touch in a substep. Rebuilt for each substep in linear time.
#pragma once

#include "base/allocator.h"
#include "base/float4.h"
#include "collision/hashed_cells.h"

#include <cstdint>

namespace lr {

struct BodyBox {
    Box box;
    // Set by the grid: the level of its size, and the hash of level and cell.
    uint32_t level, cell;
};

class BodyBroadPhase {
public:
    // Room for boxes [0, count). False when out of memory; nothing has then changed.
    bool reserve(Allocator& allocator, uint32_t count);
    BodyBox* boxes() { return boxes_.data(); }
    const BodyBox& box(uint32_t i) const { return boxes_[i]; }
    // Builds the grid from boxes(). A box that is not finite, or as large as a world, touches nothing.
    void build(uint32_t count);

    // Boxes in the grid, sorted by cell: in this order searches for neighbours are fastest.
    uint32_t placed() const { return placed_; }
    uint32_t placed(uint32_t i) const { return index_[i]; }

    // Calls fn(i, mutual), in no order, for each box i that overlaps `around` and is of its level or a larger one, itself included: of two
    // levels the smaller finds the larger; of one level the box in the first of two cells finds the other. mutual: whether that box finds
    // `around` too, as in the same cell.
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
            // Four boxes at once. Boxes of other buckets, or room, follow a bucket's last: whole vectors can be read.
            Int4 in = (load(row(0) + i) <= high[0]) & (load(row(3) + i) >= low[0]);
            for (size_t k = 1; k < 3; ++k) in &= (load(row(k) + i) <= high[k]) & (load(row(k + 3) + i) >= low[k]);
            if (!any(in)) continue;
            for (uint32_t lane = 0; lane < lanes && i + lane < end; ++lane) {
                if (in[lane] == 0 || cells_[i + lane] != id) continue;
                // Nearby cells can share a hash: a box is reported only in its own cell, so once.
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
    // low and high of each axis, bucket after bucket.
    const float* row(size_t k) const { return rows_.data() + k * room_; }

    static constexpr uint32_t lanes = 4;
    uint32_t populated_ = 0, mask_ = 0, placed_ = 0;
    size_t room_ = 0;
    Buffer<BodyBox> boxes_;
    Buffer<float> rows_;     // six of room_
    Buffer<uint32_t> index_; // of boxes, in the order of rows
    Buffer<uint32_t> cells_; // of these
    Buffer<uint32_t> first_; // by bucket, and the end
};
} // namespace lr
