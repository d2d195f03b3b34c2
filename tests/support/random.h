// Repeatable random numbers for tests: SplitMix64 (Steele, Lea, Flood 2014).
#pragma once

#include <cmath>
#include <cstdint>

namespace test {

class Random {
public:
    explicit Random(uint64_t seed) : state_(seed) {}
    uint64_t bits() {
        uint64_t z = state_ += 0x9e3779b97f4a7c15ull;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ z >> 27) * 0x94d049bb133111ebull;
        return z ^ z >> 31;
    }
    uint32_t below(uint32_t n) { return static_cast<uint32_t>((bits() >> 32) * n >> 32); }
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(bits() >> 11) / 9007199254740992.0;
    }
    double logarithmic(double low, double high) { return low * std::exp(uniform(0.0, std::log(high / low))); }
    float real(double low, double high) { return static_cast<float>(uniform(low, high)); }

private:
    uint64_t state_;
};

} // namespace test
