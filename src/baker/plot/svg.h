// Writes SVG with plain shapes and text. Deterministic and self-contained.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace lr::baker {

struct SvgPoint {
    double x = 0.0, y = 0.0; // px, y down
};

// attributes: XML, not escaped, such as `fill="none" stroke="#333"`.
class Svg {
public:
    // White background. The description is not visible.
    Svg(double width, double height, std::string_view title, std::string_view description);

    void style(std::string_view css);
    void line(SvgPoint a, SvgPoint b, std::string_view attributes);
    void polyline(std::span<const SvgPoint> points, std::string_view attributes);
    void polygon(std::span<const SvgPoint> points, std::string_view attributes);
    void rect(double x, double y, double width, double height, std::string_view attributes);
    void circle(SvgPoint center, double radius, std::string_view attributes);
    // text: any bytes; replaces those that XML does not allow.
    void text(SvgPoint at, std::string_view text, std::string_view attributes);
    void begin_group(std::string_view attributes);
    void end_group();

    // One path of many polygons: begin_path, add, end_path.
    void begin_path();
    void add_to_path(std::span<const SvgPoint> polygon);
    void end_path(std::string_view attributes);

    // Closes the document and returns it; do not use the object afterwards.
    std::string finish();

private:
    void append(std::initializer_list<std::string_view> parts);
    void add_points(std::span<const SvgPoint> points, std::string_view attributes);

    std::string text_;
};

// At most two decimals, without trailing zeros; 0 for numbers that are not finite.
std::string svg_number(double value);

// Escapes text for element content and attributes.
std::string xml_escape(std::string_view text);
} // namespace lr::baker
