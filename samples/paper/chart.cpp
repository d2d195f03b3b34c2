// SPDX-License-Identifier: MIT
#include "chart.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

double round_step(double range, int parts) {
    const double raw = range / parts, power = std::pow(10.0, std::floor(std::log10(raw))), lead = raw / power;
    return power * (lead < 1.5 ? 1.0 : lead < 3.5 ? 2.0 : lead < 7.5 ? 5.0 : 10.0);
}

std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", std::abs(x) < 1e-12 ? 0.0 : x);
    return text;
}

} // namespace

Colour ink() {
    return from_srgb(40, 40, 44);
}

Colour pale() {
    return from_srgb(214, 216, 220);
}

void write_centred(Picture& picture, Point baseline, double height, Colour colour, const std::string& text) {
    write_text(picture, {baseline.x - 0.5 * text_width(height, text), baseline.y}, height, colour, text);
}

void draw_scale_bar(Picture& picture, Point right, double metres_per_pixel, double longest_pixels) {
    double bar = 10.0; // m: 1, 2 or 5 times a power of ten
    for (int k = 0; bar / metres_per_pixel > longest_pixels; ++k) bar /= k % 3 == 1 ? 2.5 : 2.0;
    const double left = right.x - bar / metres_per_pixel;
    picture.line({left, right.y}, right, 2.0, ink());
    for (const double x : {left, right.x}) picture.line({x, right.y - 4.0}, {x, right.y + 4.0}, 2.0, ink());
    char text[32];
    std::snprintf(text, sizeof text, bar >= 1.0 ? "%.0f m" : "%.0f cm", bar >= 1.0 ? bar : 100.0 * bar);
    write_centred(picture, {0.5 * (left + right.x), right.y - 9.0}, 10.0, ink(), text);
}

void draw_chart(Picture& picture, Frame frame, const std::string& title, const std::string& x_label,
                const std::vector<Curve>& curves) {
    double x0 = 1e300, x1 = -1e300, y0 = 0.0, y1 = 0.0;
    for (const Curve& curve : curves) {
        for (const Point& p : curve.points) {
            x0 = std::min(x0, p.x);
            x1 = std::max(x1, p.x);
            y0 = std::min(y0, p.y);
            y1 = std::max(y1, p.y);
        }
    }
    if (!(x1 > x0)) x1 = x0 + 1.0;
    if (!(y1 > y0)) y1 = y0 + 1.0;
    const double y_step = round_step(y1 - y0, 5), x_step = round_step(x1 - x0, 6);
    y0 = y_step * std::floor(y0 / y_step);
    y1 = y_step * std::ceil(y1 / y_step - 1e-9);
    const double left = frame.left + 52.0, right = frame.left + frame.width - 12.0, top = frame.top + 34.0,
                 bottom = frame.top + frame.height - 40.0;
    const auto on_page = [&](Point p) {
        return Point{left + (right - left) * (p.x - x0) / (x1 - x0), bottom - (bottom - top) * (p.y - y0) / (y1 - y0)};
    };
    for (double y = y0; y <= y1 + 0.01 * y_step; y += y_step) {
        const Point at = on_page({x0, y});
        picture.line({left, at.y}, {right, at.y}, 1.0, pale());
        const std::string text = number(y);
        write_text(picture, {left - 8.0 - text_width(10.0, text), at.y + 4.5}, 10.0, ink(), text);
    }
    for (double x = x_step * std::ceil(x0 / x_step - 1e-9); x <= x1 + 1e-9; x += x_step) {
        const Point at = on_page({x, y0});
        picture.line({at.x, bottom}, {at.x, bottom + 4.0}, 1.2, ink());
        write_centred(picture, {at.x, bottom + 18.0}, 10.0, ink(), number(x));
    }
    picture.line({left, bottom}, {right, bottom}, 1.2, ink());
    write_centred(picture, {0.5 * (left + right), bottom + 34.0}, 10.0, ink(), x_label);
    write_text(picture, {frame.left + 4.0, frame.top + 14.0}, 12.0, ink(), title);
    double row = top + 16.0;
    for (const Curve& curve : curves) {
        for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
            if (curve.dashed && i % 4 >= 2) continue;
            picture.line(on_page(curve.points[i]), on_page(curve.points[i + 1]), 1.8, curve.colour);
        }
        if (curve.name.empty()) continue;
        const double text_left = right - 8.0 - text_width(10.0, curve.name);
        picture.line({text_left - 34.0, row - 4.0}, {text_left - 8.0, row - 4.0}, 2.4, curve.colour);
        write_text(picture, {text_left, row}, 10.0, ink(), curve.name);
        row += 18.0;
    }
}
