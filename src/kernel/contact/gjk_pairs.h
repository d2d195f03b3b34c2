// Closest points of the cores of many pairs of bodies, one pair per lane.
#pragma once

#include <cstdint>

namespace lr {

inline constexpr uint32_t search_lanes = 16;

// Vertices of a convex hull in its own frame.
struct SearchHull {
    const float *x, *y, *z;
    uint32_t count;
};

// Pairs of the same two hulls, each in the frame of its a (docs/maintainers/contact.md, 12).
struct SearchBlock {
    using Row = float[search_lanes];
    // In: b's scale, origin and axes; a guess of the normal, unit, from b to a; cores farther apart than `enough` are not refined, nearer than `near`
    // they overlap; tolerance of the distance.
    alignas(64) Row ratio, offset[3], axes[9], start[3], enough, near, tolerance;
    // Out.
    Row state; // as below
    Row normal[3], distance, on_a[3];
    static constexpr float apart = 0.0f, beyond = 1.0f, overlap = 2.0f;
};

// Searches the first `count` lanes.
using PairSearch = void(const SearchHull& a, const SearchHull& b, uint32_t count, SearchBlock& block);
} // namespace lr
