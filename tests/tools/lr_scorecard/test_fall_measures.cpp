// Averages, peaks and measures of a fall, on known tracks.
#include "tools/lr_scorecard/disc_fall.h"
#include "tools/lr_scorecard/measured_bodies.h"
#include "tools/lr_scorecard/random.h"

#include <doctest/doctest.h>

#include <numbers>

using namespace lr::scorecard;

namespace {

constexpr double pi = std::numbers::pi;

// Glides along x at `glide`, sinks at `sink`, sways along z, and rotates about x, across the camera's line of sight (z).
Track turning(double glide, double sink, double turns_per_second, double duration) {
    Track t;
    t.interval = 1.0 / 98.0;
    for (double time = 0.0; time <= duration; time += t.interval) {
        Sample s;
        s.position = {glide * time, -sink * time, 0.0};
        s.velocity = {glide, -sink, 0.0};
        s.spin = {2.0 * pi * turns_per_second, 0.0, 0.0};
        s.orientation = Eigen::AngleAxisd(2.0 * pi * turns_per_second * time, Eigen::Vector3d::UnitX());
        t.samples.push_back(s);
    }
    return t;
}

} // namespace

TEST_CASE("fall measures: a glide with a steady turn") {
    for (double rate : {1.5, 3.0, 8.0}) {
        const FallMeasures m = measure_fall(turning(0.3, 0.6, rate, 20.0), Eigen::Vector3d::UnitZ(), 0.1);
        CHECK(m.descent == doctest::Approx(0.6));
        CHECK(m.horizontal_speed == doctest::Approx(0.3));
        CHECK(m.drift_angle == doctest::Approx(std::atan(0.5) * 180.0 / pi));
        CHECK(m.peak_rate == doctest::Approx(2.0 * rate).epsilon(0.02)); // two per turn
    }
    // A short window loses no peak at its cuts, except the last.
    double sum = 0.0;
    for (int i = 0; i < 100; ++i)
        sum += measure_fall(turning(0.0, 1.0, 3.0 + 0.01 * i, 1.5), Eigen::Vector3d::UnitZ(), 0.1).peak_rate / 100.0;
    CHECK(sum == doctest::Approx(7.0).epsilon(0.06));
}

TEST_CASE("fall measures: only the second half counts") {
    Track t = turning(0.0, 1.0, 0.0, 2.0);
    for (size_t i = 0; i < t.samples.size() / 2; ++i)
        t.samples[i].position.x() -= 100.0 * std::sin(static_cast<double>(i));
    const FallMeasures m = measure_fall(t, Eigen::Vector3d::UnitZ(), 0.1);
    CHECK(m.horizontal_speed == doctest::Approx(0.0));
    CHECK(m.drift_angle == doctest::Approx(0.0));
    CHECK(m.peak_rate == 0.0);
}

TEST_CASE("peaks: those lower than the hysteresis and the ends do not count") {
    CHECK(peaks(std::vector<double>{}, 0.1).empty());
    CHECK(peaks(std::vector<double>{1.0, 0.0, 1.0}, 0.1).empty());
    CHECK(peaks(std::vector<double>{0.0, 1.0, 0.0}, 0.1) == std::vector<size_t>{1});
    CHECK(peaks(std::vector<double>{0.0, 1.0, 0.95, 1.1, 0.0}, 0.1) == std::vector<size_t>{3});
    CHECK(peaks(std::vector<double>{0.0, 1.0, 0.8, 1.1, 0.0}, 0.1) == std::vector<size_t>{1, 3});
    CHECK(peaks(std::vector<double>{0.0, 0.05, 0.0, 0.05, 0.0}, 0.1).empty());
}

TEST_CASE("statistics: mean, error, percentiles") {
    std::vector<double> values;
    for (int i = 100; i >= 0; --i) values.push_back(i);
    const Statistic s = summarise(values);
    CHECK(s.mean == doctest::Approx(50.0));
    CHECK(s.deviation == doctest::Approx(std::sqrt(101.0 * 102.0 / 12.0)));
    CHECK(s.standard_error == doctest::Approx(s.deviation / std::sqrt(101.0)));
    CHECK(s.p5 == doctest::Approx(5.0));
    CHECK(s.p50 == doctest::Approx(50.0));
    CHECK(s.p95 == doctest::Approx(95.0));
    CHECK(summarise({}).count == 0);
    CHECK(summarise({3.0}).standard_error == 0.0);
}

TEST_CASE("a baked disc is a disc: mass, inertia and added mass") {
    const double a = 0.02, density = 0.07;
    const lr_asset_info info = info_of(bake_disc(a, 1e-4, density, Fluid{}));
    const double mass = density * pi * a * a;
    CHECK(info.mass == doctest::Approx(mass).epsilon(1e-6));
    CHECK(info.inertia[0] == doctest::Approx(mass * a * a / 4.0).epsilon(2e-3));
    CHECK(info.inertia[8] == doctest::Approx(mass * a * a / 2.0).epsilon(2e-3));
    CHECK(info.added_mass[14] == doctest::Approx(1.2 * 8.0 / 3.0 * a * a * a).epsilon(0.01));
    CHECK(info.added_mass[21] == doctest::Approx(1.2 * 16.0 / 45.0 * std::pow(a, 5.0)).epsilon(0.01));
}

TEST_CASE("random orientations are uniform: the normal's height is") {
    Random random(4);
    double mean = 0.0, square = 0.0, spin = 0.0;
    const int n = 20000;
    for (int i = 0; i < n; ++i) {
        const Eigen::Quaterniond q = random.orientation();
        const double y = (q * Eigen::Vector3d::UnitZ()).y();
        mean += y / n, square += y * y / n;
        spin += (q * Eigen::Vector3d::UnitX()).y() * y / n;
    }
    CHECK(std::abs(mean) < 5.0 / std::sqrt(3.0 * n));
    CHECK(square == doctest::Approx(1.0 / 3.0).epsilon(0.02));
    CHECK(std::abs(spin) < 0.02);
}

TEST_CASE("a recording of a body in vacuum's stead falls as Galileo says, at times between steps too") {
    const Asset ball = make_ellipsoid({0.05, 0.05, 0.05}, 1e4, {1e-3, 1.5e-5});
    Run run;
    run.loads.load_model = LR_LOADS_NONE;
    run.duration = 0.5;
    run.interval = 1.0 / 98.0;
    Start start;
    start.velocity = {1.0, 0.0, 0.0};
    start.spin = {0.0, 2.0, 0.0};
    const std::vector<Track> tracks = record(ball, run, {start, Start{}});
    REQUIRE(tracks.size() == 2);
    REQUIRE(tracks[0].samples.size() == 50);
    for (size_t i = 0; i < 50; ++i) {
        const double t = run.interval * static_cast<double>(i);
        const Sample& s = tracks[0].samples[i];
        CHECK((s.position - Eigen::Vector3d(t, -0.5 * 9.81 * t * t, 0.0)).norm() < 2e-5);
        CHECK((s.velocity - Eigen::Vector3d(1.0, -9.81 * t, 0.0)).norm() < 2e-4);
        const Eigen::Vector3d x = s.orientation * Eigen::Vector3d::UnitX();
        CHECK((x - Eigen::Vector3d(std::cos(2.0 * t), 0.0, -std::sin(2.0 * t))).norm() < 1e-3);
        CHECK(std::abs(tracks[1].samples[i].position.x()) < 1e-9);
    }
}
