// Timing in turns: a short burst of each row, then of each again, until the time is up. What else the machine does then
// falls on all rows alike, and ratios of rows are those of neighbours in time.
#pragma once

#include "lr_bench/subject.h"

#include <string>
#include <vector>

namespace lr_bench {

struct Measured {
    Row row;
    Facts facts;
    uint64_t lost = 0;
    unsigned rounds = 0;
    // ns a body and substep; of the wall, and of the processor time of the whole process.
    double wall_median = 0, wall_least = 0, cpu_median = 0, cpu_least = 0;
    double cycles = 0; // processor time in cycles of just after it, of one body and substep
    // Times as fast as the sketch with as many bodies and substeps, median over rounds; of the wall for rows with workers,
    // of processor time for others. 0: no such sketch.
    double over_sketch = 0, over_sketch_avx2 = 0;
};

struct Schedule {
    double budget = 100.0; // s for the rounds of all groups
    double burst = 0.002;  // s, at least one step
    unsigned least_rounds = 3, most_rounds = 200;
};

// Says on stderr which rows cannot run here. `share` is the part of the budget that this group has.
std::vector<Measured> measure(const std::vector<Row>& rows, const Schedule& schedule, double share);

} // namespace lr_bench
