#include "tools/lr_scorecard/phase_map.h"

#include "tools/lr_scorecard/measured_bodies.h"
#include "tools/lr_scorecard/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lr::scorecard {
namespace {

using std::numbers::pi;

constexpr double fluid_density = 1000.0;
constexpr double earth = 9.81;

// Re is set by the viscosity near Earth's gravity, then corrected by gravity alone, so that each point is baked once.
constexpr double reynolds_tolerance = 0.03;
constexpr int most_corrections = 6;

// Initial guess: the fit of Clift, Grace and Weber for discs up to Re 130, constant above.
double drag_coefficient(double re) {
    return std::max(1.1, 20.37 / re * (1.0 + 0.138 * std::pow(re, 0.792)));
}

std::vector<Start> starts(const PhaseOptions& options) {
    Random random(options.seed);
    // The sheet is in the plane z = 0 and falls along -y: a quarter turn makes it horizontal.
    const Eigen::Quaterniond flat(Eigen::AngleAxisd(0.5 * pi, -Eigen::Vector3d::UnitX()));
    std::vector<Start> out(options.seeds);
    for (Start& s : out) {
        const double azimuth = random.real(0.0, 2.0 * pi),
                     tilt = random.real(0.1, 1.0) * options.largest_tilt * pi / 180.0;
        const Eigen::Vector3d axis(std::cos(azimuth), 0.0, std::sin(azimuth));
        s.orientation = Eigen::AngleAxisd(tilt, axis) * flat;
    }
    return out;
}

double mean_speed(const std::vector<Track>& tracks) {
    double sum = 0.0;
    for (const Track& t : tracks) {
        const size_t last = t.samples.size() - 1, first = last / 2;
        sum += (t.samples[first].position.y() - t.samples[last].position.y()) /
               (t.interval * static_cast<double>(last - first));
    }
    return sum / static_cast<double>(tracks.size());
}

void classify_all(const std::vector<Track>& tracks, const RegimeLimits& limits, PhaseResult& result) {
    for (const Track& t : tracks) {
        std::vector<Eigen::Vector3d> normals;
        for (size_t i = t.samples.size() / 2; i < t.samples.size(); ++i)
            normals.push_back(t.samples[i].orientation * Eigen::Vector3d::UnitZ());
        result.measures.push_back(measure_regime(normals, up(), limits));
        result.regimes.push_back(classify(result.measures.back(), normals.size(), limits));
        result.share[static_cast<size_t>(result.regimes.back())] += 1.0 / static_cast<double>(tracks.size());
    }
}
} // namespace

PhaseResult run_phase_point(const PhasePoint& point, const PhaseOptions& options, bool keep_tracks) {
    const double d = options.diameter, thickness = options.thickness_ratio * d;
    const double areal_density = 64.0 * fluid_density * d * point.inertia / pi;
    const double pressure =
        earth * (areal_density - fluid_density * thickness); // weight in the fluid over the disc's area
    double speed = std::sqrt(2.0 * pressure / (fluid_density * drag_coefficient(point.reynolds)));
    const double viscosity = speed * d / point.reynolds;
    const Asset disc = bake_disc(0.5 * d, thickness, areal_density, {fluid_density, viscosity}, 8);

    PhaseResult result;
    result.asked = point;
    Run run;
    run.loads = options.loads;
    run.seed = options.seed;
    run.threads = options.threads;
    run.gravity = earth;
    const double wanted = point.reynolds * viscosity / d;
    const std::vector<Start> released = starts(options);
    const double unit = d / wanted;
    run.dt = static_cast<float>(std::min(options.step * unit, 1e-3));
    run.interval = 0.1 * unit;
    const auto fall = [&](double duration) {
        run.duration = duration * unit;
        std::vector<Track> tracks = record(disc, run, released);
        speed = mean_speed(tracks);
        return tracks;
    };
    for (int i = 0; i < most_corrections; ++i) { // a fraction of the duration suffices for the speed
        fall(0.4 * options.duration);
        if (std::abs(speed / wanted - 1.0) <= reynolds_tolerance) break;
        run.gravity *= std::clamp(std::pow(wanted / speed, 1.8), 0.1, 10.0);
    }
    std::vector<Track> tracks = fall(options.duration);
    result.speed = speed;
    result.interval = run.interval;
    result.measured = {speed * d / viscosity, point.inertia};
    classify_all(tracks, options.limits, result);
    if (keep_tracks) result.tracks = std::move(tracks);
    return result;
}

std::span<const BoundaryPoint> boundary_points() {
    using enum BoundaryKind;
    // Fig. 2 of Field et al. 1997, as in physics.md. For small I* the first boundary is between Re 89 and 161.
    static constexpr BoundaryPoint points[] = {
        {steady_periodic, {89.0, 0.004}},     {steady_periodic, {161.0, 0.004}},   {periodic_chaotic, {155.0, 0.057}},
        {periodic_chaotic, {198.0, 0.018}},   {periodic_chaotic, {345.0, 0.0114}}, {periodic_chaotic, {739.0, 0.0090}},
        {periodic_chaotic, {1386.0, 0.0083}}, {periodic_chaotic, {2.7e4, 0.0109}}, {chaotic_tumbling, {160.0, 0.0376}},
        {chaotic_tumbling, {2e3, 0.0401}},    {chaotic_tumbling, {3.4e4, 0.0449}}};
    return points;
}

std::vector<ExpectedPoint> expected_points() {
    using enum Regime;
    std::vector<ExpectedPoint> out;
    const std::span<const BoundaryPoint> boundary = boundary_points();
    for (size_t i = 0; i < boundary.size(); ++i) {
        const PhasePoint at = boundary[i].at;
        const auto across_inertia = [&](double factor, std::vector<Regime> allowed) {
            out.push_back({{at.reynolds, at.inertia * factor}, std::move(allowed), i});
        };
        const auto across_reynolds = [&](double factor, std::vector<Regime> allowed) {
            out.push_back({{at.reynolds * factor, at.inertia}, std::move(allowed), i});
        };
        for (double factor : {1.3, 1.7}) switch (boundary[i].kind) {
            case BoundaryKind::steady_periodic: // no points inside the band
                if (at.reynolds < 100.0)
                    across_reynolds(1.0 / factor, {steady});
                else
                    across_reynolds(factor, {periodic});
                break;
            case BoundaryKind::periodic_chaotic:
                if (at.inertia > 0.0376) {
                    // The boundary is steep here, towards that of tumbling: cross it along Re.
                    across_reynolds(1.0 / factor, {steady, periodic});
                    across_reynolds(factor, {chaotic, tumbling});
                } else {
                    across_inertia(1.0 / factor, {periodic});
                    across_inertia(factor, {chaotic});
                }
                break;
            case BoundaryKind::chaotic_tumbling:
                // Below about Re 180 the chaotic motion becomes periodic.
                across_inertia(1.0 / factor,
                               at.reynolds < 180.0 ? std::vector{periodic, chaotic} : std::vector{chaotic});
                across_inertia(factor, {tumbling});
                break;
            }
    }
    return out;
}

double agreement(const PhaseResult& result, const ExpectedPoint& expected) {
    double sum = 0.0;
    for (Regime r : expected.allowed) sum += result.share[static_cast<size_t>(r)];
    return sum;
}
} // namespace lr::scorecard
