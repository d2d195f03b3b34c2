#include "baker/eigensystem.h"
#include "tools/lr_scorecard/line_plot.h"
#include "tools/lr_scorecard/measured_bodies.h"
#include "tools/lr_scorecard/phase_map.h"
#include "tools/lr_scorecard/row.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>

namespace lr::scorecard {
namespace {

constexpr std::array<const char*, 4> colors{"#1f5fa8", "#2e7d43", "#b5402a", "#7a4a9c"};

struct Point {
    ExpectedPoint expected;
    PhaseResult result;

    bool agrees() const { return result.most(expected.regime); }
};

constexpr std::array<double, 6> onset_inertia{0.0005, 0.002, 0.004, 0.01, 0.02, 0.04};

constexpr ptrdiff_t example_samples = 400;

// Keeps the end of one track of each regime, for the picture.
void keep_examples(PhaseResult& result) {
    std::vector<Track> kept(regime_names.size());
    for (size_t i = 0; i < result.tracks.size(); ++i) {
        Track& slot = kept[static_cast<size_t>(result.regimes[i])];
        if (!slot.samples.empty()) continue;
        slot = std::move(result.tracks[i]);
        slot.samples.erase(slot.samples.begin(),
                           slot.samples.end() - std::min(example_samples, std::ssize(slot.samples)));
    }
    result.tracks = std::move(kept);
}

// The result with the largest share of this regime.
const PhaseResult* clearest(const std::vector<Point>& points, size_t regime) {
    const PhaseResult* best = nullptr;
    for (const Point& p : points)
        if (p.result.share[regime] > (best ? best->share[regime] : 0.0)) best = &p.result;
    return best;
}

std::string draw_map(const std::vector<Point>& points, const std::array<Onset, onset_inertia.size()>& onsets) {
    LinePlot plot{"Falling discs: Re and I*", "Re = U d/nu", "I* = pi rho_s t/(64 rho_f d)"};
    plot.log_x = plot.log_y = true;
    plot.legend_width = 150.0;
    plot.note = "filled: most discs fall as the map says; rings: they do not";
    const auto line = [&](const char* name, const char* color, std::vector<PlotPoint> at) {
        Series s{name, color, std::move(at)};
        s.width = 1.2;
        plot.series.push_back(std::move(s));
    };
    const auto along = [](std::span<const PhasePoint> boundary) {
        std::vector<PlotPoint> out;
        for (const PhasePoint& p : boundary) out.push_back({p.reynolds, p.inertia});
        return out;
    };
    line("steady | periodic", "#b0b0b0", {{first_onset, 5e-4}, {first_onset, 0.1}});
    line("", "#b0b0b0", {{last_onset, 5e-4}, {last_onset, 0.1}});
    line("periodic | chaotic", "#7d7d7d", along(chaotic_boundary()));
    line("chaotic | tumbling", "#303030", along(tumbling_boundary()));
    Series onset{"our onset", "#000000", {}};
    onset.dashed = true;
    for (size_t i = 0; i < onsets.size(); ++i)
        if (std::isfinite(onsets[i].reynolds)) onset.points.push_back({onsets[i].reynolds, onset_inertia[i]});
    plot.series.push_back(std::move(onset));
    for (size_t regime = 0; regime < regime_names.size(); ++regime)
        for (bool agrees : {true, false}) {
            Series s{agrees ? regime_names[regime] : "", colors[regime], {}};
            s.line = false;
            s.marker = agrees ? Marker::disc : Marker::ring;
            for (const Point& p : points) {
                const auto most = std::max_element(p.result.share.begin(), p.result.share.end());
                if (static_cast<size_t>(most - p.result.share.begin()) == regime && p.agrees() == agrees)
                    s.points.push_back({p.result.measured.reynolds, p.result.measured.inertia});
            }
            plot.series.push_back(std::move(s));
        }
    return draw(plot, {860.0, 520.0});
}

std::string draw_paths(const std::vector<Point>& points, double diameter) {
    std::vector<LinePlot> plots;
    for (size_t regime = 0; regime < regime_names.size(); ++regime) {
        const PhaseResult* example = clearest(points, regime);
        if (!example) continue;
        const Track& track = example->tracks[regime];
        const Sample& first = track.samples.front();
        // Projected on the vertical plane of the disc's swing, along the largest horizontal spread of the normal.
        Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
        for (const Sample& s : track.samples) {
            const Eigen::Vector3d n = s.orientation * Eigen::Vector3d::UnitZ();
            spread += Eigen::Vector2d(n.x(), n.z()) * Eigen::Vector2d(n.x(), n.z()).transpose();
        }
        const Eigen::Vector2d side = baker::eigensystem(spread).vectors.col(1);
        const Eigen::Vector3d across(side.x(), 0.0, side.y());
        const auto place = [&](const Eigen::Vector3d& p) -> PlotPoint {
            const Eigen::Vector3d r = (p - first.position) / diameter;
            return {across.dot(r), r.y()};
        };
        char title[96];
        std::snprintf(title, sizeof title, "%s: Re %.0f, I* %.4f", regime_names[regime], example->measured.reynolds,
                      example->measured.inertia);
        LinePlot plot{title, "x/d", "y/d"};
        plot.equal_scale = true;
        Series path{"", colors[regime], {}};
        for (const Sample& s : track.samples) path.points.push_back(place(s.position));
        plot.series.push_back(path);
        for (size_t i = 0; i < track.samples.size(); i += 8) { // the disc edge-on, as a line
            const Sample& s = track.samples[i];
            const Eigen::Vector3d n = s.orientation * Eigen::Vector3d::UnitZ(), view = across.cross(up());
            const Eigen::Vector3d edge = 0.5 * diameter * n.cross(view);
            Series disc{"", "#555555", {place(s.position - edge), place(s.position + edge)}};
            disc.width = 0.8;
            plot.series.push_back(std::move(disc));
        }
        plots.push_back(std::move(plot));
    }
    return draw(plots, 2);
}

std::string describe(const Point& p) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "Re %.0f, I* %.4f: %.0f %% steady, %.0f %% periodic, %.0f %% chaotic, %.0f %% tumbling; map: %s",
                  p.result.measured.reynolds, p.result.measured.inertia, 100.0 * p.result.share[0],
                  100.0 * p.result.share[1], 100.0 * p.result.share[2], 100.0 * p.result.share[3],
                  regime_names[static_cast<size_t>(p.expected.regime)]);
    return text;
}

void add_agreement(RowResult& result, const std::vector<Point>& points) {
    std::array<double, 4> right{}, count{};
    for (const Point& p : points) {
        count[static_cast<size_t>(p.expected.regime)] += 1.0;
        right[static_cast<size_t>(p.expected.regime)] += p.agrees() ? 1.0 : 0.0;
    }
    result.add("share of " + std::to_string(points.size()) + " points where most discs fall as the map says",
               Rule::at_least, std::accumulate(right.begin(), right.end(), 0.0) / static_cast<double>(points.size()),
               0.85, 0.0);
    for (size_t r = 0; r < regime_names.size(); ++r) {
        const std::string what = std::string("the same, of the ") + std::to_string(std::lround(count[r])) +
                                 " points of " + regime_names[r] + " discs";
        if (static_cast<Regime>(r) == Regime::tumbling) // discs must tumble above I* 0.04 in any case
            result.add(what, Rule::at_least, right[r] / count[r], 0.85, 0.0);
        else
            result.show(what, right[r] / count[r]);
    }
}
} // namespace

RowResult run_phase_map(const Context& context) {
    RowResult result;
    PhaseOptions options;
    options.loads.load_model = context.loads.model;
    options.seeds = context.quick ? 8 : context.phase_seeds;
    if (context.quick) options.duration = 200.0;
    std::vector<Point> points;
    for (const ExpectedPoint& e : expected_points()) points.push_back({e, {}});
    std::array<Onset, onset_inertia.size()> onsets{};
    std::array<SmallDiscFalls, small_discs.size()> small;
    std::map<double, Asset> discs; // by I*
    for (const Point& p : points) discs[p.expected.at.inertia] = nullptr;
    for (double inertia : onset_inertia) discs[inertia] = nullptr;
    for (auto& [inertia, disc] : discs) disc = phase_disc(inertia, options);
    const size_t others = onsets.size() + small.size();
    context.parallel(others + points.size(), [&](size_t i) { // longest jobs first
        if (i < onsets.size()) {
            const double inertia = onset_inertia[i];
            onsets[i] = onset_of_motion(
                [&](double re) {
                    return run_phase_point(discs.at(inertia), {re, inertia}, options);
                },
                context.quick ? 4 : 6);
        } else if (i < others) {
            const SmallDisc& disc = small_discs[i - onsets.size()];
            small[i - onsets.size()] = drop_small_disc(disc, disc_sinking_at(disc.reynolds, disc.diameter),
                                                       context.quick ? 100 : 400, 1000.0, options.loads);
        } else {
            Point& p = points[i - others];
            p.result = run_phase_point(discs.at(p.expected.at.inertia), p.expected.at, options, true);
            keep_examples(p.result);
        }
    });
    for (size_t i = 0; i < onsets.size(); ++i) {
        char what[64];
        std::snprintf(what, sizeof what, "smallest Re of discs that are not steady, I* %g", onset_inertia[i]);
        result.add(what, Rule::absolute, onsets[i].reynolds, 125.0, 35.0);
        result.add("share of these that is periodic", Rule::at_least, onsets[i].periodic, 0.5, 0.0);
    }
    add_agreement(result, points);
    double slowest = 0.0;
    for (const Point& p : points)
        if (p.expected.at.inertia < 1e-3) slowest = std::max(slowest, p.result.drag);
    result.add("largest mean drag below I* 0.001, over that broadside", Rule::at_most, slowest, 2.0, 0.0);
    result.add("discs of 1 mm in air: share that tumbles, beyond that of 3 mm", Rule::at_least,
               small[0].tumbling - small[1].tumbling, 0.05, 0.0);
    for (size_t i = 0; i < small.size(); ++i) {
        const double diameter = small_discs[i].diameter;
        const std::string of = ", discs of " + std::to_string(std::lround(1e3 * diameter)) + " mm";
        result.show("share that tumbles" + of, small[i].tumbling);
        result.show("Re of the fall" + of, small[i].speed * diameter / Fluid{}.viscosity);
    }
    for (const Point& p : points) result.show(describe(p), p.agrees() ? 1.0 : 0.0);
    result.remarks.push_back(std::to_string(options.seeds) + " releases a point, tilted by up to 5 degrees.");
    result.pictures.push_back(
        {"phase_map.svg", draw_map(points, onsets), "Our points over the boundaries of Field et al. 1997."});
    result.pictures.push_back(
        {"regimes.svg", draw_paths(points, options.diameter), "Paths by regime, the disc seen edge on."});
    return result;
}
} // namespace lr::scorecard
