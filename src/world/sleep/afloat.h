// Bodies that float on still water fall asleep, as those that lie on something do. docs/maintainers/contact.md, 5.
#pragma once

#include "base/pose.h"

#include <cstdint>

struct lr_world;

namespace lr {

class Batch;

// After the batch's step: of its awake bodies [begin, end) those that float and touch nothing gather time, and fall asleep.
void rest_afloat(const lr_world& world, Batch& batch, uint32_t begin, uint32_t end);
// The water has changed: awake bodies have not floated on it yet.
void forget_afloat(Batch& batch);
// Whether a body that sleeps afloat has to wake: in a wind with which it would drift faster than a still body, or on water that a callback moves.
bool wakes_afloat(const lr_world& world, const Batch& batch, uint32_t index, Vector wind);
} // namespace lr
