#include "base/portable_math.h"

#include "base/bit_cast.h"

#include <cmath>
#include <cstdint>

namespace lr::shape {

namespace {

constexpr double ln2_high = 0.693147180369123816490, ln2_low = 1.90821492927058770002e-10;
} // namespace

double portable_log(double x) {
    // As in portable_pow, but with the exponent from the bits and the coefficients as constants, because this runs in every cell.
    const uint64_t bits = bit_cast<uint64_t>(x);
    int e = static_cast<int>(bits >> 52) - 1022;
    double m = bit_cast<double>((bits & 0x000fffffffffffffu) | 0x3fe0000000000000u);
    if (m < 0.70710678118654752440) m *= 2.0, --e;
    const double t = (m - 1.0) / (m + 1.0), t2 = t * t;
    constexpr double c[] = {1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11,
                            1.0 / 13, 1.0 / 15, 1.0 / 17, 1.0 / 19, 1.0 / 21};
    double series = c[9];
    for (int k = 8; k >= 0; --k) series = series * t2 + c[k];
    return e * ln2_high + (e * ln2_low + 2.0 * t * (1.0 + series * t2));
}

double portable_exp(double x) {
    constexpr double log2_e = 1.44269504088896340736;
    // Rounds to the nearest whole number without a call: 1.5 * 2^52 leaves no room for a fraction.
    constexpr double shifter = 6755399441055744.0;
    const double n = (x * log2_e + shifter) - shifter;
    const double r = (x - n * ln2_high) - n * ln2_low; // |r| < 0.347: 13 terms reach 1e-17
    constexpr double c[] = {
        1.0,        1.0,         1.0 / 2,      1.0 / 6,       1.0 / 24,       1.0 / 120,       1.0 / 720,
        1.0 / 5040, 1.0 / 40320, 1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
    double sum = c[13];
    for (int k = 12; k >= 0; --k) sum = sum * r + c[k];
    return sum * bit_cast<double>(static_cast<uint64_t>(static_cast<int64_t>(n) + 1023) << 52);
}

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
    const double log2_x = e + mantissa_log / (ln2_high + ln2_low);
    const double n = std::floor(y * log2_x + 0.5);
    const double r = (y * e - n) * ln2_high + ((y * e - n) * ln2_low + y * mantissa_log);
    double power = 1.0;
    for (int k = 18; k >= 1; --k) power = 1.0 + power * r / k;
    return std::ldexp(power, static_cast<int>(n));
}
} // namespace lr::shape
