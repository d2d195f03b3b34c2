// Discs falling through a liquid, over Re and I*, beside the boundaries that Field et al. 1997 drew; docs/maintainers/measurements.md.
#pragma once

#include "tools/lr_scorecard/fall_recording.h"
#include "tools/lr_scorecard/regime.h"
#include "tools/lr_scorecard/statistics.h"

#include <span>
#include <vector>

namespace lr::scorecard {

struct PhaseOptions {
    Loads loads;
    uint32_t seeds = 24;
    uint64_t seed = 1;
    uint32_t threads = 1;
    double step = 0.01;            // d/U a time step, but at most 1 ms
    double duration = 400.0;       // d/U; the second half is classified
    double largest_tilt = 5.0;     // degrees at release
    double thickness_ratio = 0.01; // t/d
    double diameter = 0.02;        // m
    RegimeLimits limits;
};

struct PhasePoint {
    double reynolds = 0.0; // U d/nu, U the mean vertical velocity
    double inertia = 0.0;  // I* = pi rho_s t/(64 rho_f d)
};

struct PhaseResult {
    PhasePoint asked, measured;
    double speed = 0.0;            // m/s, mean vertical, of all seeds
    double interval = 0.0;         // s between samples
    std::array<double, 4> share{}; // of the seeds, by Regime
    std::vector<Regime> regimes;   // of each seed
    std::vector<RegimeMeasures> measures;
    std::vector<Track> tracks; // if asked for
};

PhaseResult run_phase_point(const PhasePoint& point, const PhaseOptions& options, bool keep_tracks = false);

// A point of the map, and the regimes that it may have there.
struct ExpectedPoint {
    PhasePoint at;
    std::vector<Regime> allowed;
    size_t boundary; // index of the boundary point that it was made from
};

enum class BoundaryKind : uint8_t { steady_periodic, periodic_chaotic, chaotic_tumbling };
struct BoundaryPoint {
    BoundaryKind kind;
    PhasePoint at;
};

std::span<const BoundaryPoint> boundary_points();
// On both sides of each, by factors of 1.3 and 1.7.
std::vector<ExpectedPoint> expected_points();

// The part of the seeds that fall as the map says.
double agreement(const PhaseResult& result, const ExpectedPoint& expected);

} // namespace lr::scorecard
