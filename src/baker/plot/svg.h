// Writes SVG: plain shapes and text, the same bytes for the same calls, nothing outside the file needed.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace lr::baker {

struct SvgPoint {
    double x = 0.0, y = 0.0; // px, y down
};

// `attributes` are XML as it stands, such as `fill="none" stroke="#333"`.
class Svg {
public:
    // White ground. `description` is not shown.
    Svg(double width, double height, std::string_view title, std::string_view description);

    void style(std::string_view css);
    void line(SvgPoint a, SvgPoint b, std::string_view attributes);
    void polyline(std::span<const SvgPoint> points, std::string_view attributes);
    void polygon(std::span<const SvgPoint> points, std::string_view attributes);
    void rect(double x, double y, double width, double height, std::string_view attributes);
    void circle(SvgPoint center, double radius, std::string_view attributes);
    // Any bytes: what XML cannot hold is replaced.
    void text(SvgPoint at, std::string_view text, std::string_view attributes);
    void begin_group(std::string_view attributes);
    void end_group();

    // One path of many polygons: begin, add, end.
    void begin_path();
    void add_to_path(std::span<const SvgPoint> polygon);
    void end_path(std::string_view attributes);

    // Closes the document; the object is then used up.
    std::string finish();

private:
    void append(std::initializer_list<std::string_view> parts);
    void add_points(std::span<const SvgPoint> points, std::string_view attributes);

    std::string text_;
};

// Two decimals at most, without trailing zeros; 0 for what is not finite.
std::string svg_number(double value);

// Escaped for text and for attributes.
std::string xml_escape(std::string_view text);

} // namespace lr::baker
