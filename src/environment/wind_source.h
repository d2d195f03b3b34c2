// A wind source: checks of its description, its state between steps, and the constants for the kernel.
#pragma once

#include "base/allocator.h"
#include "base/counter_random.h"
#include "base/pose.h"
#include "environment/source_desc.h"
#include "kernel/limits.h"
#include "kernel/wind/sample_wind.h"

#include <array>
#include <cstdint>

namespace lr {

// Random bits from a counter: SplitMix64.
inline uint64_t random_bits(uint64_t seed, uint64_t counter) {
    return mix64(seed + (counter + 1) * 0x9e3779b97f4a7c15ull);
}

// Gusts: a velocity that depends on time alone, a sum of harmonics with von Karman's spectrum (docs/reference/wind_and_water.md). They
// begin at 0: each harmonic grows over its own first cycle, slow ones within four integral times.
class Gusts {
public:
    static constexpr size_t modes = 48;

    Gusts() = default;
    // m/s, root mean square; a unit vector; rad, root mean square; s, integral time.
    Gusts(double rms, Double3 direction, double spread, double period, CounterRandom random);
    // Adds the velocity at an age in s: any age, without state between calls, and nothing before the beginning.
    void add(double age, double (&velocity)[3]) const;

private:
    struct Mode {
        double frequency; // 1/s
        double growth;    // 1/s
        double phase;     // turns
        Double3 amplitude;
    };
    std::array<Mode, modes> mode_{};
};

// Samples of a grid, shared by all sources that use them.
struct GridSamples {
    uint32_t references;
    uint64_t hash; // of counts, frames and samples
    Buffer<float> values;
    float fastest; // m/s
};

// Does not check samples.
Outcome check_wind_source(const SourceDesc& desc);
// Floats of a grid.
uint64_t sample_count(const SourceDesc& desc);
uint64_t hash_samples(const SourceDesc& desc, const float* samples);

struct WindSource {
    SourceDesc desc;   // without samples
    double since;      // s, world time at which it was at desc.position, or its gusts began
    GridSamples* grid; // null for other kinds
    Gusts gusts;

    uint64_t hash() const { return grid ? grid->hash : 0; } // of its samples
    uint32_t instants() const;                              // how many SourceInstants it makes
    float fastest() const;                                  // m/s, a bound of its velocities, or a typical speed
    // drift, drift_velocity: way and velocity of the uniform wind. out: instants() of them.
    void at(double time, uint64_t world_seed, const double drift[3], const double drift_velocity[3],
            SourceInstant* out) const;
};

Gusts gusts_of(const SourceDesc& desc, uint64_t world_seed);
} // namespace lr
