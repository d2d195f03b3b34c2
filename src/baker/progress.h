// What is being done and how long it will take, on standard error.
#pragma once

#include <chrono>
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

} // namespace lr::baker
