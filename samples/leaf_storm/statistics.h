// Averages over the bodies of a storm, at one time and over its second half.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "langevin_rigid.h"

struct Sample {
    double time = 0.0;         // s
    std::uint64_t bodies = 0;  // awake bodies with finite motion
    double descent = 0.0;      // m/s, mean, relative to the vertical speed of the air; down is positive
    double horizontal = 0.0;   // m/s, mean magnitude, relative to the air
    double spin = 0.0;         // rad/s, mean magnitude
    double tilt = 0.0;         // mean |cos| between body z and the vertical: 1 flat, 0 on edge
    std::uint64_t at_rest = 0; // asleep; all other values are of awake bodies
};

// Counts values in bins of 2 mm/s from -50 to 50 m/s; the outer bins take the rest.
class Histogram {
public:
    Histogram() : bins_(50000) {}
    void add(double value);
    double quantile(double part) const; // part: 0 to 1
private:
    std::vector<std::uint64_t> bins_;
    std::uint64_t total_ = 0;
};

// Adds the awake bodies of a view to sums; `finish` turns them into means.
class Sampler {
public:
    explicit Sampler(double time) { sample_.time = time; }
    // velocities: of lr_batch_write_velocities. descents may be null.
    void add(const lr_batch_view& view, const std::vector<float>& velocities, const float* wind, Histogram* descents);
    Sample finish() const;

private:
    Sample sample_; // sums until finish()
};

// The body axis along which the body is thin: a plate has its largest moment of inertia about it.
int thin_axis(const lr_asset_info& info);

struct Summary {
    double mean_descent = 0.0, median_descent = 0.0, descent_5 = 0.0, descent_95 = 0.0; // m/s
    double horizontal = 0.0;                                                            // m/s
    double spin = 0.0;                                                                  // rad/s
    double tilt = 0.0;
    double from = 0.0, to = 0.0; // s: averaged time
    std::uint64_t samples = 0;
};

Summary summarise(const std::vector<Sample>& samples, const Histogram& descents, double from);
