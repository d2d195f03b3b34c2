// Parts of the scenes of benchmarks.
#pragma once

#include "langevin_rigid.h"

#include <cstdint>

namespace bench {

inline lr_collider_desc collider_at(int32_t kind, float x, float y, float z) {
    lr_collider_desc d;
    lr_collider_desc_init(&d, sizeof d);
    d.kind = kind;
    d.position[0] = x, d.position[1] = y, d.position[2] = z;
    return d;
}
// 0 to 1, the same everywhere.
inline float hashed(uint32_t a, uint32_t b) {
    uint32_t h = a * 0x9e3779b1u ^ b * 0x85ebca77u;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    h = (h ^ h >> 12) * 0x297a2d39u;
    return static_cast<float>((h ^ h >> 15) >> 8) * 0x1p-24f;
}
} // namespace bench
