// Classifies the fall of a disc by the motion of its normal: steady, periodic, chaotic, tumbling; docs/maintainers/measurements.md.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace lr::falls {

enum class Regime : uint8_t { steady, periodic, chaotic, tumbling };
inline constexpr std::array<const char*, 4> regime_names{"steady", "periodic", "chaotic", "tumbling"};

struct RegimeLimits {
    double steady_tilt = 3.0;    // degrees; steady: smaller tilt 95 % of the time
    double tumbling_share = 0.8; // tumbling: least fraction of the time in straight half turns
    size_t tumbling_run = 8;     // tumbling: least number of half turns in a row
    // Path of the normal in one straight half turn, in half turns; a longer one goes to and fro.
    double longest_half_turn = 1.35;
    double regularity = 0.8;        // autocorrelation of the normal's horizontal part after one period
    double amplitude_spread = 0.25; // relative standard deviation of the tilt's maxima
    double least_periods = 5.0;     // in the window, for "periodic"
};

struct RegimeMeasures {
    double tilt95 = 0.0;     // degrees, 95th percentile of the angle between the normal and the vertical, either side
    double overturns = 0.0;  // number of times the normal crossed the horizontal
    double half_turns = 0.0; // straight half turns, two or more in a row
    double net_half_turns = 0.0;   // from first to last crossing; to and fro cancel
    double tumbling_share = 0.0;   // fraction of the time in runs of at least tumbling_run
    double regularity = 0.0;       // see RegimeLimits
    double period = 0.0;           // samples; 0: none found
    double amplitude_spread = 0.0; // see RegimeLimits
};

// normals: the disc's unit normal in the world frame, at equal time intervals, without transients; at least 20 samples per
// period. up: the vertical.
RegimeMeasures measure_regime(std::span<const Eigen::Vector3d> normals, const Eigen::Vector3d& up,
                              const RegimeLimits& limits = {});
Regime classify(const RegimeMeasures& measures, size_t samples, const RegimeLimits& limits = {});
Regime classify(std::span<const Eigen::Vector3d> normals, const Eigen::Vector3d& up, const RegimeLimits& limits = {});
} // namespace lr::falls
