#include "tools/lr_scorecard/phase_map.h"

#include "tools/falls/random.h"
#include "tools/lr_scorecard/measured_bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lr::scorecard {
namespace {

using std::numbers::pi;

constexpr double fluid_density = 1000.0;
constexpr double reynolds_tolerance = 0.03;
constexpr int most_corrections = 8;

// Initial guess: the fit of Clift, Grace and Weber for discs up to Re 130, constant above.
double drag_coefficient(double re) {
    return std::max(1.1, 20.37 / re * (1.0 + 0.138 * std::pow(re, 0.792)));
}

double areal_density(double inertia, const PhaseOptions& options) {
    return 64.0 * fluid_density * options.diameter * inertia / pi;
}

std::vector<Start> starts(const PhaseOptions& options) {
    Random random(options.seed);
    // The sheet is baked in the plane z = 0 and falls along -y; a quarter turn makes it horizontal.
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

// I* of a boundary at this Re, straight between its points on logarithmic axes, constant beyond its ends.
double inertia_at(std::span<const PhasePoint> boundary, double reynolds) {
    if (reynolds <= boundary.front().reynolds) return boundary.front().inertia;
    for (size_t i = 1; i < boundary.size(); ++i)
        if (reynolds <= boundary[i].reynolds) {
            const PhasePoint &a = boundary[i - 1], &b = boundary[i];
            const double part = std::log(reynolds / a.reynolds) / std::log(b.reynolds / a.reynolds);
            return a.inertia * std::pow(b.inertia / a.inertia, part);
        }
    return boundary.back().inertia;
}

std::optional<Regime> region(const PhasePoint& p) {
    if (p.reynolds < first_onset) return Regime::steady;
    if (p.reynolds <= last_onset) return std::nullopt;
    if (p.inertia > inertia_at(tumbling_boundary(), p.reynolds)) return Regime::tumbling;
    return p.inertia > inertia_at(chaotic_boundary(), p.reynolds) ? Regime::chaotic : Regime::periodic;
}
} // namespace

Asset phase_disc(double inertia, const PhaseOptions& options) {
    const double d = options.diameter;
    return bake_disc(0.5 * d, options.thickness_ratio * d, areal_density(inertia, options),
                     {fluid_density, options.speed * d / 1000.0});
}

PhaseResult run_phase_point(const Asset& disc, const PhasePoint& point, const PhaseOptions& options, bool keep_tracks) {
    const double d = options.diameter, unit = d / options.speed;
    PhaseResult result;
    result.asked = point;
    Run run;
    run.loads = options.loads;
    run.seed = options.seed;
    run.threads = options.threads;
    run.viscosity = options.speed * d / point.reynolds;
    run.gravity = 0.5 * fluid_density * options.speed * options.speed * drag_coefficient(point.reynolds) /
                  (areal_density(point.inertia, options) - fluid_density * options.thickness_ratio * d);
    const double broadside = run.gravity;
    const std::vector<Start> released = starts(options);
    run.dt = static_cast<float>(std::min(options.step * unit, 1e-3));
    run.interval = 0.1 * unit;
    double speed = 0.0;
    const auto fall = [&](double duration) {
        run.duration = duration * unit;
        std::vector<Track> tracks = record(disc, run, released);
        speed = mean_speed(tracks);
        return tracks;
    };
    for (int i = 0; i < most_corrections; ++i) { // part of the duration suffices for the speed
        fall(0.4 * options.duration);
        if (std::abs(speed / options.speed - 1.0) <= reynolds_tolerance) break;
        run.gravity *= speed > 0.0 ? std::clamp(std::pow(options.speed / speed, 1.8), 0.1, 10.0) : 10.0;
    }
    std::vector<Track> tracks = fall(options.duration);
    result.measured = {speed * d / run.viscosity, point.inertia};
    result.drag = run.gravity / broadside * (options.speed / speed) * (options.speed / speed);
    result.regimes = classify_all(tracks, options.limits);
    for (Regime r : result.regimes) result.share[static_cast<size_t>(r)] += 1.0;
    for (double& share : result.share) share /= static_cast<double>(tracks.size());
    if (keep_tracks) result.tracks = std::move(tracks);
    return result;
}

std::vector<Regime> classify_all(std::span<const Track> tracks, const RegimeLimits& limits) {
    std::vector<Regime> regimes;
    for (const Track& t : tracks) {
        std::vector<Eigen::Vector3d> normals;
        for (size_t i = t.samples.size() / 2; i < t.samples.size(); ++i)
            normals.push_back(t.samples[i].orientation * Eigen::Vector3d::UnitZ());
        regimes.push_back(classify(normals, up(), limits));
    }
    return regimes;
}

Onset onset_of_motion(const std::function<PhaseResult(double)>& run, int halvings) {
    PhaseResult low = run(40.0), high = run(640.0);
    const auto periodic = [](const PhaseResult& r) {
        const auto share = [&r](Regime regime) { return r.share[static_cast<size_t>(regime)]; };
        return share(Regime::periodic) / (1.0 - share(Regime::steady));
    };
    if (!low.most(Regime::steady)) return {low.measured.reynolds, periodic(low)};
    if (high.most(Regime::steady)) return {std::numeric_limits<double>::infinity(), 0.0};
    for (int i = 0; i < halvings; ++i) {
        PhaseResult middle = run(std::sqrt(low.asked.reynolds * high.asked.reynolds));
        (middle.most(Regime::steady) ? low : high) = std::move(middle);
    }
    return {std::sqrt(low.measured.reynolds * high.measured.reynolds), periodic(high)};
}

// Both boundaries: Fig. 2 of Field et al. 1997, as in physics.md.
std::span<const PhasePoint> chaotic_boundary() {
    static constexpr PhasePoint points[] = {{155.0, 0.057},  {198.0, 0.018},   {345.0, 0.0114},
                                            {739.0, 0.0090}, {1386.0, 0.0083}, {2.7e4, 0.0109}};
    return points;
}

std::span<const PhasePoint> tumbling_boundary() {
    static constexpr PhasePoint points[] = {{160.0, 0.0376}, {2e3, 0.0401}, {3.4e4, 0.0449}};
    return points;
}

std::optional<Regime> published_regime(const PhasePoint& point, double margin) {
    const std::optional<Regime> here = region(point);
    for (double re : {1.0 / margin, margin})
        for (double inertia : {1.0 / margin, margin})
            if (region({point.reynolds * re, point.inertia * inertia}) != here) return std::nullopt;
    return here;
}

std::vector<ExpectedPoint> expected_points() {
    constexpr int across = 11, along = 8;
    std::vector<ExpectedPoint> out;
    for (int j = 0; j < along; ++j) // by I*, so that points of one disc are adjacent
        for (int i = 0; i < across; ++i) {
            const PhasePoint at{40.0 * std::pow(3e4 / 40.0, static_cast<double>(i) / (across - 1)),
                                5e-4 * std::pow(0.1 / 5e-4, static_cast<double>(j) / (along - 1))};
            if (const std::optional<Regime> regime = published_regime(at)) out.push_back({at, *regime});
        }
    return out;
}

SmallDiscFalls drop_small_disc(const SmallDisc& disc, const Asset& asset, uint32_t falls, double duration,
                               const Loads& loads) {
    const double unit = disc.diameter * disc.diameter / (disc.reynolds * Fluid{}.viscosity); // s, d/U
    Random random(7);
    std::vector<Start> starts(falls);
    for (Start& s : starts) s.orientation = random.orientation();
    Run run;
    run.loads = loads;
    run.dt = static_cast<float>(0.02 * unit);
    run.duration = duration * unit;
    run.interval = 0.1 * unit;
    const std::vector<Track> tracks = record(asset, run, starts);
    SmallDiscFalls out;
    for (const Track& t : tracks) {
        const Eigen::Vector3d displacement = t.samples[t.samples.size() / 2].position - t.samples.back().position;
        out.speed += displacement.y() / (0.5 * run.duration * falls);
    }
    for (Regime r : classify_all(tracks)) out.tumbling += r == Regime::tumbling ? 1.0 / falls : 0.0;
    return out;
}
} // namespace lr::scorecard
