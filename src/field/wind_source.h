// A wind source: its description checked, what it holds between steps, and the constants that the kernel takes.
#pragma once

#include "field/gusts.h"
#include "kernel/wind.h"
#include "langevin_rigid.h"
#include "world/allocator.h"

#include <cstdint>

namespace lr {

// Samples of a grid, shared by every source that shows them.
struct GridSamples {
    uint32_t references;
    uint64_t hash; // of counts, frames and samples
    Buffer<float> values;
    float fastest; // m/s
};

// Bytes of a description that say what a source is: everything but the pointer to samples that were copied.
inline constexpr size_t source_bytes = offsetof(lr_wind_source_desc, samples);

// LR_OK, or why not. Samples are not looked at.
lr_status check_wind_source(const lr_wind_source_desc& desc, const char*& why);
// Floats of a grid.
uint64_t sample_count(const lr_wind_source_desc& desc);
uint64_t hash_samples(const lr_wind_source_desc& desc, const float* samples);

struct WindSource {
    lr_wind_source_desc desc; // without samples
    double since;             // s, world time at which it was where desc.position says, or its gusts began
    GridSamples* grid;        // null for other kinds
    Gusts gusts;

    uint32_t instants() const; // how many SourceInstants it makes
    float fastest() const;     // m/s, a bound of its velocities or a typical speed
    // drift, drift_velocity: way and velocity of the uniform wind. out: instants() of them.
    void at(double time, uint64_t world_seed, const double drift[3], const double drift_velocity[3],
            SourceInstant* out) const;
};

Gusts gusts_of(const lr_wind_source_desc& desc, uint64_t world_seed);

} // namespace lr
