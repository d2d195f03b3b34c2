// A batch's poses in the layouts that renderers take.
#pragma once

#include "base/lane_arrays.h"

#include <cstdint>

namespace lr {

// Bytes of one element of an LR_TRANSFORM_* format; 0 for an unknown one.
uint32_t transform_bytes(int32_t format);

// Writes `count` elements, `stride` bytes apart, in a known format. Arrays are aligned and readable in whole lane blocks. simd: LR_SIMD_* that this
// processor has; all write the same bits. ahead: s by which bodies move on with their velocities.
void write_transforms(int32_t simd, const BatchArrays& arrays, uint32_t count, float ahead, int32_t format, void* to,
                      uint64_t stride);
} // namespace lr
