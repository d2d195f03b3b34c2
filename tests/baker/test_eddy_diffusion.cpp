#include "baker/turbulence/eddy_diffusion.h"

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
        GridField field = grid.velocity[0]; // no inflow column: no flux at all ends
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
        for (uint32_t j = 0; j < 6; ++j) { // a wall across, without inflow values
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
    CHECK(total == doctest::Approx(1.0).epsilon(1e-6)); // rates of 1e8 lose digits
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

TEST_CASE("a wall between two samples holds what slips along it, lets nothing pass, and the two methods agree") {
    // A closed layer of faces across x in the middle of the grid.
    MacGrid grid({8, 6, 6}, {8.0, 6.0, 6.0});
    ClosedFaces closed;
    closed[0].assign(grid.cell_count(), 0);
    for (uint32_t k = 1; k < 5; ++k)
        for (uint32_t j = 1; j < 5; ++j) closed[0][grid.cell(4, j, k)] = 1;
    grid.set_solid({}, closed);

    const WallShares centred = find_wall_shares(grid, 3), along_y = find_wall_shares(grid, 1);
    GridField field = grid.make_centred_field();
    CHECK(centred[0][field.index(5, 2, 2)] == 2);
    CHECK(centred[0][field.index(5, 0, 2)] == 0);
    CHECK(centred[0][field.index(4, 2, 2)] == 0);
    const GridField& v = grid.velocity[1];
    CHECK(along_y[0][v.index(5, 2, 2)] == 2);
    CHECK(along_y[0][v.index(5, 1, 2)] == 1); // at the rim one of its two cells has the wall
    CHECK(along_y[0][v.index(5, 0, 2)] == 0);

    std::vector<uint8_t> prescribed(field.values.size(), 0);
    std::vector<double> viscosity(field.values.size(), 1.0);
    for (uint32_t k = 0; k < 6; ++k)
        for (uint32_t j = 0; j < 6; ++j) prescribed[field.index(0, j, k)] = 1;
    // No flux: values ahead of the wall stay there at first, in both directions.
    WallShares whole = centred;
    for (uint32_t k = 0; k < 6; ++k)
        for (uint32_t j = 0; j < 6; ++j) whole[0][field.index(5, j, k)] = 2;
    for (uint32_t k = 0; k < 6; ++k)
        for (uint32_t j = 0; j < 6; ++j)
            for (uint32_t i = 1; i < 5; ++i) field.values[field.index(i, j, k)] = 1.0;
    GridField other = field;
    EddyDiffusion diffusion;
    diffusion.apply(field, prescribed, viscosity, EddyDiffusion::Wall::no_flux, 100.0, whole);
    double behind = 0.0;
    for (uint32_t k = 0; k < 6; ++k)
        for (uint32_t j = 0; j < 6; ++j)
            for (uint32_t i = 5; i < 9; ++i) behind = std::max(behind, std::abs(field.values[field.index(i, j, k)]));
    CHECK(behind == 0.0);

    // No slip: a straight line from the inflow's 1 at x = 0 to the wall at x = 4, 0 behind it.
    for (uint32_t k = 0; k < 6; ++k)
        for (uint32_t j = 0; j < 6; ++j) other.values[other.index(0, j, k)] = 1.0;
    GridField unsplit = other;
    for (int s = 0; s < 40; ++s) {
        diffusion.apply(other, prescribed, viscosity, EddyDiffusion::Wall::no_slip, 10.0, whole);
        const std::vector<double> guess = unsplit.values;
        diffusion.apply_unsplit(unsplit, guess, prescribed, viscosity, EddyDiffusion::Wall::no_slip, 10.0, whole,
                                1e-12);
    }
    for (uint32_t i = 0; i <= 8; ++i) {
        const double x = i == 0 ? 0.0 : i - 0.5;
        const double line = x < 4.0 ? 1.0 - x / 4.0 : 0.0;
        CHECK(other.values[other.index(i, 2, 1)] == doctest::Approx(line).epsilon(1e-6));
        CHECK(unsplit.values[unsplit.index(i, 2, 1)] == doctest::Approx(line).epsilon(1e-6));
    }
}

TEST_CASE("the unsplit system is solved: small steps agree with the split one, large ones with the steady state") {
    MacGrid grid({12, 10, 8}, {3.0, 2.0, 2.0});
    ClosedFaces closed;
    closed[0].assign(grid.cell_count(), 0);
    for (uint32_t k = 2; k < 6; ++k)
        for (uint32_t j = 3; j < 7; ++j) closed[0][grid.cell(5, j, k)] = 1;
    grid.set_solid({}, closed);
    const WallShares walls = find_wall_shares(grid, 2);
    const std::vector<uint8_t>& prescribed = grid.prescribed[2];
    std::vector<double> viscosity(prescribed.size());
    GridField start = grid.velocity[2];
    uint64_t state = 9;
    for (size_t s = 0; s < viscosity.size(); ++s) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        viscosity[s] = 0.1 + static_cast<double>(state >> 40) * 6e-8;
        start.values[s] = prescribed[s] != 0 ? 0.0 : static_cast<double>(state >> 36 & 255u) / 255.0;
    }
    EddyDiffusion diffusion;
    const auto gap = [&](double dt) {
        GridField a = start, b = start;
        diffusion.apply(a, prescribed, viscosity, EddyDiffusion::Wall::no_slip, dt, walls);
        diffusion.apply_unsplit(b, start.values, prescribed, viscosity, EddyDiffusion::Wall::no_slip, dt, walls, 1e-13);
        double largest = 0.0;
        for (size_t s = 0; s < a.values.size(); ++s) largest = std::max(largest, std::abs(a.values[s] - b.values[s]));
        return largest;
    };
    // The error of the splitting is of second order in one step.
    CHECK(gap(2e-4) / gap(1e-4) == doctest::Approx(4.0).epsilon(0.05));
    // In the end everything is 0, as on inflow, sides and plate.
    GridField field = start;
    diffusion.apply_unsplit(field, start.values, prescribed, viscosity, EddyDiffusion::Wall::no_slip, 1e4, walls, 1e-9);
    for (const double x : field.values) CHECK(std::abs(x) < 1e-2);
}
