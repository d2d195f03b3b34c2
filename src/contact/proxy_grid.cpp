#include "contact/proxy_grid.h"

#include <bit>
#include <cstring>

namespace lr {
namespace {

constexpr uint64_t spare_words = uint64_t{8} * most_occupancy_levels;

constexpr uint64_t few = 1u << 12; // proxies

} // namespace

// For the bits of `count` proxies, never fewer for more: a few bits in a hundred are set, one in ten or twenty where there are so many
// that they would not stay in a cache.
uint64_t ProxyGrid::words_for(uint64_t count) const {
    const uint64_t each = fine_ ? 512 : 128, most_each = 16;
    return spare_words + std::max(each * std::min(count, 128 * few / each), most_each * count);
}

bool ProxyGrid::reserve(Allocator& allocator, uint64_t proxies) {
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

void ProxyGrid::clear() {
    count_ = 0;
    level_count_ = 0;
}

ProxyGrid::Cells ProxyGrid::cells_of(const Box& box, float grow_x, float grow_y, float grow_z, float inverse_cell) {
    return {{cell_number(box.low.x - grow_x, inverse_cell), cell_number(box.low.y - grow_y, inverse_cell),
             cell_number(box.low.z - grow_z, inverse_cell)},
            {cell_number(box.high.x + grow_x, inverse_cell), cell_number(box.high.y + grow_y, inverse_cell),
             cell_number(box.high.z + grow_z, inverse_cell)}};
}

// Each proxy to the finest cells of which, with `dilation`, it covers at most three along each axis, or five. Where these are of more
// sizes than there may be levels, the ones for which coarser cells add the least volume give way.
void ProxyGrid::choose_levels(float dilation, uint32_t levels) {
    const int finer = fine_ && count_ <= few ? 1 : 0;
    uint32_t in_rung[rungs] = {};
    for (uint32_t i = 0; i < count_; ++i) {
        int power = 0;
        (void)std::frexp(0.5f * extent(proxies_[i].box) + dilation, &power);
        level_of_[i] = static_cast<uint8_t>(std::clamp(power - finer - least_rung, 0, rungs - 1));
        ++in_rung[level_of_[i]];
    }
    int used[rungs];
    double sum[rungs]; // of proxies
    int count = 0;
    for (int r = 0; r < rungs; ++r)
        if (in_rung[r] != 0) {
            used[count] = r;
            sum[count++] = in_rung[r];
        }
    int to[rungs]; // rung to rung
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
        levels_[l] = {{std::ldexp(1.0f, -power), dilation, words, size - 1},
                      std::ldexp(1.0f, -(power + finer + 1)),
                      {0.0f, 0.0f, 0.0f},
                      0};
        words += size;
    }
    for (uint32_t i = 0; i < count_; ++i) {
        level_of_[i] = level_in[level_of_[i]];
        Level& level = levels_[level_of_[i]];
        const Box& box = proxies_[i].box;
        const Vector middle = middle_of(box), low = middle - box.low, high = box.high - middle;
        level.spread[0] = std::max(level.spread[0], std::max(low.x, high.x));
        level.spread[1] = std::max(level.spread[1], std::max(low.y, high.y));
        level.spread[2] = std::max(level.spread[2], std::max(low.z, high.z));
        ++level.count;
    }
    // The differences may have been rounded down.
    for (uint32_t l = 0; l < level_count_; ++l)
        for (float& s : levels_[l].spread) s += s * 0x1p-22f;
}

void ProxyGrid::enter(uint32_t level, const Box& box) {
    const OccupancyLevel& near = levels_[level].near;
    // Sums are rounded to nearest, which keeps their order with any position in single precision.
    const Cells c = cells_of(box, near.dilation, near.dilation, near.dilation, near.inverse_cell);
    uint32_t* const bits = words_.data() + (near.bits - words_.data());
    for (int32_t z = c.low[2]; z <= c.high[2]; ++z)
        for (int32_t y = c.low[1]; y <= c.high[1]; ++y)
            for (int32_t x = c.low[0]; x <= c.high[0]; ++x) {
                const uint32_t h = cell_hash(x, y, z);
                bits[(h >> 5) & near.mask] |= 1u << (h & 31);
            }
}

void ProxyGrid::build(float dilation, uint32_t levels) {
    level_count_ = 0;
    if (count_ == 0) return;
    choose_levels(dilation, levels);
    bucket_count_ = std::bit_ceil(count_);
    std::memset(buckets_.data(), 0, 4 * (size_t{bucket_count_} + 1));
    const auto bucket_of = [&](uint32_t i) {
        const float inverse = levels_[level_of_[i]].inverse_bucket;
        const Vector at = middle_of(proxies_[i].box);
        return bucket(cell_number(at.x, inverse), cell_number(at.y, inverse), cell_number(at.z, inverse), level_of_[i]);
    };
    for (uint32_t i = 0; i < count_; ++i) {
        enter(level_of_[i], proxies_[i].box);
        ++buckets_[bucket_of(i)];
    }
    uint32_t sum = 0;
    for (uint32_t b = 0; b < bucket_count_; ++b) buckets_[b] = sum += buckets_[b];
    buckets_[bucket_count_] = sum;
    for (uint32_t i = count_; i-- > 0;) entries_[--buckets_[bucket_of(i)]] = i;
}

// A box that reaches into this one has its middle within `dilation`: levels whose bit is clear there have none.
uint32_t ProxyGrid::levels_about(const Box& box) const {
    const Vector middle = middle_of(box), below = middle - box.low, above = box.high - middle;
    const float half =
        std::max({below.x, below.y, below.z, above.x, above.y, above.z}) * 1.000001f; // rounded differences
    uint32_t levels = 0;
    for (uint32_t l = 0; l < level_count_; ++l) {
        const OccupancyLevel& level = levels_[l].near;
        const uint32_t h =
            cell_hash(cell_number(middle.x, level.inverse_cell), cell_number(middle.y, level.inverse_cell),
                      cell_number(middle.z, level.inverse_cell));
        const uint32_t bit = level.bits[(h >> 5) & level.mask] >> (h & 31) & 1u;
        levels |= (half <= level.dilation ? bit : 1u) << l;
    }
    return levels;
}

} // namespace lr
