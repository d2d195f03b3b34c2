#include "tools/lr_scorecard/disc_fall.h"

#include "tools/lr_scorecard/measured_bodies.h"
#include "tools/lr_scorecard/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lr::scorecard {
namespace {

double horizontal(const Eigen::Vector3d& v) {
    return std::hypot(v.x(), v.z());
}

Statistic over_falls(const std::vector<FallMeasures>& falls, double FallMeasures::*member) {
    std::vector<double> values;
    values.reserve(falls.size());
    for (const FallMeasures& f : falls) values.push_back(f.*member);
    return summarise(std::move(values));
}
} // namespace

FallMeasures measure_fall(const Track& track, const Eigen::Vector3d& normal, double hysteresis) {
    const size_t last = track.samples.size() - 1, first = last / 2;
    const double time = track.interval * static_cast<double>(last - first);
    const Eigen::Vector3d way = track.samples[last].position - track.samples[first].position;
    FallMeasures m;
    m.descent = -way.y() / time;
    m.drift_angle = std::atan2(horizontal(way), -way.y()) * 180.0 / std::numbers::pi;
    double path = 0.0;
    for (size_t i = first; i < last; ++i) path += horizontal(track.samples[i + 1].position - track.samples[i].position);
    m.horizontal_speed = path / time;
    // Search peaks in the whole fall, count them in its second half: a search in that half alone would lose peaks at its start.
    std::vector<double> area; // relative to the area of the sheet
    for (const Sample& s : track.samples) area.push_back(std::abs((s.orientation * normal).z()));
    const std::vector<size_t> found = peaks(area, hysteresis);
    const auto begin = std::lower_bound(found.begin(), found.end(), first);
    m.peak_rate = static_cast<double>(found.end() - begin) / time;
    return m;
}

DiscFalls summarise_falls(const std::vector<Track>& tracks, const Eigen::Vector3d& normal, double hysteresis) {
    DiscFalls out;
    for (const Track& t : tracks) out.falls.push_back(measure_fall(t, normal, hysteresis));
    out.descent = over_falls(out.falls, &FallMeasures::descent);
    out.horizontal_speed = over_falls(out.falls, &FallMeasures::horizontal_speed);
    out.drift_angle = over_falls(out.falls, &FallMeasures::drift_angle);
    out.peak_rate = over_falls(out.falls, &FallMeasures::peak_rate);
    return out;
}

std::vector<Track> record_falls(const Asset& sheet, const DiscFallOptions& options) {
    Random random(options.seed);
    std::vector<Start> starts(options.falls);
    for (Start& s : starts) s.orientation = random.orientation();
    Run run;
    run.loads = options.loads;
    run.dt = options.dt;
    run.substeps = options.substeps;
    run.duration = options.duration;
    run.interval = 1.0 / options.frame_rate;
    run.seed = options.seed;
    run.threads = options.threads;
    return record(sheet, run, starts);
}

Asset paper_disc(double radius, const DiscFallOptions& options) {
    return bake_disc(radius, options.thickness, options.areal_density, Fluid{});
}

DiscFalls drop_discs(const Asset& disc, const DiscFallOptions& options) {
    return summarise_falls(record_falls(disc, options), Eigen::Vector3d::UnitZ(), options.hysteresis);
}
} // namespace lr::scorecard
