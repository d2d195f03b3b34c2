// Many pairs of bodies side by side: which boxes about them are near each other, and the closest points of their cores.
#pragma once

#include <cstdint>

namespace lr {

inline constexpr uint32_t search_lanes = 16;
inline constexpr uint32_t most_outline = 24; // corners of a flat core
// Cosine between a face and the normal below which its edge counts instead; share of the smaller core: places closer than this are one.
inline constexpr float plate_edge_on = 0.2f, plate_same_place = 0.02f;

// Vertices of a convex hull in its own frame.
struct SearchHull {
    const float *x, *y, *z;
    uint32_t count;
    const float *ring_x, *ring_y; // of a flat core in z = 0: its corners, counter-clockwise; else null
};

// Pairs of the same two hulls, each in the frame of its a (docs/maintainers/contact.md, 12).
struct SearchBlock {
    using Row = float[search_lanes];
    // In: b's scale, origin and axes; a guess of the normal, unit, from b to a; cores farther apart than `enough` are not refined, nearer than `near`
    // they overlap; tolerance of the distance.
    alignas(64) Row ratio, offset[3], axes[9], start[3], enough, near, tolerance;
    Row smaller; // reach of the smaller core
    // Out.
    Row state; // as below
    Row normal[3], distance, on_a[3];
    // Of two flat cores: how many contacts, on b's core, and the cores' gaps there. no_manifold: not found here.
    Row count, place[12], place_gap[4];
    static constexpr float no_manifold = -1.0f;
    static constexpr float apart = 0.0f, beyond = 1.0f, overlap = 2.0f;
};

// Searches the first `count` lanes.
using PairSearch = void(const SearchHull& a, const SearchHull& b, uint32_t count, SearchBlock& block);

// The box of a hull in the hull's own frame, rounding included, as a substep begins.
struct alignas(64) PlacedBox {
    float middle[3]; // m, world
    float q[4];      // of the own frame
    float half[3];   // m
    float shift[3];  // m: way of the centre of mass in the substep
    float turns;     // m: way of the farthest point about it
    float margin;    // m: two bodies can touch while they come nearer than the smaller of their margins
    float spare;
};

// Keeps those of others[0 .. count) that can come near boxes[one] within the substep, in their order; returns how many. It errs to the near side.
// Most bodies of a heap whose upright boxes overlap lie apart.
using NearBoxes = uint32_t(const PlacedBox* boxes, uint32_t one, uint32_t* others, uint32_t count);
} // namespace lr
