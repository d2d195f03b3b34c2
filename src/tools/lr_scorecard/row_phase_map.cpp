#include "tools/lr_scorecard/line_plot.h"
#include "tools/lr_scorecard/phase_map.h"
#include "tools/lr_scorecard/row.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lr::scorecard {
namespace {

constexpr std::array<const char*, 4> colors{"#1f5fa8", "#2e7d43", "#b5402a", "#7a4a9c"};

struct Point {
    ExpectedPoint expected;
    PhaseResult result;
    double agreement = 0.0;
};

constexpr ptrdiff_t example_samples = 400;

// Keeps the end of the first track of each regime, for the picture.
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

std::string draw_map(const std::vector<Point>& points) {
    LinePlot plot{"Falling discs: Re and I*", "Re = U d/nu", "I* = pi rho_s t/(64 rho_f d)"};
    plot.log_x = plot.log_y = true;
    plot.legend_width = 150.0;
    plot.note = "filled: most seeds fall as the map says; rings: they do not";
    static constexpr const char* kinds[] = {"steady | periodic", "periodic | chaotic", "chaotic | tumbling"};
    for (size_t kind = 0; kind < 3; ++kind) {
        static constexpr const char* greys[] = {"#b0b0b0", "#7d7d7d", "#303030"};
        Series line{kinds[kind], greys[kind], {}};
        line.dashed = kind == 1;
        line.width = 1.2;
        for (const BoundaryPoint& b : boundary_points())
            if (static_cast<size_t>(b.kind) == kind) line.points.push_back({b.at.reynolds, b.at.inertia});
        if (kind == 0) { // a band of Re
            const double at[2] = {line.points[0].x, line.points[1].x};
            for (double re : at) {
                Series edge = line;
                edge.name = re == at[0] ? line.name : "";
                edge.points = {{re, 0.0025}, {re, 0.012}};
                plot.series.push_back(edge);
            }
            continue;
        }
        plot.series.push_back(line);
    }
    for (size_t regime = 0; regime < regime_names.size(); ++regime)
        for (bool agrees : {true, false}) {
            Series s{agrees ? regime_names[regime] : "", colors[regime], {}};
            s.line = false;
            s.marker = agrees ? Marker::disc : Marker::ring;
            for (const Point& p : points) {
                const auto most = std::max_element(p.result.share.begin(), p.result.share.end());
                if (static_cast<size_t>(most - p.result.share.begin()) == regime && (p.agreement >= 0.5) == agrees)
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
        // Projected on the vertical plane of the disc's swing: the direction of the normal's largest horizontal spread.
        Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
        for (const Sample& s : track.samples) {
            const Eigen::Vector3d n = s.orientation * Eigen::Vector3d::UnitZ();
            spread += Eigen::Vector2d(n.x(), n.z()) * Eigen::Vector2d(n.x(), n.z()).transpose();
        }
        const Eigen::Vector2d side = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(1);
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
        for (size_t i = 0; i < track.samples.size(); i += 8) { // the disc edge on, a line
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
                  "Re %.0f, I* %.4f: %.0f %% steady, %.0f %% periodic, %.0f %% chaotic, %.0f %% tumbling; map:",
                  p.result.measured.reynolds, p.result.measured.inertia, 100.0 * p.result.share[0],
                  100.0 * p.result.share[1], 100.0 * p.result.share[2], 100.0 * p.result.share[3]);
    std::string out = text;
    for (size_t i = 0; i < p.expected.allowed.size(); ++i)
        out += std::string(i > 0 ? " or " : " ") + regime_names[static_cast<size_t>(p.expected.allowed[i])];
    return out;
}
} // namespace

RowResult run_phase_map(const Context& context) {
    RowResult result;
    PhaseOptions options;
    options.loads.load_model = context.loads.model;
    options.seeds = context.quick ? 8 : context.phase_seeds;
    if (context.quick) options.duration = 200.0;
    std::vector<Point> points;
    for (const ExpectedPoint& e : expected_points()) points.push_back({e, {}, 0.0});
    context.parallel(points.size(), [&](size_t i) {
        Point& p = points[i];
        p.result = run_phase_point(p.expected.at, options, true);
        p.agreement = agreement(p.result, p.expected);
        keep_examples(p.result);
    });
    double all = 0.0;
    std::array<std::array<double, 2>, 3> agreed{}, count{}; // [boundary][side]
    for (const Point& p : points) {
        const auto kind = static_cast<size_t>(boundary_points()[p.expected.boundary].kind);
        // Beyond a boundary the last allowed regime is past it; before it, none is.
        const size_t side = static_cast<size_t>(p.expected.allowed.back()) > kind ? 1 : 0;
        all += p.agreement / static_cast<double>(points.size());
        agreed[kind][side] += p.agreement;
        count[kind][side] += 1.0;
    }
    result.add("agreement over all points", Rule::at_least, all, 0.8, 0.0);
    static constexpr const char* kinds[] = {"steady to periodic", "periodic to chaotic", "chaotic to tumbling"};
    for (size_t k = 0; k < 3; ++k)
        result.add(std::string("agreement, ") + kinds[k] + ", both sides", Rule::at_least,
                   (agreed[k][0] + agreed[k][1]) / (count[k][0] + count[k][1]), 0.8, 0.0);
    for (size_t k = 0; k < 3; ++k)
        for (size_t side = 0; side < 2; ++side)
            result.add(std::string("agreement, ") + (side == 0 ? "before " : "beyond ") + kinds[k], Rule::at_least,
                       agreed[k][side] / count[k][side], 0.8, 0.0);
    for (const Point& p : points) result.show(describe(p), p.agreement);
    result.remarks.push_back(std::to_string(options.seeds) + " releases a point, tilted by up to 5 degrees.");
    result.pictures.push_back(
        {"phase_map.svg", draw_map(points), "Our points over the boundaries of Field et al. 1997."});
    result.pictures.push_back(
        {"regimes.svg", draw_paths(points, options.diameter), "Paths by regime, the disc seen edge on."});
    return result;
}
} // namespace lr::scorecard
