// What is being done and how long it will take, on standard error.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace lr::baker {

// On a terminal one line that is drawn over and over and removed in the end; elsewhere one line for each phase.
class Progress {
public:
    explicit Progress(bool quiet);
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void update(const char* phase, double fraction);
    void clear(); // before anything else is printed

private:
    using Clock = std::chrono::steady_clock;
    bool quiet_, terminal_, drawn_ = false;
    std::string phase_;
    Clock::time_point start_, shown_;
};

// For many bakes: one bar for all of them on a terminal, nothing elsewhere.
class BatchProgress {
public:
    BatchProgress(bool quiet, std::size_t total);
    ~BatchProgress() { clear(); }
    BatchProgress(const BatchProgress&) = delete;
    BatchProgress& operator=(const BatchProgress&) = delete;

    void update(double finished); // bakes, with parts of those at work
    void clear();

private:
    using Clock = std::chrono::steady_clock;
    bool shown_, drawn_ = false;
    double total_;
    Clock::time_point start_ = Clock::now();
};

} // namespace lr::baker
