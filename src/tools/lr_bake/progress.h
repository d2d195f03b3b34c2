// Shows the phase of a bake and the time left, on standard error.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace lr::baker {

// On a terminal: one line, redrawn and erased at the end. Otherwise: one line for each phase.
class Progress {
public:
    explicit Progress(bool quiet);
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void update(const char* phase, double fraction);
    void clear(); // call before printing anything else

private:
    using Clock = std::chrono::steady_clock;
    bool quiet_, terminal_, drawn_ = false;
    std::string phase_;
    Clock::time_point start_, shown_;
};

// For many bakes. On a terminal: one bar for all. Otherwise: nothing.
class BatchProgress {
public:
    BatchProgress(bool quiet, std::size_t total);
    ~BatchProgress() { clear(); }
    BatchProgress(const BatchProgress&) = delete;
    BatchProgress& operator=(const BatchProgress&) = delete;

    void update(double finished); // number of finished bakes, plus the fractions of running ones
    void clear();

private:
    using Clock = std::chrono::steady_clock;
    bool shown_, drawn_ = false;
    double total_;
    Clock::time_point start_ = Clock::now();
};
} // namespace lr::baker
