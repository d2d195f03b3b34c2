// Shelter from wind in heaps: how much of a body lies open. docs/maintainers/contact.md, "Shelter".
#pragma once

#include "collision/broad_face.h"

#include <cmath>
#include <cstdint>

struct lr_world;

namespace lr {

class Batch;

// Forces of the wind grow with the square of its speed and with the surface that it meets: a body of which a share lies open feels them
// at this share of the speed.
inline float felt_wind(float open) {
    return std::sqrt(open);
}

// The share of a body's surface that lies open: sleeping bodies cover it, others as in `hidden`, and colliders where a body covers the
// other side. 1 if no body covers it. batch: slot. at: a pose of the body. Any thread, while no body falls asleep or wakes.
float open_to_wind(const lr_world& world, uint32_t batch, uint32_t index, const Pose& at, Hidden hidden);

// A body wakes that has lain in this box: others that it has sheltered try the wind again, and its own shelter is to be found.
void uncover(lr_world& world, Batch& batch, uint32_t index, const Box& box);
} // namespace lr
