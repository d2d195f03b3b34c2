#include "tools/lr_scorecard/progress.h"

#include <unistd.h>

#include <cstdio>

namespace lr::scorecard {

Progress::Progress(bool quiet, double expected)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0), expected_(expected), begin_(Clock::now()), shown_(begin_) {}

void Progress::update(const char* row, double part, double cost) {
    const Clock::time_point now = Clock::now();
    const bool often = now - shown_ < std::chrono::milliseconds(200);
    if (quiet_ || (part > 0.0 && (!terminal_ || often))) return;
    shown_ = now;
    const double fraction = expected_ > 0.0 ? (done_ + part * cost) / expected_ : 1.0;
    const double elapsed = std::chrono::duration<double>(now - begin_).count();
    char estimate[64] = "";
    if (fraction > 0.02)
        std::snprintf(estimate, sizeof estimate, ", about %.0f s left", elapsed * (1.0 / fraction - 1.0));
    std::fprintf(stderr, "%s%3.0f %%  %s%s%s", terminal_ ? "\r" : "", 100.0 * fraction, row, estimate,
                 terminal_ ? "\033[K" : "\n");
    std::fflush(stderr);
    drawn_ = terminal_;
}

void Progress::finish(double cost) {
    done_ += cost;
    clear();
}

void Progress::clear() {
    if (drawn_) std::fputs("\r\033[K", stderr);
    drawn_ = false;
}
} // namespace lr::scorecard
