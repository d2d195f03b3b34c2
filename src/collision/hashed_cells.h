// Unbounded lattices of hashed cells for searches. In each level a thing extends at most half a cell from its middle.
#pragma once

#include "base/pose.h"
#include "kernel/contact/collider_contact.h"

#include <algorithm>
#include <cstdint>

namespace lr {

// floor(x inverse_cell), clamped. Monotonic, so a box's cells lie between those of its corners. std::floor is a function call without SSE4.1.
inline int32_t cell_number(float x, float inverse_cell) {
    const float at = x * inverse_cell;
    if (!(at > -most_cells)) return static_cast<int32_t>(-most_cells); // also NaN
    if (!(at < most_cells)) return static_cast<int32_t>(most_cells);
    const auto whole = static_cast<int32_t>(at);
    return whole - (static_cast<float>(whole) > at ? 1 : 0);
}

struct CellAt {
    int32_t x, y, z;
    bool operator==(const CellAt&) const = default;
};
inline CellAt cell_at(Vector p, float inverse_cell) {
    return {cell_number(p.x, inverse_cell), cell_number(p.y, inverse_cell), cell_number(p.z, inverse_cell)};
}
constexpr uint32_t cell_hash(CellAt at, uint32_t level) {
    return cell_hash(at.x, at.y, at.z) ^ level * 0x9e3779b9u;
}

struct CellRange {
    CellAt first{}, last{};

    CellRange() = default;
    CellRange(const Box& box, float inverse_cell)
        : first(cell_at(box.low, inverse_cell)), last(cell_at(box.high, inverse_cell)) {}
    double count() const {
        const auto along = [](int32_t from, int32_t to) { return static_cast<double>(to) - from + 1.0; };
        return along(first.x, last.x) * along(first.y, last.y) * along(first.z, last.z);
    }
    template <class Function> void visit(const Function& function) const {
        all([&](CellAt at) { return function(at), true; });
    }
    // Ends at the first cell for which f is false.
    template <class Function> bool all(const Function& f) const {
        for (int32_t x = first.x; x <= last.x; ++x)
            for (int32_t y = first.y; y <= last.y; ++y)
                for (int32_t z = first.z; z <= last.z; ++z)
                    if (!f(CellAt{x, y, z})) return false;
        return true;
    }
};

// Cells of a level, `width` wide, that can hold a thing that overlaps the box. Rounding to nearest keeps the order of differences, so none is missed.
inline CellRange cells_about(const Box& box, float width) {
    return {grown(box, 0.500001f * width), 1.0f / width};
}

// Stable sort of things [0, count) by bucket. `first` receives the start of each bucket in `index`.
template <class BucketOf>
void sort_into_buckets(uint32_t count, uint32_t buckets, const BucketOf& bucket_of, uint32_t* first, uint32_t* index) {
    std::fill_n(first, buckets, 0u);
    for (uint32_t i = 0; i < count; ++i) ++first[bucket_of(i)];
    uint32_t sum = 0;
    for (uint32_t b = 0; b < buckets; ++b) first[b] = sum += first[b];
    // Fills each bucket from its end, so that first[b] ends at its start.
    for (uint32_t i = count; i-- > 0;) index[--first[bucket_of(i)]] = i;
}
} // namespace lr
