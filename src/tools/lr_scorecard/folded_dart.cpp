#include "tools/lr_scorecard/folded_dart.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace lr::scorecard {
namespace {

using Point = Eigen::Vector2d; // in the square: x from the nose along the middle line, y across
using Polygon = std::vector<Point>;

constexpr double degree = std::numbers::pi / 180.0;
constexpr double first_fold = 45.0 * degree, second_fold = 22.5 * degree, wing_fold = 7.5 * degree;

Point turned(const Point& p, double angle) {
    return Eigen::Rotation2Dd(angle) * p;
}

// The parts of a convex polygon below and above a line through the nose; either can be empty.
std::pair<Polygon, Polygon> cut(const Polygon& polygon, double angle) {
    constexpr double tiny = 1e-12;
    Polygon below, above;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double a = turned(p, -angle).y(), b = turned(q, -angle).y();
        if (a <= tiny) below.push_back(p);
        if (a >= -tiny) above.push_back(p);
        if (std::min(a, b) < -tiny && std::max(a, b) > tiny) {
            below.emplace_back(p + (q - p) * (a / (a - b)));
            above.push_back(below.back());
        }
    }
    const auto flat = [&](const Polygon& part) {
        return std::all_of(part.begin(), part.end(),
                           [&](const Point& p) { return std::abs(turned(p, -angle).y()) <= tiny; });
    };
    if (flat(below)) below.clear();
    if (flat(above)) above.clear();
    return {below, above};
}

std::vector<Polygon> folded(const std::vector<Polygon>& pieces, double angle) {
    std::vector<Polygon> out;
    for (const Polygon& piece : pieces) {
        Polygon below, above;
        std::tie(below, above) = cut(piece, angle);
        for (Point& p : above) p = turned({p.x(), -p.y()}, 2.0 * angle);
        for (Polygon* part : {&below, &above})
            if (!part->empty()) out.push_back(std::move(*part));
    }
    return out;
}

// Adds a convex part of the paper on the left (hand 1) or right (-1): wing, or keel if it is below the wing's crease.
void add(const Polygon& polygon, double hand, Triangles& to) {
    const double rise = std::atan(0.1);
    const auto first = static_cast<uint32_t>(to.positions.size() / 3);
    for (const Point& at : polygon) {
        const Point p = turned(at, -wing_fold); // along the crease and across
        const double wing = std::max(p.y(), 0.0), keel = std::min(p.y(), 0.0);
        to.positions.insert(to.positions.end(), {-p.x(), hand * wing * std::cos(rise), wing * std::sin(rise) + keel});
    }
    for (uint32_t i = 2; i < polygon.size(); ++i)
        to.indices.insert(to.indices.end(), {first, first + i - 1, first + i});
}
} // namespace

Dart folded_dart(double side, double uneven) {
    Dart dart;
    const Point nose(0.0, 0.0), tail(side, side * std::tan(wing_fold));
    for (const double hand : {1.0, -1.0}) {
        const double fold = second_fold + (hand > 0.0 ? uneven : 0.0);
        std::vector<Polygon> pieces{{nose, {side, 0.0}, {side, 0.5 * side}, {0.0, 0.5 * side}}};
        pieces = folded(folded(pieces, first_fold), fold);
        for (const Polygon& piece : pieces) {
            const auto [keel, wing] = cut(piece, wing_fold);
            for (const Polygon* part : {&keel, &wing}) add(*part, hand, dart.layers);
        }
        // The flap of the second fold extends behind the tail to the corner of the square.
        const Point tip(side, side * std::tan(fold)), corner = turned({side, -0.5 * side}, 2.0 * fold);
        const Point direction = turned({1.0, 0.0}, 2.0 * fold),
                    inner = corner - direction * ((corner.x() - side) / direction.x());
        add({nose, tail, inner}, hand, dart.surface);
        add({nose, inner, tip}, hand, dart.surface);
        add({inner, corner, tip}, hand, dart.surface);
    }
    add({nose, {side, 0.0}, tail}, 1.0, dart.surface);
    return dart;
}
} // namespace lr::scorecard
