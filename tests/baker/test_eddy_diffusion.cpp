#include "baker/eddy_diffusion.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <vector>

using namespace lr::baker;

TEST_CASE("a cosine mode decays at its rate along each axis") {
    for (size_t axis = 0; axis < 3; ++axis) {
        MacGrid grid({32, 32, 32}, {1.0, 1.0, 1.0});
        GridField field = grid.velocity[0]; // no inflow column: all ends without flux
        const std::vector<uint8_t> prescribed(field.values.size(), 0);
        const std::vector<double> viscosity(field.values.size(), 0.5);
        // Samples of the x-velocity lie on the ends along x and half a cell inside along y and z; without flux
        // the box ends half a cell beyond the last sample.
        const double n = field.count[axis], wave = 3.14159265358979 / n;
        const auto mode = [&](uint32_t i, uint32_t j, uint32_t k) {
            const uint32_t at[3] = {i, j, k};
            return std::cos(wave * (at[axis] + 0.5));
        };
        for (uint32_t k = 0; k < field.count[2]; ++k)
            for (uint32_t j = 0; j < field.count[1]; ++j)
                for (uint32_t i = 0; i < field.count[0]; ++i) field.values[field.index(i, j, k)] = mode(i, j, k);
        EddyDiffusion diffusion;
        for (int s = 0; s < 100; ++s) diffusion.apply(field, prescribed, viscosity, EddyDiffusion::Wall::no_flux, 1e-3);
        const double rate = 0.5 * 32.0 * 32.0 * wave * wave;
        CHECK(field.values[field.index(3, 3, 3)] / mode(3, 3, 3) ==
              doctest::Approx(std::exp(-0.1 * rate)).epsilon(0.01));
    }
}

TEST_CASE("diffusion keeps the total, the sign and the bounds at any step, and passes no solid without flux") {
    MacGrid grid({8, 6, 6}, {1.0, 1.0, 1.0});
    GridField field = grid.make_centred_field();
    std::vector<uint8_t> prescribed(field.values.size(), 0);
    std::vector<double> viscosity(field.values.size(), 1.0);
    for (uint32_t k = 0; k < 6; ++k)
        for (uint32_t j = 0; j < 6; ++j) { // a wall across, and nothing from the inflow
            prescribed[field.index(4, j, k)] = 1;
            viscosity[field.index(4, j, k)] = 0.0;
            viscosity[field.index(0, j, k)] = 0.0;
        }
    field.values[field.index(2, 3, 3)] = 1.0;
    EddyDiffusion diffusion;
    for (double dt : {1e-4, 1.0, 1e6}) diffusion.apply(field, prescribed, viscosity, EddyDiffusion::Wall::no_flux, dt);
    double total = 0.0, behind = 0.0;
    for (uint32_t k = 0; k < 6; ++k)
        for (uint32_t j = 0; j < 6; ++j)
            for (uint32_t i = 1; i < 9; ++i) {
                const double value = field.values[field.index(i, j, k)];
                CHECK(value >= 0.0);
                CHECK(value <= 1.0);
                (i < 4 ? total : behind) += value;
            }
    CHECK(total == doctest::Approx(1.0).epsilon(1e-6)); // rates of 1e8 cost digits
    CHECK(behind == 0.0);
    CHECK(field.values[field.index(1, 0, 0)] == doctest::Approx(1.0 / 108.0).epsilon(1e-4)); // spread evenly
}

TEST_CASE("without slip the profile between the inflow value and a wall becomes straight") {
    MacGrid grid({8, 4, 4}, {1.0, 1.0, 1.0});
    GridField field = grid.make_centred_field();
    std::vector<uint8_t> prescribed(field.values.size(), 0);
    std::vector<double> viscosity(field.values.size(), 1.0);
    for (uint32_t k = 0; k < 4; ++k)
        for (uint32_t j = 0; j < 4; ++j) {
            prescribed[field.index(0, j, k)] = 1;
            field.values[field.index(0, j, k)] = 1.0;
            prescribed[field.index(8, j, k)] = 1;
            viscosity[field.index(8, j, k)] = 0.0;
        }
    EddyDiffusion diffusion;
    for (int s = 0; s < 20; ++s) diffusion.apply(field, prescribed, viscosity, EddyDiffusion::Wall::no_slip, 10.0);
    // From 1 at x = 0 to 0 at the last centre, x = 7.5 cells.
    for (uint32_t i = 0; i <= 8; ++i) {
        const double x = i == 0 ? 0.0 : i - 0.5;
        CHECK(field.values[field.index(i, 2, 1)] == doctest::Approx(1.0 - x / 7.5).epsilon(1e-6));
    }
}
