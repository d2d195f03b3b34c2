// Discs falling through a liquid, on both sides of the boundaries of Field et al. 1997 in Re and I*; docs/maintainers/measurements.md.
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
    double step = 0.01;            // time step in d/U, limited to 1 ms
    double duration = 400.0;       // in d/U; the second half is classified
    double largest_tilt = 5.0;     // degrees, at release
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
    double speed = 0.0;            // m/s, mean vertical speed over all seeds
    double interval = 0.0;         // s between samples
    std::array<double, 4> share{}; // fraction of the seeds in each Regime
    std::vector<Regime> regimes;   // one per seed
    std::vector<RegimeMeasures> measures;
    std::vector<Track> tracks; // if asked for
};

PhaseResult run_phase_point(const PhasePoint& point, const PhaseOptions& options, bool keep_tracks = false);

// A point of the map and its allowed regimes.
struct ExpectedPoint {
    PhasePoint at;
    std::vector<Regime> allowed;
    size_t boundary; // index of its boundary point
};

enum class BoundaryKind : uint8_t { steady_periodic, periodic_chaotic, chaotic_tumbling };
struct BoundaryPoint {
    BoundaryKind kind;
    PhasePoint at;
};

std::span<const BoundaryPoint> boundary_points();
// Points on both sides of each boundary point, at factors of 1.3 and 1.7.
std::vector<ExpectedPoint> expected_points();

// The fraction of seeds in an allowed regime.
double agreement(const PhaseResult& result, const ExpectedPoint& expected);
} // namespace lr::scorecard
