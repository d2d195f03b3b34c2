#include "base/portable_math.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

using namespace lr::shape;

TEST_CASE("portable logarithm and exponential are those of the C library to a few units in the last place") {
    double log_error = 0.0, exp_error = 0.0;
    for (double x = 1e-300; x < 1e300; x *= 1.000731 * (x < 0.5 || x > 2.0 ? 3.7 : 1.0)) {
        const double l = std::log(x);
        log_error = std::max(log_error, std::abs(portable_log(x) - l) / (1.0 + std::abs(l)));
    }
    for (double x = -700.0; x < 700.0; x += 0.0973) {
        const double e = std::exp(x);
        exp_error = std::max(exp_error, std::abs(portable_exp(x) / e - 1.0) / (1.0 + std::abs(x)));
    }
    MESSAGE("largest errors " << log_error << ", " << exp_error);
    CHECK(log_error < 4e-16);
    CHECK(exp_error < 1e-15);
    CHECK(portable_log(1.0) == 0.0);
    CHECK(portable_exp(0.0) == 1.0);
    CHECK(std::isfinite(portable_log(1e-308)));
}
