// Progress on stderr: a bar that redraws itself on a terminal, elsewhere a line for every tenth.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>

class Progress {
public:
    Progress(bool quiet, std::uint64_t steps, double bodies_per_step, double dt);
    ~Progress() { close(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // stepping: s spent in lr_world_step up to now.
    void update(std::uint64_t step, double stepping);
    void note(const char* text); // names other slow work, on its own line
    void close();                // ends the line of the bar

private:
    bool quiet_, terminal_, open_ = false;
    std::uint64_t steps_;
    double bodies_per_step_, dt_;
    int tenths_ = 0;
    std::chrono::steady_clock::time_point start_, shown_;
};
