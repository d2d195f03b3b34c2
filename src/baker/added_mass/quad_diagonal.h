// How four corners become two triangles.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace lr::baker {

// Whether to cut from a to c rather than from b to d: the shorter one; of two that differ by rounding only, the one with the lowest
// vertex, so that the choice changes neither when the body is turned nor when it is wound the other way.
inline bool prefers_diagonal(const std::vector<Eigen::Vector3d>& vertices, uint32_t a, uint32_t c, uint32_t b,
                             uint32_t d) {
    constexpr double tie = 1e-9;
    const double first = (vertices[a] - vertices[c]).squaredNorm(), second = (vertices[b] - vertices[d]).squaredNorm();
    if (first < (1.0 - tie) * second) return true;
    return first < (1.0 + tie) * second && std::min(a, c) < std::min(b, d);
}

} // namespace lr::baker
