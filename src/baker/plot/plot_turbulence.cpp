#include "baker/plot/plot_axis.h"
#include "baker/plot/plots.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lr::baker {
namespace {

struct Curve {
    const char* symbol;
    const char* unit;
    const char* color;
    std::vector<double> values;
};

std::vector<Curve> curves_of(const AssetData& a) {
    const double rate = a.u0 / a.length_l, dissipation = a.u0 * a.u0 * rate;
    std::vector<Curve> curves{{"k", "m\xc2\xb2/s\xc2\xb2", "#1f5fa8", {}},
                              {"\xce\xb5", "m\xc2\xb2/s\xc2\xb3", "#b5402a", {}},
                              {"\xcf\x87", "1/s", "#2e7d43", {}}};
    for (std::size_t i = 0; i < std::min(a.turbulence.chi.size(), a.turbulence.epsilon.size()); ++i) {
        const double chi = a.turbulence.chi[i] * rate, epsilon = a.turbulence.epsilon[i] * dissipation;
        curves[0].values.push_back(chi > 0.0 ? epsilon / chi : 0.0);
        curves[1].values.push_back(epsilon);
        curves[2].values.push_back(chi);
    }
    return curves;
}

struct TimeUnit {
    const char* name;
    double per_second;
};

TimeUnit time_unit(double duration) {
    if (duration < 5e-4) return {"\xc2\xb5s", 1e6};
    if (duration < 0.5) return {"ms", 1e3};
    return {"s", 1.0};
}
} // namespace

std::string plot_turbulence(const AssetData& a) {
    constexpr double left = 92.0, width = 560.0, top = 92.0, height = 150.0, gap = 24.0;
    const std::vector<Curve> curves = curves_of(a);
    Svg svg(left + width + 28.0, top + 3.0 * height + 2.0 * gap + 56.0, "Turbulence of " + a.name, plot_description(a));
    svg.text({left, 30.0}, "Turbulence of " + shortened(a.name, 48), R"(font-size="17" font-weight="bold")");
    const TurbulenceData& t = a.turbulence;
    std::string how = "U\xe2\x82\x80 = " + paper_number(a.u0, 3) + " m/s,  l = " + paper_number(1e3 * a.length_l, 3) +
                      " mm,  Re = " + paper_number(a.reynolds(), 3) + ",  intensity " +
                      paper_number(100.0 * t.intensity, 3) + " %,  C\xe2\x82\x80 = " + paper_number(t.c0, 3) +
                      ",  grid ";
    for (std::size_t i = 0; i < 3; ++i) how += (i > 0 ? "\xc3\x97" : "") + std::to_string(t.cells[i]);
    svg.text({left, 50.0}, how, R"(fill="#444")");

    const std::size_t n = curves[0].values.size();
    const double dt = t.dt * a.length_l / a.u0, duration = dt * static_cast<double>(n > 1 ? n - 1 : 1);
    const TimeUnit unit = time_unit(duration);
    const bool marked = t.stationary < n;
    if (marked) {
        svg.circle({left + 4.0, 70.0}, 4.0, R"(fill="#222")");
        svg.text({left + 14.0, 74.0},
                 "stationary state, for the SPEED clock:  k = " + paper_number(curves[0].values[t.stationary], 3) +
                     " m\xc2\xb2/s\xc2\xb2,  \xce\xb5 = " + paper_number(curves[1].values[t.stationary], 3) +
                     " m\xc2\xb2/s\xc2\xb3,  \xcf\x87 = " + paper_number(curves[2].values[t.stationary], 3) + " /s",
                 R"(fill="#444")");
    }
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const Curve& curve = curves[c];
        PlotFrame frame;
        frame.x = left;
        frame.y = top + static_cast<double>(c) * (height + gap);
        frame.width = width;
        frame.height = height;
        frame.horizontal = Axis::up_to(duration * unit.per_second, 8);
        const auto [low, high] = std::minmax_element(curve.values.begin(), curve.values.end());
        frame.vertical = n > 0 ? Axis::fitting(*low, *high) : Axis::linear(0.0, 1.0, 5);
        frame.draw(svg, c + 1 == curves.size());
        frame.draw_title(svg, std::string(curve.symbol) + "  (" + frame.vertical.factor() + curve.unit + ")");
        std::vector<SvgPoint> line;
        const std::size_t stride = n / 4096 + 1; // the resolution of the picture
        for (std::size_t i = 0; i < n; i += stride)
            line.push_back(frame.at(dt * static_cast<double>(i) * unit.per_second, curve.values[i]));
        if (line.size() == 1) line.push_back({frame.x + frame.width, line[0].y});
        if (marked) {
            const SvgPoint p =
                frame.at(dt * static_cast<double>(t.stationary) * unit.per_second, curve.values[t.stationary]);
            svg.line({frame.x, p.y}, {frame.x + width, p.y},
                     R"(stroke="#222" stroke-width="0.8" stroke-dasharray="4 4")");
        }
        if (!line.empty())
            svg.polyline(line, std::string(R"(fill="none" stroke-width="1.8" stroke-linejoin="round" stroke=")") +
                                   curve.color + "\"");
        if (marked)
            svg.circle(frame.at(dt * static_cast<double>(t.stationary) * unit.per_second, curve.values[t.stationary]),
                       4.0, R"(fill="#222")");
    }
    svg.text({left + 0.5 * width, top + 3.0 * height + 2.0 * gap + 38.0},
             "time  (" + Axis::up_to(duration * unit.per_second, 8).factor() + unit.name + ")",
             R"(text-anchor="middle" font-size="13")");
    return svg.finish();
}
} // namespace lr::baker
