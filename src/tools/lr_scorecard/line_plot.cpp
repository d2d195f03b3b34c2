#include "tools/lr_scorecard/line_plot.h"

#include "baker/plot/plot_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lr::scorecard {
namespace {

using baker::Axis;
using baker::PlotFrame;
using baker::Svg;
using baker::SvgPoint;

constexpr double left = 78.0, right = 20.0, top = 62.0, bottom = 56.0;
constexpr double legend_line = 16.0;

struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void add(double v) {
        if (!std::isfinite(v)) return;
        low = std::min(low, v);
        high = std::max(high, v);
    }
    void widen() {
        if (!(low <= high)) low = 0.0, high = 1.0;
        if (low == high) low -= 0.5, high += 0.5;
    }
};

Axis axis(Range r, bool logarithmic, int ticks) {
    r.widen();
    if (logarithmic && r.low > 0.0) return Axis::logarithmic(r.low, r.high);
    return Axis::linear(r.low, r.high, ticks);
}

PlotFrame frame_of(const LinePlot& plot, SvgPoint corner, PanelSize panel) {
    Range x, y;
    for (const Series& s : plot.series)
        for (const PlotPoint& p : s.points) {
            x.add(p.x);
            y.add(p.y);
            if (p.low < p.high) {
                y.add(p.low);
                y.add(p.high);
            }
        }
    if (plot.from_zero) y.add(0.0);
    PlotFrame frame;
    frame.x = corner.x + left;
    frame.y = corner.y + top;
    frame.width = panel.width - left - right - plot.legend_width;
    frame.height = panel.height - top - bottom;
    if (plot.equal_scale) {
        x.widen();
        y.widen();
        const double unit = std::max((x.high - x.low) / frame.width, (y.high - y.low) / frame.height);
        const auto stretch = [](Range& r, double length) {
            const double more = 0.5 * (length - (r.high - r.low));
            r.low -= more;
            r.high += more;
        };
        stretch(x, 1.02 * unit * frame.width);
        stretch(y, 1.02 * unit * frame.height);
        // Axes end on whole ticks, so equal scales hold only to a tick.
    }
    frame.horizontal = axis(x, plot.log_x, 6);
    frame.vertical = axis(y, plot.log_y, 6);
    return frame;
}

void draw_marker(Svg& svg, SvgPoint at, const Series& s) {
    if (s.marker == Marker::disc) svg.circle(at, 4.0, "fill=\"" + s.color + "\"");
    if (s.marker == Marker::ring) svg.circle(at, 4.0, "fill=\"white\" stroke-width=\"1.4\" stroke=\"" + s.color + "\"");
}

void draw_series(Svg& svg, const PlotFrame& frame, const Series& s) {
    std::vector<SvgPoint> line;
    const size_t stride = s.points.size() / 4000 + 1; // the resolution of the picture
    for (size_t i = 0; i < s.points.size(); i += stride) line.push_back(frame.at(s.points[i].x, s.points[i].y));
    if (s.line && line.size() > 1)
        svg.polyline(line, "fill=\"none\" stroke-linejoin=\"round\" stroke-width=\"" + baker::svg_number(s.width) +
                               "\" stroke=\"" + s.color + "\"" + (s.dashed ? " stroke-dasharray=\"6 4\"" : ""));
    const std::string stroke = "stroke-width=\"1.4\" stroke=\"" + s.color + "\"";
    for (const PlotPoint& p : s.points) {
        if (p.low < p.high) svg.line(frame.at(p.x, p.low), frame.at(p.x, p.high), stroke);
        draw_marker(svg, frame.at(p.x, p.y), s);
    }
}

void draw_legend(Svg& svg, const PlotFrame& frame, const LinePlot& plot) {
    const bool outside = plot.legend_width > 0.0;
    const double x = frame.x + frame.width + (outside ? 14.0 : -28.0); // left end of the line sample, 16 px wide
    double y = frame.y + 16.0;
    for (const Series& s : plot.series) {
        if (s.name.empty()) continue;
        svg.text({outside ? x + 24.0 : x - 8.0, y + 4.0}, s.name,
                 outside ? R"(fill="#222")"
                         : R"(text-anchor="end" stroke="white" stroke-width="3" paint-order="stroke" fill="#222")");
        if (s.line)
            svg.line({x, y}, {x + 16.0, y},
                     "stroke-width=\"2\" stroke=\"" + s.color + "\"" + (s.dashed ? " stroke-dasharray=\"5 3\"" : ""));
        draw_marker(svg, {x + 8.0, y}, s);
        y += legend_line;
    }
}

std::string with_factor(const std::string& title, const std::string& factor) {
    return factor.empty() ? title : title + "  (" + factor + ")";
}
} // namespace

std::string draw(const std::vector<LinePlot>& plots, size_t across, PanelSize panel) {
    const size_t columns = std::max<size_t>(1, std::min(across, plots.size())),
                 rows = (plots.size() + columns - 1) / columns;
    Svg svg(panel.width * static_cast<double>(columns), panel.height * static_cast<double>(rows),
            plots.empty() ? "" : plots[0].title, "lr_scorecard");
    for (size_t i = 0; i < plots.size(); ++i) {
        const LinePlot& plot = plots[i];
        const SvgPoint corner{panel.width * static_cast<double>(i % columns),
                              panel.height * static_cast<double>(i / columns)};
        const PlotFrame frame = frame_of(plot, corner, panel);
        svg.text({frame.x, corner.y + 26.0}, plot.title, R"(font-size="15" font-weight="bold")");
        svg.text({frame.x, corner.y + 46.0}, plot.note, R"(fill="#444")");
        frame.draw(svg, true);
        frame.draw_title(svg, with_factor(plot.y_title, frame.vertical.factor()));
        svg.text({frame.x + 0.5 * frame.width, frame.y + frame.height + 40.0},
                 with_factor(plot.x_title, frame.horizontal.factor()), R"(text-anchor="middle" font-size="13")");
        for (const Series& s : plot.series) draw_series(svg, frame, s);
        draw_legend(svg, frame, plot);
    }
    return svg.finish();
}

Series histogram(const std::string& name, const std::string& color, const std::vector<double>& values, double low,
                 double high, size_t bins) {
    std::vector<double> counts(bins, 0.0);
    const double width = (high - low) / static_cast<double>(bins);
    for (double v : values)
        if (v >= low && v < high) counts[std::min(bins - 1, static_cast<size_t>((v - low) / width))] += 1.0;
    Series s{name, color, {}};
    for (size_t i = 0; i < bins; ++i) {
        const double x = low + width * static_cast<double>(i);
        const double density = counts[i] / (static_cast<double>(std::max<size_t>(1, values.size())) * width);
        s.points.push_back({x, density});
        s.points.push_back({x + width, density});
    }
    return s;
}
} // namespace lr::scorecard
