// Measures of single falls, and their averages.
#pragma once

#include "tools/falls/drop.h"
#include "tools/falls/statistics.h"

#include <array>

namespace lr::falls {

// steady: keeps its attitude; fluttering: swings to and fro; tumbling: turns over and over; spinning: autorotates about the vertical; gliding: flies
// flatter than 45 degrees, straight or in a spiral; chaotic: turns over now and then, or swings far without a period.
enum class Motion : uint8_t { steady, fluttering, tumbling, spinning, gliding, chaotic };
inline constexpr std::array<const char*, 6> motion_names{"steady",   "fluttering", "tumbling",
                                                         "spinning", "gliding",    "chaotic"};

struct MotionLimits {
    double steady_angle = 6.0;       // degrees from the mean attitude, within which it is steady 95 % of the time
    double rocking_angle = 45.0;     // the same for flutter, however irregular
    double tumbling_share = 0.5;     // least share of the time in straight half turns, two or more in a row
    double spin_turns = 1.0;         // least net turns about the vertical
    double spin_per_length = 0.05;   // least net turns per body length of fall
    double spin_constancy = 0.8;     // least mean over root mean square of the rate about the vertical
    double glide_straightness = 0.7; // least net horizontal distance over horizontal path
    double regularity = 0.4;         // least autocorrelation of swings after one period
    double judged_swings = 4.0;      // swings below which their regularity is not judged
};

// Means are over the second half of the fall's time. The motion is judged without the first quarter.
struct Fall {
    bool arrived = false;
    double time = 0.0;                              // s, of the whole fall
    double descent = 0.0;                           // m/s, negative if it rises
    double third_quarter = 0.0, last_quarter = 0.0; // m/s, descent in these parts of the time
    double horizontal_speed = 0.0;                  // m/s, relative to the mean wind
    double spin = 0.0;                              // turns/s about the vertical, net
    double turnovers = 0.0; // turns/s about horizontal axes: whole turns of the broad side's normal
    double swings = 0.0;    // 1/s, of the normal to and fro
    Eigen::Vector3d end = Eigen::Vector3d::Zero(); // m, from the point of release
    Motion motion = Motion::steady;
    bool spirals = false; // glides in a spiral
};

Fall measure(const Track& track, const Shape& shape, const Eigen::Vector3d& wind, const MotionLimits& limits = {});

struct Falls {
    uint32_t count = 0, arrived = 0;
    Statistic descent, horizontal_speed, spin, turnovers, swings; // spin: magnitudes; swings: of fluttering bodies
    Statistic turning;                                            // spin of spinning bodies
    Statistic time;                                               // of arrived bodies
    Statistic third_quarter, last_quarter;                        // of descent; third: 0 if a fall is short
    bool settled = false;
    std::array<double, motion_names.size()> shares{}; // of each Motion
    double spirals = 0.0;                             // share gliding in spirals
    Eigen::Vector3d drift = Eigen::Vector3d::Zero();  // m, mean horizontal displacement
    double half_radius = 0.0, most_radius = 0.0; // m, radii about the drift with half and with 95 % of the landings
};

Falls summarise(const std::vector<Fall>& falls);

// "flutters", or "mixed" if no motion has half of the bodies.
const char* summary_word(const Falls& falls);
} // namespace lr::falls
