// Which bodies' spheres a ray meets, or a sphere overlaps: a loop over arrays that compilers make vectors of. It lets pass
// some that do not, never the other way round.
#pragma once

#include "kernel/batch_arrays.h"

#include <cstdint>

namespace lr {

inline constexpr uint32_t filter_block = 256;

struct RayFilter {
    float origin[3], direction[3]; // m; unit
    float reach;                   // m, of a body of scale 1
    float most;                    // m, along the ray
};
struct SphereFilter {
    float middle[3], radius; // m
    float reach;
};

// Of bodies [begin, end), filter_block at most, of which `end` may be rounded up to whole lane blocks. marks: by place from
// `begin`. Returns whether any is marked.
bool filter_bodies(const RayFilter& filter, const BatchArrays& arrays, uint32_t begin, uint32_t end,
                   uint32_t (&marks)[filter_block]);
bool filter_bodies(const SphereFilter& filter, const BatchArrays& arrays, uint32_t begin, uint32_t end,
                   uint32_t (&marks)[filter_block]);

} // namespace lr
