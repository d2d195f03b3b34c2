#include "world/use.h"

#include "world/world.h"

#include <cstdio>

namespace lr {

lr_status enter(const lr_world& world, const char* function) {
    const lr_status status = world.use.enter(function);
    if (status == LR_OK || !world.use.begin_telling()) return status;
    const char* const other = world.use.function();
    char why[192];
    std::snprintf(why, sizeof why,
                  status == LR_ERROR_REENTRANT
                      ? "called from a callback of %s, which is still inside the same world"
                      : "called while %s is inside the same world, in another thread or in a callback of it",
                  other ? other : "another function");
    world.log(LR_LOG_ERROR, function, why);
    world.use.end_telling();
    return status;
}

} // namespace lr
