// Rows for the measured paper discs.
#include "tools/lr_scorecard/disc_fall.h"
#include "tools/lr_scorecard/line_plot.h"
#include "tools/lr_scorecard/row.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace lr::scorecard {
namespace {

struct Quantity {
    const char *name, *unit;
    double MeasuredDisc::*measured;
    Statistic DiscFalls::*ours;
    double FallMeasures::*single;
    double most; // upper end of the histogram
    size_t bins;
};
// Half a fall of 1.5 s has a whole number of peaks: each of 15 bins holds one number.
const std::array<Quantity, 4> quantities{
    {{"descent", "m/s", &MeasuredDisc::descent, &DiscFalls::descent, &FallMeasures::descent, 1.6, 32},
     {"horizontal speed", "m/s", &MeasuredDisc::horizontal_speed, &DiscFalls::horizontal_speed,
      &FallMeasures::horizontal_speed, 1.6, 32},
     {"drift angle", "deg", &MeasuredDisc::drift_angle, &DiscFalls::drift_angle, &FallMeasures::drift_angle, 90.0, 30},
     {"projected-area peaks", "1/s", &MeasuredDisc::peak_rate, &DiscFalls::peak_rate, &FallMeasures::peak_rate, 20.0,
      15}}};

constexpr std::array<const char*, 4> colors{"#1f5fa8", "#2e7d43", "#b5402a", "#7a4a9c"};

std::string millimetres(double radius) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f mm", 1e3 * radius);
    return text;
}

DiscFallOptions options_of(const Context& context) {
    DiscFallOptions o;
    o.loads.load_model = context.loads.model;
    o.falls = context.quick ? std::min(context.seeds, 200U) : context.seeds;
    return o;
}

std::string draw_means(const std::array<DiscFalls, 4>& all) {
    std::vector<LinePlot> plots;
    for (const Quantity& q : quantities) {
        LinePlot plot{q.name, "mean radius (mm)", std::string(q.name) + " (" + q.unit + ")"};
        plot.from_zero = true;
        plot.legend_width = 90.0;
        plot.note = "bars: 5th to 95th percentile of single falls";
        Series ours{"here", "#b5402a", {}}, measured{"measured", "#1f5fa8", {}};
        ours.marker = Marker::disc, measured.marker = Marker::ring;
        for (size_t i = 0; i < all.size(); ++i) {
            const Statistic& s = all[i].*q.ours;
            ours.points.push_back({1e3 * measured_discs[i].radius, s.mean, s.p5, s.p95});
            measured.points.push_back({1e3 * measured_discs[i].radius, measured_discs[i].*q.measured});
        }
        plot.series = {ours, measured};
        plots.push_back(std::move(plot));
    }
    return draw(plots, 2);
}

std::string draw_distributions(const std::array<DiscFalls, 4>& all) {
    std::vector<LinePlot> plots;
    for (const Quantity& q : quantities) {
        LinePlot plot{q.name, std::string(q.name) + " (" + q.unit + ")", "density"};
        plot.from_zero = true;
        plot.legend_width = 90.0;
        for (size_t i = 0; i < all.size(); ++i) {
            std::vector<double> values;
            for (const FallMeasures& f : all[i].falls) values.push_back(f.*q.single);
            plot.series.push_back(
                histogram(millimetres(measured_discs[i].radius), colors[i], values, 0.0, q.most, q.bins));
        }
        plots.push_back(std::move(plot));
    }
    return draw(plots, 2);
}
} // namespace

RowResult run_discs(const Context& context) {
    RowResult result;
    std::array<DiscFalls, 4> all;
    const DiscFallOptions options = options_of(context);
    context.parallel(all.size(), [&](size_t i) { all[i] = drop_discs(measured_discs[i].radius, options); });
    for (const Quantity& q : quantities)
        for (size_t i = 0; i < all.size(); ++i) {
            const Statistic& s = all[i].*q.ours;
            char error[48];
            std::snprintf(error, sizeof error, " (standard error %.2g)", s.standard_error);
            result.add(std::string(q.name) + ", " + millimetres(measured_discs[i].radius) + error, Rule::relative,
                       s.mean, measured_discs[i].*q.measured, 0.10, q.unit);
        }
    result.remarks.push_back(std::to_string(options.falls) +
                             " falls of 1.5 s a radius, released at rest, any orientation.");
    result.pictures.push_back({"discs.svg", draw_means(all), "Paper discs: means against radius."});
    result.pictures.push_back({"distributions.svg", draw_distributions(all), "Paper discs: single falls."});
    return result;
}

RowResult run_time_step(const Context& context) {
    RowResult result;
    // Enough falls for a standard error of about half a percent.
    DiscFallOptions fine = options_of(context);
    fine.falls = context.quick ? 2000 : 8000;
    DiscFallOptions coarse = fine;
    coarse.dt = 1.0f / 120.0f;
    std::array<DiscFalls, 4> at_fine, at_coarse;
    context.parallel(measured_discs.size(), [&](size_t i) {
        const Asset disc = paper_disc(measured_discs[i].radius, fine);
        at_fine[i] = drop_discs(disc, fine);
        at_coarse[i] = drop_discs(disc, coarse);
    });
    for (const Quantity& q : quantities)
        for (size_t i = 0; i < measured_discs.size(); ++i)
            result.add(std::string(q.name) + ", " + millimetres(measured_discs[i].radius), Rule::relative,
                       (at_coarse[i].*q.ours).mean, (at_fine[i].*q.ours).mean, 0.05, q.unit);
    return result;
}
} // namespace lr::scorecard
