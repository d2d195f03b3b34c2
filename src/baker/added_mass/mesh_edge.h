// Edges of a mesh by their vertices.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace lr::baker {

using Edge = std::array<uint32_t, 2>; // lower vertex first

inline Edge make_edge(uint32_t a, uint32_t b) {
    return {std::min(a, b), std::max(a, b)};
}
} // namespace lr::baker
