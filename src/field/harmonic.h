// Sine and cosine in double that are the same with every C library, and random bits from a counter.
#pragma once

#include <cmath>
#include <cstdint>

namespace lr {

// Of a phase in turns; absolute error below 1e-14.
inline void sin_cos_turns(double turns, double& sine, double& cosine) {
    const double quadrant = std::floor(4.0 * turns + 0.5);
    const double x = (4.0 * turns - quadrant) * 1.57079632679489661923, z = x * x; // |x| <= pi/4
    double s = 0.0, c = 0.0;
    for (int k = 8; k >= 1; --k) {
        s = (s + 1.0) * -z / (2.0 * k * (2.0 * k + 1.0));
        c = (c + 1.0) * -z / (2.0 * k * (2.0 * k - 1.0));
    }
    s = x * (1.0 + s);
    c = 1.0 + c;
    switch (static_cast<int>(quadrant - 4.0 * std::floor(0.25 * quadrant))) {
    case 0:
        sine = s, cosine = c;
        return;
    case 1:
        sine = c, cosine = -s;
        return;
    case 2:
        sine = -s, cosine = -c;
        return;
    default:
        sine = -c, cosine = s;
    }
}

// SplitMix64 (Steele, Lea, Flood 2014) as a function of a counter.
inline uint64_t random_bits(uint64_t seed, uint64_t counter) {
    uint64_t z = seed + (counter + 1) * 0x9e3779b97f4a7c15ull;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ z >> 27) * 0x94d049bb133111ebull;
    return z ^ z >> 31;
}
// In (0, 1).
inline double random_unit(uint64_t seed, uint64_t counter) {
    return (static_cast<double>(random_bits(seed, counter) >> 11) + 0.5) / 9007199254740992.0;
}

} // namespace lr
