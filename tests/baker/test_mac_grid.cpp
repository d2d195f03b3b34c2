#include "baker/turbulence/mac_grid.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <initializer_list>

using namespace lr::baker;

namespace {

void fill(MacGrid& grid, const std::function<GridPoint(const GridPoint&)>& f) {
    for (size_t a = 0; a < 3; ++a) {
        GridField& field = grid.velocity[a];
        for (uint32_t k = 0; k < field.count[2]; ++k)
            for (uint32_t j = 0; j < field.count[1]; ++j)
                for (uint32_t i = 0; i < field.count[0]; ++i)
                    field.values[field.index(i, j, k)] = f(field.position(i, j, k))[a];
    }
}

} // namespace

TEST_CASE("sampling reproduces linear fields, also between the inflow and the first cell") {
    MacGrid grid({8, 6, 5}, {2.0, 1.2, 0.5});
    const auto linear = [](const GridPoint& p) {
        return GridPoint{1.0 + 2.0 * p[0] - p[1] + 3.0 * p[2], p[0] + p[1] - 2.0 * p[2], 0.5 - p[0] + 4.0 * p[1]};
    };
    fill(grid, linear);
    // Within the outermost samples of every component.
    for (double x : {0.0, 0.03, 0.125, 0.9, 1.87})
        for (double y : {0.1, 0.55, 1.1})
            for (double z : {0.05, 0.25, 0.45}) {
                const GridPoint got = grid.velocity_at({x, y, z}), want = linear({x, y, z});
                for (size_t a = 0; a < 3; ++a) CHECK(std::abs(got[a] - want[a]) < 1e-12);
            }
    // Outside: the nearest boundary value, never an extrapolation.
    CHECK(grid.velocity_at({-5.0, 0.6, 0.25})[0] == doctest::Approx(linear({0.0, 0.6, 0.25})[0]));
    CHECK(grid.velocity_at({99.0, 0.6, 0.25})[0] == doctest::Approx(linear({2.0, 0.6, 0.25})[0]));
    CHECK(grid.divergence(3, 2, 1) == doctest::Approx(2.0 + 1.0).epsilon(1e-12));
}

TEST_CASE("back-tracing is second order in the step") {
    // Solid rotation about the middle: sampled exactly, so that all the error is the integrator's.
    MacGrid grid({16, 16, 4}, {2.0, 2.0, 1.0});
    fill(grid, [](const GridPoint& p) { return GridPoint{-(p[1] - 1.0), p[0] - 1.0, 0.0}; });
    const auto error = [&](int steps) {
        GridPoint p = {1.4, 1.0, 0.5};
        for (int n = 0; n < steps; ++n) p = grid.trace_back(p, 1.0 / steps);
        return std::hypot(p[0] - (1.0 + 0.4 * std::cos(-1.0)), p[1] - (1.0 + 0.4 * std::sin(-1.0)));
    };
    CHECK(error(10) < 1e-3);
    CHECK(error(10) / error(20) == doctest::Approx(4.0).epsilon(0.1));
}

TEST_CASE("solid cells prescribe zero on all their faces and nothing else") {
    MacGrid grid({6, 6, 6}, {1.0, 1.0, 1.0});
    fill(grid, [](const GridPoint&) { return GridPoint{1.0, 2.0, 3.0}; });
    std::vector<uint8_t> mask(216);
    mask[grid.cell(2, 3, 1)] = 1;
    grid.set_solid(mask);
    const GridField &u = grid.velocity[0], &v = grid.velocity[1], &w = grid.velocity[2];
    for (uint32_t side : {0u, 1u}) {
        CHECK(u.values[u.index(2 + side, 3, 1)] == 0.0);
        CHECK(v.values[v.index(3, 3 + side, 1)] == 0.0);
        CHECK(w.values[w.index(3, 3, 1 + side)] == 0.0);
    }
    int zero_u = 0, zero_v = 0, zero_w = 0;
    for (double value : u.values) zero_u += value == 0.0;
    for (double value : v.values) zero_v += value == 0.0;
    for (double value : w.values) zero_w += value == 0.0;
    CHECK(zero_u == 2);
    CHECK(zero_v == 2 + 2 * 7 * 6); // and the sides of the domain
    CHECK(zero_w == 2 + 2 * 7 * 6);
    CHECK(grid.prescribed[0][u.index(0, 0, 0)] == 1);
    CHECK(grid.prescribed[0][u.index(6, 0, 0)] == 0);
}

TEST_CASE("a closed pocket of fluid becomes solid") {
    MacGrid grid({8, 8, 8}, {1.0, 1.0, 1.0});
    std::vector<uint8_t> mask(512);
    for (uint32_t k = 2; k < 5; ++k)
        for (uint32_t j = 2; j < 5; ++j)
            for (uint32_t i = 2; i < 5; ++i) mask[grid.cell(i, j, k)] = !(i == 3 && j == 3 && k == 3);
    grid.set_solid(mask);
    CHECK(grid.solid[grid.cell(3, 3, 3)] == 1);
    mask[grid.cell(4, 3, 3)] = 0; // a hole downstream
    grid.set_solid(mask);
    CHECK(grid.solid[grid.cell(3, 3, 3)] == 0);
}
