#include "collision/sleeping_grid.h"

namespace lr {

uint32_t next_in(const Box& box, float* const* position, const float* scale, float reach, uint32_t from, uint32_t to) {
    const float *const x = position[0], *const y = position[1], *const z = position[2];
    const auto is_in = [&](uint32_t i) -> uint32_t {
        const float r = reach * scale[i];
        return (x[i] + r >= box.low.x) & (x[i] - r <= box.high.x) & (y[i] + r >= box.low.y) & (y[i] - r <= box.high.y) &
               (z[i] + r >= box.low.z) & (z[i] - r <= box.high.z);
    };
    constexpr uint32_t at_once = 16; // in vectors
    for (; from + at_once <= to; from += at_once) {
        uint32_t any = 0;
        for (uint32_t k = 0; k < at_once; ++k) any |= is_in(from + k);
        if (any != 0) break;
    }
    while (from < to && is_in(from) == 0) ++from;
    return from;
}

bool SleepingGrid::create(Allocator& allocator, uint32_t capacity, double reach) {
    uint32_t buckets = 16;
    while (buckets < capacity) buckets *= 2;
    if (!heads_.allocate(allocator, buckets) || !next_.allocate(allocator, capacity) ||
        !previous_.allocate(allocator, capacity) || !level_.allocate(allocator, capacity))
        return false;
    mask_ = buckets - 1;
    reach_ = reach;
    double width = 2.0 * reach * 1e-3; // of bodies of the least scale
    for (float& w : width_) w = static_cast<float>(width * (1.000001 + room)), width *= 4.0;
    clear();
    return true;
}

uint32_t SleepingGrid::level_of(float scale) const {
    const double width = 2.0 * reach_ * (1.0 + room) * static_cast<double>(scale);
    uint32_t level = 0;
    while (level + 1 < level_count && wide(width_[level]) < width) ++level;
    return level;
}

void SleepingGrid::insert(uint32_t slot, Vector position, float scale) {
    const uint32_t level = level_of(scale);
    const uint32_t to = cell_hash(cell_at(position, 1.0f / width_[level]), level) & mask_;
    const uint32_t first = heads_[to];
    next_[slot] = first;
    previous_[slot] = head_bit | to;
    level_[slot] = static_cast<uint8_t>(level);
    if (first != none) previous_[first] = slot;
    heads_[to] = slot;
    ++population_[level];
}

void SleepingGrid::remove(uint32_t slot) {
    const uint32_t next = next_[slot], previous = previous_[slot];
    if (next != none) previous_[next] = previous;
    if (previous & head_bit)
        heads_[previous & ~head_bit] = next;
    else
        next_[previous] = next;
    --population_[level_[slot]];
}

void SleepingGrid::clear() {
    std::fill_n(heads_.data(), heads_.size(), none);
    std::fill_n(population_, level_count, 0u);
}
} // namespace lr
