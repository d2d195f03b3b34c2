#include "collision/collider_broad_phase.h"

#include <bit>
#include <cstring>

namespace lr {
namespace {

constexpr uint64_t spare_words = uint64_t{8} * most_occupancy_levels;

constexpr uint64_t few = 1u << 12; // proxies
} // namespace

// Words of bits for `count` proxies; monotonic in count. A few per cent of the bits are set, 5 to 10 % if more bits would not fit into a cache.
uint64_t ColliderBroadPhase::words_for(uint64_t count) const {
    const uint64_t each = fine_ ? 512 : 128, most_each = 16;
    return spare_words + std::max(each * std::min(count, 128 * few / each), most_each * count);
}

bool ColliderBroadPhase::reserve(Allocator& allocator, uint64_t proxies) {
    if (proxies <= capacity()) return true;
    const uint64_t size = std::max<uint64_t>(proxies, capacity() + capacity() / 2);
    Buffer<Proxy> new_proxies;
    Buffer<uint8_t> new_levels;
    Buffer<uint32_t> buckets, entries, words;
    if (!new_proxies.allocate(allocator, size) || !new_levels.allocate(allocator, size) ||
        !buckets.allocate(allocator, std::bit_ceil(size) + 1) || !entries.allocate(allocator, size) ||
        !words.allocate(allocator, words_for(size)))
        return false;
    proxies_.swap(new_proxies);
    level_of_.swap(new_levels);
    buckets_.swap(buckets);
    entries_.swap(entries);
    words_.swap(words);
    clear();
    return true;
}

// Gives each proxy the finest cells of which its box, enlarged by `dilation`, covers at most three along each axis (five if finer). If there are more
// sizes than levels, those that add the least volume are merged into the next coarser one.
void ColliderBroadPhase::choose_levels(float dilation, uint32_t levels) {
    const int finer = fine_ && count_ <= few ? 1 : 0;
    uint32_t in_rung[rungs] = {};
    for (uint32_t i = 0; i < count_; ++i) {
        int power = 0;
        (void)std::frexp(0.5f * extent(proxies_[i].box) + dilation, &power);
        level_of_[i] = static_cast<uint8_t>(std::clamp(power - finer - least_rung, 0, rungs - 1));
        ++in_rung[level_of_[i]];
    }
    int used[rungs];
    double sum[rungs]; // number of proxies
    int count = 0;
    for (int r = 0; r < rungs; ++r)
        if (in_rung[r] != 0) {
            used[count] = r;
            sum[count++] = in_rung[r];
        }
    int to[rungs]; // from a rung to the one it is merged into
    for (int r = 0; r < rungs; ++r) to[r] = r;
    while (count > static_cast<int>(levels)) {
        int least = 0;
        double least_cost = 0.0;
        for (int i = 0; i + 1 < count; ++i) {
            const double cost = sum[i] * std::ldexp(1.0, 3 * (used[i + 1] - used[i]));
            if (i == 0 || cost < least_cost) least = i, least_cost = cost;
        }
        for (int& r : to)
            if (r == used[least]) r = used[least + 1];
        sum[least + 1] += sum[least];
        for (int i = least; i + 1 < count; ++i) used[i] = used[i + 1], sum[i] = sum[i + 1];
        --count;
    }
    uint8_t level_in[rungs] = {};
    for (int r = 0; r < rungs; ++r)
        for (int i = 0; i < count; ++i)
            if (used[i] == to[r]) level_in[r] = static_cast<uint8_t>(i);
    level_count_ = static_cast<uint32_t>(count);
    uint32_t* words = words_.data();
    for (uint32_t l = 0; l < level_count_; ++l) {
        const auto share =
            static_cast<uint64_t>(static_cast<double>(words_for(count_) - spare_words) * sum[l] / count_);
        const auto size = static_cast<uint32_t>(std::bit_floor(std::max<uint64_t>(8, share)));
        std::memset(words, 0, size_t{4} * size);
        const int power = used[l] + least_rung;
        levels_[l] = {
            {std::ldexp(1.0f, -power), dilation, words, size - 1}, std::ldexp(1.0f, -(power + finer + 1)), {}};
        words += size;
    }
    for (uint32_t i = 0; i < count_; ++i) {
        level_of_[i] = level_in[level_of_[i]];
        Level& level = levels_[level_of_[i]];
        const Box& box = proxies_[i].box;
        const Vector middle = middle_of(box), low = middle - box.low, high = box.high - middle;
        level.spread = high_of(level.spread, high_of(low, high));
    }
    // The differences may have been rounded down.
    for (uint32_t l = 0; l < level_count_; ++l) levels_[l].spread = levels_[l].spread + 0x1p-22f * levels_[l].spread;
}

void ColliderBroadPhase::enter(uint32_t level, const Box& box) {
    const OccupancyLevel& near = levels_[level].near;
    // Rounding to nearest keeps the order of sums, so no cell that a position in float can fall into is missed.
    uint32_t* const bits = words_.data() + (near.bits - words_.data());
    CellRange(grown(box, near.dilation), near.inverse_cell).visit([&](CellAt at) {
        const Bit bit = bit_of(near, at);
        bits[bit.word] |= bit.mask;
    });
}

void ColliderBroadPhase::build(float dilation, uint32_t levels) {
    level_count_ = 0;
    if (count_ == 0) return;
    choose_levels(dilation, levels);
    bucket_count_ = std::bit_ceil(count_);
    const auto bucket_of = [&](uint32_t i) {
        const uint32_t level = level_of_[i];
        return bucket(cell_at(middle_of(proxies_[i].box), levels_[level].inverse_bucket), level);
    };
    for (uint32_t i = 0; i < count_; ++i) enter(level_of_[i], proxies_[i].box);
    // One more, empty bucket marks the end of the last.
    sort_into_buckets(count_, bucket_count_ + 1, bucket_of, buckets_.data(), entries_.data());
}

// A level can have a box here only if the bit of the middle's cell is set: bits reach as far as `dilation`.
uint32_t ColliderBroadPhase::levels_about(const Box& box) const {
    const Vector middle = middle_of(box), below = middle - box.low, above = box.high - middle;
    const float half =
        std::max({below.x, below.y, below.z, above.x, above.y, above.z}) * 1.000001f; // rounded differences
    uint32_t levels = 0;
    for (uint32_t l = 0; l < level_count_; ++l) {
        const OccupancyLevel& level = levels_[l].near;
        const Bit bit = bit_of(level, cell_at(middle, level.inverse_cell));
        if (half > level.dilation || (level.bits[bit.word] & bit.mask) != 0) levels |= 1u << l;
    }
    return levels;
}
} // namespace lr
