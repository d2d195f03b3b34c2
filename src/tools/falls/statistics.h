// Averages with standard errors, percentiles, peaks.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lr::falls {

struct Statistic {
    size_t count = 0;
    double mean = 0.0;
    double standard_error = 0.0; // of the mean
    double deviation = 0.0;      // sample standard deviation
    double p5 = 0.0, p25 = 0.0, p50 = 0.0, p75 = 0.0, p95 = 0.0;
};

Statistic summarise(std::vector<double> values);

// part: 0 to 1; linear between order statistics. sorted: ascending, not empty.
double quantile(std::span<const double> sorted, double part);

// Indices of the prominent local maxima: before and after each, the signal is at least `hysteresis` lower before it is
// higher again. The ends of the signal are not maxima.
std::vector<size_t> peaks(std::span<const double> signal, double hysteresis);
} // namespace lr::falls
