// SPDX-License-Identifier: MIT
#include "progress.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <unistd.h>

Progress::Progress(bool quiet, std::uint64_t steps, double bodies_per_step, double dt)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0), steps_(steps), bodies_per_step_(bodies_per_step), dt_(dt),
      start_(std::chrono::steady_clock::now()), shown_(start_ - std::chrono::hours(1)) {}

void Progress::close() {
    if (open_) std::fputc('\n', stderr);
    open_ = false;
}

void Progress::update(std::uint64_t step, double stepping) {
    if (quiet_) return;
    const auto now = std::chrono::steady_clock::now();
    const double part = static_cast<double>(step) / static_cast<double>(steps_);
    const int tenth = static_cast<int>(10.0 * part);
    const bool due = terminal_ ? now - shown_ > std::chrono::milliseconds(100) : tenth > tenths_;
    if (!due && step != steps_) return;
    if (!terminal_ && tenth <= tenths_) return;
    shown_ = now;
    tenths_ = tenth;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const double rate = stepping > 0.0 ? static_cast<double>(step) * bodies_per_step_ / stepping : 0.0;
    const double left = part > 0.0 ? elapsed * (1.0 - part) / part : 0.0;
    const int filled = static_cast<int>(30.0 * part);
    const std::string bar =
        std::string(static_cast<std::size_t>(filled), '#') + std::string(static_cast<std::size_t>(30 - filled), '.');
    std::fprintf(stderr, "%s[%s] %3d %%  t = %.1f s  %.1f M body-steps/s  %.0f s left %s", terminal_ ? "\r" : "",
                 bar.c_str(), static_cast<int>(100.0 * part), static_cast<double>(step) * dt_, 1e-6 * rate, left,
                 terminal_ ? " " : "\n");
    open_ = terminal_;
    std::fflush(stderr);
}

void Progress::note(const char* text) {
    if (quiet_) return;
    close();
    std::fprintf(stderr, "%s\n", text);
}
