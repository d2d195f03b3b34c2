// Measures of triangles: bodies calculated by hand, invariance (winding, subdivision), and brute force.
#include "baker/aerodynamics/surface_measures.h"

#include "support/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace lr::shape;
using std::numbers::pi;
using test::Random;

namespace {

using Point = SurfaceMeasures::Point;
using Triangle = std::array<Point, 3>;

constexpr std::array<double, 9> identity{1, 0, 0, 0, 1, 0, 0, 0, 1};

AerodynamicGeometry measure(const std::vector<Triangle>& triangles, double sides, const Point& centre = {0, 0, 0},
                            double size = 1.0) {
    SurfaceMeasures m(identity, centre, size);
    for (const Triangle& t : triangles) m.add(t[0], t[1], t[2], sides);
    return m.geometry();
}

std::vector<Triangle> quad(const Point& a, const Point& b, const Point& c, const Point& d) {
    return {{a, b, c}, {a, c, d}};
}

std::vector<Triangle> split(const std::vector<Triangle>& from) {
    std::vector<Triangle> out;
    const auto between = [](const Point& a, const Point& b) {
        Point p{};
        for (size_t i = 0; i < 3; ++i) p[i] = 0.5 * (a[i] + b[i]);
        return p;
    };
    for (const auto& [a, b, c] : from) {
        const Point ab = between(a, b), bc = between(b, c), ca = between(c, a);
        out.insert(out.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return out;
}

Point random_point(Random& random) {
    return {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
}

void check_same(const AerodynamicGeometry& a, const AerodynamicGeometry& b, double digits, double rub_digits) {
    CHECK(a.surface == doctest::Approx(b.surface).epsilon(digits));
    for (size_t k = 0; k < 3; ++k) {
        CHECK(a.extent[k] == doctest::Approx(b.extent[k]).epsilon(digits));
        CHECK(a.area[k] == doctest::Approx(b.area[k]).epsilon(digits));
        CHECK(a.bluntness[k] == doctest::Approx(b.bluntness[k]).epsilon(digits));
        CHECK(a.stroke2[k] == doctest::Approx(b.stroke2[k]).epsilon(digits));
        CHECK(a.stroke3[k] == doctest::Approx(b.stroke3[k]).epsilon(digits));
        CHECK(a.rub[k] == doctest::Approx(b.rub[k]).epsilon(rub_digits));
    }
}

} // namespace

TEST_CASE("a card 2:1, both sides: moments of its area and thirds") {
    const double a = 0.1, b = 0.05; // half sides
    const AerodynamicGeometry g = measure(quad({-a, -b, 0}, {a, -b, 0}, {a, b, 0}, {-a, b, 0}), 2.0, {0, 0, 0}, 0.2);
    CHECK(g.surface == doctest::Approx(8.0 * a * b).epsilon(1e-14));
    CHECK(g.area[2] == doctest::Approx(4.0 * a * b).epsilon(1e-14));
    CHECK(g.bluntness[2] == doctest::Approx(1.0).epsilon(1e-14));
    CHECK(g.stroke2[0] == doctest::Approx(2.0 * a * 2.0 / 3.0 * b * b * b).epsilon(1e-14));
    CHECK(g.stroke2[1] == doctest::Approx(2.0 * b * 2.0 / 3.0 * a * a * a).epsilon(1e-14));
    CHECK(g.stroke3[0] == doctest::Approx(2.0 * a * 0.5 * std::pow(b, 4)).epsilon(1e-13));
    CHECK(g.stroke3[1] == doctest::Approx(2.0 * b * 0.5 * std::pow(a, 4)).epsilon(1e-13));
    CHECK(g.rub[0] == doctest::Approx(2.0 * g.stroke3[0]).epsilon(1e-5));
    for (size_t k = 0; k < 2; ++k) {
        CHECK(g.area[k] == 0.0);
        CHECK(g.bluntness[k] == 0.0);
    }
    CHECK((g.stroke2[2] == 0.0 && g.stroke3[2] == 0.0 && g.extent[2] == 0.0));
    CHECK((g.extent[0] == doctest::Approx(2.0 * a) && g.extent[1] == doctest::Approx(2.0 * b)));
}

TEST_CASE("a cube, by hand") {
    const double h = 0.02;
    std::vector<Triangle> cube;
    for (size_t k = 0; k < 3; ++k)
        for (double side : {-h, h}) {
            const auto corner = [&](double u, double v) {
                Point p{};
                p[k] = side, p[(k + 1) % 3] = u, p[(k + 2) % 3] = v;
                return p;
            };
            for (const Triangle& t : quad(corner(-h, -h), corner(h, -h), corner(h, h), corner(-h, h)))
                cube.push_back(t);
        }
    const AerodynamicGeometry g = measure(cube, 1.0, {0, 0, 0}, 2.0 * h);
    CHECK(g.surface == doctest::Approx(24.0 * h * h).epsilon(1e-14));
    // Two faces square to the axis, at all distances from it; four along it, each int (h^2 + y^2)^(3/2).
    double ends = 0.0, sides = 0.0;
    constexpr int n = 400;
    for (int i = 0; i < n; ++i) {
        const double x = (i + 0.5) * h / n;
        sides += 4.0 * 2.0 * h * 2.0 * h / n * std::pow(h * h + x * x, 1.5);
        for (int j = 0; j < n; ++j) {
            const double y = (j + 0.5) * h / n;
            ends += 2.0 * 4.0 * h / n * h / n * std::pow(x * x + y * y, 1.5);
        }
    }
    for (size_t k = 0; k < 3; ++k) {
        CHECK(g.area[k] == doctest::Approx(4.0 * h * h).epsilon(1e-14));
        CHECK(g.bluntness[k] == doctest::Approx(1.0).epsilon(1e-14));
        CHECK(g.stroke2[k] == doctest::Approx(8.0 / 3.0 * std::pow(h, 4)).epsilon(1e-13));
        CHECK(g.stroke3[k] == doctest::Approx(2.0 * std::pow(h, 5)).epsilon(1e-13));
        CHECK(g.rub[k] == doctest::Approx(ends + sides).epsilon(2e-5));
    }
    // Cut into small triangles, and wound the other way.
    std::vector<Triangle> small = split(split(split(cube)));
    for (Triangle& t : small) std::swap(t[0], t[1]);
    check_same(measure(small, 1.0, {0, 0, 0}, 2.0 * h), g, 1e-12, 1e-5);
}

TEST_CASE("a disc of many sectors: the third moment about a diameter is 8/15 a^5") {
    const double a = 0.03;
    constexpr int sectors = 720;
    std::vector<Triangle> disc;
    for (int i = 0; i < sectors; ++i) {
        const double from = 2.0 * pi * i / sectors, to = 2.0 * pi * (i + 1) / sectors;
        disc.push_back(
            {Point{0, 0, 0}, {a * std::cos(from), a * std::sin(from), 0}, {a * std::cos(to), a * std::sin(to), 0}});
    }
    const AerodynamicGeometry g = measure(disc, 2.0, {0, 0, 0}, 2.0 * a);
    for (size_t k = 0; k < 2; ++k) {
        CHECK(g.stroke2[k] == doctest::Approx(pi / 4.0 * std::pow(a, 4)).epsilon(1e-4));
        CHECK(g.stroke3[k] == doctest::Approx(8.0 / 15.0 * std::pow(a, 5)).epsilon(1e-4));
    }
    CHECK(g.rub[2] == doctest::Approx(4.0 / 5.0 * pi * std::pow(a, 5)).epsilon(1e-4));
}

TEST_CASE("random triangles: no subdivision and no order of corners changes a measure") {
    Random random(71);
    for (int round = 0; round < 100; ++round) {
        std::vector<Triangle> soup;
        for (int i = 0; i < 3; ++i) soup.push_back({random_point(random), random_point(random), random_point(random)});
        // Zero lines of the stroke through a corner, and along a side.
        if (round % 5 == 0) soup[0][0] = {0.0, 0.0, 0.0};
        if (round % 5 == 1) soup[0][0] = {0.0, 0.0, 0.3}, soup[0][1] = {0.0, 0.0, -0.6};
        const Point centre = round % 2 == 0 ? Point{0, 0, 0} : random_point(random);
        const AerodynamicGeometry g = measure(soup, 1.0, centre);
        std::vector<Triangle> other = split(soup);
        for (Triangle& t : other) std::swap(t[0], t[random.below(3)]);
        check_same(measure(other, 1.0, centre), g, 1e-11, 1e-5);
        check_same(measure(split(other), 1.0, centre, 17.0), g, 1e-11, 1e-5);
        const AerodynamicGeometry twice = measure(soup, 2.0, centre);
        CHECK(twice.stroke3[0] == doctest::Approx(2.0 * g.stroke3[0]).epsilon(1e-14));
    }
}

TEST_CASE("strokes of random triangles agree with points spread over them") {
    Random random(72);
    for (int round = 0; round < 20; ++round) {
        const Triangle t{random_point(random), random_point(random), random_point(random)};
        const AerodynamicGeometry g = measure({t}, 1.0);
        Point u{}, v{}, n{};
        for (size_t i = 0; i < 3; ++i) u[i] = t[1][i] - t[0][i], v[i] = t[2][i] - t[0][i];
        for (size_t i = 0; i < 3; ++i) n[i] = u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
        const double twice = std::hypot(n[0], n[1], n[2]);
        for (double& x : n) x /= twice;
        std::array<double, 3> third{}, rub{};
        constexpr int cuts = 300;
        for (int i = 0; i < cuts; ++i)
            for (int j = 0; j + i < cuts; ++j)
                for (int half = 0; half < (i + j + 1 < cuts ? 2 : 1); ++half) {
                    const double p = (i + (half + 1) / 3.0) / cuts, q = (j + (half + 1) / 3.0) / cuts;
                    Point r{};
                    for (size_t k = 0; k < 3; ++k) r[k] = t[0][k] + p * u[k] + q * v[k];
                    for (size_t k = 0; k < 3; ++k) {
                        const size_t a = (k + 1) % 3, b = (k + 2) % 3;
                        third[k] += std::pow(std::abs(n[b] * r[a] - n[a] * r[b]), 3) * 0.5 * twice / (cuts * cuts);
                        rub[k] += std::pow(std::hypot(r[a], r[b]), 3) * 0.5 * twice / (cuts * cuts);
                    }
                }
        for (size_t k = 0; k < 3; ++k) {
            CHECK(g.stroke3[k] == doctest::Approx(0.5 * third[k]).epsilon(1e-3));
            CHECK(g.rub[k] == doctest::Approx(rub[k]).epsilon(1e-3));
        }
    }
}
