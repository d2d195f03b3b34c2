// SPDX-License-Identifier: MIT
#include "image/picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

float to_linear(float s) {
    return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
}

float to_srgb(float l) {
    return l <= 0.0031308f ? 12.92f * l : 1.055f * std::pow(l, 1.0f / 2.4f) - 0.055f;
}

const std::array<float, 256>& linear_table() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = to_linear(static_cast<float>(i) / 255.0f);
        return values;
    }();
    return table;
}

int clamp_to(double x, int limit) {
    return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(limit)));
}

} // namespace

Colour from_srgb(int r, int g, int b) {
    const auto& table = linear_table();
    return {table[static_cast<std::size_t>(r)], table[static_cast<std::size_t>(g)], table[static_cast<std::size_t>(b)]};
}

Colour mixed(Colour a, Colour b, float part_of_b) {
    return {a.r + (b.r - a.r) * part_of_b, a.g + (b.g - a.g) * part_of_b, a.b + (b.b - a.b) * part_of_b};
}

Picture::Picture(int width, int height, Colour fill)
    : width_(width), height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {}

std::vector<std::uint8_t> Picture::srgb() const {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(pixels_.size() * 3);
    for (const Colour& p : pixels_) {
        for (const float x : {p.r, p.g, p.b}) {
            bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0f * to_srgb(std::clamp(x, 0.0f, 1.0f)))));
        }
    }
    return bytes;
}

void Picture::blend(int x, int y, Colour colour, float alpha) {
    Colour& p = pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    p = mixed(p, colour, std::clamp(alpha, 0.0f, 1.0f));
}

void Picture::paste_srgb(const std::vector<std::uint8_t>& pixels, int width, int height, int left, int top) {
    for (int y = std::max(0, -top); y < std::min(height, height_ - top); ++y) {
        for (int x = std::max(0, -left); x < std::min(width, width_ - left); ++x) {
            const std::uint8_t* p = &pixels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                                 static_cast<std::size_t>(x))];
            blend(left + x, top + y, from_srgb(p[0], p[1], p[2]), 1.0f);
        }
    }
}

void Picture::fill(int left, int top, int width, int height, Colour colour, float alpha) {
    for (int y = std::max(0, top); y < std::min(height_, top + height); ++y) {
        for (int x = std::max(0, left); x < std::min(width_, left + width); ++x) blend(x, y, colour, alpha);
    }
}

void Picture::line(Point a, Point b, double thickness, Colour colour, float alpha) {
    const double half = 0.5 * thickness, reach = half + 1.0;
    const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
    const int right = clamp_to(std::max(a.x, b.x) + reach, width_), low = clamp_to(std::max(a.y, b.y) + reach, height_);
    for (int y = clamp_to(std::min(a.y, b.y) - reach, height_); y < low; ++y) {
        for (int x = clamp_to(std::min(a.x, b.x) - reach, width_); x < right; ++x) {
            const double px = x + 0.5 - a.x, py = y + 0.5 - a.y;
            const double along = squared > 0.0 ? std::clamp((px * dx + py * dy) / squared, 0.0, 1.0) : 0.0;
            const double distance = std::hypot(px - along * dx, py - along * dy);
            const double cover = std::clamp(half + 0.5 - distance, 0.0, 1.0);
            if (cover > 0.0) blend(x, y, colour, alpha * static_cast<float>(cover));
        }
    }
}

void Picture::ellipse(Point centre, Point direction, double minor, Colour colour, float alpha) {
    const double major = std::hypot(direction.x, direction.y);
    if (major < 1e-9) return;
    const double c = direction.x / major, s = direction.y / major;
    const double small = std::max(0.5, minor * major), reach = major + 1.0;
    const int right = clamp_to(centre.x + reach, width_), low = clamp_to(centre.y + reach, height_);
    for (int y = clamp_to(centre.y - reach, height_); y < low; ++y) {
        for (int x = clamp_to(centre.x - reach, width_); x < right; ++x) {
            const double px = x + 0.5 - centre.x, py = y + 0.5 - centre.y;
            const double u = (px * c + py * s) / major, v = (py * c - px * s) / small;
            // Distance to the curve to first order: value over gradient.
            const double f = u * u + v * v, slope = 2.0 * std::hypot(u / major, v / small);
            const double cover = slope > 0.0 ? std::clamp(0.5 - (f - 1.0) / slope, 0.0, 1.0) : 1.0;
            if (cover > 0.0) blend(x, y, colour, alpha * static_cast<float>(cover));
        }
    }
}
