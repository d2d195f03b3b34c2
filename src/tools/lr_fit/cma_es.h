// Separable CMA-ES: a search for the minimum of a function of n numbers between 0 and 1 that learns a step for each of them.
// Ros and Hansen 2008, "A simple modification in CMA-ES achieving linear time and space complexity", PPSN X.
#pragma once

#include "tools/falls/random.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace lr::fit {

using Point = std::vector<double>;

class SeparableCmaEs {
public:
    // step: standard deviation of the first generation. population: at least 4.
    SeparableCmaEs(Point start, double step, size_t population, uint64_t seed);

    // The next generation. Steps across a bound are reflected.
    const std::vector<Point>& ask();
    // The function at each point of the generation, in its order; no NaN.
    void tell(std::span<const double> values);

    const Point& best() const { return best_; } // of all generations; at first the start
    double best_value() const { return best_value_; }
    double step() const { return step_; }

private:
    falls::Random random_;
    Point mean_, best_;
    double best_value_ = std::numeric_limits<double>::infinity(), step_;
    int generations_ = 0;
    std::vector<Point> points_;
    std::vector<double> weights_;                                 // of the better half, best first
    double selected_, learn_path_, learn_one_, learn_all_, fade_; // mu_eff, c_sigma, c_1, c_mu, c_c
    Point variance_, path_, step_path_;                           // diagonal of C, p_c, p_sigma
};
} // namespace lr::fit
