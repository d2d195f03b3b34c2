// Lines, points and histograms in a frame with axes, as SVG.
#pragma once

#include <string>
#include <vector>

namespace lr::scorecard {

struct PlotPoint {
    double x = 0.0, y = 0.0;
    double low = 0.0, high = 0.0; // of an error bar, if they differ
};

enum class Marker : uint8_t { none, disc, ring };

struct Series {
    std::string name, color;
    std::vector<PlotPoint> points;
    bool line = true;
    Marker marker = Marker::none;
    bool dashed = false;
    double width = 1.8;
};

struct LinePlot {
    std::string title, x_title, y_title;
    std::vector<Series> series = {};
    bool log_x = false, log_y = false;
    bool equal_scale = false;  // same scale on both axes
    bool from_zero = false;    // the vertical axis
    std::string note = {};     // below the title
    double legend_width = 0.0; // px to the right of the frame; 0: inside, top right
};

// Draws several plots in rows of `across` each.
struct PanelSize {
    double width = 520.0, height = 400.0; // px
};
std::string draw(const std::vector<LinePlot>& plots, size_t across, PanelSize panel = {});
inline std::string draw(const LinePlot& plot, PanelSize panel = {}) {
    return draw(std::vector{plot}, 1, panel);
}

// Probability density of the values in equal bins, as a step curve.
Series histogram(const std::string& name, const std::string& color, const std::vector<double>& values, double low,
                 double high, size_t bins);
} // namespace lr::scorecard
