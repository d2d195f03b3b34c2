// The classifier on motions of known regime.
#include "tools/falls/random.h"
#include "tools/falls/regime.h"
#include "tools/lr_scorecard/fall_recording.h"

#include <doctest/doctest.h>

#include <functional>
#include <string>
#include <vector>

using namespace lr::scorecard;
using Normals = std::vector<Eigen::Vector3d>;

namespace {

constexpr double pi = std::numbers::pi, degree = pi / 180.0;
constexpr int count = 2000; // samples
constexpr double interval = 0.1;

// Tilted by `tilt` towards `azimuth`, radians, at time t.
Normals normals(const std::function<double(double)>& tilt, const std::function<double(double)>& azimuth) {
    Normals out;
    for (int i = 0; i < count; ++i) {
        const double t = interval * i, a = tilt(t), b = azimuth(t);
        out.emplace_back(std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b));
    }
    return out;
}
Normals in_plane(const std::function<double(double)>& tilt) {
    return normals(tilt, [](double) { return 0.7; });
}

std::string regime(const Normals& n) {
    const RegimeMeasures m = measure_regime(n, up());
    INFO("tilt95 ", m.tilt95, ", overturns ", m.overturns, ", half turns ", m.half_turns, ", tumbling ",
         m.tumbling_share, ", regularity ", m.regularity, ", period ", m.period, ", spread ", m.amplitude_spread);
    // Only the motion counts: not which face is up, nor the direction of the vertical among the axes.
    Normals other_face, turned;
    const Eigen::Quaterniond turn = Random(3).orientation();
    for (const Eigen::Vector3d& v : n) {
        other_face.push_back(-v);
        turned.push_back(turn * v);
    }
    const Regime r = classify(n, up());
    CHECK(classify(other_face, up()) == r);
    CHECK(classify(turned, turn * up()) == r);
    return regime_names[static_cast<size_t>(r)];
}

// Lorenz's equations at his parameters, by RK4: x swings about 8 and -8, and changes sides irregularly.
std::vector<double> lorenz() {
    Eigen::Vector3d s(1.0, 1.0, 25.0);
    const auto rate = [](const Eigen::Vector3d& v) -> Eigen::Vector3d {
        return {10.0 * (v.y() - v.x()), v.x() * (28.0 - v.z()) - v.y(), v.x() * v.y() - 8.0 / 3.0 * v.z()};
    };
    std::vector<double> x;
    const double h = 0.02;
    for (int i = -500; i < count; ++i) {
        const Eigen::Vector3d a = rate(s), b = rate(s + 0.5 * h * a), c = rate(s + 0.5 * h * b), d = rate(s + h * c);
        s += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
        if (i >= 0) x.push_back(s.x());
    }
    return x;
}

} // namespace

TEST_CASE("regime: a disc that settles, or never moved, is steady") {
    CHECK(regime(in_plane([](double) { return 0.0; })) == "steady");
    CHECK(regime(in_plane([](double) { return pi; })) == "steady");
    CHECK(regime(in_plane([](double t) { return 5.0 * degree * std::exp(-t / 20.0) * std::cos(t); })) == "steady");
    CHECK(regime(in_plane([](double t) { return 2.0 * degree * std::cos(t); })) == "steady");
    Random random(5);
    CHECK(regime(normals([&](double) { return 0.5 * degree * random.gaussian(); },
                         [&](double) { return random.real(0.0, pi); })) == "steady");
}

TEST_CASE("regime: flutter in a plane, on an ellipse, along a helix, and with a slowly turning plane is periodic") {
    for (double amplitude : {5.0, 30.0, 80.0})
        for (double period : {3.0, 6.0, 12.0}) {
            CAPTURE(amplitude);
            CAPTURE(period);
            const double w = 2.0 * pi / period;
            CHECK(regime(in_plane([&](double t) { return amplitude * degree * std::sin(w * t); })) == "periodic");
            CHECK(regime(normals([&](double t) { return amplitude * degree * std::sin(w * t); },
                                 [&](double t) { return 0.02 * w * t; })) == "periodic");
            CHECK(regime(normals([&](double) { return amplitude * degree; }, [&](double t) { return w * t; })) ==
                  "periodic");
            CHECK(regime(normals(
                      [&](double t) { return amplitude * degree * std::hypot(std::sin(w * t), 0.4 * std::cos(w * t)); },
                      [&](double t) { return std::atan2(0.4 * std::cos(w * t), std::sin(w * t)); })) == "periodic");
        }
    // Past the vertical and back: far, but never over.
    CHECK(regime(in_plane([](double t) { return 110.0 * degree * std::sin(t); })) == "periodic");
}

TEST_CASE("regime: noise of a tenth of the amplitude leaves flutter periodic") {
    Random random(6);
    double amplitude = 30.0, noise = 0.0;
    CHECK(regime(in_plane([&](double t) {
              noise = 0.95 * noise + std::sqrt(1.0 - 0.95 * 0.95) * 3.0 * random.gaussian();
              return (amplitude * std::sin(t) + noise) * degree;
          })) == "periodic");
}

TEST_CASE("regime: turning on and on is tumbling, also unevenly and with a slowly turning axis") {
    for (double sign : {1.0, -1.0}) {
        CHECK(regime(in_plane([&](double t) { return sign * 1.1 * t; })) == "tumbling");
        CHECK(regime(in_plane([&](double t) { return sign * (1.1 * t + 0.4 * std::sin(2.2 * t)); })) == "tumbling");
        CHECK(regime(normals([&](double t) { return sign * 1.1 * t; }, [](double t) { return 0.02 * t; })) ==
              "tumbling");
    }
    // A wobble of 20 degrees out of the plane.
    CHECK(regime(normals([](double t) { return 1.1 * t; },
                         [](double t) { return 20.0 * degree * std::sin(0.7 * t); })) == "tumbling");
    // One change of direction in the middle.
    CHECK(regime(in_plane([](double t) { return t < 100.0 ? 1.1 * t : 220.0 - 1.1 * t; })) == "tumbling");
}

TEST_CASE("regime: flutter that now and then goes over, or has no regular amplitude, is chaotic") {
    const std::vector<double> x = lorenz();
    const auto at = [&](double t) { return x[static_cast<size_t>(std::lround(t / interval))]; };
    for (double gain : {3.0, 6.0, 10.0}) // up to 55, 110 and 185 degrees
        CHECK(regime(in_plane([&](double t) { return gain * at(t) * degree; })) == "chaotic");
    // The sum of its own increments: turns over in steps, with swings between.
    double sum = 0.0;
    CHECK(regime(in_plane([&](double t) { return sum += 0.012 * at(t); })) == "chaotic");
    // Half the time flutter, half the time tumbling.
    CHECK(regime(in_plane([](double t) {
              const double cycle = std::fmod(t, 40.0);
              return cycle < 20.0 ? 60.0 * degree * std::sin(0.3 * pi * cycle) : 0.1 * pi * 2.0 * (cycle - 20.0);
          })) == "chaotic");
    // A random tilt.
    Random random(7);
    double tilt = 0.0;
    CHECK(regime(in_plane([&](double) { return tilt = 0.97 * tilt + 0.1 * random.gaussian(); })) == "chaotic");
    // Two frequencies without a common period: beats.
    CHECK(regime(in_plane([](double t) { return 25.0 * degree * (std::sin(t) + std::sin(1.27 * t)); })) == "chaotic");
}

TEST_CASE("regime: tumbling that turns back after a few half turns is chaotic") {
    for (double turns : {2.0, 3.0}) // to and fro; a single one is flutter of 180 degrees
        CHECK(regime(in_plane([&](double t) {
                  const double phase = std::fmod(1.1 * t, 4.0 * pi * turns);
                  return phase < 2.0 * pi * turns ? phase : 4.0 * pi * turns - phase;
              })) == "chaotic");
}

TEST_CASE("regime: turned back at every second half turn is not tumbling") {
    // 0 to 200 degrees and back: the normal goes over, and returns the same way.
    CHECK(regime(in_plane([](double t) { return (100.0 - 100.0 * std::cos(0.8 * t)) * degree; })) != "tumbling");
}
