// Boxes of bodies that move, in hashed cells of as many sizes as there are: which may touch each other in a substep. Made
// anew for each substep, in time linear in the number of bodies.
#pragma once

#include "contact/four.h"
#include "kernel/contact.h"
#include "world/allocator.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace lr {

struct MeetingBox {
    float low[3], high[3]; // m
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

    // Calls fn(box) for each that overlaps one of them and is of its level or a larger one, itself too, in no order: of a pair
    // of two levels the smaller finds the larger.
    template <class Function> void visit(const MeetingBox& around, Function&& function) const {
        look(around, false, [&](const MeetingBox& box, bool) { function(box); });
    }
    // The same, but of two of a level only the one in the first of two cells finds the other. fn(box, mutual): whether that
    // finds `around` as well, as in the same cell.
    template <class Function> void visit_onward(const MeetingBox& around, Function&& function) const {
        look(around, true, function);
    }

private:
    template <class Function> void look(const MeetingBox& around, bool onward, const Function& function) const {
        if (around.cell == nowhere) return;
        for (uint32_t level = around.level; level < levels; ++level) {
            if ((populated_ >> level & 1u) == 0) continue;
            const float size = size_of(level), inverse = inverse_size_of(level);
            int32_t first[3], last[3], own[3];
            for (size_t k = 0; k < 3; ++k) {
                // No box of a level reaches farther than half a cell from its middle.
                first[k] = cell(around.low[k] - 0.500001f * size, inverse);
                last[k] = cell(around.high[k] + 0.500001f * size, inverse);
                own[k] = cell(middle(around, k), inverse);
            }
            const bool half = onward && level == around.level;
            for (int32_t x = half ? own[0] : first[0]; x <= last[0]; ++x) {
                const bool at_x = half && x == own[0];
                for (int32_t y = at_x ? own[1] : first[1]; y <= last[1]; ++y) {
                    const bool at_y = at_x && y == own[1];
                    for (int32_t z = at_y ? own[2] : first[2]; z <= last[2]; ++z) {
                        const bool mutual = !onward || (at_y && z == own[2]);
                        look_in(around, level, {x, y, z}, [&](const MeetingBox& box) { function(box, mutual); });
                    }
                }
            }
        }
    }
    template <class Function>
    void look_in(const MeetingBox& around, uint32_t level, std::array<int32_t, 3> at, const Function& function) const {
        const uint32_t id = hash(level, at[0], at[1], at[2]), bucket = id & mask_, end = first_[bucket + 1];
        for (uint32_t i = first_[bucket]; i < end; i += lanes) {
            // Four boxes at once; behind the last of a bucket there are others', and room for a whole vector.
            FourInts in = (load(row(0) + i) <= all(around.high[0])) & (load(row(3) + i) >= all(around.low[0]));
            for (size_t k = 1; k < 3; ++k)
                in &= (load(row(k) + i) <= all(around.high[k])) & (load(row(k + 3) + i) >= all(around.low[k]));
            if (!any(in)) continue;
            for (uint32_t lane = 0; lane < lanes && i + lane < end; ++lane) {
                if (in[lane] == 0) continue;
                const MeetingBox& box = boxes_[index_[i + lane]];
                if (box.cell == id && lies_in(box, inverse_size_of(level), at)) function(box);
            }
        }
    }

    static constexpr uint32_t levels = 32, nowhere = UINT32_MAX;
    static constexpr float smallest =
        1.0f / (1 << 14); // m, cells of the first level; each is twice as wide as the last

    // Powers of two: products with them and with their inverses are exact.
    static float size_of(uint32_t level) { return static_cast<float>(uint32_t{1} << level) * smallest; }
    static float inverse_size_of(uint32_t level) { return 1.0f / size_of(level); }
    static int32_t cell(float x, float inverse_size) {
        const float at = std::clamp(x * inverse_size, -most_cells, most_cells);
        const auto whole = static_cast<int32_t>(at);
        return whole - (static_cast<float>(whole) > at ? 1 : 0);
    }
    // Never that of nowhere.
    static uint32_t hash(uint32_t level, int32_t x, int32_t y, int32_t z) {
        const uint32_t h = cell_hash(x, y, z) ^ level * 0x9e3779b9u;
        return h == nowhere ? 0 : h;
    }
    static float middle(const MeetingBox& box, size_t k) { return 0.5f * (box.low[k] + box.high[k]); }
    // Cells nearby may have the same hash: a box is seen in its own alone, and so once.
    static bool lies_in(const MeetingBox& box, float inverse_size, const std::array<int32_t, 3>& at) {
        bool in = true;
        for (size_t k = 0; k < 3; ++k) in = in && cell(middle(box, k), inverse_size) == at[k];
        return in;
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
