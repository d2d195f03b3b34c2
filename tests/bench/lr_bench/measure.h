// Timing in turns: a short burst of each row, then of each again, until the time is up. Other load on the machine affects all
// rows alike, and ratios of rows compare neighbours in time.
#pragma once

#include "lr_bench/subject.h"

#include <cstdio>
#include <string>
#include <vector>

namespace lr_bench {

struct Measured {
    Row row;
    Facts facts;
    uint64_t lost = 0;
    unsigned rounds = 0;
    // ns per body and substep, of wall time, and of processor time of the whole process.
    double wall_median = 0, wall_least = 0, cpu_median = 0, cpu_least = 0;
    double cycles = 0; // processor time in cycles, measured just after it, per body and substep
    // Speed relative to the sketch with the same bodies and substeps, median over rounds; of wall time for rows with workers,
    // of processor time for others. 0: no such sketch.
    double over_sketch = 0, over_sketch_avx2 = 0;
};

struct Schedule {
    double budget = 100.0; // s for the rounds of all groups
    double burst = 0.002;  // s, at least one step
    unsigned least_rounds = 3, most_rounds = 200;
};

// The subject of a row; null, with a reason.
using Make = std::unique_ptr<Subject> (*)(const Row& row, std::string& why_not);

// Reports on stderr which rows cannot run here. `share` is this group's part of the budget.
std::vector<Measured> measure(const std::vector<Row>& rows, Make make, const Schedule& schedule, double share);

void write_head(std::FILE* file); // of a CSV file
void write_row(std::FILE* file, const Measured& m);

} // namespace lr_bench
