// Gusts: a velocity that depends on time alone, as a sum of harmonics with von Karman's spectrum (docs/reference/wind_and_water.md).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace lr {

struct GustSettings {
    double rms;          // m/s
    double direction[3]; // unit vector
    double spread;       // rad, root mean square
    double period;       // s, integral time
    uint64_t seed;
};

class Gusts {
public:
    static constexpr size_t modes = 48;

    Gusts() = default;
    explicit Gusts(const GustSettings& settings);
    // Adds the velocity at a time. Any time: nothing is remembered between calls.
    void add(double time, double velocity[3]) const;

private:
    struct Mode {
        double frequency; // 1/s
        double phase;     // turns
        double amplitude[3];
    };
    std::array<Mode, modes> mode_{};
};

} // namespace lr
