#include "baker/plot/svg.h"

#include "baker/printable_text.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <utility>

namespace lr::baker {

std::string svg_number(double value) {
    if (!std::isfinite(value) || std::abs(value) > 1e9) return "0";
    char buffer[32];
    const std::to_chars_result end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, 2);
    std::string_view text(buffer, static_cast<std::size_t>(end.ptr - buffer));
    while (text.back() == '0') text.remove_suffix(1);
    if (text.back() == '.') text.remove_suffix(1);
    return text == "-0" ? "0" : std::string(text);
}

std::string xml_escape(std::string_view text) {
    const std::string clean = printable(text);
    std::string result;
    for (std::size_t i = 0; i < clean.size(); ++i) {
        const std::string_view rest = std::string_view(clean).substr(i);
        // U+FFFE and U+FFFF, which XML does not allow.
        if (rest.starts_with("\xef\xbf\xbe") || rest.starts_with("\xef\xbf\xbf")) {
            result += '?';
            i += 2;
            continue;
        }
        switch (clean[i]) {
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '&':
            result += "&amp;";
            break;
        case '"':
            result += "&quot;";
            break;
        case '\'':
            result += "&#39;";
            break;
        default:
            result += clean[i];
        }
    }
    return result;
}

void Svg::append(std::initializer_list<std::string_view> parts) {
    for (const std::string_view part : parts) text_ += part;
}

Svg::Svg(double width, double height, std::string_view title, std::string_view description) {
    const std::string w = svg_number(width), h = svg_number(height);
    append({R"(<?xml version="1.0" encoding="UTF-8"?>)", "\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", w,
            "\" height=\"", h, "\" viewBox=\"0 0 ", w, " ", h,
            "\" font-family=\"Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif\" font-size=\"12\">\n"
            "<title>",
            xml_escape(title), "</title>\n<desc>", xml_escape(description), "</desc>\n"});
    rect(0.0, 0.0, width, height, R"(fill="#fff")");
}

void Svg::style(std::string_view css) {
    append({"<style>", xml_escape(css), "</style>\n"});
}

void Svg::line(SvgPoint a, SvgPoint b, std::string_view attributes) {
    append({"<line x1=\"", svg_number(a.x), "\" y1=\"", svg_number(a.y), "\" x2=\"", svg_number(b.x), "\" y2=\"",
            svg_number(b.y), "\" ", attributes, "/>\n"});
}

void Svg::add_points(std::span<const SvgPoint> points, std::string_view attributes) {
    append({" points=\""});
    for (std::size_t i = 0; i < points.size(); ++i)
        append({i > 0 ? " " : "", svg_number(points[i].x), ",", svg_number(points[i].y)});
    append({"\" ", attributes, "/>\n"});
}

void Svg::polyline(std::span<const SvgPoint> points, std::string_view attributes) {
    append({"<polyline"});
    add_points(points, attributes);
}

void Svg::polygon(std::span<const SvgPoint> points, std::string_view attributes) {
    append({"<polygon"});
    add_points(points, attributes);
}

void Svg::rect(double x, double y, double width, double height, std::string_view attributes) {
    append({"<rect x=\"", svg_number(x), "\" y=\"", svg_number(y), "\" width=\"", svg_number(width), "\" height=\"",
            svg_number(height), "\" ", attributes, "/>\n"});
}

void Svg::circle(SvgPoint center, double radius, std::string_view attributes) {
    append({"<circle cx=\"", svg_number(center.x), "\" cy=\"", svg_number(center.y), "\" r=\"", svg_number(radius),
            "\" ", attributes, "/>\n"});
}

void Svg::text(SvgPoint at, std::string_view text, std::string_view attributes) {
    append({"<text x=\"", svg_number(at.x), "\" y=\"", svg_number(at.y), "\" ", attributes, ">", xml_escape(text),
            "</text>\n"});
}

void Svg::begin_group(std::string_view attributes) {
    append({"<g ", attributes, ">\n"});
}

void Svg::end_group() {
    append({"</g>\n"});
}

void Svg::begin_path() {
    append({"<path d=\""});
}

void Svg::add_to_path(std::span<const SvgPoint> polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
        append({i == 0 ? "M" : " ", svg_number(polygon[i].x), " ", svg_number(polygon[i].y)});
    append({"z"});
}

void Svg::end_path(std::string_view attributes) {
    append({"\" ", attributes, "/>\n"});
}

std::string Svg::finish() {
    append({"</svg>\n"});
    return std::move(text_);
}
} // namespace lr::baker
