// Which boxes about bodies are near one of them, many side by side: most bodies of a heap whose upright boxes overlap lie apart.
#pragma once

#include <cstdint>

namespace lr {

// The box of a hull in the hull's own frame, rounding included, as a substep begins.
struct alignas(64) PlacedBox {
    float middle[3]; // m, world
    float q[4];      // of the own frame
    float half[3];   // m
    float shift[3];  // m: way of the centre of mass in the substep
    float turns;     // m: way of the farthest point about it
    float margin;    // m: two bodies can touch while they come nearer than the smaller of their margins
    float spare;
};

// Keeps those of others[0 .. count) that can come near boxes[one] within the substep, in their order; returns how many. It errs to the near side.
using NearBoxes = uint32_t(const PlacedBox* boxes, uint32_t one, uint32_t* others, uint32_t count);
} // namespace lr
