// Axes of inertia: known axes, the body's own axes if they are principal, and no jumps from noise.
#include "baker/aerodynamics/principal_axes.h"

#include "support/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using lr::shape::principal_axes;
using test::Random;

namespace {

using Matrix = std::array<double, 9>;
constexpr Matrix identity{1, 0, 0, 0, 1, 0, 0, 0, 1};

// Rows of `axes` are the principal axes.
Matrix inertia(const std::array<double, 3>& moments, const Matrix& axes) {
    Matrix m{};
    for (size_t k = 0; k < 3; ++k)
        for (size_t i = 0; i < 9; ++i) m[i] += moments[k] * axes[3 * k + i / 3] * axes[3 * k + i % 3];
    return m;
}

Matrix rotation(Random& random, double largest_angle) {
    double n[3], length = 0.0;
    for (double& x : n) x = random.uniform(-1.0, 1.0), length += x * x;
    for (double& x : n) x /= std::sqrt(length);
    const double angle = random.uniform(-largest_angle, largest_angle), c = std::cos(angle), s = std::sin(angle);
    Matrix r{};
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) r[3 * i + j] = (1.0 - c) * n[i] * n[j] + (i == j ? c : 0.0);
    r[1] -= s * n[2], r[2] += s * n[1], r[3] += s * n[2], r[5] -= s * n[0], r[6] -= s * n[1], r[7] += s * n[0];
    return r;
}

double distance(const Matrix& a, const Matrix& b) {
    double most = 0.0;
    for (size_t i = 0; i < 9; ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

void check_right_handed(const Matrix& e) {
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) {
            double dot = 0.0;
            for (size_t n = 0; n < 3; ++n) dot += e[3 * i + n] * e[3 * j + n];
            CHECK(std::abs(dot - (i == j ? 1.0 : 0.0)) < 1e-14);
        }
    CHECK(e[0] * (e[4] * e[8] - e[5] * e[7]) + e[1] * (e[5] * e[6] - e[3] * e[8]) + e[2] * (e[3] * e[7] - e[4] * e[6]) >
          0.9);
}

} // namespace

TEST_CASE("axes that are the body's come back to the last bit, in body order") {
    Random random(61);
    for (int round = 0; round < 100; ++round) {
        std::array<double, 3> moments{};
        for (double& m : moments) m = random.logarithmic(1e-12, 1e-3);
        Matrix m = inertia(moments, identity);
        const double largest = std::max({moments[0], moments[1], moments[2]});
        CHECK(principal_axes(m) == identity);
        for (size_t i = 0; i < 9; ++i)
            if (i % 4 != 0) m[i] += random.uniform(-1e-7, 1e-7) * largest;
        CHECK(principal_axes(m) == identity);
    }
}

TEST_CASE("square to a mirror plane there is an axis, to the last bit") {
    Random random(65);
    for (int round = 0; round < 50; ++round) {
        const double angle = random.uniform(0.001, 0.7), c = std::cos(angle), s = std::sin(angle);
        Matrix m = inertia({0.2, 0.6, 1.0}, {c, 0, s, 0, 1, 0, -s, 0, c});
        for (size_t i : {size_t{1}, size_t{5}}) m[i] += random.uniform(-1e-9, 1e-9);
        const Matrix e = principal_axes(m);
        CHECK((e[1] == 0.0 && e[3] == 0.0 && e[4] == 1.0 && e[5] == 0.0 && e[7] == 0.0));
        CHECK(e[0] == doctest::Approx(c).epsilon(1e-8));
    }
}

TEST_CASE("distinct moments give their axes back, each under the number of the nearest body axis") {
    Random random(62);
    for (int round = 0; round < 300; ++round) {
        // A twentieth apart at least, so that rounding is not magnified much.
        std::array<double, 3> moments{random.uniform(0.1, 0.5), random.uniform(0.6, 0.8), random.uniform(0.9, 1.0)};
        std::swap(moments[0], moments[random.below(3)]);
        const double unit = random.logarithmic(1e-12, 1e3);
        for (double& m : moments) m *= unit;
        const Matrix small = rotation(random, 0.6), axes = principal_axes(inertia(moments, small));
        CHECK(distance(axes, small) < 1e-5); // entries of a millionth are rounding
        const Matrix any = principal_axes(inertia(moments, rotation(random, 3.1)));
        check_right_handed(any);
        // They diagonalise it.
        const Matrix turned = rotation(random, 3.1), m = inertia(moments, turned), e = principal_axes(m);
        for (size_t i = 0; i < 3; ++i)
            for (size_t j = 0; j < i; ++j) {
                double off = 0.0;
                for (size_t a = 0; a < 3; ++a)
                    for (size_t b = 0; b < 3; ++b) off += e[3 * i + a] * m[3 * a + b] * e[3 * j + b];
                CHECK(std::abs(off) < 1e-14 * unit);
            }
    }
}

TEST_CASE("a disc, a square and a cube keep the body's axes in spite of noise") {
    Random random(63);
    for (int round = 0; round < 300; ++round) {
        const auto noisy = [&](const std::array<double, 3>& moments) {
            Matrix m = inertia(moments, identity);
            for (size_t i = 0; i < 3; ++i)
                for (size_t j = 0; j <= i; ++j) {
                    const double noise = random.uniform(-1e-3, 1e-3);
                    m[3 * i + j] += noise;
                    if (i != j) m[3 * j + i] += noise;
                }
            return principal_axes(m);
        };
        for (const std::array<double, 3> disc : {std::array{0.5, 0.5, 1.0}, {0.5, 1.0, 0.5}, {1.0, 0.5, 0.5}}) {
            const Matrix e = noisy(disc);
            CHECK(distance(e, identity) < 5e-3);
            check_right_handed(e);
        }
        CHECK(distance(noisy({1.0, 1.0, 0.1}), identity) < 5e-3); // a needle
        CHECK(noisy({1.0, 1.0, 1.0}) == identity);
    }
}

TEST_CASE("of a tilted disc the axis is its own, and noise does not turn the others") {
    Random random(64);
    for (int round = 0; round < 100; ++round) {
        const Matrix tilt = rotation(random, 3.1);
        const Matrix first = principal_axes(inertia({0.5, 0.5, 1.0}, tilt));
        check_right_handed(first);
        size_t along = 0;
        for (size_t i = 1; i < 3; ++i)
            if (std::abs(tilt[6 + i]) > std::abs(tilt[6 + along])) along = i;
        double dot = 0.0;
        for (size_t i = 0; i < 3; ++i) dot += first[3 * along + i] * tilt[6 + i];
        CHECK(std::abs(dot) == doctest::Approx(1.0).epsilon(1e-12));
        const Matrix again = principal_axes(inertia({0.5 + random.uniform(-1e-4, 1e-4), 0.5, 1.0}, tilt));
        if (std::abs(tilt[6 + along]) > 0.6) CHECK(distance(first, again) < 1e-2);
    }
}

TEST_CASE("of a square the axes go along its sides, however it lies, and a disc keeps the body's") {
    Random random(66);
    const auto turned = [](std::vector<Eigen::Vector3d> corners, const Matrix& by) {
        for (Eigen::Vector3d& p : corners)
            p = Eigen::Vector3d(by[0] * p.x() + by[3] * p.y(), by[1] * p.x() + by[4] * p.y(),
                                by[2] * p.x() + by[5] * p.y()); // z is 0
        return corners;
    };
    const std::vector<Eigen::Vector3d> square{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 0}};
    std::vector<Eigen::Vector3d> disc;
    for (int i = 0; i < 48; ++i) disc.emplace_back(std::cos(i * 0.1309), std::sin(i * 0.1309), 0.0);
    CHECK(principal_axes(inertia({0.5, 0.5, 1.0}, identity), square) == identity);
    for (int round = 0; round < 100; ++round) {
        const Matrix by = rotation(random, 3.1), m = inertia({0.501, 0.499, 1.0}, by);
        const Matrix e = principal_axes(m, turned(square, by));
        check_right_handed(e);
        for (size_t row = 0; row < 3; ++row) {
            double most = 0.0;
            for (size_t k = 0; k < 3; ++k)
                most = std::max(most, std::abs(e[3 * row] * by[3 * k] + e[3 * row + 1] * by[3 * k + 1] +
                                               e[3 * row + 2] * by[3 * k + 2]));
            CHECK(most > 0.9999); // less than a hundredth of the rectangle does not turn them
        }
        CHECK(principal_axes(m, turned(disc, by)) == principal_axes(m));
    }
}
