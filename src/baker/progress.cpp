#include "baker/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace lr::baker {

Progress::Progress(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

void Progress::update(const char* phase, double fraction) {
    if (quiet_) return;
    const Clock::time_point now = Clock::now();
    if (phase_ != phase || fraction <= 0.0) {
        phase_ = phase;
        start_ = now;
        shown_ = {};
    }
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    if (!terminal_) {
        if (fraction >= 1.0) std::fprintf(stderr, "%s: %.2f s\n", phase, elapsed);
        return;
    }
    if (fraction < 1.0 && now - shown_ < std::chrono::milliseconds(100)) return;
    shown_ = now;
    drawn_ = true;
    const double share = std::clamp(fraction, 0.0, 1.0);
    const int filled = static_cast<int>(30.0 * share);
    std::fprintf(stderr, "\r\033[K%-12s [%.*s%.*s] %3d %%", phase, filled, "##############################",
                 30 - filled, "..............................", static_cast<int>(100.0 * share));
    if (share > 0.02 && share < 1.0 && elapsed > 0.5)
        std::fprintf(stderr, "  %.0f s left", elapsed * (1.0 - share) / share);
    std::fflush(stderr);
}

void Progress::clear() {
    if (!drawn_) return;
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
    drawn_ = false;
}

} // namespace lr::baker
