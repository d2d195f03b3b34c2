#include "baker/bake.h"

#include "baker_build.h"

namespace lr::baker {

const char* baker_version() {
    return LR_VERSION_STRING "+" LR_BAKER_BUILD;
}
} // namespace lr::baker
