#include "baker/plot/plot_axis.h"

#include "baker/printable_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace lr::baker {
namespace {

constexpr const char* minus = "\xe2\x88\x92";

double ten_to(int exponent) {
    return std::pow(10.0, exponent);
}

int decade_of(double value) {
    return static_cast<int>(std::floor(std::log10(value) + 1e-9));
}

std::string fixed(double value, int decimals) {
    char buffer[64];
    const std::to_chars_result end =
        std::to_chars(buffer, buffer + sizeof buffer, std::abs(value), std::chars_format::fixed, decimals);
    if (end.ec != std::errc{}) return "0";
    const std::string text(buffer, end.ptr);
    const bool zero = text.find_first_not_of("0.") == std::string::npos;
    return value < 0.0 && !zero ? minus + text : text;
}

std::string superscript(int number) {
    static constexpr const char* digits[] = {"\xe2\x81\xb0", "\xc2\xb9",     "\xc2\xb2",     "\xc2\xb3",
                                             "\xe2\x81\xb4", "\xe2\x81\xb5", "\xe2\x81\xb6", "\xe2\x81\xb7",
                                             "\xe2\x81\xb8", "\xe2\x81\xb9"};
    std::string text;
    for (const char c : std::to_string(number)) text += c == '-' ? "\xe2\x81\xbb" : digits[c - '0'];
    return text;
}

// 1, 2 or 5 times a power of ten that gives at most `most` ticks.
double tick_step(double range, int most) {
    const double least = range / most;
    const double decade = ten_to(decade_of(least));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * decade >= least * (1.0 - 1e-9)) return factor * decade;
    return 10.0 * decade;
}
} // namespace

std::string power_of_ten(int exponent) {
    return "10" + superscript(exponent);
}

std::string paper_number(double value, int digits) {
    if (value == 0.0 || !std::isfinite(value)) return "0";
    char buffer[64];
    const std::to_chars_result end = std::to_chars(buffer, buffer + sizeof buffer, std::abs(value),
                                                   std::chars_format::scientific, std::max(digits - 1, 0));
    const std::string text(buffer, end.ptr);
    const std::size_t e = text.find('e');
    int exponent = 0;
    std::from_chars(text.data() + e + (text[e + 1] == '+' ? 2 : 1), text.data() + text.size(), exponent);
    if (exponent >= -3 && exponent < std::max(digits, 4)) return fixed(value, std::max(digits - 1 - exponent, 0));
    return (value < 0.0 ? minus : "") + text.substr(0, e) + "\xc3\x97" + power_of_ten(exponent);
}

std::string shortened(const std::string& utf8, std::size_t most) {
    const std::string text = printable(utf8);
    std::size_t characters = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if ((static_cast<unsigned char>(text[i]) & 0xc0) == 0x80) continue;
        if (characters++ == most) return text.substr(0, i) + "\xe2\x80\xa6";
    }
    return text;
}

Axis Axis::linear(double low, double high, int most_ticks) {
    Axis axis;
    if (!(high > low)) high = low + (low == 0.0 ? 1.0 : 0.1 * std::abs(low));
    const double step = tick_step(high - low, most_ticks);
    const double first = std::floor(low / step + 1e-9), last = std::ceil(high / step - 1e-9);
    axis.low_ = first * step;
    axis.high_ = last * step;
    const double largest = std::max(std::abs(axis.low_), std::abs(axis.high_));
    int shift = 0;
    if (largest >= 1e4 || largest < 1e-2) shift = decade_of(largest);
    if (shift != 0) axis.factor_ = power_of_ten(shift) + " ";
    const int decimals = std::max(shift - decade_of(step), 0);
    for (double i = first; i <= last; ++i) axis.ticks_.push_back({i * step, fixed(i * step / ten_to(shift), decimals)});
    return axis;
}

Axis Axis::up_to(double high, int most_ticks) {
    Axis axis = linear(0.0, high, most_ticks);
    if (!(high > 0.0)) return axis;
    axis.high_ = high;
    while (axis.ticks_.back().value > high * (1.0 + 1e-9)) axis.ticks_.pop_back();
    return axis;
}

Axis Axis::logarithmic(double low, double high) {
    Axis axis;
    axis.logarithmic_ = true;
    const int first = decade_of(low);
    int last = decade_of(high);
    if (ten_to(last) < high * (1.0 - 1e-9)) ++last;
    if (last == first) ++last;
    axis.low_ = ten_to(first);
    axis.high_ = ten_to(last);
    const int every = (last - first + 5) / 6;
    for (int decade = first; decade <= last; ++decade) {
        axis.ticks_.push_back({ten_to(decade), (decade - first) % every == 0 ? power_of_ten(decade) : ""});
        for (int i = 2; i < 10 && decade < last && every == 1; ++i) axis.ticks_.push_back({i * ten_to(decade), ""});
    }
    return axis;
}

Axis Axis::fitting(double low, double high) {
    if (low > 0.0 && high >= 20.0 * low) return logarithmic(low, high);
    if (low > 0.0 && low < 0.5 * high) low = 0.0;
    return linear(low, high, 5);
}

double Axis::at(double value) const {
    const double part = logarithmic_ ? (value > 0.0 ? std::log(value / low_) / std::log(high_ / low_) : 0.0)
                                     : (value - low_) / (high_ - low_);
    return std::isfinite(part) ? std::clamp(part, 0.0, 1.0) : 0.0;
}

void PlotFrame::draw(Svg& svg, bool label_horizontal) const {
    for (const Tick& tick : vertical.ticks()) {
        const double ty = at(horizontal.low(), tick.value).y;
        if (!tick.label.empty()) {
            svg.line({x, ty}, {x + width, ty}, R"(stroke="#e3e3e3" stroke-width="0.8")");
            svg.text({x - 8.0, ty + 4.0}, tick.label, R"(text-anchor="end" fill="#222")");
        }
        svg.line({x, ty}, {x + (tick.label.empty() ? 3.0 : 5.0), ty}, R"(stroke="#222" stroke-width="0.8")");
    }
    for (const Tick& tick : horizontal.ticks()) {
        const double tx = at(tick.value, vertical.low()).x;
        svg.line({tx, y}, {tx, y + height}, R"(stroke="#e3e3e3" stroke-width="0.8")");
        svg.line({tx, y + height}, {tx, y + height - 5.0}, R"(stroke="#222" stroke-width="0.8")");
        if (label_horizontal) svg.text({tx, y + height + 17.0}, tick.label, R"(text-anchor="middle" fill="#222")");
    }
    svg.rect(x, y, width, height, R"(fill="none" stroke="#222" stroke-width="1")");
}

void PlotFrame::draw_title(Svg& svg, const std::string& text) const {
    const std::string cx = svg_number(x - 54.0), cy = svg_number(y + 0.5 * height);
    svg.text({x - 54.0, y + 0.5 * height}, text,
             "text-anchor=\"middle\" font-size=\"13\" transform=\"rotate(-90 " + cx + " " + cy + ")\"");
}
} // namespace lr::baker
