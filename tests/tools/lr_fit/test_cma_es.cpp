// The search finds known minima.
#include "tools/lr_fit/cma_es.h"

#include <doctest/doctest.h>

#include <cmath>

using lr::fit::Point;
using lr::fit::SeparableCmaEs;

namespace {

// Squared distance from `place`, with axes of an ellipsoid whose ratios go up to 1000.
double ellipsoid(const Point& p, double place) {
    double sum = 0.0;
    for (size_t i = 0; i < p.size(); ++i)
        sum +=
            std::pow(1e6, static_cast<double>(i) / static_cast<double>(p.size() - 1)) * (p[i] - place) * (p[i] - place);
    return sum;
}

SeparableCmaEs after(int generations, double place, uint64_t seed) {
    SeparableCmaEs strategy(Point(10, 0.5), 0.12, 12, seed);
    std::vector<double> values(12);
    for (int g = 0; g < generations; ++g) {
        const std::vector<Point>& points = strategy.ask();
        for (size_t i = 0; i < points.size(); ++i) values[i] = ellipsoid(points[i], place);
        strategy.tell(values);
    }
    return strategy;
}
} // namespace

TEST_CASE("lr_fit: the search finds the minimum of an ellipsoid, inside and on a bound") {
    for (const uint64_t seed : {1U, 2U, 3U})
        for (const double place : {0.3, 0.8}) CHECK(after(500, place, seed).best_value() < 1e-8);
    const Point corner = after(500, -0.1, 1).best();
    for (const double x : corner) CHECK((x >= 0.0 && x < 1e-3));
}

TEST_CASE("lr_fit: a seed repeats its search, another does not") {
    CHECK(after(20, 0.3, 1).best() == after(20, 0.3, 1).best());
    CHECK(after(20, 0.3, 1).best() != after(20, 0.3, 2).best());
}
