// Broad phase: boxes in hashed grids of several cell sizes, and the bits that tell the kernel which cells they reach into.
#pragma once

#include "contact/cells.h"
#include "contact/geometry_store.h"
#include "kernel/contact.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lr {

// A collider, or a part of one, as the broad phase knows it.
struct Proxy {
    Box box; // over all of a step
    uint32_t slot;
    ColliderPart part;
};

class ProxyGrid {
public:
    // fine: of a few proxies the bits are entered in cells half as large, which takes longer and tells more bodies to be far.
    explicit ProxyGrid(bool fine = false) : fine_(fine) {}

    // Memory for `proxies` of them; what was built is gone when this had to take more. False: out of memory, all as before.
    bool reserve(Allocator& allocator, uint64_t proxies);
    size_t capacity() const { return proxies_.size(); }
    uint32_t size() const { return count_; }

    // Building: clear, add up to capacity(), build. Levels hold at most `levels` cell sizes, up to most_occupancy_levels;
    // bodies that reach no farther than `dilation` (m) are found by the bits.
    void clear();
    void add(const Proxy& proxy) { proxies_[count_++] = proxy; }
    void build(float dilation, uint32_t levels);

    uint32_t level_count() const { return level_count_; }
    const OccupancyLevel& level(uint32_t i) const { return levels_[i].near; }

    // Calls found(proxy) once for each whose box reaches into `box`, in no certain order.
    template <class Found> void query(const Box& box, Found&& found) const;

private:
    // Cells of 2^rung m, up to more than the longest step at the highest speed can reach: a box lies in few of its own.
    static constexpr int least_rung = -24, rungs = 96;
    struct Level {
        OccupancyLevel near;
        float inverse_bucket; // 1/m, of the cells that make buckets: coarser, so that a query visits few
        float spread[3];      // m: no box reaches farther from its middle
        uint32_t count;
    };
    struct Cells {
        int32_t low[3], high[3];
    };

    uint32_t levels_about(const Box& box) const; // a bit for each that may have a box there
    static Cells cells_of(const Box& box, float grow_x, float grow_y, float grow_z, float inverse_cell);
    uint32_t bucket(int32_t x, int32_t y, int32_t z, uint32_t level) const {
        return (cell_hash(x, y, z) ^ level * 0x9e3779b9u) & (bucket_count_ - 1);
    }
    void choose_levels(float dilation, uint32_t levels);
    void enter(uint32_t level, const Box& box);
    uint64_t words_for(uint64_t count) const;

    bool fine_;
    Buffer<Proxy> proxies_;
    Buffer<uint8_t> level_of_; // of each proxy
    Buffer<uint32_t> buckets_; // where each begins in entries_, and an end
    Buffer<uint32_t> entries_; // proxies, by the bucket of their middle
    Buffer<uint32_t> words_;   // bits of all levels
    uint32_t count_ = 0, bucket_count_ = 1, level_count_ = 0;
    Level levels_[most_occupancy_levels] = {};
};

template <class Found> void ProxyGrid::query(const Box& box, Found&& found) const {
    const uint32_t levels = levels_about(box);
    if (levels == 0) return;
    Cells cells[most_occupancy_levels];
    uint64_t visits = 0;
    for (uint32_t l = 0; l < level_count_; ++l) {
        if ((levels >> l & 1u) == 0) continue;
        const Level& level = levels_[l];
        cells[l] = cells_of(box, level.spread[0], level.spread[1], level.spread[2], level.inverse_bucket);
        double all = 1.0;
        for (int k = 0; k < 3; ++k)
            all *= static_cast<double>(cells[l].high[k]) - static_cast<double>(cells[l].low[k]) + 1.0;
        visits += static_cast<uint64_t>(std::min(all, 1e15));
    }
    // A look into a cell costs as much as one at a few boxes.
    if (4 * visits > count_) {
        for (uint32_t i = 0; i < count_; ++i)
            if (overlap(proxies_[i].box, box)) found(proxies_[i]);
        return;
    }
    for (uint32_t l = 0; l < level_count_; ++l) {
        if ((levels >> l & 1u) == 0) continue;
        const float inverse = levels_[l].inverse_bucket;
        const Cells& c = cells[l];
        for (int32_t z = c.low[2]; z <= c.high[2]; ++z)
            for (int32_t y = c.low[1]; y <= c.high[1]; ++y)
                for (int32_t x = c.low[0]; x <= c.high[0]; ++x) {
                    const uint32_t b = bucket(x, y, z, l);
                    for (uint32_t e = buckets_[b]; e < buckets_[b + 1]; ++e) {
                        const Proxy& proxy = proxies_[entries_[e]];
                        if (!overlap(proxy.box, box) || level_of_[entries_[e]] != l) continue;
                        // Of the cells that share the bucket only one holds its middle.
                        const Vector at = middle_of(proxy.box);
                        if (cell_number(at.x, inverse) == x && cell_number(at.y, inverse) == y &&
                            cell_number(at.z, inverse) == z)
                            found(proxy);
                    }
                }
    }
}

} // namespace lr
