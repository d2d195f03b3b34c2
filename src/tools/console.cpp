// SPDX-License-Identifier: MIT
#include "tools/console.h"

#include <signal.h>
#include <unistd.h>

namespace lr::baker {

std::vector<std::string> utf8_arguments(int argc, char** argv) {
    return {argv, argv + argc};
}

void set_up_console() {
    // Without SIGXFSZ a write beyond a file size limit fails, and the temporary file is removed.
    signal(SIGXFSZ, SIG_IGN);
}

bool shows_progress() {
    return isatty(STDERR_FILENO) != 0;
}

std::string with_slashes(std::string path) {
    return path;
}
} // namespace lr::baker
