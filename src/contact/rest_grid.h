// Where the bodies of a batch lie that are at rest: a uniform grid without bounds, its cells hashed, in levels by size.
#pragma once

#include "kernel/contact.h"
#include "world/allocator.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lr {

class RestGrid {
public:
    // Each level's cells are four times as wide as those of the one before: all scales of bodies find theirs.
    static constexpr uint32_t level_count = 11;

    // reach: m, of a body of scale 1 from its centre of mass. False when out of memory.
    bool create(Allocator& allocator, uint32_t capacity, double reach);

    // By slots; `at` is in [insert(), remove()) of it.
    void insert(uint32_t slot, const float (&position)[3], float scale);
    void remove(uint32_t slot);
    void clear();

    // Calls fn(slot) for all bodies whose boxes, position +- reach, reach into [low, high] (m), for others near it, and
    // for some more than once, in no order; fn may remove the body that it is called for. Returns false, having called
    // nothing, where it takes less to look at `all` bodies.
    template <class Function>
    bool visit(const float (&low)[3], const float (&high)[3], uint32_t all, Function&& fn) const {
        double cells = 0.0;
        for (uint32_t level = 0; level < level_count; ++level) {
            if (population_[level] == 0) continue;
            const Range range = cells_of(level, low, high);
            double here = 1.0;
            for (size_t k = 0; k < 3; ++k) here *= static_cast<double>(range.last[k]) - range.first[k] + 1.0;
            cells += here;
        }
        if (cells > static_cast<double>(all)) return false;
        for (uint32_t level = 0; level < level_count; ++level) {
            if (population_[level] == 0) continue;
            const Range range = cells_of(level, low, high);
            for (int32_t x = range.first[0]; x <= range.last[0]; ++x)
                for (int32_t y = range.first[1]; y <= range.last[1]; ++y)
                    for (int32_t z = range.first[2]; z <= range.last[2]; ++z)
                        for (uint32_t slot = heads_[bucket(level, x, y, z)]; slot != none;) {
                            const uint32_t next = next_[slot];
                            fn(slot);
                            slot = next;
                        }
        }
        return true;
    }

private:
    static constexpr uint32_t none = UINT32_MAX;
    static constexpr uint32_t head_bit = 1u << 31; // above every slot

    struct Range {
        int32_t first[3], last[3];
    };
    static int32_t cell(double x, double size) {
        const double at = x / size, most = static_cast<double>(most_cells);
        if (!(at == at)) return 0;
        const double within = std::clamp(at, -most, most);
        const auto truncated = static_cast<int32_t>(within); // std::floor is a call where processors need not have SSE4
        return truncated - (within < static_cast<double>(truncated) ? 1 : 0);
    }
    // Bodies of a level reach no farther than half a cell.
    Range cells_of(uint32_t level, const float (&low)[3], const float (&high)[3]) const {
        Range range{};
        const double size = size_[level];
        for (size_t k = 0; k < 3; ++k) {
            const auto from = static_cast<double>(low[k]), to = static_cast<double>(high[k]);
            const double rounding = 1e-6 * size + 1e-12 * std::max(std::abs(from), std::abs(to));
            range.first[k] = cell(from - 0.5 * size - rounding, size);
            range.last[k] = cell(to + 0.5 * size + rounding, size);
        }
        return range;
    }
    uint32_t bucket(uint32_t level, int32_t x, int32_t y, int32_t z) const {
        return (cell_hash(x, y, z) ^ level * 0x9e3779b9u) & mask_;
    }
    uint32_t level_of(float scale) const;

    double reach_ = 0.0;
    double size_[level_count] = {}; // m, of cells
    uint32_t population_[level_count] = {};
    uint32_t mask_ = 0;
    Buffer<uint32_t> heads_;
    Buffer<uint32_t> next_, previous_; // by slot; previous: head_bit and the bucket for the first of it
    Buffer<uint8_t> level_;            // by slot
};

} // namespace lr
