// Paper discs let go in still air, and the four averages that were measured of real ones; docs/maintainers/measurements.md.
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
    double duration = 1.5;       // s: what ends a fall
    double frame_rate = 98.0;    // 1/s
    double hysteresis = 0.1;     // of a projected-area peak, in parts of the disc's area
    double areal_density = 0.07; // kg/m^2
    double thickness = 1e-4;     // m
};

// One fall, over the second half of its time.
struct FallMeasures {
    double descent = 0.0;          // m/s, height lost over time
    double horizontal_speed = 0.0; // m/s, mean of the magnitude, from frame to frame
    double drift_angle = 0.0;      // degrees from the vertical, of the way from begin to end
    double peak_rate = 0.0;        // 1/s, peaks of the area seen by a camera that looks along world z
};

struct DiscFalls {
    std::vector<FallMeasures> falls;
    Statistic descent, horizontal_speed, drift_angle, peak_rate;
};

// What the paper of Howison et al. 2020 has, averaged for physics.md: means over 25-55 falls a radius.
struct MeasuredDisc {
    double radius; // m
    double descent, horizontal_speed, drift_angle, peak_rate;
};
inline constexpr std::array<MeasuredDisc, 4> measured_discs{{{0.0172, 0.74, 0.53, 31.0, 9.4},
                                                             {0.0244, 0.70, 0.58, 35.0, 6.7},
                                                             {0.0342, 0.73, 0.58, 34.0, 5.4},
                                                             {0.0457, 0.78, 0.60, 30.0, 4.2}}};

// normal: body axis of the sheet's normal.
FallMeasures measure_fall(const Track& track, const Eigen::Vector3d& normal, double hysteresis);

// A disc that was baked before, for series with other loads.
DiscFalls drop_discs(const Asset& disc, const DiscFallOptions& options);
Asset paper_disc(double radius, const DiscFallOptions& options);
inline DiscFalls drop_discs(double radius, const DiscFallOptions& options) {
    return drop_discs(paper_disc(radius, options), options);
}

// Falls of other flat sheets are measured in the same way: tracks of any asset.
DiscFalls summarise_falls(const std::vector<Track>& tracks, const Eigen::Vector3d& normal, double hysteresis);
std::vector<Track> record_falls(const Asset& sheet, const DiscFallOptions& options);

} // namespace lr::scorecard
