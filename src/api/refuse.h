#pragma once

#include "api/arguments.h"
#include "api/inner.h"
#include "world/world.h"

namespace lr::api {

// Tells the world's log why a call fails, and passes the status on.
inline lr_status refuse(const lr_world* world, const char* function, lr_status status, const char* why = nullptr) {
    world->log(LR_LOG_ERROR, function, why ? why : lr_status_string(status));
    return status;
}

} // namespace lr::api
