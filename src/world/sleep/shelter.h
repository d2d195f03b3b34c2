// Shelter from wind in heaps: the share of a body that is open to wind. docs/maintainers/contact.md, section 18.
#pragma once

#include "collision/broad_face.h"

#include <cmath>
#include <cstdint>

struct lr_world;

namespace lr {

class Batch;

// Wind forces grow with the square of the speed and with the exposed surface. So a body with the open share o feels the wind at sqrt(o) of its speed.
inline float felt_wind(float open) {
    return std::sqrt(open);
}

// Share of a body's surface open to wind, 1 if no body covers it. Sleeping bodies cover it, others as in `hidden`; colliders count only where a body
// covers the other side. batch: slot. at: the body's pose. Any thread, while none falls asleep or wakes.
float open_to_wind(const lr_world& world, uint32_t batch, uint32_t index, const Pose& at, Hidden hidden);

// For a body that wakes and slept in this box: bodies that it sheltered take the trial of wind again, and its own shelter becomes unknown.
void uncover(lr_world& world, Batch& batch, uint32_t index, const Box& box);
} // namespace lr
