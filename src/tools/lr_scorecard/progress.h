// How far the scorecard is and how long it will take, on standard error: one line drawn over and over on a terminal, a line a row
// elsewhere.
#pragma once

#include <chrono>
#include <string>

namespace lr::scorecard {

class Progress {
public:
    // expected: seconds of all rows together on some machine; only their proportions matter.
    Progress(bool quiet, double expected);
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void update(const char* row, double part, double cost);
    void finish(double cost); // of a row; before its result is printed

private:
    using Clock = std::chrono::steady_clock;
    void clear();

    bool quiet_, terminal_, drawn_ = false;
    double expected_, done_ = 0.0;
    Clock::time_point begin_, shown_;
};

} // namespace lr::scorecard
