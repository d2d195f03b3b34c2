// Broad phase for colliders: boxes in hashed grids of several cell sizes, and bits of occupied cells for the kernel.
#pragma once

#include "collision/geometry_store.h"
#include "collision/hashed_cells.h"
#include "kernel/contact/collider_contact.h"

#include <cstdint>

namespace lr {

// A collider, or a part of one, in the broad phase.
struct Proxy {
    Box box; // over a whole step
    uint32_t slot;
    ColliderPart part;
};

class ColliderBroadPhase {
public:
    // fine: with few proxies cells are half as large. The grid takes longer to build and rules out more bodies.
    explicit ColliderBroadPhase(bool fine = false) : fine_(fine) {}

    // Makes room for `proxies`; growing discards the built grid. Returns false and changes nothing when out of memory.
    bool reserve(Allocator& allocator, uint64_t proxies);
    size_t capacity() const { return proxies_.size(); }
    uint32_t size() const { return count_; }

    // Call clear(), add() up to capacity() times, build(). levels: number of cell sizes. dilation: m, the largest reach that the bits cover.
    void clear() { count_ = level_count_ = 0; }
    void add(const Proxy& proxy) { proxies_[count_++] = proxy; }
    void build(float dilation, uint32_t levels);

    uint32_t level_count() const { return level_count_; }
    const OccupancyLevel& level(uint32_t i) const { return levels_[i].near; }

    // Calls found(proxy) once for each proxy whose box overlaps `box`, in no particular order, until it returns false. Returns false then.
    template <class Found> bool query(const Box& box, Found&& found) const;

private:
    // Cells of 2^rung m. The coarsest exceed the longest step at the highest speed, so that any box covers few cells.
    static constexpr int least_rung = -24, rungs = 96;
    struct Level {
        OccupancyLevel near;
        float inverse_bucket; // 1/m, of bucket cells: coarser, so that a query visits few
        Vector spread;        // m: largest half extents of the level's boxes
    };

    uint32_t levels_about(const Box& box) const; // bits of the levels that may have a box there
    struct Bit {
        uint32_t word, mask;
    };
    static Bit bit_of(const OccupancyLevel& level, CellAt at) {
        const uint32_t h = cell_hash(at, 0);
        return {(h >> 5) & level.mask, 1u << (h & 31)};
    }
    uint32_t bucket(CellAt at, uint32_t level) const { return cell_hash(at, level) & (bucket_count_ - 1); }
    void choose_levels(float dilation, uint32_t levels);
    void enter(uint32_t level, const Box& box);
    uint64_t words_for(uint64_t count) const;

    bool fine_;
    Buffer<Proxy> proxies_;
    Buffer<uint8_t> level_of_; // by proxy
    Buffer<uint32_t> buckets_; // first entry of each bucket, then the end
    Buffer<uint32_t> entries_; // proxies, by the bucket of their middle
    Buffer<uint32_t> words_;   // bits of all levels
    uint32_t count_ = 0, bucket_count_ = 1, level_count_ = 0;
    Level levels_[most_occupancy_levels] = {};
};

template <class Found> bool ColliderBroadPhase::query(const Box& box, Found&& found) const {
    const uint32_t levels = levels_about(box);
    if (levels == 0) return true;
    CellRange cells[most_occupancy_levels];
    double visits = 0.0;
    for (uint32_t l = 0; l < level_count_; ++l) {
        if ((levels >> l & 1u) == 0) continue;
        cells[l] = CellRange(grown(box, levels_[l].spread), levels_[l].inverse_bucket);
        visits += cells[l].count();
    }
    // Visiting a cell costs as much as testing a few boxes, so few proxies are tested one by one.
    if (4.0 * visits > count_) {
        for (uint32_t i = 0; i < count_; ++i)
            if (overlap(proxies_[i].box, box) && !found(proxies_[i])) return false;
        return true;
    }
    for (uint32_t l = 0; l < level_count_; ++l) {
        if ((levels >> l & 1u) == 0) continue;
        const bool all = cells[l].all([&](CellAt at) {
            const uint32_t b = bucket(at, l);
            for (uint32_t e = buckets_[b]; e < buckets_[b + 1]; ++e) {
                const Proxy& proxy = proxies_[entries_[e]];
                if (!overlap(proxy.box, box) || level_of_[entries_[e]] != l) continue;
                // Several cells share a bucket; a box counts only in the cell of its middle, so it is found once.
                if (cell_at(middle_of(proxy.box), levels_[l].inverse_bucket) == at && !found(proxy)) return false;
            }
            return true;
        });
        if (!all) return false;
    }
    return true;
}
} // namespace lr
