// Boxes of bodies that move, in hashed cells of as many sizes as there are: which may touch each other in a substep. Made
// anew for each substep, in time linear in the number of bodies.
#pragma once

#include "kernel/contact.h"
#include "world/allocator.h"

#include <algorithm>
#include <cmath>
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

    // Calls fn(box) for each that overlaps one of them and is of its level or a larger one, itself too, in no order: of a pair
    // of two levels the smaller finds the larger.
    template <class Function> void visit(const MeetingBox& around, Function&& function) const {
        if (around.cell == nowhere) return;
        for (uint32_t level = around.level; level < levels; ++level) {
            if ((populated_ >> level & 1u) == 0) continue;
            const float size = size_of(level), inverse = inverse_size_of(level);
            int32_t first[3], last[3];
            for (size_t k = 0; k < 3; ++k) {
                // No box of a level reaches farther than half a cell from its middle.
                first[k] = cell(around.low[k] - 0.500001f * size, inverse);
                last[k] = cell(around.high[k] + 0.500001f * size, inverse);
            }
            for (int32_t x = first[0]; x <= last[0]; ++x)
                for (int32_t y = first[1]; y <= last[1]; ++y)
                    for (int32_t z = first[2]; z <= last[2]; ++z) {
                        const uint32_t id = hash(level, x, y, z), bucket = id & mask_;
                        for (uint32_t i = first_[bucket]; i < first_[bucket + 1]; ++i)
                            if (sorted_[i].cell == id && overlap(sorted_[i], around) &&
                                lies_in(sorted_[i], inverse, x, y, z))
                                function(sorted_[i]);
                    }
        }
    }

private:
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
    // Cells nearby may have the same hash: a box is seen in its own alone, and so once.
    static bool lies_in(const MeetingBox& box, float inverse_size, int32_t x, int32_t y, int32_t z) {
        const int32_t of[3] = {x, y, z};
        bool in = true;
        for (size_t k = 0; k < 3; ++k) in = in && cell(0.5f * (box.low[k] + box.high[k]), inverse_size) == of[k];
        return in;
    }
    static bool overlap(const MeetingBox& a, const MeetingBox& b) {
        bool in = true;
        for (size_t k = 0; k < 3; ++k) in = in && a.low[k] <= b.high[k] && a.high[k] >= b.low[k];
        return in;
    }

    uint32_t populated_ = 0, mask_ = 0;
    Buffer<MeetingBox> boxes_, sorted_;
    Buffer<uint32_t> first_; // by bucket, and the end
};

} // namespace lr
