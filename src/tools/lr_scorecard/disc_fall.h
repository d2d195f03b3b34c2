// Paper discs dropped flat or edge-on and measured as in the filmed falls of Howison et al. 2020; docs/maintainers/measurements.md.
#pragma once

#include "tools/falls/statistics.h"
#include "tools/lr_scorecard/fall_recording.h"

#include <array>
#include <optional>
#include <span>

namespace lr::scorecard {

enum class Release : uint8_t { flat, edge };

// The quantities of a whole fall, in this order in all arrays of five.
struct Quantity {
    const char *name, *unit;
};
inline constexpr std::array<Quantity, 5> quantities{
    {{"descent", "m/s"}, {"horizontal speed", "m/s"}, {"drift", "deg"}, {"landing", "m"}, {"area peaks", "1/s"}}};

// Measured discs of one size, released in one way. Speeds in m/s.
struct MeasuredCell {
    double radius; // m, mean
    Release release;
    std::array<double, 3> radii; // m, means of the smallest, middle and largest third of the discs
    double falls;
    std::array<double, 5> mean, deviation; // over falls, by quantity
    double vz_deviation;                   // of the instantaneous descent
    std::array<double, 5> vz;              // its quantiles: 5, 25, 50, 75, 95 %
    std::array<double, 3> vh;              // quantiles of the instantaneous horizontal speed: 5, 50, 95 %
    double sideways;                       // s, median time to 5 cm sideways, of flat releases
    // In bins of 0.1 s, from 0.1 s after the first frame; 0 after the last bin: horizontal speed (rms), mean descent.
    std::array<double, 12> growth, growth_descent;
};
std::span<const MeasuredCell> measured_cells();

inline constexpr double frame_rate = 98.0;             // 1/s
inline constexpr double longest_fall = 3.0;            // s
inline constexpr size_t least_frames = 20;             // of a fall that can be measured
inline constexpr double sideways_distance = 0.05;      // m
inline const Eigen::Vector3d camera(-1.20, 1.81, 0.0); // m; the floor is at y = 0, discs are dropped above the origin

// One fall, from its first frame in sight to the floor. Its second half begins at frame n/2 of n.
struct Fall {
    std::array<double, 5> quantity{};  // of the second half; landing of the whole fall
    double time = 0.0;                 // s
    double sideways = 0.0;             // s to 5 cm from the place at 0.06 s; longest_fall if never
    std::vector<double> vz, vh;        // m/s between frames
    std::vector<Eigen::Vector3d> path; // m, smoothed
};

// Nothing if the disc is too short in sight.
std::optional<Fall> measure_fall(const Track& track, Release release);

// Area of the disc as the camera sees it, relative to that seen broadside from 1 m.
double seen_area(const Eigen::Vector3d& position, const Eigen::Vector3d& normal);

struct CellStatistics {
    std::array<Statistic, 5> quantity;
    Statistic time, sideways, vz, vh; // vz, vh: pooled over falls
    std::array<double, 12> growth{}, growth_descent{};
};
CellStatistics summarise_falls(std::span<const Fall> falls);

struct DiscFallOptions {
    Loads loads;
    uint32_t falls = 600;
    uint64_t seed = 1;
    float dt = 1e-3f;
    uint32_t substeps = 1;
};
inline constexpr double paper_density = 0.07, paper_thickness = 1e-4; // kg/m^2, m

// Starts at rest. flat: 0.98 m above the floor, normal within 4.6 degrees of the vertical. edge: 1.16 m above it, within 3.4 degrees of edge-on. In
// any azimuth.
std::vector<Start> releases(Release release, uint32_t count, uint64_t seed);

// Falls of one disc in a world of its own. Falls that cannot be measured are left out.
std::vector<Fall> drop_disc(const Asset& disc, Release release, const DiscFallOptions& options);

// A cell's discs differ in size: each third of its falls has one of the measured radii.
std::vector<Asset> bake_cell(const MeasuredCell& cell);
std::vector<Fall> drop_cell(const MeasuredCell& cell, const std::vector<Asset>& discs, DiscFallOptions options);
} // namespace lr::scorecard
