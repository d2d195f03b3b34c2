// Points of the phase map: their positions, and that the runs have them.
#include "tools/lr_scorecard/phase_map.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

using namespace lr::scorecard;

TEST_CASE("phase map: regions of the published map, and their boundaries left out") {
    using enum Regime;
    CHECK(published_regime({50.0, 0.0005}) == steady);
    CHECK(published_regime({50.0, 0.1}) == steady);
    CHECK(published_regime({1e4, 0.001}) == periodic);
    CHECK(published_regime({250.0, 0.008}) == periodic);
    CHECK(published_regime({250.0, 0.03}) == chaotic);
    CHECK(published_regime({2e4, 0.02}) == chaotic);
    CHECK(published_regime({250.0, 0.06}) == tumbling);
    CHECK(published_regime({1e4, 0.09}) == tumbling);
    for (double re : {80.0, 89.0, 120.0, 161.0, 184.0}) CHECK_FALSE(published_regime({re, 0.001}));
    for (std::span<const PhasePoint> boundary : {chaotic_boundary(), tumbling_boundary()})
        for (const PhasePoint& p : boundary)
            for (double factor : {0.9, 1.0, 1.1}) {
                CHECK_FALSE(published_regime({p.reynolds, p.inertia * factor}));
                if (p.reynolds < 1e3 && boundary.size() > 3)
                    CHECK_FALSE(published_regime({p.reynolds * factor, p.inertia}));
            }
    // Between two points of a boundary it is straight on logarithmic axes.
    const double re = std::sqrt(345.0 * 739.0), inertia = std::sqrt(0.0114 * 0.0090);
    CHECK(published_regime({re, 0.98 * inertia}, 1.0) == periodic);
    CHECK(published_regime({re, 1.02 * inertia}, 1.0) == chaotic);
}

TEST_CASE("phase map: about sixty points in all regions, each of its own regime") {
    std::array<int, 4> count{};
    const std::vector<ExpectedPoint> points = expected_points();
    for (const ExpectedPoint& p : points) {
        ++count[static_cast<size_t>(p.regime)];
        CHECK(published_regime(p.at) == p.regime);
        CHECK(p.at.reynolds >= 40.0 - 1e-9);
        CHECK(p.at.reynolds <= 3e4 + 1e-6);
    }
    CHECK(points.size() >= 55);
    CHECK(points.size() <= 70);
    for (int n : count) CHECK(n >= 8);
}

TEST_CASE("phase map: a point is run at the Re that was asked for, and twice the same") {
    PhaseOptions options;
    options.loads.load_model = LR_LOADS_LANGEVIN;
    options.seeds = 6;
    options.duration = 60.0;
    const PhasePoint at{500.0, 0.02};
    const Asset disc = phase_disc(at.inertia, options);
    const PhaseResult one = run_phase_point(disc, at, options, true);
    CHECK(one.measured.reynolds == doctest::Approx(500.0).epsilon(0.25)); // few and short
    CHECK(one.measured.inertia == 0.02);
    CHECK(one.share[0] + one.share[1] + one.share[2] + one.share[3] == doctest::Approx(1.0));
    REQUIRE(one.tracks.size() == 6);
    CHECK(one.tracks[0].samples.size() == 601);
    options.threads = 3;
    const PhaseResult other = run_phase_point(disc, at, options, true);
    for (size_t i = 0; i < 6; ++i)
        CHECK(one.tracks[i].samples.back().position == other.tracks[i].samples.back().position);
}

TEST_CASE("phase map: the onset is found by bisection, and is none or the first Re where there is nothing to bisect") {
    for (double onset : {41.0, 100.0, 333.0, 600.0}) {
        int runs = 0;
        const Onset found = onset_of_motion(
            [&](double re) {
                ++runs;
                PhaseResult r;
                r.asked = {re, 0.01};
                r.measured = {1.01 * re, 0.01}; // it is the measured Re that counts
                r.share[re < onset ? 0 : 1] = 1.0;
                return r;
            },
            8);
        CHECK(found.periodic == 1.0);
        CHECK(found.reynolds == doctest::Approx(1.01 * onset).epsilon(0.01));
        CHECK(runs == 10);
    }
    const auto all = [](size_t regime) {
        return [regime](double re) {
            PhaseResult r;
            r.asked = r.measured = {re, 0.01};
            r.share[regime] = 1.0;
            return r;
        };
    };
    CHECK(onset_of_motion(all(0), 8).reynolds == std::numeric_limits<double>::infinity());
    CHECK(onset_of_motion(all(3), 8).reynolds == 40.0);
}
