// How a disc falls: steady, periodic, chaotic or tumbling, told from the motion of its normal; docs/maintainers/measurements.md.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace lr::scorecard {

enum class Regime : uint8_t { steady, periodic, chaotic, tumbling };
inline constexpr std::array<const char*, 4> regime_names{"steady", "periodic", "chaotic", "tumbling"};

struct RegimeLimits {
    double steady_tilt = 3.0;        // degrees; steady: 95 % of the time the tilt is below
    double tumbling_share = 0.8;     // of the time, that straight half turns take
    size_t tumbling_run = 8;         // half turns in a row, at least, for that: otherwise it turns back too soon
    double longest_half_turn = 1.35; // half turns' worth of way that the normal may go in one: more is to and fro
    double regularity = 0.8;         // autocorrelation of the normal's horizontal part after one period
    double amplitude_spread = 0.25;  // relative standard deviation of the tilt's maxima
    double least_periods = 5.0;      // in the window, for "periodic"
};

struct RegimeMeasures {
    double tilt95 = 0.0;     // degrees, 95th percentile of the angle between the normal and the vertical, either side
    double overturns = 0.0;  // times that the normal went through the horizontal
    double half_turns = 0.0; // straight, one face to the other, and two or more in a row
    double tumbling_share = 0.0;   // of the time, that those of long enough runs take
    double regularity = 0.0;       // see RegimeLimits
    double period = 0.0;           // samples; 0 without one
    double amplitude_spread = 0.0; // see RegimeLimits
};

// normals: unit vectors of the disc's normal, world frame, evenly spaced in time, transients left out; at least 20 a
// period. up: the vertical.
RegimeMeasures measure_regime(std::span<const Eigen::Vector3d> normals, const Eigen::Vector3d& up,
                              const RegimeLimits& limits = {});
Regime classify(const RegimeMeasures& measures, size_t samples, const RegimeLimits& limits = {});
Regime classify(std::span<const Eigen::Vector3d> normals, const Eigen::Vector3d& up, const RegimeLimits& limits = {});

} // namespace lr::scorecard
