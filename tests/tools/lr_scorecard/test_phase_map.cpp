// Points of the phase map: their positions, and that the runs have them.
#include "tools/lr_scorecard/phase_map.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace lr::scorecard;

TEST_CASE("phase map: each boundary point is crossed at 1.3 and 1.7, and its two sides do not agree") {
    const std::vector<ExpectedPoint> points = expected_points();
    for (size_t b = 0; b < boundary_points().size(); ++b) {
        const PhasePoint at = boundary_points()[b].at;
        std::vector<const ExpectedPoint*> low, high;
        for (const ExpectedPoint& p : points) {
            if (p.boundary != b) continue;
            const double re = std::log(p.at.reynolds / at.reynolds), inertia = std::log(p.at.inertia / at.inertia);
            CHECK((re == 0.0 || inertia == 0.0));
            const double factor = std::exp(std::abs(re + inertia));
            CHECK((factor == doctest::Approx(1.3) || factor == doctest::Approx(1.7)));
            (re + inertia < 0.0 ? low : high).push_back(&p);
        }
        if (boundary_points()[b].kind == BoundaryKind::steady_periodic) {
            CHECK(low.size() + high.size() == 2); // one edge of the band each
            continue;
        }
        CHECK(low.size() == 2);
        CHECK(high.size() == 2);
        for (const ExpectedPoint* l : low)
            for (const ExpectedPoint* h : high)
                for (Regime r : l->allowed)
                    CHECK(std::find(h->allowed.begin(), h->allowed.end(), r) == h->allowed.end());
    }
}

TEST_CASE("phase map: a point is run at the Re that was asked for, and twice the same") {
    PhaseOptions options;
    options.loads.load_model = LR_LOADS_LANGEVIN;
    options.seeds = 6;
    options.duration = 60.0;
    const PhasePoint at{500.0, 0.02};
    const PhaseResult one = run_phase_point(at, options, true);
    CHECK(one.measured.reynolds == doctest::Approx(500.0).epsilon(0.25)); // few and short
    CHECK(one.measured.inertia == 0.02);
    CHECK(one.share[0] + one.share[1] + one.share[2] + one.share[3] == doctest::Approx(1.0));
    REQUIRE(one.tracks.size() == 6);
    CHECK(one.tracks[0].samples.size() == 601);
    options.threads = 3;
    const PhaseResult other = run_phase_point(at, options, true);
    for (size_t i = 0; i < 6; ++i)
        CHECK(one.tracks[i].samples.back().position == other.tracks[i].samples.back().position);
    ExpectedPoint expected{at, {Regime::chaotic, Regime::tumbling}, 0};
    CHECK(agreement(one, expected) == doctest::Approx(one.share[2] + one.share[3]));
}
