#include "tools/lr_bake/preview.h"

#include "baker/length_text.h"
#include "tools/encode_png.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace lr::baker {
namespace {

using Eigen::Vector3d;

constexpr int width = 1600, height = 1000, samples = 3; // px; samples: of a pixel, along each side

const Colour paper = from_srgb(252, 250, 245), black = from_srgb(44, 42, 40), grey = from_srgb(140, 136, 130),
             front = from_srgb(132, 168, 108), back = from_srgb(196, 176, 128), hull_line = from_srgb(70, 96, 150),
             station_dot = from_srgb(186, 78, 42), centre_dot = from_srgb(20, 20, 20);
// Long, wide, thin.
const std::array<Colour, 3> axis_inks{from_srgb(24, 104, 118), from_srgb(188, 134, 26), from_srgb(178, 44, 92)};

// Principal axes in order of the body's extent, the longest first.
struct Frame {
    std::array<Vector3d, 3> axis;
    std::array<double, 3> low{}, high{}; // m, from the centre of mass
};

Frame frame_of(const AssetData& asset, const Mesh& body) {
    std::array<Vector3d, 3> axes;
    std::array<double, 3> low{}, high{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& rows = asset.aerodynamics.axes;
        axes[k] = Vector3d(rows[3 * k], rows[3 * k + 1], rows[3 * k + 2]);
        low[k] = std::numeric_limits<double>::max(), high[k] = -low[k];
        for (const Vector3d& v : body.vertices) {
            low[k] = std::min(low[k], v.dot(axes[k]));
            high[k] = std::max(high[k], v.dot(axes[k]));
        }
    }
    std::array<std::size_t, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return high[a] - low[a] > high[b] - low[b]; });
    Frame frame;
    for (std::size_t k = 0; k < 3; ++k) {
        frame.axis[k] = axes[order[k]];
        frame.low[k] = low[order[k]];
        frame.high[k] = high[order[k]];
    }
    // A sheet has its thickness, which its middle surface lacks.
    const double missing = asset.length_b - (frame.high[2] - frame.low[2]);
    if (missing > 0.0) {
        frame.low[2] -= 0.5 * missing;
        frame.high[2] += 0.5 * missing;
    }
    return frame;
}

class View {
public:
    View(Picture& picture, const AssetData& asset, const Mesh& body, const Frame& frame)
        : picture_(picture), asset_(asset), body_(body), frame_(frame) {}

    // toward: from the body to the viewer. Fits the body into the rectangle.
    void draw(double left, double top, double wide, double high, const Vector3d& toward, const Vector3d& right) {
        toward_ = toward.normalized();
        right_ = (right - right.dot(toward_) * toward_).normalized();
        up_ = toward_.cross(right_);
        double low_x = 0.0, high_x = 0.0, low_y = 0.0, high_y = 0.0;
        for (const Vector3d& v : body_.vertices) {
            low_x = std::min(low_x, v.dot(right_)), high_x = std::max(high_x, v.dot(right_));
            low_y = std::min(low_y, v.dot(up_)), high_y = std::max(high_y, v.dot(up_));
        }
        constexpr double part = 0.74; // of the rectangle; the rest is for axes and their names
        scale_ = part * std::min(wide / std::max(high_x - low_x, 1e-12), high / std::max(high_y - low_y, 1e-12));
        origin_ = {left + 0.5 * wide - 0.5 * (low_x + high_x) * scale_,
                   top + 0.5 * high + 0.5 * (low_y + high_y) * scale_};
        draw_surface(left, top, wide, high);
        draw_hull();
        for (std::size_t k = 0; k < 3; ++k) draw_axis(k);
        draw_marks();
    }

    double scale() const { return scale_; }

private:
    Point at(const Vector3d& v) const { return {origin_.x + scale_ * v.dot(right_), origin_.y - scale_ * v.dot(up_)}; }

    // With a depth buffer of several samples in each pixel.
    void draw_surface(double left, double top, double wide, double high) {
        const int columns = static_cast<int>(wide) * samples, rows = static_cast<int>(high) * samples;
        std::vector<float> depth(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), -HUGE_VALF);
        std::vector<Colour> colour(depth.size());
        const Vector3d light = (0.75 * toward_ + 0.55 * up_ - 0.4 * right_).normalized();
        for (const Face& f : body_.faces) {
            const Vector3d &a = body_.vertices[f[0]], &b = body_.vertices[f[1]], &c = body_.vertices[f[2]];
            const Vector3d normal = (b - a).cross(c - a).normalized();
            const bool faces_reader = normal.dot(toward_) >= 0.0;
            const double bright = std::abs(normal.dot(light));
            const Colour ink = mixed(mixed(faces_reader ? front : back, black, 0.45f),
                                     mixed(faces_reader ? front : back, paper, 0.35f), static_cast<float>(bright));
            const auto place = [&](const Vector3d& v) {
                const Point p = at(v);
                return Vector3d((p.x - left) * samples, (p.y - top) * samples, v.dot(toward_));
            };
            fill_triangle(place(a), place(b), place(c), columns, rows, ink, depth, colour);
        }
        for (int y = 0; y < rows / samples; ++y)
            for (int x = 0; x < columns / samples; ++x) {
                Colour sum;
                int covered = 0;
                for (int k = 0; k < samples * samples; ++k) {
                    const auto i =
                        static_cast<std::size_t>(y * samples + k / samples) * static_cast<std::size_t>(columns) +
                        static_cast<std::size_t>(x * samples + k % samples);
                    if (depth[i] == -HUGE_VALF) continue;
                    ++covered;
                    sum = {sum.r + colour[i].r, sum.g + colour[i].g, sum.b + colour[i].b};
                }
                if (covered == 0) continue;
                const float n = static_cast<float>(covered);
                picture_.fill(static_cast<int>(left) + x, static_cast<int>(top) + y, 1, 1,
                              {sum.r / n, sum.g / n, sum.b / n}, n / (samples * samples));
            }
    }

    static void fill_triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c, int columns, int rows,
                              Colour ink, std::vector<float>& depth, std::vector<Colour>& colour) {
        const double area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
        if (std::abs(area) < 1e-12) return;
        const auto clamp = [](double x, int limit) {
            return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(limit)));
        };
        const int x0 = clamp(std::min({a.x(), b.x(), c.x()}), columns),
                  x1 = clamp(std::max({a.x(), b.x(), c.x()}) + 1.0, columns);
        const int y0 = clamp(std::min({a.y(), b.y(), c.y()}), rows),
                  y1 = clamp(std::max({a.y(), b.y(), c.y()}) + 1.0, rows);
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                const double px = x + 0.5, py = y + 0.5;
                const double u = ((px - a.x()) * (c.y() - a.y()) - (py - a.y()) * (c.x() - a.x())) / area;
                const double v = ((b.x() - a.x()) * (py - a.y()) - (b.y() - a.y()) * (px - a.x())) / area;
                if (u < 0.0 || v < 0.0 || u + v > 1.0) continue;
                const auto z = static_cast<float>(a.z() + u * (b.z() - a.z()) + v * (c.z() - a.z()));
                const auto i =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x);
                if (z <= depth[i]) continue;
                depth[i] = z;
                colour[i] = ink;
            }
    }

    Vector3d hull_vertex(uint32_t i) const {
        const std::vector<float>& v = asset_.hull.vertices;
        return {static_cast<double>(v[3 * i]), static_cast<double>(v[3 * i + 1]), static_cast<double>(v[3 * i + 2])};
    }

    // Only edges where the hull turns, not those between its coplanar triangles.
    void draw_hull() {
        const std::vector<uint32_t>& t = asset_.hull.triangles;
        const auto normal = [&](std::size_t face) {
            const Vector3d a = hull_vertex(t[face]), b = hull_vertex(t[face + 1]), c = hull_vertex(t[face + 2]);
            return (b - a).cross(c - a).normalized();
        };
        std::vector<std::pair<std::pair<uint32_t, uint32_t>, std::size_t>> edges;
        for (std::size_t face = 0; face + 2 < t.size(); face += 3)
            for (std::size_t k = 0; k < 3; ++k) {
                const uint32_t a = t[face + k], b = t[face + (k + 1) % 3];
                edges.push_back({{std::min(a, b), std::max(a, b)}, face});
            }
        std::sort(edges.begin(), edges.end());
        const bool many = t.size() > 600;
        for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
            if (edges[i].first != edges[i + 1].first) continue;
            const Vector3d one = normal(edges[i].second), other = normal(edges[i + 1].second);
            const bool outline = one.dot(toward_) * other.dot(toward_) <= 0.0;
            if (!outline && (many || one.dot(other) > 0.97)) continue;
            picture_.line(at(hull_vertex(edges[i].first.first)), at(hull_vertex(edges[i].first.second)),
                          outline ? 1.6 : 1.0, hull_line, outline ? 0.75f : 0.3f);
        }
    }

    void draw_axis(std::size_t k) {
        const double beyond = 0.08 * (frame_.high[0] - frame_.low[0]);
        const Vector3d& axis = frame_.axis[k];
        const Point from = at((frame_.low[k] - beyond) * axis), to = at((frame_.high[k] + beyond) * axis);
        const double length = std::hypot(to.x - from.x, to.y - from.y);
        if (length < 40.0) return; // it points at the viewer
        const double dx = (to.x - from.x) / length, dy = (to.y - from.y) / length;
        picture_.line(from, to, k == 2 ? 3.2 : 2.0, axis_inks[k]);
        if (k == 2) // arrowheads mark the thin direction
            for (const double end : {-1.0, 1.0}) {
                const Point tip = end > 0.0 ? to : from;
                for (const double side : {-6.0, 6.0})
                    picture_.line(tip, {tip.x - end * 13.0 * dx - side * dy, tip.y - end * 13.0 * dy + side * dx}, 3.2,
                                  axis_inks[k]);
            }
        static constexpr std::array<const char*, 3> names{"long ", "wide ", "thin "};
        const std::string text = names[k] + length_text(frame_.high[k] - frame_.low[k]);
        // At the higher end or, of level axes, at the right end.
        const bool first = std::abs(dy) > 0.3 ? from.y < to.y : from.x > to.x;
        const Point tip = first ? from : to;
        const double out = first ? -1.0 : 1.0, room = text_width(15.0, text);
        const bool level = std::abs(dy) <= 0.3; // then the name is above the line and ends with it
        const Point place = level ? Point{tip.x - (tip.x > 0.5 * (from.x + to.x) ? room : 0.0), tip.y - 9.0}
                                  : Point{tip.x + out * 14.0 * dx - 0.5 * room, tip.y - 12.0};
        write_text(picture_, {std::clamp(place.x, 8.0, width - room - 8.0), place.y}, 15.0, axis_inks[k], text);
    }

    void draw_marks() {
        if (asset_.stations.size() > 1)
            for (const auto& station : asset_.stations) {
                const Point p = at({station.place[0], station.place[1], station.place[2]});
                picture_.ellipse(p, {8.0, 0.0}, 1.0, paper, 1.0f);
                picture_.ellipse(p, {6.0, 0.0}, 1.0, station_dot, 1.0f);
            }
        const Point c = at(Vector3d::Zero());
        picture_.ellipse(c, {10.0, 0.0}, 1.0, paper, 1.0f);
        picture_.ellipse(c, {8.5, 0.0}, 1.0, centre_dot, 1.0f);
        for (const double arm : {-1.0, 1.0})
            picture_.line({c.x - 5.0, c.y - 5.0 * arm}, {c.x + 5.0, c.y + 5.0 * arm}, 2.0, paper);
    }

    Picture& picture_;
    const AssetData& asset_;
    const Mesh& body_;
    const Frame& frame_;
    Vector3d toward_, right_, up_;
    Point origin_;
    double scale_ = 1.0;
};

std::string rounded(double value, const char* unit) {
    char text[48];
    std::snprintf(text, sizeof text, "%.3g %s", value, unit);
    return text;
}

void legend(Picture& picture, const AssetData& asset, const std::string& fall) {
    double x = 48.0;
    const double y = height - 34.0;
    const auto word = [&](const std::string& text) {
        write_text(picture, {x, y}, 14.0, black, text);
        x += text_width(14.0, text) + 40.0;
    };
    const auto dot = [&](Colour colour, double radius) {
        picture.ellipse({x + 8.0, y - 6.0}, {radius, 0.0}, 1.0, colour, 1.0f);
        x += 26.0;
    };
    dot(centre_dot, 8.5);
    word("centre of mass");
    if (asset.stations.size() > 1) {
        dot(station_dot, 6.0);
        word(std::to_string(asset.stations.size()) + " stations");
    } else {
        word("one plate (no stations)");
    }
    picture.line({x, y - 6.0}, {x + 26.0, y - 6.0}, 1.6, hull_line, 0.75f);
    x += 36.0;
    word("hull, for contact");
    const double mass = asset.mass;
    word("mass " + (mass >= 1.0    ? rounded(mass, "kg")
                    : mass >= 1e-3 ? rounded(1e3 * mass, "g")
                                   : rounded(1e6 * mass, "mg")));
    word(fall);
}
} // namespace

std::vector<uint8_t> draw_preview(const AssetData& asset, const Mesh& body, const std::string& fall) {
    Picture picture(width, height, paper);
    const Frame frame = frame_of(asset, body);
    const auto& [along, across, thin] = frame.axis;
    View view(picture, asset, body, frame);
    view.draw(20.0, 40.0, 960.0, 880.0, 0.60 * thin - 0.62 * across + 0.36 * along, along);
    view.draw(1010.0, 70.0, 560.0, 460.0, thin, along);
    write_text(picture, {1030.0, 52.0}, 14.0, grey, "its broad side");
    view.draw(1010.0, 580.0, 560.0, 320.0, -across, along);
    write_text(picture, {1030.0, 562.0}, 14.0, grey, "edge on");
    picture.line({995.0, 60.0}, {995.0, height - 90.0}, 1.0, grey, 0.5f);
    legend(picture, asset, fall);
    return tools::encode_png(picture);
}
} // namespace lr::baker
