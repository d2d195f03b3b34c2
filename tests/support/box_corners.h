// The corners of a box, for hulls of bodies and colliders.
#pragma once

#include <cstdint>
#include <vector>

namespace test {

// Half extents, m.
inline std::vector<float> box_corners(float x, float y, float z) {
    std::vector<float> v;
    for (uint32_t i = 0; i < 8; ++i)
        for (const float c : {i & 1u ? x : -x, i & 2u ? y : -y, i & 4u ? z : -z}) v.push_back(c);
    return v;
}
} // namespace test
