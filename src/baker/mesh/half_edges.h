// The half-edges of all faces, sorted so that those of one edge are adjacent.
#pragma once

#include "baker/mesh/mesh.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace lr::baker {

struct HalfEdge {
    uint32_t low, high;  // vertices
    uint32_t face, side; // from corner `side` of the face to the next
};

inline bool same_edge(const HalfEdge& a, const HalfEdge& b) {
    return a.low == b.low && a.high == b.high;
}

// Sorted by vertices, then by face.
inline std::vector<HalfEdge> sorted_half_edges(const Mesh& mesh) {
    std::vector<HalfEdge> halves;
    halves.reserve(3 * mesh.faces.size());
    for (uint32_t t = 0; t < mesh.faces.size(); ++t)
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t a = mesh.faces[t][k], b = mesh.faces[t][(k + 1) % 3];
            halves.push_back({std::min(a, b), std::max(a, b), t, k});
        }
    std::sort(halves.begin(), halves.end(), [](const HalfEdge& a, const HalfEdge& b) {
        if (a.low != b.low) return a.low < b.low;
        return a.high != b.high ? a.high < b.high : a.face < b.face;
    });
    return halves;
}
} // namespace lr::baker
