// Paper discs released in still air, and the four averages measured for real discs; docs/maintainers/measurements.md.
#pragma once

#include "tools/lr_scorecard/fall_recording.h"
#include "tools/lr_scorecard/statistics.h"

#include <array>

namespace lr::scorecard {

struct DiscFallOptions {
    Loads loads;
    uint32_t falls = 400;
    uint64_t seed = 1;
    float dt = 1e-3f;
    uint32_t substeps = 1;
    uint32_t threads = 1;
    double duration = 1.5;       // s, of a fall
    double frame_rate = 98.0;    // 1/s
    double hysteresis = 0.1;     // of a projected-area peak, relative to the disc's area
    double areal_density = 0.07; // kg/m^2
    double thickness = 1e-4;     // m
};

// Measures of one fall, over its second half.
struct FallMeasures {
    double descent = 0.0;          // m/s, mean rate of descent
    double horizontal_speed = 0.0; // m/s, mean magnitude between frames
    double drift_angle = 0.0;      // degrees from the vertical, of the line from first to last position
    double peak_rate = 0.0;        // 1/s, peaks of the area projected along world z
};

struct DiscFalls {
    std::vector<FallMeasures> falls;
    Statistic descent, horizontal_speed, drift_angle, peak_rate;
};

// Measurements of Howison et al. 2020, averaged for physics.md over 25 to 55 falls per radius.
struct MeasuredDisc {
    double radius; // m
    double descent, horizontal_speed, drift_angle, peak_rate;
};
inline constexpr std::array<MeasuredDisc, 4> measured_discs{{{0.0172, 0.74, 0.53, 31.0, 9.4},
                                                             {0.0244, 0.70, 0.58, 35.0, 6.7},
                                                             {0.0342, 0.73, 0.58, 34.0, 5.4},
                                                             {0.0457, 0.78, 0.60, 30.0, 4.2}}};

// normal: the sheet's normal in the body frame.
FallMeasures measure_fall(const Track& track, const Eigen::Vector3d& normal, double hysteresis);

// Drops an existing disc, for series with different loads.
DiscFalls drop_discs(const Asset& disc, const DiscFallOptions& options);
Asset paper_disc(double radius, const DiscFallOptions& options);
inline DiscFalls drop_discs(double radius, const DiscFallOptions& options) {
    return drop_discs(paper_disc(radius, options), options);
}

// For tracks of any flat sheet.
DiscFalls summarise_falls(const std::vector<Track>& tracks, const Eigen::Vector3d& normal, double hysteresis);
std::vector<Track> record_falls(const Asset& sheet, const DiscFallOptions& options);
} // namespace lr::scorecard
