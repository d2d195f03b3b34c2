#include "baker/aerodynamics/silhouette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace lr::baker {
namespace {

constexpr std::size_t even_lines = 2048;
// Above this number, evenly spaced lines are as good as slabs between corners.
constexpr std::size_t most_slabs = 8192;
// Most intervals in all lines: a million long needles then take seconds, with fewer lines.
constexpr double most_intervals = 2e7;

struct Slab {
    double at, width; // middle
};

// Slabs between neighbouring corners, at most `step` wide; evenly spaced if there are too many corners.
std::vector<Slab> make_slabs(std::vector<double> corners, double step) {
    const double low = corners.front(), high = corners.back();
    const double tiny = 1e-12 * (high - low);
    corners.erase(std::unique(corners.begin(), corners.end(), [&](double a, double b) { return b - a <= tiny; }),
                  corners.end());
    if (corners.size() > most_slabs) corners = {low, high};
    corners.back() = high;
    std::vector<Slab> slabs;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const double width = corners[i + 1] - corners[i];
        const auto parts = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(width / step)));
        for (std::size_t n = 0; n < parts; ++n)
            slabs.push_back({corners[i] + width * (static_cast<double>(n) + 0.5) / static_cast<double>(parts),
                             width / static_cast<double>(parts)});
    }
    return slabs;
}

// The interval of a triangle on the line at `x`; its corners are sorted by x.
std::pair<double, double> cut(const FlatTriangle& t, double x) {
    const auto on = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return b.x() > a.x() ? a.y() + (b.y() - a.y()) * ((x - a.x()) / (b.x() - a.x())) : a.y();
    };
    const double through = on(t[0], t[2]), bent = x < t[1].x() ? on(t[0], t[1]) : on(t[1], t[2]);
    return std::minmax(through, bent);
}

struct Covered {
    double length = 0.0, moment = 0.0; // moment: of first order, about 0
};

Covered union_of(std::vector<std::pair<double, double>>& intervals) {
    std::sort(intervals.begin(), intervals.end());
    Covered covered;
    double reached = intervals.empty() ? 0.0 : intervals.front().first;
    for (const auto& [begin, end] : intervals) {
        if (end <= reached) continue;
        const double from = std::max(begin, reached);
        covered.length += end - from;
        covered.moment += 0.5 * (end - from) * (end + from);
        reached = end;
    }
    return covered;
}
} // namespace

double union_area(std::vector<FlatTriangle> triangles) {
    return union_silhouette(std::move(triangles)).area;
}

Silhouette union_silhouette(std::vector<FlatTriangle> triangles) {
    Silhouette seen;
    if (triangles.empty()) return seen;
    Eigen::Vector2d low = triangles[0][0], high = low;
    for (const FlatTriangle& t : triangles)
        for (const Eigen::Vector2d& p : t) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
    const Eigen::Vector2d size = high - low;
    const bool turn = size.y() > size.x();
    const double length = size.maxCoeff();
    if (!(length > 0.0)) return seen;

    std::vector<double> corners;
    corners.reserve(3 * triangles.size());
    double covered = 0.0;
    for (FlatTriangle& t : triangles) {
        for (Eigen::Vector2d& p : t) {
            if (turn) std::swap(p.x(), p.y());
            corners.push_back(p.x());
        }
        std::sort(t.begin(), t.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
        covered += (t[2].x() - t[0].x()) / length;
    }
    std::sort(triangles.begin(), triangles.end(), [](const FlatTriangle& a, const FlatTriangle& b) {
        return std::pair(a[0].x(), a[0].y()) < std::pair(b[0].x(), b[0].y());
    });
    std::sort(corners.begin(), corners.end());
    const double lines = std::min(static_cast<double>(even_lines), std::max(16.0, most_intervals / (covered + 1.0)));
    const bool know_corners = covered * static_cast<double>(most_slabs) < most_intervals;
    const std::vector<Slab> slabs = make_slabs(
        know_corners ? std::move(corners) : std::vector<double>{corners.front(), corners.back()}, length / lines);

    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    std::size_t next = 0;
    std::vector<std::size_t> active;
    std::vector<std::pair<double, double>> intervals;
    for (const Slab& slab : slabs) {
        while (next < triangles.size() && triangles[next][0].x() <= slab.at) active.push_back(next++);
        std::erase_if(active, [&](std::size_t t) { return triangles[t][2].x() < slab.at; });
        intervals.clear();
        for (const std::size_t t : active) intervals.push_back(cut(triangles[t], slab.at));
        const Covered covered_here = union_of(intervals);
        seen.area += covered_here.length * slab.width;
        moment += slab.width * Eigen::Vector2d(slab.at * covered_here.length, covered_here.moment);
    }
    if (!(seen.area > 0.0)) return seen;
    seen.centroid = moment / seen.area;
    if (turn) std::swap(seen.centroid.x(), seen.centroid.y());
    return seen;
}
} // namespace lr::baker
