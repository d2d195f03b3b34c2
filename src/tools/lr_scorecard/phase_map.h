// Discs falling through a liquid, over the phase map of Field et al. 1997 in Re and I*; docs/maintainers/measurements.md.
#pragma once

#include "tools/falls/regime.h"
#include "tools/lr_scorecard/fall_recording.h"

#include <optional>
#include <span>
#include <vector>

namespace lr::scorecard {

struct PhaseOptions {
    Loads loads;
    uint32_t seeds = 24;
    uint64_t seed = 1;
    uint32_t threads = 1;
    double step = 0.01;             // time step in d/U, limited to 1 ms
    double duration = 400.0;        // in d/U; the second half is classified
    double largest_tilt = 5.0;      // degrees, at release
    double thickness_ratio = 0.004; // t/d
    double diameter = 0.02;         // m
    double speed = 0.2;             // m/s, of the fall
    RegimeLimits limits;
};

struct PhasePoint {
    double reynolds = 0.0; // U d/nu, U the mean vertical velocity
    double inertia = 0.0;  // I* = pi rho_s t/(64 rho_f d)
};

struct PhaseResult {
    PhasePoint asked, measured;
    double drag = 0.0;             // mean drag coefficient of the fall over that broadside
    std::array<double, 4> share{}; // fraction of the seeds in each Regime
    std::vector<Regime> regimes;   // one per seed
    std::vector<Track> tracks;     // if asked for

    bool most(Regime r) const { return share[static_cast<size_t>(r)] > 0.5; }
};

// A sheet of this I*, for all Re: viscosity sets Re, and gravity corrects it to 3 %.
Asset phase_disc(double inertia, const PhaseOptions& options);
PhaseResult run_phase_point(const Asset& disc, const PhasePoint& point, const PhaseOptions& options,
                            bool keep_tracks = false);

// Regimes of the second halves of tracks of a disc with its normal along z.
std::vector<Regime> classify_all(std::span<const Track> tracks, const RegimeLimits& limits = {});

struct Onset {
    double reynolds = 0.0;
    double periodic = 0.0; // share of the releases that are not steady just above it
};
// The smallest Re between 40 and 640 at which most releases are not steady, by bisection; infinite if there is none.
Onset onset_of_motion(const std::function<PhaseResult(double reynolds)>& run, int halvings);

// Published boundaries, by growing Re.
inline constexpr double first_onset = 89.0, last_onset = 161.0; // Re, steady to periodic
std::span<const PhasePoint> chaotic_boundary();                 // periodic to chaotic
std::span<const PhasePoint> tumbling_boundary();                // chaotic to tumbling

// The regime on the published map; nothing within `margin`, a factor in Re and I*, of a boundary.
std::optional<Regime> published_regime(const PhasePoint& point, double margin = 1.15);

struct ExpectedPoint {
    PhasePoint at;
    Regime regime;
};
// Re from 40 to 3e4, I* from 5e-4 to 0.1, evenly on both logarithmic axes, except near boundaries.
std::vector<ExpectedPoint> expected_points();

// Discs in air of Tinklenberg, Guala and Coletti 2023; Re measured in still air. Assets: disc_sinking_at.
struct SmallDisc {
    double diameter, reynolds; // m
};
inline constexpr std::array<SmallDisc, 2> small_discs{{{1e-3, 96.0}, {3e-3, 360.0}}};

struct SmallDiscFalls {
    double tumbling = 0.0, speed = 0.0; // share of the falls; m/s
};
// Released at rest in any orientation. duration: in diameters over the speed, the second half is classified.
SmallDiscFalls drop_small_disc(const SmallDisc& disc, const Asset& asset, uint32_t falls, double duration,
                               const Loads& loads);
} // namespace lr::scorecard
