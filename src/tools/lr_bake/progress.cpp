#include "tools/lr_bake/progress.h"

#include "tools/console.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lr::baker {

namespace {

void draw_bar(double share) {
    const int filled = static_cast<int>(30.0 * share);
    std::fprintf(stderr, "[%.*s%.*s]", filled, "##############################", 30 - filled,
                 "..............................");
}

void draw_estimate(double elapsed, double share) {
    if (share > 0.02 && share < 1.0 && elapsed > 0.5)
        std::fprintf(stderr, "  %.0f s left", elapsed * (1.0 - share) / share);
    std::fflush(stderr);
}

void erase_line() {
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
}
} // namespace

Progress::Progress(bool quiet) : quiet_(quiet), terminal_(shows_progress()) {}

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
    std::fprintf(stderr, "\r\033[K%-12s ", phase);
    draw_bar(share);
    std::fprintf(stderr, " %3d %%", static_cast<int>(100.0 * share));
    draw_estimate(elapsed, share);
}

void Progress::clear() {
    if (drawn_) erase_line();
    drawn_ = false;
}

BatchProgress::BatchProgress(bool quiet, std::size_t total)
    : shown_(!quiet && shows_progress()), total_(static_cast<double>(total)) {}

void BatchProgress::update(double finished) {
    if (!shown_) return;
    drawn_ = true;
    const double share = std::clamp(finished / std::max(total_, 1.0), 0.0, 1.0);
    std::fputs("\r\033[Kbaking ", stderr);
    draw_bar(share);
    std::fprintf(stderr, " %.0f of %.0f", std::floor(finished), total_);
    // No estimate before the first bake is done.
    draw_estimate(std::chrono::duration<double>(Clock::now() - start_).count(), finished < 1.0 ? 0.0 : share);
}

void BatchProgress::clear() {
    if (drawn_) erase_line();
    drawn_ = false;
}
} // namespace lr::baker
