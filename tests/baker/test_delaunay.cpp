// The Delaunay property, in exact arithmetic.
#include "baker/card/delaunay.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace lr::baker;

namespace {

__extension__ using Wide = __int128;

// Positive when d lies inside the circle through a, b, c, which are counter-clockwise.
Wide in_circle(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
    const auto row = [&](const GridPoint& p) {
        const Wide x = p.x - d.x, y = p.y - d.y;
        return std::array<Wide, 3>{x, y, x * x + y * y};
    };
    const auto p = row(a), q = row(b), r = row(c);
    return p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
}

// Faces are counter-clockwise, fill `doubled`, and have no point inside their circles.
void check(const std::vector<GridPoint>& points, Wide doubled) {
    const std::vector<Face> faces = delaunay(points);
    Wide area = 0;
    std::size_t bad = 0;
    for (const Face& f : faces) {
        const int64_t part = doubled_area(points[f[0]], points[f[1]], points[f[2]]);
        bad += part <= 0;
        area += part;
        for (const GridPoint& p : points) bad += in_circle(points[f[0]], points[f[1]], points[f[2]], p) > 0;
    }
    CHECK(bad == 0);
    CHECK((area == doubled));
}

} // namespace

TEST_CASE("delaunay: random points, near and far") {
    std::mt19937 random(3);
    for (const int32_t range : {50, 1000, 1 << 28}) {
        std::vector<GridPoint> points = {{-range, -range}, {range, -range}, {range, range}, {-range, range}};
        std::uniform_int_distribution<int32_t> coordinate(1 - range, range - 1);
        for (int i = 0; i < 200; ++i) {
            const GridPoint p{coordinate(random), coordinate(random)};
            if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
        }
        check(points, Wide{8} * range * range);
    }
}

TEST_CASE("delaunay: points on common circles and lines") {
    std::vector<GridPoint> lattice;
    for (int x = 0; x < 12; ++x)
        for (int y = 0; y < 9; ++y) lattice.push_back({x * 1000, y * 1000});
    check(lattice, Wide{2} * 11000 * 8000);
    // twelve points of one circle, by Pythagorean triples
    std::vector<GridPoint> circle;
    for (const auto& [x, y] : {std::pair{3, 4}, {4, 3}, {5, 0}, {4, -3}, {3, -4}, {0, -5}}) {
        circle.push_back({x * 12345, y * 12345});
        circle.push_back({-x * 12345, -y * 12345});
    }
    std::vector<GridPoint> hull = circle;
    std::sort(hull.begin(), hull.end(), [](const GridPoint& a, const GridPoint& b) {
        const bool above_a = a.y > 0 || (a.y == 0 && a.x > 0), above_b = b.y > 0 || (b.y == 0 && b.x > 0);
        return above_a != above_b ? above_a : doubled_area({0, 0}, a, b) > 0;
    });
    Wide doubled = 0;
    for (std::size_t i = 0; i < hull.size(); ++i) doubled += doubled_area({0, 0}, hull[i], hull[(i + 1) % hull.size()]);
    check(circle, doubled);
}
