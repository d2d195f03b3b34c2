// Splits a quadrilateral into two triangles.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace lr::baker {

// Whether to cut from a to c instead of from b to d: the shorter diagonal or, if equal within rounding, the one with the lowest vertex. The choice
// does not change with the orientation or winding of the body.
inline bool prefers_diagonal(const std::vector<Eigen::Vector3d>& vertices, uint32_t a, uint32_t c, uint32_t b,
                             uint32_t d) {
    constexpr double tie = 1e-9;
    const double first = (vertices[a] - vertices[c]).squaredNorm(), second = (vertices[b] - vertices[d]).squaredNorm();
    if (first < (1.0 - tie) * second) return true;
    return first < (1.0 + tie) * second && std::min(a, c) < std::min(b, d);
}
} // namespace lr::baker
