// Resistances in creeping flow against the textbook's closed cases.
#include "asset/closed_forms/ellipsoid_formulas.h"

#include "support/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace lr::shape;
using std::numbers::pi;
using test::Random;

TEST_CASE("R_F agrees with Carlson's numbers, its symmetry and its scaling") {
    // Numerical Algorithms 10 (1995), section 3.
    CHECK(carlson_rf(1.0, 2.0, 0.0) == doctest::Approx(1.3110287771461).epsilon(1e-13));
    CHECK(carlson_rf(0.5, 1.0, 0.0) == doctest::Approx(1.8540746773014).epsilon(1e-13));
    CHECK(carlson_rf(2.0, 3.0, 4.0) == doctest::Approx(0.58408284167715).epsilon(1e-13));
    CHECK(carlson_rf(3.0, 3.0, 3.0) == doctest::Approx(1.0 / std::sqrt(3.0)).epsilon(1e-15));
    CHECK(carlson_rf(0.0, 1.0, 1.0) == doctest::Approx(0.5 * pi).epsilon(1e-14));
    Random random(31);
    for (int round = 0; round < 100; ++round) {
        const double x = random.logarithmic(1e-8, 1.0), y = random.logarithmic(1e-8, 1.0),
                     z = random.logarithmic(1e-8, 1.0), s = random.logarithmic(1e-6, 1e6);
        const double value = carlson_rf(x, y, z);
        CHECK(carlson_rf(z, x, y) == doctest::Approx(value).epsilon(1e-14));
        CHECK(carlson_rf(s * x, s * y, s * z) == doctest::Approx(value / std::sqrt(s)).epsilon(1e-13));
    }
}

TEST_CASE("a sphere resists with 6 pi a and 8 pi a^3") {
    for (double a : {1e-6, 0.01, 1.0, 1000.0}) {
        const StokesResistance r = stokes_resistance({a, a, a});
        for (size_t i = 0; i < 3; ++i) {
            CHECK(r.translation[i] == doctest::Approx(6.0 * pi * a).epsilon(1e-14));
            CHECK(r.rotation[i] == doctest::Approx(8.0 * pi * a * a * a).epsilon(1e-14));
        }
    }
}

TEST_CASE("a disc without thickness: 16 a broadside, 32/3 a edge on, 32/3 a^3 about any axis") {
    const double a = 0.03;
    const StokesResistance r = stokes_resistance({a, 0.0, a});
    CHECK(r.translation[1] == doctest::Approx(16.0 * a).epsilon(1e-13));
    for (size_t i : {size_t{0}, size_t{2}}) CHECK(r.translation[i] == doctest::Approx(32.0 / 3.0 * a).epsilon(1e-13));
    for (size_t i = 0; i < 3; ++i) CHECK(r.rotation[i] == doctest::Approx(32.0 / 3.0 * a * a * a).epsilon(1e-13));
    // To first order in the thickness.
    for (double thin : {1e-2, 1e-4, 1e-6, 1e-9, 1e-12}) {
        const StokesResistance near = stokes_resistance({a, thin * a, a});
        for (size_t i = 0; i < 3; ++i) {
            CHECK(std::abs(near.translation[i] / r.translation[i] - 1.0) < 1.5 * thin + 1e-13);
            CHECK(std::abs(near.rotation[i] / r.rotation[i] - 1.0) < 1.5 * thin + 1e-13);
        }
    }
}

// Kim & Karrila, Microhydrodynamics, table 3.4.
TEST_CASE("prolate spheroids agree with their elementary forms, from nearly round to needles") {
    for (double e : {0.2, 0.5, 0.9, 0.999, 0.999999}) {
        const double b = std::sqrt((1.0 - e) * (1.0 + e)), l = std::log1p(2.0 * e / (1.0 - e));
        const double e3 = e * e * e;
        const double along = 8.0 / 3.0 * e3 / ((1.0 + e * e) * l - 2.0 * e);
        const double across = 16.0 / 3.0 * e3 / ((3.0 * e * e - 1.0) * l + 2.0 * e);
        const double roll = 4.0 / 3.0 * e3 * b * b / (2.0 * e - b * b * l);
        const double tumble = 4.0 / 3.0 * e3 * (2.0 - e * e) / ((1.0 + e * e) * l - 2.0 * e);
        const StokesResistance r = stokes_resistance({b, 1.0, b});
        const double digits = e < 0.3 ? 1e-10 : 1e-12;
        CHECK(r.translation[1] == doctest::Approx(6.0 * pi * along).epsilon(digits));
        CHECK(r.translation[0] == doctest::Approx(6.0 * pi * across).epsilon(digits));
        CHECK(r.rotation[1] == doctest::Approx(8.0 * pi * roll).epsilon(digits));
        CHECK(r.rotation[2] == doctest::Approx(8.0 * pi * tumble).epsilon(digits));
    }
}

TEST_CASE("resistances of any ellipsoid are finite, grow with the body and scale with it") {
    Random random(32);
    for (int round = 0; round < 300; ++round) {
        std::array<double, 3> a{};
        for (double& x : a) x = random.logarithmic(1e-5, 1.0);
        const StokesResistance r = stokes_resistance(a);
        const double s = random.logarithmic(1e-4, 1e4);
        const StokesResistance scaled = stokes_resistance({s * a[0], s * a[1], s * a[2]});
        const auto [least, most] = std::minmax({a[0], a[1], a[2]});
        for (size_t i = 0; i < 3; ++i) {
            // Hill & Power 1956: between the resistances of the inscribed and the circumscribed sphere.
            CHECK(r.translation[i] > 6.0 * pi * least * (1.0 - 1e-12));
            CHECK(r.translation[i] < 6.0 * pi * most * (1.0 + 1e-12));
            CHECK(r.rotation[i] > 8.0 * pi * least * least * least * (1.0 - 1e-12));
            CHECK(r.rotation[i] < 8.0 * pi * most * most * most * (1.0 + 1e-12));
            CHECK(scaled.translation[i] == doctest::Approx(s * r.translation[i]).epsilon(1e-11));
            CHECK(scaled.rotation[i] == doctest::Approx(s * s * s * r.rotation[i]).epsilon(1e-11));
        }
        std::array<double, 3> larger = a;
        larger[static_cast<size_t>(round) % 3] *= 1.1;
        const StokesResistance more = stokes_resistance(larger);
        for (size_t i = 0; i < 3; ++i) CHECK(more.translation[i] > r.translation[i]);
    }
    for (const double x : stokes_resistance({1.0, 0.0, 0.0}).rotation) CHECK((std::isfinite(x) && x > 0.0));
}
