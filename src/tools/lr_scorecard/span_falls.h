// Releases, measures and pictures of bodies with a span.
#pragma once

#include "tools/falls/statistics.h"
#include "tools/lr_scorecard/fall_recording.h"
#include "tools/lr_scorecard/line_plot.h"
#include "tools/lr_scorecard/row.h"

#include <span>

namespace lr::scorecard {

// At 1/60 s as games do, with a sample at each step.
Run game_run(const Context& context, uint32_t substeps, double duration);

// At rest in any orientation, at different places so that no two bodies meet the same turbulence.
std::vector<Start> released_anyhow(uint32_t count, uint64_t seed);

// Samples until the body has fallen this far. Empty if any number is not finite.
std::span<const Sample> fallen(const Track& track, double height);

// The last part of a fall.
inline std::span<const Sample> end_of(std::span<const Sample> samples, double part) {
    return samples.last(static_cast<size_t>(part * static_cast<double>(samples.size())));
}

double descent_of(std::span<const Sample> samples, double interval); // m/s, mean
double spin_of(std::span<const Sample> samples);                     // rad/s about the vertical, mean
double share_of(const std::vector<bool>& seen);
Statistic mean_descent(const std::vector<Track>& tracks, double part); // of the last part of each fall

// Side views of the first falls, next to each other, to a depth, with strokes of this length along a body axis every `every` samples.
struct Strokes {
    Eigen::Vector3d axis;
    double length = 0.0; // m
    size_t every = 1;
};
LinePlot side_view(const std::string& title, const std::vector<Track>& tracks, size_t count, double depth, double apart,
                   const Strokes& strokes);
} // namespace lr::scorecard
