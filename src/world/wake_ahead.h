// Bodies at rest that are about to be hit: they wake before the step, and take the blow as bodies that move.
#pragma once

#include "kernel/float_mode.h"

struct lr_world;

namespace lr {

// dt: s, of the step that begins.
void wake_ahead(lr_world& world, float dt, const FloatMode& mode);

} // namespace lr
