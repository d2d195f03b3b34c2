// Letters as strokes on a grid of 8 units from the top of a digit to the baseline: sharp at any size, and no font file.
// SPDX-License-Identifier: MIT
#include "image/picture.h"

#include <algorithm>
#include <cctype>

#include "image/glyphs.h"

namespace {

int digit(char c) {
    return c <= '9' ? c - '0' : c - 'a' + 10;
}

Point catmull_rom(const Point& a, const Point& b, const Point& c, const Point& d, double t) {
    const auto blend = [t](double p, double q, double r, double s) {
        return 0.5 * (2.0 * q + t * (r - p + t * (2.0 * p - 5.0 * q + 4.0 * r - s + t * (3.0 * (q - r) + s - p))));
    };
    return {blend(a.x, b.x, c.x, d.x), blend(a.y, b.y, c.y, d.y)};
}

// Draws if there is a picture, otherwise only measures. Returns the advance.
double stroke_glyph(Picture* picture, Point origin, double unit, Colour colour, char c) {
    const char* at = glyph(c);
    double right = *at ? 0.0 : 2.0;
    while (*at) {
        const bool smooth = *at == '~';
        if (smooth) ++at;
        std::vector<Point> points;
        for (; *at && *at != ','; at += *at == ' ' ? 1 : 0) {
            points.push_back({static_cast<double>(digit(at[0])), static_cast<double>(digit(at[1]))});
            right = std::max(right, points.back().x);
            at += 2;
        }
        if (*at) ++at;
        const double thickness = std::max(1.2, (points.size() == 1 ? 1.6 : 1.05) * unit);
        if (points.size() == 1) points.push_back(points[0]);
        if (!picture) continue;
        const auto on_page = [&](Point p) { return Point{origin.x + unit * p.x, origin.y + unit * (p.y - 8.0)}; };
        const bool closed = points.front().x == points.back().x && points.front().y == points.back().y;
        const std::size_t n = points.size();
        for (std::size_t i = 0; i + 1 < n; ++i) {
            const Point& before = i > 0 ? points[i - 1] : points[closed ? n - 2 : 0];
            const Point& after = i + 2 < n ? points[i + 2] : points[closed ? 1 : n - 1];
            const int parts = smooth ? 6 : 1;
            Point from = points[i];
            for (int k = 1; k <= parts; ++k) {
                const Point to =
                    smooth ? catmull_rom(before, points[i], points[i + 1], after, k / static_cast<double>(parts))
                           : points[i + 1];
                picture->line(on_page(from), on_page(to), thickness, colour);
                from = to;
            }
        }
    }
    return (right + 2.4) * unit;
}

double set_text(Picture* picture, Point baseline, double height, Colour colour, std::string_view text) {
    const double start = baseline.x;
    for (const char c : text) {
        const char small = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        baseline.x += stroke_glyph(picture, baseline, height / 8.0, colour, small);
    }
    return baseline.x - start;
}

} // namespace

double write_text(Picture& picture, Point baseline, double height, Colour colour, std::string_view text) {
    return set_text(&picture, baseline, height, colour, text);
}

double text_width(double height, std::string_view text) {
    return set_text(nullptr, {}, height, {}, text);
}
