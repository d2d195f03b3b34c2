// SPDX-License-Identifier: MIT
#include "scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace {

constexpr int fineness = 3; // subpixels per pixel and direction

Vector vector_of(const float* v) {
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

} // namespace

View View::from(double azimuth, double elevation) {
    const double a = azimuth * std::numbers::pi / 180.0, e = elevation * std::numbers::pi / 180.0;
    const Vector towards{std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)};
    const Vector right = unit(cross({0.0, 1.0, 0.0}, towards));
    return {right, cross(towards, right), towards};
}

View View::above() {
    return {{1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}};
}

Scene::Scene(Frame frame, const View& view, const std::vector<Vector>& bounds, double margin_metres)
    : frame_(frame), view_(view), width_(fineness * static_cast<int>(frame.width)),
      height_(fineness * static_cast<int>(frame.height)),
      pixels_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
              Pixel{{}, -std::numeric_limits<float>::infinity(), false}) {
    const std::array<Vector, 3> axes{view.right, view.up, view.towards};
    Vector low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (const Vector& point : bounds) {
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], dot(point, axes[k]));
            high[k] = std::max(high[k], dot(point, axes[k]));
        }
    }
    for (std::size_t k = 0; k < 3; ++k) centre_ = plus(centre_, times(0.5 * (low[k] + high[k]), axes[k]));
    metres_per_pixel_ = std::max((high[0] - low[0] + 2.0 * margin_metres) / frame.width,
                                 (high[1] - low[1] + 2.0 * margin_metres) / frame.height);
}

void Scene::set_metres_per_pixel(double value) {
    metres_per_pixel_ = value;
}

Scene::Screen Scene::project(const Vector& world) const {
    const Vector from_centre = minus(world, centre_);
    const double scale = fineness / metres_per_pixel_;
    return {0.5 * width_ + scale * dot(from_centre, view_.right), 0.5 * height_ - scale * dot(from_centre, view_.up),
            scale * dot(from_centre, view_.towards)};
}

void Scene::put(int x, int y, double depth, Colour colour) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    Pixel& pixel =
        pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    if (static_cast<float>(depth) > pixel.depth) pixel = {colour, static_cast<float>(depth), true};
}

void Scene::triangle(const std::array<Screen, 3>& p, Colour colour) {
    const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
    if (std::abs(area) < 1e-9) return;
    const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
    const int x1 = std::min(width_ - 1, static_cast<int>(std::floor(right)));
    const int y1 = std::min(height_ - 1, static_cast<int>(std::floor(bottom)));
    for (int y = std::max(0, static_cast<int>(std::floor(top))); y <= y1; ++y) {
        for (int x = std::max(0, static_cast<int>(std::floor(left))); x <= x1; ++x) {
            const double px = x + 0.5, py = y + 0.5;
            const double b = ((px - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (py - p[0].y)) / area;
            const double c = ((p[1].x - p[0].x) * (py - p[0].y) - (px - p[0].x) * (p[1].y - p[0].y)) / area;
            if (b < 0.0 || c < 0.0 || b + c > 1.0) continue;
            put(x, y, p[0].depth + b * (p[1].depth - p[0].depth) + c * (p[2].depth - p[0].depth), colour);
        }
    }
}

void Scene::body(const Mesh& mesh, const Vector& position, const Quaternion& turn, Colour front, Colour back,
                 bool octants) {
    const Vector light = unit(plus(plus(times(0.9, view_.towards), times(0.5, view_.up)), times(-0.35, view_.right)));
    std::vector<Vector> placed;
    for (const Vertex& v : mesh.vertices) placed.push_back(plus(position, turned(turn, vector_of(v.position))));
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::array<Screen, 3> corners;
        Vector normal{}, middle{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t index = mesh.indices[i + k];
            corners[k] = project(placed[index]);
            normal = plus(normal, vector_of(mesh.vertices[index].normal));
            middle = plus(middle, vector_of(mesh.vertices[index].position));
        }
        const bool first = octants ? (middle[0] > 0.0) == (middle[1] > 0.0) : normal[2] > 0.0;
        // Few shades: fewer colours, smaller files.
        const double shade = 0.35 + 0.65 / 12.0 * std::round(12.0 * std::abs(dot(unit(turned(turn, normal)), light)));
        const Colour base = first ? front : back;
        const auto s = static_cast<float>(shade);
        triangle(corners, {base.r * s, base.g * s, base.b * s});
    }
    // A sheet of 0.1 mm seen edge on covers no pixel: draw its outline as a line.
    if (octants) return;
    const auto [low, high] =
        std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                            [](const Vertex& a, const Vertex& b) { return a.position[0] < b.position[0]; });
    const auto at = [&](const Vertex& v) { return plus(position, turned(turn, vector_of(v.position))); };
    const Vector axis = unit(turned(turn, {0.0, 0.0, 1.0}));
    if (std::abs(dot(axis, view_.towards)) < 0.06) path({at(*low), at(*high)}, 1.2, mixed(front, back, 0.5f));
}

void Scene::path(const std::vector<Vector>& points, double thickness_pixels, Colour colour) {
    const double half = 0.5 * thickness_pixels * fineness;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Screen a = project(points[i]), b = project(points[i + 1]);
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        const int parts = std::max(1, static_cast<int>(std::ceil(length)));
        for (int k = 0; k <= parts; ++k) {
            const double t = static_cast<double>(k) / parts;
            const double cx = a.x + t * (b.x - a.x), cy = a.y + t * (b.y - a.y),
                         depth = a.depth + t * (b.depth - a.depth);
            for (int y = static_cast<int>(std::floor(cy - half)); y <= static_cast<int>(std::floor(cy + half)); ++y) {
                for (int x = static_cast<int>(std::floor(cx - half)); x <= static_cast<int>(std::floor(cx + half));
                     ++x) {
                    if (std::hypot(x + 0.5 - cx, y + 0.5 - cy) <= half) put(x, y, depth, colour);
                }
            }
        }
    }
}

void Scene::draw(Picture& picture) const {
    const int left = static_cast<int>(frame_.left), top = static_cast<int>(frame_.top);
    for (int y = 0; y < height_ / fineness; ++y) {
        for (int x = 0; x < width_ / fineness; ++x) {
            Colour sum{};
            int used = 0;
            for (int sub = 0; sub < fineness * fineness; ++sub) {
                const auto row = static_cast<std::size_t>(y * fineness + sub / fineness);
                const auto column = static_cast<std::size_t>(x * fineness + sub % fineness);
                const Pixel& pixel = pixels_[row * static_cast<std::size_t>(width_) + column];
                if (!pixel.used) continue;
                sum = {sum.r + pixel.colour.r, sum.g + pixel.colour.g, sum.b + pixel.colour.b};
                ++used;
            }
            if (used == 0) continue;
            const auto n = static_cast<float>(used);
            picture.fill(left + x, top + y, 1, 1, {sum.r / n, sum.g / n, sum.b / n}, n / (fineness * fineness));
        }
    }
}
