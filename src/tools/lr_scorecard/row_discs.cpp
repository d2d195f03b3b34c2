// Rows for the filmed falls of paper discs.
#include "tools/lr_scorecard/disc_fall.h"
#include "tools/lr_scorecard/line_plot.h"
#include "tools/lr_scorecard/row.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace lr::scorecard {
namespace {

constexpr size_t cells = 8, sets = 3;
constexpr std::array<const char*, 4> size_colors{"#1f5fa8", "#2e7d43", "#b5402a", "#7a4a9c"};
constexpr std::array<double, 5> vz_parts{0.05, 0.25, 0.5, 0.75, 0.95};

struct CellFalls {
    std::array<std::vector<Fall>, sets> set;
    std::vector<Fall> all;
    CellStatistics of_all;
};

std::string name_of(const MeasuredCell& cell) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f mm %s", 1e3 * cell.radius, cell.release == Release::flat ? "flat" : "edge");
    return text;
}

DiscFallOptions options_of(const Context& context) {
    DiscFallOptions o;
    o.loads.load_model = context.loads.model;
    o.falls = context.quick ? std::min(context.seeds, 100U) : context.seeds;
    return o;
}

std::string draw_means(const std::array<CellFalls, cells>& all) {
    std::vector<LinePlot> plots;
    for (size_t q = 0; q < quantities.size(); ++q) {
        LinePlot plot{quantities[q].name, "mean radius (mm)",
                      std::string(quantities[q].name) + " (" + quantities[q].unit + ")"};
        plot.from_zero = true;
        plot.legend_width = 150.0;
        plot.note = "bars: two standard errors of the measured means";
        for (Release release : {Release::flat, Release::edge}) {
            const std::string label = release == Release::flat ? "flat" : "edge-on";
            const char* color = release == Release::flat ? "#1f5fa8" : "#b5402a";
            Series ours{"here, " + label, color, {}}, measured{"measured, " + label, color, {}};
            ours.marker = Marker::disc, measured.marker = Marker::ring;
            measured.line = false;
            for (size_t i = 0; i < cells; ++i) {
                const MeasuredCell& cell = measured_cells()[i];
                if (cell.release != release) continue;
                const double error = 2.0 * cell.deviation[q] / std::sqrt(cell.falls), radius = 1e3 * cell.radius;
                ours.points.push_back({radius, all[i].of_all.quantity[q].mean});
                measured.points.push_back({radius, cell.mean[q], cell.mean[q] - error, cell.mean[q] + error});
            }
            plot.series.push_back(ours);
            plot.series.push_back(measured);
        }
        plots.push_back(std::move(plot));
    }
    return draw(plots, 2);
}

// The library as lines, measured values as rings, one plot for each release.
template <class Ours, class Measured>
std::string draw_by_release(LinePlot frame, std::initializer_list<Release> drawn, Ours ours, Measured measured) {
    std::vector<LinePlot> plots;
    frame.legend_width = 115.0;
    frame.note = "lines: here; rings: measured";
    for (Release release : drawn) {
        LinePlot plot = frame;
        plot.title += release == Release::flat ? ", released flat" : ", released edge-on";
        for (size_t i = 0; i < cells; ++i) {
            const MeasuredCell& cell = measured_cells()[i];
            if (cell.release != release) continue;
            Series line{name_of(cell), size_colors[i / 2], ours(i)}, rings{"", size_colors[i / 2], measured(cell)};
            rings.line = false;
            rings.marker = Marker::ring;
            plot.series.push_back(std::move(line));
            plot.series.push_back(std::move(rings));
        }
        plots.push_back(std::move(plot));
    }
    return draw(plots, 2);
}

std::vector<PlotPoint> growth_points(const std::array<double, 12>& speeds) {
    std::vector<PlotPoint> points;
    for (size_t bin = 0; bin < speeds.size(); ++bin)
        if (speeds[bin] > 0.0) points.push_back({0.15 + 0.1 * static_cast<double>(bin), speeds[bin]});
    return points;
}

std::string draw_growth(const std::array<CellFalls, cells>& all) {
    return draw_by_release(
        {"Horizontal speed (rms)", "time (s)", "speed (m/s)"}, {Release::flat, Release::edge},
        [&](size_t i) { return growth_points(all[i].of_all.growth); },
        [](const MeasuredCell& cell) { return growth_points(cell.growth); });
}

std::string draw_descent_speeds(const std::array<CellFalls, cells>& all) {
    return draw_by_release(
        {"Instantaneous descent", "speed (m/s)", "share of the frames below it"}, {Release::flat, Release::edge},
        [&](size_t i) {
            std::vector<double> vz;
            for (const Fall& f : all[i].all)
                vz.insert(vz.end(), f.vz.begin() + static_cast<ptrdiff_t>(f.path.size() / 2), f.vz.end());
            std::sort(vz.begin(), vz.end());
            std::vector<PlotPoint> points;
            for (double part = 0.01; part < 0.995; part += 0.01) points.push_back({quantile(vz, part), part});
            return points;
        },
        [](const MeasuredCell& cell) {
            std::vector<PlotPoint> points;
            for (size_t k = 0; k < vz_parts.size(); ++k) points.push_back({cell.vz[k], vz_parts[k]});
            return points;
        });
}

std::string draw_paths(const std::array<CellFalls, cells>& all) {
    std::vector<LinePlot> plots;
    for (Release release : {Release::flat, Release::edge})
        for (size_t i = 0; i < cells; ++i) {
            if (measured_cells()[i].release != release) continue;
            LinePlot plot{name_of(measured_cells()[i]), "x (m)", "height (m)"};
            plot.equal_scale = true;
            for (size_t k = 0; k < std::min<size_t>(6, all[i].all.size()); ++k) {
                Series path{"", size_colors[k % 4], {}};
                path.width = 1.2;
                for (const Eigen::Vector3d& p : all[i].all[k].path) path.points.push_back({p.x(), p.y()});
                plot.series.push_back(std::move(path));
            }
            plots.push_back(std::move(plot));
        }
    return draw(plots, 4, {380.0, 420.0});
}

double rms_difference(const std::array<double, 12>& ours, const std::array<double, 12>& measured) {
    double squares = 0.0, bins = 0.0;
    for (size_t i = 0; i < measured.size(); ++i)
        if (measured[i] > 0.0) {
            squares += (ours[i] - measured[i]) * (ours[i] - measured[i]);
            bins += 1.0;
        }
    return std::sqrt(squares / bins);
}

// For each set of seeds: number of the forty means within 15 % of the measured ones, and the largest deviation.
void add_counts(RowResult& result, const std::array<CellFalls, cells>& all) {
    std::array<double, sets> within{}, worst{};
    for (size_t s = 0; s < sets; ++s)
        for (size_t i = 0; i < cells; ++i) {
            const CellStatistics ours = summarise_falls(all[i].set[s]);
            for (size_t q = 0; q < quantities.size(); ++q) {
                const double off = std::abs(ours.quantity[q].mean / measured_cells()[i].mean[q] - 1.0);
                within[s] += off <= 0.15 ? 1.0 : 0.0;
                worst[s] = std::max(worst[s], 100.0 * off);
            }
        }
    for (size_t s = 0; s < sets; ++s) {
        const std::string seeds = ", set of seeds " + std::to_string(s + 1);
        result.add("means within 15 % of the measured, of 40" + seeds, Rule::at_least, within[s], 38.0, 0.0);
        result.add("largest deviation of a mean" + seeds, Rule::at_most, worst[s], 30.0, 0.0, "%");
    }
}

void add_cell(RowResult& result, const MeasuredCell& cell, const CellStatistics& ours) {
    const std::string of = ", " + name_of(cell);
    result.add("spread of instantaneous descent" + of, Rule::relative, ours.vz.deviation, cell.vz_deviation, 0.2,
               "m/s");
    const std::array<double, 5> vz{ours.vz.p5, ours.vz.p25, ours.vz.p50, ours.vz.p75, ours.vz.p95};
    for (size_t k = 0; k < vz.size(); ++k)
        result.add("instantaneous descent, " + std::to_string(std::lround(100.0 * vz_parts[k])) + " % quantile" + of,
                   Rule::absolute, vz[k], cell.vz[k], 0.12, "m/s");
    const std::array<double, 3> vh{ours.vh.p5, ours.vh.p50, ours.vh.p95};
    for (size_t k = 0; k < vh.size(); ++k) {
        const double part = vz_parts[2 * k];
        result.add("instantaneous horizontal speed, " + std::to_string(std::lround(100.0 * part)) + " % quantile" + of,
                   Rule::compared, vh[k], cell.vh[k], 0.2, "m/s");
    }
    if (cell.release == Release::flat) {
        result.add("median time to 5 cm sideways" + of, Rule::absolute, ours.sideways.p50, 0.475, 0.125, "s");
        result.show("the same, measured" + of, cell.sideways, "s");
    }
    result.show("growth of horizontal speed, rms difference over bins" + of, rms_difference(ours.growth, cell.growth),
                "m/s");
    result.show("descent over time, rms difference over bins" + of,
                rms_difference(ours.growth_descent, cell.growth_descent), "m/s");
    result.show("mean duration" + of, ours.time.mean, "s");
}
} // namespace

RowResult run_discs(const Context& context) {
    RowResult result;
    const std::span<const MeasuredCell> measured = measured_cells();
    std::array<CellFalls, cells> all;
    const DiscFallOptions options = options_of(context);
    context.parallel(cells, [&](size_t i) {
        const std::vector<Asset> discs = bake_cell(measured[i]);
        for (size_t s = 0; s < sets; ++s) {
            DiscFallOptions o = options;
            o.seed = 1 + sets * i + s;
            all[i].set[s] = drop_cell(measured[i], discs, o);
            all[i].all.insert(all[i].all.end(), all[i].set[s].begin(), all[i].set[s].end());
        }
        all[i].of_all = summarise_falls(all[i].all);
    });
    add_counts(result, all);
    double lost = 0.0;
    for (const CellFalls& cell : all) lost += static_cast<double>(sets * options.falls - cell.all.size());
    result.add("falls that cannot be measured", Rule::at_most, lost, 0.0, 0.0);
    for (size_t q = 0; q < quantities.size(); ++q)
        for (size_t i = 0; i < cells; ++i)
            result.add(std::string(quantities[q].name) + ", " + name_of(measured[i]), Rule::compared,
                       all[i].of_all.quantity[q].mean, measured[i].mean[q], 0.15, quantities[q].unit);
    for (size_t i = 0; i < cells; ++i) add_cell(result, measured[i], all[i].of_all);
    result.remarks.push_back(std::to_string(sets) + " sets of " + std::to_string(options.falls) +
                             " falls a cell; single values are of all sets together.");
    result.pictures.push_back({"discs.svg", draw_means(all), "Paper discs: means against radius."});
    result.pictures.push_back({"growth.svg", draw_growth(all), "Paper discs: how they leave the vertical."});
    result.pictures.push_back(
        {"descent_speeds.svg", draw_descent_speeds(all), "Paper discs: distribution of instantaneous descent."});
    result.pictures.push_back(
        {"disc_paths.svg", draw_paths(all), "Paper discs: paths of six falls a cell, from the side."});
    return result;
}

RowResult run_time_step(const Context& context) {
    RowResult result;
    struct Step {
        const char* name;
        float dt;
        double tolerance;
    };
    static constexpr std::array<Step, 3> steps{
        {{"1 ms", 1e-3f, 0.0}, {"1/60 s", 1.0f / 60.0f, 0.05}, {"1/30 s", 1.0f / 30.0f, 0.10}}};
    // The landing's standard error is the largest: about 0.7 % at 8000 falls. Worlds of 1000 bodies bound the memory.
    const uint32_t worlds = context.quick ? 2 : 8;
    std::array<std::array<CellStatistics, cells>, steps.size()> at;
    context.parallel(cells, [&](size_t i) {
        const std::vector<Asset> discs = bake_cell(measured_cells()[i]);
        for (size_t k = 0; k < steps.size(); ++k) {
            DiscFallOptions options = options_of(context);
            options.dt = steps[k].dt;
            options.falls = 1000;
            std::vector<Fall> falls;
            for (uint32_t w = 0; w < worlds; ++w) {
                options.seed = 100 + worlds * i + w;
                for (Fall& f : drop_cell(measured_cells()[i], discs, options)) falls.push_back(std::move(f));
            }
            at[k][i] = summarise_falls(falls);
        }
    });
    for (size_t k = 1; k < steps.size(); ++k)
        for (size_t q = 0; q < quantities.size(); ++q)
            for (size_t i = 0; i < cells; ++i) {
                const double reference = at[0][i].quantity[q].mean;
                result.add(std::string(steps[k].name) + ": " + quantities[q].name + ", " + name_of(measured_cells()[i]),
                           Rule::relative, at[k][i].quantity[q].mean, reference, steps[k].tolerance,
                           quantities[q].unit);
            }
    result.remarks.push_back(std::to_string(1000 * worlds) + " falls a cell and step, 1 substep.");
    return result;
}
} // namespace lr::scorecard
