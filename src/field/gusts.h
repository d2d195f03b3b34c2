// Gusts: a velocity that depends on time alone, as a sum of harmonics with von Karman's spectrum (docs/reference/wind_and_water.md). They
// begin at 0: each harmonic grows over its own first cycle, the slow ones within four integral times.
#pragma once

#include "world/counter_random.h"

#include <array>
#include <cstddef>

namespace lr {

struct GustSettings {
    double rms;          // m/s
    double direction[3]; // unit vector
    double spread;       // rad, root mean square
    double period;       // s, integral time
};

class Gusts {
public:
    static constexpr size_t modes = 48;

    Gusts() = default;
    Gusts(const GustSettings& settings, CounterRandom random);
    // Adds the velocity at an age in s. Any age: nothing is remembered between calls. None before the beginning.
    void add(double age, double velocity[3]) const;

private:
    struct Mode {
        double frequency; // 1/s
        double growth;    // 1/s
        double phase;     // turns
        double amplitude[3];
    };
    std::array<Mode, modes> mode_{};
};

} // namespace lr
