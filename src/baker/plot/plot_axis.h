// Axes of plots: ranges, ticks and number formats.
#pragma once

#include "baker/plot/svg.h"

#include <string>
#include <vector>

namespace lr::baker {

struct Tick {
    double value;
    std::string label; // empty for minor ticks
};

class Axis {
public:
    // Logarithmic if low is positive and high at least 20 times low. Ends on whole ticks. A linear axis includes 0 if that takes at most a fifth of
    // its length.
    static Axis fitting(double low, double high);
    static Axis linear(double low, double high, int most_ticks);
    // From 0 to exactly `high`.
    static Axis up_to(double high, int most_ticks);
    static Axis logarithmic(double low, double high);

    // 0 at the beginning, 1 at the end; clamped.
    double at(double value) const;
    const std::vector<Tick>& ticks() const { return ticks_; }
    bool is_logarithmic() const { return logarithmic_; }
    double low() const { return low_; }
    double high() const { return high_; }
    // Power of ten that multiplies the labels, to be printed before the unit: "10⁻³ " or empty.
    const std::string& factor() const { return factor_; }

private:
    double low_ = 0.0, high_ = 1.0;
    bool logarithmic_ = false;
    std::vector<Tick> ticks_;
    std::string factor_;
};

// The frame of a panel, with the position of values in it.
struct PlotFrame {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
    Axis horizontal, vertical;

    SvgPoint at(double h, double v) const {
        return {x + width * horizontal.at(h), y + height * (1.0 - vertical.at(v))};
    }
    // Draws box, grid, ticks and labels; labels of the horizontal axis only if `label_horizontal`.
    void draw(Svg& svg, bool label_horizontal) const;
    // Draws the title of the vertical axis, rotated, left of its labels.
    void draw_title(Svg& svg, const std::string& text) const;
};

// "1.23×10⁻⁵", "0.0123", "−4.5"
std::string paper_number(double value, int digits);

// "10⁻³"
std::string power_of_ten(int exponent);

// At most `most` characters, cut with an ellipsis.
std::string shortened(const std::string& utf8, std::size_t most);
} // namespace lr::baker
