// Distance between falls with given coefficients and measured falls: paper discs, the phase map, small discs.
#pragma once

#include "tools/lr_fit/coefficients.h"
#include "tools/lr_scorecard/disc_fall.h"
#include "tools/lr_scorecard/phase_map.h"

namespace lr::fit {

struct Effort {
    uint32_t falls;       // of a cell of paper discs
    uint32_t substeps;    // a frame
    size_t map_stride;    // stride in the map's points
    uint32_t map_seeds;   // releases a point
    uint32_t small_falls; // of each small disc
    double hopeless;      // misfit of the paper discs above which nothing else is run
};
inline constexpr Effort search_effort{72, 4, 2, 3, 16, 150.0}; // a second or two on one core
inline constexpr Effort summary_effort{600, 10, 1, 12, 64, std::numeric_limits<double>::infinity()};

struct Score {
    double misfit = 0.0;
    int means = 0, spreads = 0, quantiles = 0, sideways = 0; // number within the scorecard's tolerances
    double worst_mean = 0.0;                                 // relative
    double map = 0.0;  // share of points where most discs fall as in the published map
    double drag = 0.0; // largest mean drag of the map's lightest discs, over their broadside drag
    std::array<double, scorecard::small_discs.size()> tumbling{};
};

class Objective {
public:
    Objective(uint32_t threads); // bakes the discs

    // Does not depend on `threads`. Concurrent calls are allowed.
    Score score(const PlateCoefficients& coefficients, const Effort& effort, uint32_t threads,
                const std::function<void(double)>& progress = {}) const;

private:
    struct MapPoint {
        scorecard::ExpectedPoint expected;
        size_t disc;
    };
    scorecard::PhaseOptions phase_options_;
    std::vector<std::vector<scorecard::Asset>> paper_; // by cell
    std::vector<MapPoint> map_;
    std::vector<scorecard::Asset> map_discs_, small_;
};

// "36 of 40 means within 15 %, the worst 32 % off; ..."
std::string describe(const Score& score);
} // namespace lr::fit
