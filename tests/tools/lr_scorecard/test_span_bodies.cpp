// The generated bodies with a span: what they weigh and where, before any air.
#include "tools/lr_scorecard/span_bodies.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

using namespace lr::scorecard;

TEST_CASE("a winged seed has its weight near the leading edge, and its tip where it was asked for") {
    for (const SeedShape& shape : {SeedShape{}, SeedShape{.mass = 120e-6, .radius = 0.035}}) {
        const Seed seed = seed_mesh(shape);
        const lr_asset_info info = info_of(bake_seed(seed));
        CHECK(info.mass == doctest::Approx(shape.mass).epsilon(1e-3));
        double tip = 0.0, low = 0.0;
        for (size_t i = 0; i < seed.mesh.positions.size(); i += 3) {
            tip = std::max(tip, seed.mesh.positions[i] - info.center_of_mass[0]);
            low = std::min(low, seed.mesh.positions[i + 1]);
        }
        CHECK(tip == doctest::Approx(shape.radius).epsilon(0.01));
        CHECK(low == 0.0); // the leading edge
        CHECK(info.center_of_mass[1] / seed.widest == doctest::Approx(0.30).epsilon(0.1));
        CHECK(std::abs(info.center_of_mass[2]) < 1e-12);
    }
}

TEST_CASE("darts: 5 g, the weight where it was asked for") {
    for (const double place : {0.475, 0.54}) {
        const lr_asset_info info = info_of(bake_dart({.weight_place = place}));
        CHECK(info.mass == doctest::Approx(0.005).epsilon(1e-6));
        CHECK(-info.center_of_mass[0] / 0.2 == doctest::Approx(place).epsilon(0.01));
        CHECK(std::abs(info.center_of_mass[1]) < 1e-12);
    }
    CHECK_THROWS(bake_dart({.weight_place = 0.3}));
}

TEST_CASE("sheets have the mass of their area") {
    const double disc = std::numbers::pi / 4.0 * 0.06 * 0.06;
    CHECK(info_of(bake_cap(0.06, 0.0, 0.1)).mass == doctest::Approx(0.1 * disc).epsilon(1e-3));
    CHECK(info_of(bake_cap(0.06, 0.2, 0.1)).mass == doctest::Approx(0.1 * disc * 1.16).epsilon(5e-3)); // 1 + 4 rise^2
    CHECK(info_of(bake_ring(0.06, 0.5, 0.1)).mass == doctest::Approx(0.1 * disc * 0.75).epsilon(1e-3));
    CHECK(info_of(bake_cross(0.06, 0.012, 0.1)).mass == doctest::Approx(0.1 * 0.012 * 0.108).epsilon(1e-3));
    CHECK(info_of(bake_curled_leaf(0.04, 0.08, 0.0, 0.0, 0.08)).mass ==
          doctest::Approx(0.08 * std::numbers::pi / 4.0 * 0.04 * 0.08).epsilon(1e-3));
    CHECK(info_of(bake_snow_crystal(3e-3)).mass == doctest::Approx(3.42e-8).epsilon(1e-6));
}
