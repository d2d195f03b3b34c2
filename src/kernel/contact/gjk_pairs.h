// Pairs of bodies side by side: oriented boxes that are near each other, and nearest points of cores.
#pragma once

#include <cstdint>

namespace lr {

inline constexpr uint32_t search_lanes = 16;
inline constexpr uint32_t most_outline = 24; // corners of a flat core
// Cosine between face and normal, below which the face's edge counts; share of the smaller core, within which places are one.
inline constexpr float plate_edge_on = 0.2f, plate_same_place = 0.02f;

// Vertices of a convex hull in its own frame.
struct SearchHull {
    const float *x, *y, *z;
    uint32_t count;
    const float *ring_x, *ring_y; // of a flat core in z = 0: its corners, counter-clockwise; else null
};

// Pairs of the same two hulls, each in the frame of its a. docs/maintainers/contact.md, section 12.
struct SearchBlock {
    using Row = float[search_lanes];
    // In: b's scale, origin and axes; first guess of the normal, unit, from b to a; `enough` and `near` as for closest() in gjk-inl.h; tolerance of
    // the distance.
    alignas(64) Row ratio, offset[3], axes[9], start[3], enough, near, tolerance;
    Row smaller; // reach of the smaller core
    Row state;   // out: apart, beyond or overlap
    Row normal[3], distance, on_a[3];
    // For two flat cores: number of contacts, their places on b's core, the core gaps there. no_manifold: not computed here.
    Row count, place[12], place_gap[4];
    static constexpr float no_manifold = -1.0f;
    static constexpr float apart = 0.0f, beyond = 1.0f, overlap = 2.0f;
};

// Searches the first `count` lanes.
using PairSearch = void(const SearchHull& a, const SearchHull& b, uint32_t count, SearchBlock& block);

// The oriented box of a body, rounding included, at the beginning of a substep.
struct alignas(64) PlacedBox {
    float middle[3]; // m, world
    float q[4];      // of the own frame
    float half[3];   // m
    float shift[3];  // m: displacement of the centre of mass in the substep
    float turns;     // m: displacement of the farthest point about it
    float margin;    // m: two bodies can touch when nearer than the smaller of their margins
    float alone;     // m: length of `shift`; 0 for sheets, which count as if nothing stopped the other body
};

// Keeps those of others[0 .. count), in order, that may come near boxes[one] within the substep; returns their number. Never drops a pair that can
// touch. In heaps most bodies with overlapping upright boxes lie apart.
using NearBoxes = uint32_t(const PlacedBox* boxes, uint32_t one, uint32_t* others, uint32_t count);
} // namespace lr
