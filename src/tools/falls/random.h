// Random starts that are the same with every standard library.
#pragma once

#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace lr::falls {

class Random {
public:
    explicit Random(uint64_t seed) : state_(seed) {}

    // SplitMix64 (Steele, Lea and Flood 2014).
    uint64_t bits() {
        uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    double real(double low, double high) { return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53); }
    double gaussian() { // Box-Muller, one of the pair
        const double radius = std::sqrt(-2.0 * std::log(1.0 - real(0.0, 1.0)));
        return radius * std::cos(real(0.0, 2.0 * std::numbers::pi));
    }
    // Uniform over all rotations: four Gaussians, normalised.
    Eigen::Quaterniond orientation() {
        const double x = gaussian(), y = gaussian(), z = gaussian(), w = gaussian();
        return Eigen::Quaterniond(w, x, y, z).normalized();
    }

private:
    uint64_t state_;
};
} // namespace lr::falls
