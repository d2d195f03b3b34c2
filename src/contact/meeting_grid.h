// Boxes of bodies that move, in hashed cells of as many sizes as there are: which may touch each other in a substep. Made
// anew for each substep, in time linear in the number of bodies.
#pragma once

#include "contact/cells.h"
#include "contact/four.h"
#include "world/allocator.h"

#include <algorithm>
#include <cstdint>

namespace lr {

struct MeetingBox {
    Box box;
    uint32_t body;
    // Of the grid: the level of its size, and the hash of that and its cell.
    uint32_t level, cell;
};

class MeetingGrid {
public:
    // Boxes of [0, count). False when out of memory, and then it is as it was.
    bool reserve(Allocator& allocator, uint32_t count);
    MeetingBox* boxes() { return boxes_.data(); }
    const MeetingBox& box(uint32_t i) const { return boxes_[i]; }
    // Their boxes are what they are. One that is not finite, or as large as a world, meets nothing.
    void build(uint32_t count);

    // Boxes that can meet others, those of a cell together: in this order neighbours are looked for fastest.
    uint32_t placed() const { return placed_; }
    uint32_t placed(uint32_t i) const { return index_[i]; }

    // Calls fn(box, mutual) for each that overlaps one of them and is of its level or a larger one, itself too, in no order: of a pair
    // of two levels the smaller finds the larger, of two of a level the one in the first of two cells the other. mutual: whether that
    // finds `around` as well, as in the same cell.
    template <class Function> void visit(const MeetingBox& around, Function&& function) const {
        if (around.cell == nowhere) return;
        for (uint32_t level = around.level; level < levels; ++level) {
            if ((populated_ >> level & 1u) == 0) continue;
            const CellRange range(around.box, width_of(level));
            const CellAt first = range.first, last = range.last, own = cell_of(around, level);
            const bool half = level == around.level;
            for (int32_t x = half ? own.x : first.x; x <= last.x; ++x) {
                const bool at_x = half && x == own.x;
                for (int32_t y = at_x ? own.y : first.y; y <= last.y; ++y) {
                    const bool at_y = at_x && y == own.y;
                    for (int32_t z = at_y ? own.z : first.z; z <= last.z; ++z) {
                        const bool mutual = at_y && z == own.z;
                        look_in(around.box, level, {x, y, z}, [&](const MeetingBox& box) { function(box, mutual); });
                    }
                }
            }
        }
    }

private:
    template <class Function>
    void look_in(const Box& around, uint32_t level, CellAt at, const Function& function) const {
        const uint32_t id = hash(level, at), bucket = id & mask_, end = first_[bucket + 1];
        const Four low[3] = {all(around.low.x), all(around.low.y), all(around.low.z)};
        const Four high[3] = {all(around.high.x), all(around.high.y), all(around.high.z)};
        for (uint32_t i = first_[bucket]; i < end; i += lanes) {
            // Four boxes at once; behind the last of a bucket there are others', and room for a whole vector.
            FourInts in = (load(row(0) + i) <= high[0]) & (load(row(3) + i) >= low[0]);
            for (size_t k = 1; k < 3; ++k) in &= (load(row(k) + i) <= high[k]) & (load(row(k + 3) + i) >= low[k]);
            if (!any(in)) continue;
            for (uint32_t lane = 0; lane < lanes && i + lane < end; ++lane) {
                if (in[lane] == 0) continue;
                const MeetingBox& box = boxes_[index_[i + lane]];
                // Cells nearby may have the same hash: a box is seen in its own alone, and so once.
                if (box.cell == id && cell_of(box, level) == at) function(box);
            }
        }
    }

    static constexpr uint32_t levels = 32, nowhere = UINT32_MAX;
    static constexpr float smallest =
        1.0f / (1 << 14); // m, cells of the first level; each is twice as wide as the last

    // Powers of two: products with them and with their inverses are exact.
    static float width_of(uint32_t level) { return static_cast<float>(uint32_t{1} << level) * smallest; }
    static CellAt cell_of(const MeetingBox& box, uint32_t level) {
        return cell_at(middle_of(box.box), 1.0f / width_of(level));
    }
    // Never that of nowhere.
    static uint32_t hash(uint32_t level, CellAt at) {
        const uint32_t h = cell_hash(at, level);
        return h == nowhere ? 0 : h;
    }
    // low and high of each axis, bucket after bucket.
    const float* row(size_t k) const { return rows_.data() + k * room_; }

    static constexpr uint32_t lanes = 4;
    uint32_t populated_ = 0, mask_ = 0, placed_ = 0;
    size_t room_ = 0;
    Buffer<MeetingBox> boxes_;
    Buffer<float> rows_;     // six of room_
    Buffer<uint32_t> index_; // of boxes, in the order of rows
    Buffer<uint32_t> first_; // by bucket, and the end
};

} // namespace lr
