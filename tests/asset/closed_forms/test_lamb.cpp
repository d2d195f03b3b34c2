// Lamb's closed forms against the published numbers, limits, and an independent integration.
#include "asset/closed_forms/ellipsoid_formulas.h"

#include "support/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace lr::shape;
using test::Random;

namespace {

// int_0^inf f(l) dl by the double exponential rule l = unit exp(pi/2 sinh t), which suits such integrands.
template <class F> double integral(F&& f, double unit) {
    double sum = 0.0;
    const double h = 1.0 / 128.0;
    for (int i = -128 * 4; i <= 128 * 4; ++i) {
        const double t = h * i;
        const double l = unit * std::exp(0.5 * std::numbers::pi * std::sinh(t));
        const double term = f(l) * l * 0.5 * std::numbers::pi * std::cosh(t);
        if (std::isfinite(term)) sum += term;
    }
    return sum * h;
}

double alpha(const std::array<double, 3>& a, size_t i) {
    const double unit = std::cbrt(a[0] * a[1] * a[2]);
    return a[0] * a[1] * a[2] *
           integral(
               [&](double l) {
                   return 1.0 /
                          ((a[i] * a[i] + l) * std::sqrt((a[0] * a[0] + l) * (a[1] * a[1] + l) * (a[2] * a[2] + l)));
               },
               unit * unit);
}

double volume(const std::array<double, 3>& a) {
    return 4.0 / 3.0 * std::numbers::pi * a[0] * a[1] * a[2];
}

std::array<double, 3> random_axes(Random& random, double flattest) {
    return {random.logarithmic(flattest, 1.0), random.logarithmic(flattest, 1.0), random.logarithmic(flattest, 1.0)};
}

} // namespace

TEST_CASE("the 4:2:1 ellipsoid has the published coefficients") {
    const std::array<double, 3> axes = {4.0, 2.0, 1.0};
    const EllipsoidAddedMass m = lamb_added_mass(axes);
    const double expected[3] = {0.12657, 0.39817, 1.51806};
    for (size_t i = 0; i < 3; ++i) CHECK(std::abs(m.translation[i] / volume(axes) - expected[i]) < 5e-6);
}

TEST_CASE("a sphere drags half its volume and turns freely") {
    for (double r : {1e-6, 0.01, 1.0, 1000.0}) {
        const EllipsoidAddedMass m = lamb_added_mass({r, r, r});
        for (size_t i = 0; i < 3; ++i) {
            CHECK(m.translation[i] / volume({r, r, r}) == doctest::Approx(0.5).epsilon(1e-13));
            CHECK(m.rotation[i] == 0.0);
        }
    }
}

TEST_CASE("a thin disc tends to 8/3 a^3 broadside and 16/45 a^5 about a diameter") {
    double last_a = 1e9, last_d = 1e9;
    for (double thickness : {1e-2, 1e-3, 1e-4}) {
        const EllipsoidAddedMass m = lamb_added_mass({1.0, thickness, 1.0});
        const double a = std::abs(m.translation[1] * 3.0 / 8.0 - 1.0), d = std::abs(m.rotation[0] * 45.0 / 16.0 - 1.0);
        // To first order in the thickness.
        CHECK(a < thickness);
        CHECK(d < 3.0 * thickness);
        CHECK(a < 0.2 * last_a);
        CHECK(d < 0.2 * last_d);
        last_a = a, last_d = d;
        CHECK(m.rotation[1] == 0.0); // about its axis of revolution
        CHECK(m.rotation[0] == doctest::Approx(m.rotation[2]).epsilon(1e-12));
        CHECK(m.translation[0] < 1.6 * thickness * thickness * 4.0);
    }
}

TEST_CASE("a long needle drags its own volume across, as a cylinder does, and none along") {
    const EllipsoidAddedMass m = lamb_added_mass({1.0, 1e-3, 1e-3});
    const double v = volume({1.0, 1e-3, 1e-3});
    CHECK(m.translation[0] / v < 1e-4);
    CHECK(m.translation[1] / v == doctest::Approx(1.0).epsilon(1e-4));
    CHECK(m.rotation[0] == 0.0);
}

TEST_CASE("random ellipsoids agree with quadrature of Lamb's integrals") {
    Random random(5);
    for (int round = 0; round < 100; ++round) {
        const std::array<double, 3> a = random_axes(random, 0.01);
        CAPTURE(a[0]);
        CAPTURE(a[1]);
        CAPTURE(a[2]);
        const double q[3] = {alpha(a, 0), alpha(a, 1), alpha(a, 2)};
        REQUIRE(q[0] + q[1] + q[2] == doctest::Approx(2.0).epsilon(1e-10)); // otherwise the quadrature is wrong
        const EllipsoidAddedMass m = lamb_added_mass(a);
        for (size_t i = 0; i < 3; ++i) {
            const size_t j = (i + 1) % 3, k = (i + 2) % 3;
            CHECK(m.translation[i] == doctest::Approx(volume(a) * q[i] / (q[j] + q[k])).epsilon(1e-8));
            const double b2 = a[j] * a[j], c2 = a[k] * a[k];
            if (std::abs(b2 - c2) < 0.05 * (b2 + c2)) continue; // the quadrature's digits cancel
            const double d =
                volume(a) / 5.0 * (b2 - c2) * (b2 - c2) * (q[k] - q[j]) / (2.0 * (b2 - c2) + (b2 + c2) * (q[j] - q[k]));
            CHECK(m.rotation[i] == doctest::Approx(d).epsilon(1e-6));
        }
    }
}

TEST_CASE("added mass goes with the third and fifth power of the size, in whatever order the axes come") {
    Random random(6);
    for (int round = 0; round < 100; ++round) {
        const std::array<double, 3> a = random_axes(random, 1e-3);
        const EllipsoidAddedMass m = lamb_added_mass(a);
        for (double s : {1e-3, 1e3}) {
            const EllipsoidAddedMass scaled = lamb_added_mass({s * a[0], s * a[1], s * a[2]});
            for (size_t i = 0; i < 3; ++i) {
                CHECK(scaled.translation[i] == doctest::Approx(s * s * s * m.translation[i]).epsilon(1e-11));
                CHECK(scaled.rotation[i] == doctest::Approx(std::pow(s, 5.0) * m.rotation[i]).epsilon(1e-6));
            }
        }
        const EllipsoidAddedMass turned = lamb_added_mass({a[2], a[0], a[1]});
        for (size_t i = 0; i < 3; ++i) {
            CHECK(turned.translation[(i + 1) % 3] == doctest::Approx(m.translation[i]).epsilon(1e-13));
            CHECK(turned.rotation[(i + 1) % 3] == doctest::Approx(m.rotation[i]).epsilon(1e-9));
        }
        // The longer the axis the smaller the drag along it.
        for (size_t i = 0; i < 3; ++i)
            for (size_t j = 0; j < 3; ++j)
                if (a[i] > a[j]) CHECK(m.translation[i] < m.translation[j]);
    }
}

// Nearly a body of revolution: both factors of the closed form vanish. The limit is 0, quadratic in the difference.
TEST_CASE("rotation goes to zero smoothly towards an axis of revolution") {
    for (const std::array<double, 3> base :
         {std::array{1.0, 0.5, 0.5}, std::array{0.1, 1.0, 1.0}, std::array{1.0, 1.0, 1.0}}) {
        double last = 0.0;
        for (double e : {1e-1, 1e-2, 1e-3, 1e-4}) {
            const double d = lamb_added_mass({base[0], base[1] * (1.0 + e), base[2]}).rotation[0] / (e * e);
            CAPTURE(e);
            CHECK(d > 0.0);
            if (last != 0.0) CHECK(d == doctest::Approx(last).epsilon(e < 1e-3 ? 2e-2 : 0.3));
            last = d;
        }
    }
}

TEST_CASE("R_D agrees with quadrature and with its closed cases") {
    Random random(7);
    for (int round = 0; round < 200; ++round) {
        const double x = random.logarithmic(1e-4, 1.0), y = random.logarithmic(1e-4, 1.0),
                     z = random.logarithmic(1e-4, 1.0);
        const double expected =
            1.5 * integral([&](double t) { return 1.0 / ((t + z) * std::sqrt((t + x) * (t + y) * (t + z))); },
                           std::sqrt(x * z));
        CHECK(carlson_rd(x, y, z) == doctest::Approx(expected).epsilon(1e-9));
        CHECK(carlson_rd(y, x, z) == doctest::Approx(carlson_rd(x, y, z)).epsilon(1e-14));
        const double s = random.logarithmic(1e-6, 1e6);
        CHECK(carlson_rd(s * x, s * y, s * z) ==
              doctest::Approx(std::pow(s, -1.5) * carlson_rd(x, y, z)).epsilon(1e-12));
    }
    CHECK(carlson_rd(2.0, 2.0, 2.0) == doctest::Approx(std::pow(2.0, -1.5)).epsilon(1e-14));
    // Carlson, Numerical Algorithms 10 (1995), section 3.
    CHECK(carlson_rd(0.0, 2.0, 1.0) == doctest::Approx(1.7972103521033883).epsilon(1e-13));
    CHECK(carlson_rd(2.0, 3.0, 4.0) == doctest::Approx(0.16510527294261053).epsilon(1e-13));
}
