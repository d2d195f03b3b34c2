// Measures of synthetic falls, whose answers are known.
#include "tools/falls/how_it_falls.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

using namespace lr::falls;
using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace {

constexpr double pi = std::numbers::pi, interval = 0.005;

Shape sheet() {
    Shape shape;
    shape.density = 500.0;
    shape.fluid_density = 1.2;
    shape.length = 0.1;
    shape.thickness = 0.001;
    shape.normal = Vector3d::UnitZ();
    shape.ellipsoid = Vector3d(0.0025, 0.0025, 2.5e-7).asDiagonal();
    return shape;
}

// The sheet with its broad side level.
Quaterniond level() {
    return Quaterniond::FromTwoVectors(Vector3d::UnitZ(), up());
}

Track track(double time, const std::function<Vector3d(double)>& position,
            const std::function<Quaterniond(double)>& turned) {
    Track t;
    t.interval = interval;
    t.time = time;
    t.arrived = true;
    t.end = position(time);
    for (int i = 0; i * interval < time; ++i) {
        const Quaterniond now = turned(i * interval), next = turned((i + 1) * interval);
        const AngleAxisd step(next * now.conjugate());
        const double angle = step.angle() > pi ? step.angle() - 2.0 * pi : step.angle();
        t.samples.push_back({position(i * interval), step.axis() * (angle / interval), now * level()});
    }
    return t;
}

std::function<Vector3d(double)> straight(const Vector3d& velocity) {
    return [=](double t) { return Vector3d(velocity * t); };
}

Quaterniond about(const Vector3d& axis, double angle) {
    return Quaterniond(AngleAxisd(angle, axis));
}

const Vector3d x_axis = Vector3d::UnitX(), still = Vector3d::Zero();
const auto upright = [](double) { return Quaterniond::Identity(); };

Fall fall_with(Motion motion, const Vector3d& end, double third, double last) {
    Fall f;
    f.arrived = true;
    f.motion = motion;
    f.end = end;
    f.descent = 0.5 * (third + last);
    f.third_quarter = third;
    f.last_quarter = last;
    f.time = 1.0;
    return f;
}
} // namespace

TEST_CASE("fall measures: a steady fall") {
    const Fall f = measure(track(2.0, straight({0.1, -1.5, 0.0}), upright), sheet(), still);
    CHECK(f.descent == doctest::Approx(1.5));
    CHECK(f.horizontal_speed == doctest::Approx(0.1));
    CHECK(f.end.x() == doctest::Approx(0.2));
    CHECK(f.time == 2.0);
    CHECK(f.motion == Motion::steady);
    CHECK(f.turnovers == 0.0);
    // Carried by the wind, it moves only down.
    const Fall carried = measure(track(2.0, straight({3.0, -1.5, -1.0}), upright), sheet(), {3.0, 0.0, -1.0});
    CHECK(carried.horizontal_speed < 1e-9);
    CHECK(carried.motion == Motion::steady);
}

TEST_CASE("fall measures: flutter swings to and fro, with any heading and either face up") {
    for (const double amplitude : {30.0, 70.0, 110.0}) // degrees; the last beyond the vertical
        for (const double heading : {0.0, 1.1})
            for (const double face : {0.0, pi}) {
                CAPTURE(amplitude);
                const auto turned = [&](double t) {
                    return about(up(), heading) * about(x_axis, face + amplitude * pi / 180.0 * std::sin(6.0 * pi * t));
                };
                const Fall f = measure(track(3.0, straight({0.0, -1.0, 0.0}), turned), sheet(), still);
                CHECK(f.motion == Motion::fluttering);
                CHECK(f.turnovers == 0.0);
                CHECK(std::abs(f.spin) < 1e-9);
                if (amplitude < 90.0) CHECK(f.swings == doctest::Approx(3.0).epsilon(0.2));
            }
}

TEST_CASE("fall measures: tumbling turns over and over, also when its axis slowly turns") {
    for (const double rate : {1.5, 4.0, 9.0}) {
        CAPTURE(rate);
        const auto turned = [&](double t) { return about(up(), 0.5 * t) * about(x_axis, 2.0 * pi * rate * t); };
        const Fall f = measure(track(2.5, straight({0.5, -1.0, 0.0}), turned), sheet(), still);
        CHECK(f.motion == Motion::tumbling);
        CHECK(std::abs(f.turnovers - rate) < 1.0 / (0.75 * 2.5)); // a turn at both ends does not count
        CHECK(f.spin == doctest::Approx(0.5 / (2.0 * pi)).epsilon(0.05));
    }
}

TEST_CASE("fall measures: autorotation about the vertical, either way round") {
    for (const double rate : {5.0, -5.0}) {
        const auto turned = [&](double t) { return about(up(), 2.0 * pi * rate * t) * about(x_axis, 0.3); };
        const Fall f = measure(track(2.0, straight({0.0, -1.0, 0.0}), turned), sheet(), still);
        CHECK(f.motion == Motion::spinning);
        CHECK(f.spin == doctest::Approx(rate));
        CHECK(f.turnovers == 0.0);
    }
    const auto seed = [](double t) { return about(up(), -2.0 * pi * 15.6 * t) * about(x_axis, 0.1); };
    const Fall turning = measure(track(4.0, straight({0.0, -0.97, 0.0}), seed), sheet(), still);
    CHECK(sentence(summarise({turning, turning}), sheet()) ==
          "falls at about 0.97 m/s, turns about the vertical, 940 turns a minute");
    // A slow turn in a long fall is no autorotation.
    const auto turned = [](double t) { return about(up(), 2.0 * pi * 0.2 * t) * about(x_axis, 0.05); };
    CHECK(measure(track(8.0, straight({0.0, -1.0, 0.0}), turned), sheet(), still).motion == Motion::steady);
}

TEST_CASE("fall measures: a glide is flatter than 45 degrees through the air") {
    const auto nose_down = [](double) { return about(x_axis, 0.2); };
    CHECK(measure(track(2.0, straight({3.0, -1.0, 0.0}), nose_down), sheet(), still).motion == Motion::gliding);
    CHECK(measure(track(2.0, straight({0.8, -1.0, 0.0}), nose_down), sheet(), still).motion == Motion::steady);
    CHECK(measure(track(2.0, straight({3.0, -1.0, 0.0}), nose_down), sheet(), {3.0, 0.0, 0.0}).motion ==
          Motion::steady);
}

TEST_CASE("fall measures: a spiral glide turns as it flies, flatter than 45 degrees") {
    const auto circles = [](double radius, double t) {
        return Vector3d(radius * std::sin(t), -0.5 * t, radius * std::cos(t));
    };
    const auto banked = [](double t) { return about(up(), t) * about(x_axis, 0.3); };
    const Fall f = measure(track(
                               12.0, [&](double t) { return circles(1.5, t); }, banked),
                           sheet(), still);
    CHECK(f.motion == Motion::gliding);
    CHECK(f.spirals);
    // The same turn in a steep fall is none.
    CHECK_FALSE(measure(track(
                            12.0, [&](double t) { return circles(0.2, t); }, banked),
                        sheet(), still)
                    .spirals);
    CHECK_FALSE(measure(track(2.0, straight({3.0, -1.0, 0.0}), upright), sheet(), still).spirals);
    CHECK(sentence(summarise({f, f}), sheet()) == "falls at about 0.50 m/s, glides in spirals");
}

TEST_CASE("fall measures: slow swings between glides are swings, however long the fall") {
    const auto zigzag = [](double t) { return Vector3d(2.0 * std::sin(1.5 * t), -0.6 * t, 0.0); };
    const auto turned = [](double t) { return about(x_axis, 0.3 * std::sin(1.5 * t)); }; // a period of 4 s
    const Fall f = measure(track(60.0, zigzag, turned), sheet(), still);
    CHECK(f.motion == Motion::fluttering);
    CHECK(f.swings == doctest::Approx(1.5 / (2.0 * pi)).epsilon(0.2));
    CHECK(sentence(summarise({f, f}), sheet()) == "falls at about 0.60 m/s, glides to and fro");
}

TEST_CASE("fall measures: chaotic is a swing with a turn over now and then") {
    const auto turned = [](double t) {
        const double part = std::fmod(t, 1.2), turning = std::clamp((part - 0.9) / 0.3, 0.0, 1.0);
        return about(x_axis, 2.0 * pi * turning + 0.7 * std::sin(2.0 * pi * part / 0.3));
    };
    const Fall f = measure(track(3.4, straight({0.0, -1.0, 0.0}), turned), sheet(), still);
    CHECK(f.motion == Motion::chaotic);
    CHECK(f.turnovers < 1.0);
}

TEST_CASE("fall measures: what rocks without a period flutters, unless it rocks far") {
    for (const double degrees : {20.0, 70.0}) {
        CAPTURE(degrees);
        const auto turned = [&](double t) {
            return about(x_axis, degrees * pi / 180.0 * std::sin(1.5 * t + 0.25 * t * t));
        };
        const Fall f = measure(track(20.0, straight({0.0, -1.0, 0.0}), turned), sheet(), still);
        CHECK(f.motion == (degrees < 45.0 ? Motion::fluttering : Motion::chaotic));
    }
}

TEST_CASE("fall measures: a fall that still speeds up is not settled") {
    const auto accelerated = [](double t) { return Vector3d(0.0, -2.0 * t * t, 0.0); };
    const Fall f = measure(track(1.0, accelerated, upright), sheet(), still);
    CHECK(f.third_quarter == doctest::Approx(2.5).epsilon(0.02));
    CHECK(f.last_quarter == doctest::Approx(3.5).epsilon(0.02));
    CHECK_FALSE(summarise({f, f, f}).settled);
    const Fall even = measure(track(1.0, straight({0.0, -2.0, 0.0}), upright), sheet(), still);
    CHECK(summarise({even, even}).settled);
    const Fall few = measure(track(5.0 * interval, accelerated, upright), sheet(), still);
    CHECK_FALSE(summarise({few, few}).settled);
}

TEST_CASE("fall measures: falls are not settled while some gain speed and others begin to turn") {
    std::vector<Fall> falls;
    for (int i = 0; i < 200; ++i)
        falls.push_back(
            fall_with(Motion::spinning, still, 2.4 + 1e-3 * i, i % 2 == 0 ? 1.4 + 1e-3 * i : 3.5 + 1e-3 * i));
    const Falls parting = summarise(falls); // the means differ by 2 %
    CHECK_FALSE(parting.settled);
    for (Fall& f : falls) f.third_quarter = f.last_quarter;
    CHECK(summarise(falls).settled);
    // The word is of the same kind, settled or not: the median.
    for (int i = 0; i < 200; ++i)
        falls[static_cast<size_t>(i)] = fall_with(Motion::spinning, still, 3.0, i < 110 ? 1.0 : 6.0);
    CHECK(sentence(summarise(falls), sheet()).starts_with("falls at 1.0 m/s (not settled yet)"));
}

TEST_CASE("fall measures: landings, shares and words") {
    std::vector<Fall> falls;
    for (int i = 0; i < 1000; ++i) { // rings of 1 m and 3 m about (5, 2)
        const double angle = 2.0 * pi * i / 500.0, radius = i < 500 ? 1.0 : 3.0;
        falls.push_back(fall_with(i % 10 < 6 ? Motion::tumbling : Motion::spinning,
                                  {5.0 + radius * std::cos(angle), -4.0, 2.0 + radius * std::sin(angle)}, 1.0, 1.0));
    }
    falls.push_back(fall_with(Motion::tumbling, {5.0, -4.0, 2.0}, 1.0, 1.0)); // the median is within the inner ring
    Falls s = summarise(falls);
    CHECK(s.count == 1001);
    CHECK(s.arrived == 1001);
    CHECK(s.drift.isApprox(Vector3d(5.0, 0.0, 2.0), 1e-9));
    CHECK(s.half_radius == doctest::Approx(1.0));
    CHECK(s.most_radius == doctest::Approx(3.0));
    CHECK(s.shares[static_cast<size_t>(Motion::tumbling)] == doctest::Approx(601.0 / 1001.0));
    CHECK(summary_word(s) == std::string("tumbles"));
    CHECK(sentence(s, sheet()) == "falls at about 1.0 m/s, tumbles");

    for (Fall& f : falls) f.descent = -0.123;
    CHECK(sentence(summarise(falls), sheet()) == "rises at about 0.12 m/s, tumbles");
    Shape wet = sheet();
    wet.fluid_density = 998.0;
    for (Fall& f : falls) f.descent = 12.3;
    CHECK(sentence(summarise(falls), wet) == "sinks at about 12 m/s, tumbles");
    for (Fall& f : falls) f.last_quarter = 1.39;
    CHECK(sentence(summarise(falls), sheet()) == "falls at 1.4 m/s (not settled yet), tumbles");
    for (Fall& f : falls) f.descent = 1e-4;
    CHECK(sentence(summarise(falls), sheet()) == "floats");

    const Falls mixed = summarise({fall_with(Motion::gliding, still, 1, 1), fall_with(Motion::gliding, still, 1, 1),
                                   fall_with(Motion::fluttering, still, 1, 1), fall_with(Motion::tumbling, still, 1, 1),
                                   fall_with(Motion::fluttering, still, 1, 1)});
    CHECK(summary_word(mixed) == std::string("mixed"));
    CHECK(sentence(mixed, sheet()) == "falls at about 1.0 m/s, flutters or glides");
}

TEST_CASE("statistics: of a sample, with quantiles between its values, and peaks that rise and fall far enough") {
    const Statistic s = summarise({9.0, 1.0, 4.0, 2.0});
    CHECK((s.count == 4 && s.mean == 4.0 && s.p25 == 1.75 && s.p50 == 3.0));
    CHECK(s.deviation == doctest::Approx(std::sqrt(38.0 / 3.0)));
    CHECK(s.standard_error == doctest::Approx(0.5 * s.deviation));
    CHECK(peaks(std::vector<double>{0.0, 3.0, 1.5, 2.0, 0.5, 4.0, 0.0}, 1.0) == std::vector<size_t>{1, 5});
}
