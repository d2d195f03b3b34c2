// Measures of an ellipsoid's surface: closed cases, limits, and an independent integration.
#include "asset/closed_forms/ellipsoid_formulas.h"

#include "support/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace lr::shape;
using std::numbers::pi;
using test::Random;

namespace {

// By the midpoint rule in z and the azimuth, which is periodic.
AerodynamicGeometry by_midpoints(const std::array<double, 3>& a) {
    AerodynamicGeometry out;
    std::array<double, 3> squared{};
    constexpr int rings = 800, turns = 400;
    for (int m = 0; m < rings; ++m)
        for (int n = 0; n < turns; ++n) {
            const double theta = (m + 0.5) * pi / rings, phi = (n + 0.5) * 2.0 * pi / turns;
            const double weight = std::sin(theta) * pi / rings * 2.0 * pi / turns;
            const double u[3] = {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
            double r[3], normal[3];
            for (size_t i = 0; i < 3; ++i) {
                r[i] = a[i] * u[i];
                normal[i] = a[(i + 1) % 3] * a[(i + 2) % 3] * u[i];
            }
            const double length = std::hypot(normal[0], normal[1], normal[2]);
            out.surface += weight * length;
            for (size_t k = 0; k < 3; ++k) {
                const size_t i = (k + 1) % 3, j = (k + 2) % 3;
                const double c = std::abs(normal[j] * r[i] - normal[i] * r[j]) / length;
                squared[k] += weight * normal[k] * normal[k] / length;
                out.stroke2[k] += 0.5 * weight * length * c * c;
                out.stroke3[k] += 0.5 * weight * length * c * c * c;
                out.rub[k] += weight * length * std::pow(std::hypot(r[i], r[j]), 3);
            }
        }
    for (size_t k = 0; k < 3; ++k) out.bluntness[k] = squared[k] / (2.0 * pi * a[(k + 1) % 3] * a[(k + 2) % 3]);
    return out;
}

} // namespace

TEST_CASE("a sphere's measures") {
    for (double a : {1e-6, 0.02, 1000.0}) {
        const AerodynamicGeometry g = ellipsoid_geometry({a, a, a});
        CHECK(g.surface == doctest::Approx(4.0 * pi * a * a).epsilon(1e-13));
        CHECK(g.volume == doctest::Approx(4.0 / 3.0 * pi * a * a * a).epsilon(1e-14));
        for (size_t k = 0; k < 3; ++k) {
            CHECK(g.extent[k] == 2.0 * a);
            CHECK(g.area[k] == doctest::Approx(pi * a * a).epsilon(1e-14));
            CHECK(g.bluntness[k] == doctest::Approx(2.0 / 3.0).epsilon(1e-13));
            CHECK(g.stroke2[k] == 0.0);
            CHECK(g.stroke3[k] == 0.0);
            CHECK(g.rub[k] == doctest::Approx(0.75 * pi * pi * std::pow(a, 5)).epsilon(1e-12));
        }
    }
}

TEST_CASE("a flat ellipsoid tends to an elliptic disc") {
    const double a = 0.03, b = 0.02, thin = 1e-4 * a;
    const AerodynamicGeometry g = ellipsoid_geometry({a, b, thin});
    CHECK(g.surface == doctest::Approx(2.0 * pi * a * b).epsilon(1e-6));
    CHECK(g.bluntness[2] == doctest::Approx(1.0).epsilon(1e-6));
    CHECK(g.stroke2[0] == doctest::Approx(pi / 4.0 * a * b * b * b).epsilon(1e-6));
    CHECK(g.stroke2[1] == doctest::Approx(pi / 4.0 * b * a * a * a).epsilon(1e-6));
    CHECK(g.stroke3[0] == doctest::Approx(8.0 / 15.0 * a * std::pow(b, 4)).epsilon(1e-6));
    CHECK(g.stroke3[1] == doctest::Approx(8.0 / 15.0 * b * std::pow(a, 4)).epsilon(1e-6));
    CHECK(g.rub[0] == doctest::Approx(2.0 * 8.0 / 15.0 * a * std::pow(b, 4)).epsilon(1e-6));
    const AerodynamicGeometry disc = ellipsoid_geometry({a, a, thin});
    CHECK(disc.stroke3[2] == 0.0);
    CHECK(disc.rub[2] == doctest::Approx(2.0 * 2.0 * pi / 5.0 * std::pow(a, 5)).epsilon(1e-6));
}

TEST_CASE("surfaces of spheroids have their elementary forms") {
    for (double e : {0.3, 0.8, 0.99, 0.999999}) {
        const double b = std::sqrt((1.0 - e) * (1.0 + e));
        CHECK(ellipsoid_geometry({1.0, b, b}).surface ==
              doctest::Approx(2.0 * pi * b * (b + std::asin(e) / e)).epsilon(1e-12));
        CHECK(ellipsoid_geometry({1.0, b, 1.0}).surface ==
              doctest::Approx(2.0 * pi * (1.0 + b * b / e * std::atanh(e))).epsilon(1e-12));
    }
}

TEST_CASE("random ellipsoids agree with the midpoint rule") {
    Random random(41);
    for (int round = 0; round < 6; ++round) {
        const std::array<double, 3> a{random.logarithmic(0.15, 1.0), random.logarithmic(0.15, 1.0),
                                      random.logarithmic(0.15, 1.0)};
        const AerodynamicGeometry g = ellipsoid_geometry(a), expected = by_midpoints(a);
        CHECK(g.surface == doctest::Approx(expected.surface).epsilon(1e-4));
        for (size_t k = 0; k < 3; ++k) {
            CHECK(g.bluntness[k] == doctest::Approx(expected.bluntness[k]).epsilon(1e-4));
            CHECK(g.stroke2[k] == doctest::Approx(expected.stroke2[k]).epsilon(1e-4));
            CHECK(g.stroke3[k] == doctest::Approx(expected.stroke3[k]).epsilon(1e-4));
            CHECK(g.rub[k] == doctest::Approx(expected.rub[k]).epsilon(1e-4));
        }
    }
}

TEST_CASE("the quadrature knows no axis: turned ellipsoids have turned measures, however slender") {
    Random random(42);
    for (int round = 0; round < 60; ++round) {
        const double flattest = round < 30 ? 0.05 : 1e-4;
        const std::array<double, 3> a{random.logarithmic(flattest, 1.0), random.logarithmic(flattest, 1.0),
                                      random.logarithmic(flattest, 1.0)};
        const double s = random.logarithmic(1e-4, 1e3), digits = round < 30 ? 1e-9 : 1e-5;
        const AerodynamicGeometry g = ellipsoid_geometry(a);
        const AerodynamicGeometry turned = ellipsoid_geometry({s * a[2], s * a[0], s * a[1]});
        for (size_t k = 0; k < 3; ++k) {
            const size_t to = (k + 1) % 3;
            CHECK(turned.area[to] == doctest::Approx(s * s * g.area[k]).epsilon(1e-12));
            CHECK(turned.bluntness[to] == doctest::Approx(g.bluntness[k]).epsilon(1e-10));
            CHECK(turned.stroke2[to] == doctest::Approx(std::pow(s, 4) * g.stroke2[k]).epsilon(digits));
            CHECK(turned.stroke3[to] == doctest::Approx(std::pow(s, 5) * g.stroke3[k]).epsilon(digits));
            CHECK(turned.rub[to] == doctest::Approx(std::pow(s, 5) * g.rub[k]).epsilon(digits));
            CHECK((g.bluntness[k] > 0.0 && g.bluntness[k] < 1.0));
        }
    }
}
