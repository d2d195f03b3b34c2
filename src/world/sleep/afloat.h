// Floating bodies fall asleep on still water. docs/maintainers/contact.md, section 5.
#pragma once

#include "base/pose.h"

#include <cstdint>

struct lr_world;

namespace lr {

class Batch;

// After the batch's step: among awake bodies [begin, end), floats that touch nothing gather time and fall asleep.
void rest_afloat(const lr_world& world, Batch& batch, uint32_t begin, uint32_t end);
// The water has changed, so no awake body has gathered time on it.
void forget_afloat(Batch& batch);
// Whether a sleeping float wakes: by a wind in which it would drift faster than the limit of still floats, or on water with a callback.
bool wakes_afloat(const lr_world& world, const Batch& batch, uint32_t index, Vector wind);
} // namespace lr
