#pragma once

#include "api/arguments.h"
#include "api/inner.h"
#include "record/recorder.h"
#include "world/world.h"

namespace lr::api {

// Tells the world's log why a call fails, and passes the status on.
inline lr_status refuse(const lr_world* world, const char* function, lr_status status, const char* why = nullptr) {
    world->log(LR_LOG_ERROR, function, why ? why : lr_status_string(status));
    return status;
}

// An inner function has looked at all that it was given, and changes the world next: a recording may read it as well. False where there is
// no memory to record it, and the call must be refused.
inline bool accepted(const lr_world* world) {
    return !world->recorder || world->recorder->accepted();
}

} // namespace lr::api
