// Contact as the kernel sees it: which bodies may touch a collider within a step, and what contacts do to them.
#pragma once

#include "kernel/batch_arrays.h"
#include "kernel/constants.h"

#include <cstddef>
#include <cstdint>

namespace lr {

// Cells of a lattice that finite colliders reach into, hashed into bits: a uniform grid without bounds. A body whose
// centre's cell is not marked touches nothing on this level within `dilation`.
struct OccupancyLevel {
    float inverse_cell; // 1/m
    float dilation;     // m, by which colliders were made larger when they were entered
    const uint32_t* bits;
    uint32_t mask; // words - 1, a power of two less one
};
inline constexpr uint32_t most_occupancy_levels = 8;
inline constexpr float most_cells = 1e9f; // cell numbers beyond are clamped to this

// Bit h & 31 of word (h >> 5) & mask. The same in the kernel's vectors.
constexpr uint32_t cell_hash(int32_t x, int32_t y, int32_t z) {
    uint32_t h = static_cast<uint32_t>(x) * 0x9e3779b1u ^ static_cast<uint32_t>(y) * 0x85ebca77u ^
                 static_cast<uint32_t>(z) * 0xc2b2ae3du;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    return h ^ h >> 13;
}

struct NearPlane {
    float point[3], normal[3]; // where it is nearest to bodies in the step
    float travel;              // m, of the plane in the step
};
// A heightfield's outline: bodies above `coarse` are far.
struct NearHeightfield {
    float position[3], axes[9]; // rows: its own axes in the world
    float travel;               // m, of any of its points in the step
    float inverse_coarse[2];    // 1/m
    float coarse_size;          // m, the smaller side of a square
    uint32_t counts[2];
    const float* coarse;
    float lowest, highest, extent[2];
};
inline constexpr uint32_t most_near_planes = 16, most_near_heightfields = 16;

// Everything solid in a world, in a step. Colliders that find no room here make `everywhere` true.
struct NearColliders {
    uint32_t level_count, plane_count, heightfield_count;
    bool everywhere; // each body may be near
    OccupancyLevel levels[most_occupancy_levels];
    NearPlane planes[most_near_planes];
    NearHeightfield heightfields[most_near_heightfields];
};

} // namespace lr
