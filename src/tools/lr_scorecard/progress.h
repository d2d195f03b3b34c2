// Progress and time left, on standard error. On a terminal: one line, redrawn. Otherwise: one line per row.
#pragma once

#include <chrono>
#include <string>

namespace lr::scorecard {

class Progress {
public:
    // expected: seconds of all rows on a reference machine; only ratios matter.
    Progress(bool quiet, double expected);
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void update(const char* row, double part, double cost);
    void finish(double cost); // ends a row; call before printing its result

private:
    using Clock = std::chrono::steady_clock;
    void clear();

    bool quiet_, terminal_, drawn_ = false;
    double expected_, done_ = 0.0;
    Clock::time_point begin_, shown_;
};
} // namespace lr::scorecard
