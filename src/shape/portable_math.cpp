#include "shape/portable_math.h"

#include <cmath>

namespace lr::shape {

double portable_pow(double x, double y) {
    // ln x = e ln 2 + 2 atanh(t), t = (m - 1)/(m + 1), m in [1/sqrt 2, sqrt 2): |t| < 0.1716, 12 terms reach 1e-18.
    int e = 0;
    double m = std::frexp(x, &e);
    if (m < 0.70710678118654752440) m *= 2.0, --e;
    const double t = (m - 1.0) / (m + 1.0), t2 = t * t;
    double series = 0.0;
    for (int k = 12; k >= 1; --k) series = (series + 1.0 / (2 * k + 1)) * t2;
    const double mantissa_log = 2.0 * t * (1.0 + series);

    // y ln x = n ln 2 + r, |r| < 0.35; ln 2 in two parts, so that n ln 2 keeps its digits.
    constexpr double ln2_high = 0.693147180369123816490, ln2_low = 1.90821492927058770002e-10;
    const double log2_x = e + mantissa_log / (ln2_high + ln2_low);
    const double n = std::floor(y * log2_x + 0.5);
    const double r = (y * e - n) * ln2_high + ((y * e - n) * ln2_low + y * mantissa_log);
    double power = 1.0;
    for (int k = 18; k >= 1; --k) power = 1.0 + power * r / k;
    return std::ldexp(power, static_cast<int>(n));
}

} // namespace lr::shape
