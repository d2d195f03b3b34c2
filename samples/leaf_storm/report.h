// The storm's measurements: a table for people, JSON and CSV for programs.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "ground/lying_bodies.h"
#include "options.h"
#include "statistics.h"
#include "storm.h"

struct Measured {
    std::vector<Sample> samples;
    std::vector<Lying> lying; // with --check
    Summary summary;
    double wall = 0.0; // s, total
    std::uint64_t steps = 0;
};

std::string table_report(const Options& options, const Storm& storm, const Measured& measured);
std::string json_report(const Options& options, const Storm& storm, const Measured& measured);
std::string csv_report(const Measured& measured);
