#include "baker/turbulence/pressure_projection.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <vector>

using namespace lr::baker;

namespace {

struct Random {
    uint64_t state;
    double operator()() { // -1 to 1
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state >> 11) / 4503599627370496.0 - 1.0;
    }
};

// Gives every face with a velocity a random one.
void randomise(MacGrid& grid, uint64_t seed) {
    Random random{seed};
    for (size_t a = 0; a < 3; ++a)
        for (size_t f = 0; f < grid.velocity[a].values.size(); ++f)
            if (grid.prescribed[a][f] == 0) grid.velocity[a].values[f] = random();
    GridField& u = grid.velocity[0];
    for (uint32_t k = 0; k < grid.cells[2]; ++k)
        for (uint32_t j = 0; j < grid.cells[1]; ++j) u.values[u.index(0, j, k)] = 1.0 + 0.5 * random();
}

// Fluxes through the six faces, directly from the samples, independent of MacGrid::divergence.
double largest_divergence(const MacGrid& g) {
    const GridField &u = g.velocity[0], &v = g.velocity[1], &w = g.velocity[2];
    const size_t nu = u.count[0], nv = v.count[0], nw = w.count[0];
    double largest = 0.0;
    for (size_t k = 0; k < g.cells[2]; ++k)
        for (size_t j = 0; j < g.cells[1]; ++j)
            for (size_t i = 0; i < g.cells[0]; ++i) {
                if (g.solid[(k * g.cells[1] + j) * g.cells[0] + i]) continue;
                const double* fu = &u.values[(k * u.count[1] + j) * nu + i];
                const double* fv = &v.values[(k * v.count[1] + j) * nv + i + 1];
                const double* fw = &w.values[(k * w.count[1] + j) * nw + i + 1];
                const double flux = (fu[1] - fu[0]) * g.spacing[1] * g.spacing[2] +
                                    (fv[nv] - fv[0]) * g.spacing[0] * g.spacing[2] +
                                    (fw[nw * w.count[1]] - fw[0]) * g.spacing[0] * g.spacing[1];
                largest = std::max(largest, std::abs(flux) / (g.spacing[0] * g.spacing[1] * g.spacing[2]));
            }
    return largest;
}

double largest_difference(const MacGrid& a, const MacGrid& b) {
    double largest = 0.0;
    for (size_t c = 0; c < 3; ++c)
        for (size_t f = 0; f < a.velocity[c].values.size(); ++f)
            largest = std::max(largest, std::abs(a.velocity[c].values[f] - b.velocity[c].values[f]));
    return largest;
}

std::vector<uint8_t> random_solids(const MacGrid& grid, uint64_t seed, double share) {
    Random random{seed};
    std::vector<uint8_t> mask(grid.cell_count());
    for (uint32_t k = 0; k < grid.cells[2]; ++k)
        for (uint32_t j = 0; j < grid.cells[1]; ++j)
            for (uint32_t i = 1; i + 1 < grid.cells[0]; ++i) mask[grid.cell(i, j, k)] = random() < 2.0 * share - 1.0;
    return mask;
}

} // namespace

TEST_CASE("a random field is projected to the tolerance") {
    const std::array<uint32_t, 3> shapes[] = {{32, 32, 16}, {4, 4, 4}, {17, 5, 23}, {64, 8, 8}};
    for (const auto& cells : shapes) {
        MacGrid grid(cells, {4.0, 2.0, 3.0});
        randomise(grid, 7);
        const double before = largest_divergence(grid);
        PressureProjection projection(grid);
        const ProjectionResult result = projection.project(grid, 1e-9);
        CHECK(result.converged);
        CHECK(result.iterations > 0);
        const double after = largest_divergence(grid);
        MESSAGE(cells[0] << "x" << cells[1] << "x" << cells[2] << ": " << result.iterations
                         << " iterations, divergence " << before << " -> " << after);
        CHECK(after < 2e-9 * before);
        CHECK(result.max_divergence == doctest::Approx(after).epsilon(1e-3));
        // Inflow equals outflow.
        const GridField& u = grid.velocity[0];
        double in = 0.0, out = 0.0;
        for (uint32_t k = 0; k < cells[2]; ++k)
            for (uint32_t j = 0; j < cells[1]; ++j) {
                in += u.values[u.index(0, j, k)];
                out += u.values[u.index(cells[0], j, k)];
            }
        CHECK(out == doctest::Approx(in).epsilon(1e-8));
    }
}

TEST_CASE("projection removes exactly the gradient part") {
    MacGrid grid({12, 9, 7}, {1.0, 1.1, 0.9});
    grid.set_solid(random_solids(grid, 3, 0.1));
    randomise(grid, 11);
    PressureProjection projection(grid);
    CHECK(projection.project(grid, 1e-12).converged);
    const MacGrid solenoidal = grid;

    // Add the gradient of a random potential that is zero on the outflow face.
    Random random{5};
    std::vector<double> potential(grid.cell_count());
    for (double& p : potential) p = random();
    const auto at = [&](uint32_t i, uint32_t j, uint32_t k) { return potential[grid.cell(i, j, k)]; };
    for (uint32_t k = 0; k < grid.cells[2]; ++k)
        for (uint32_t j = 0; j < grid.cells[1]; ++j)
            for (uint32_t i = 0; i < grid.cells[0]; ++i) {
                GridField &u = grid.velocity[0], &v = grid.velocity[1], &w = grid.velocity[2];
                size_t f = u.index(i, j, k);
                if (!grid.prescribed[0][f]) u.values[f] += (at(i, j, k) - at(i - 1, j, k)) / grid.spacing[0];
                f = v.index(i + 1, j, k);
                if (!grid.prescribed[1][f]) v.values[f] += (at(i, j, k) - at(i, j - 1, k)) / grid.spacing[1];
                f = w.index(i + 1, j, k);
                if (!grid.prescribed[2][f]) w.values[f] += (at(i, j, k) - at(i, j, k - 1)) / grid.spacing[2];
                if (i + 1 == grid.cells[0])
                    u.values[u.index(i + 1, j, k)] += (0.0 - at(i, j, k)) / (0.5 * grid.spacing[0]);
            }
    CHECK(largest_difference(grid, solenoidal) > 1.0);
    CHECK(projection.project(grid, 1e-12).converged);
    CHECK(largest_difference(grid, solenoidal) < 1e-9);
    // A second projection changes nothing.
    const MacGrid once = grid;
    projection.project(grid, 1e-6);
    CHECK(largest_difference(grid, once) < 1e-9);
}

TEST_CASE("the uniform stream needs no iteration and is not touched") {
    MacGrid grid({32, 32, 16}, {8.0, 8.0, 4.0});
    for (double& u : grid.velocity[0].values) u = 0.74;
    const MacGrid before = grid;
    PressureProjection projection(grid);
    const ProjectionResult result = projection.project(grid);
    CHECK(result.iterations == 0);
    CHECK(result.max_divergence == 0.0);
    CHECK(largest_difference(grid, before) == 0.0);
}

TEST_CASE("nothing flows through solids of any shape") {
    for (double share : {0.02, 0.2, 0.5}) {
        MacGrid grid({20, 16, 12}, {2.0, 1.6, 1.2});
        grid.set_solid(random_solids(grid, 19, share));
        bool open = true;
        for (uint32_t k = 0; k < 12; ++k)
            for (uint32_t j = 0; j < 16; ++j) open = open && grid.solid[grid.cell(0, j, k)] == 0;
        REQUIRE(open);
        randomise(grid, 23);
        const double before = largest_divergence(grid);
        PressureProjection projection(grid);
        const ProjectionResult result = projection.project(grid, 1e-9);
        CHECK(result.converged);
        CHECK(largest_divergence(grid) < 2e-9 * before);
        double through = 0.0;
        for (uint32_t k = 0; k < 12; ++k)
            for (uint32_t j = 0; j < 16; ++j)
                for (uint32_t i = 0; i < 20; ++i) {
                    if (!grid.solid[grid.cell(i, j, k)]) continue;
                    const GridField &u = grid.velocity[0], &v = grid.velocity[1], &w = grid.velocity[2];
                    for (uint32_t s : {0u, 1u})
                        through = std::max({through, std::abs(u.values[u.index(i + s, j, k)]),
                                            std::abs(v.values[v.index(i + 1, j + s, k)]),
                                            std::abs(w.values[w.index(i + 1, j, k + s)])});
                }
        CHECK(through == 0.0);
    }
}

TEST_CASE("closed faces part the pressures of their sides, and the iterations do not grow with the grid") {
    for (const uint32_t n : {16u, 32u, 64u}) {
        MacGrid grid({n, n, n / 2}, {4.0, 4.0, 2.0});
        // A plate without thickness across the stream, a cell off the blocks of the coarser grids, and a slanted one.
        ClosedFaces closed;
        for (std::vector<uint8_t>& faces : closed) faces.assign(grid.cell_count(), 0);
        for (uint32_t k = n / 8; k < 3 * n / 8; ++k)
            for (uint32_t j = n / 4 + 1; j < 3 * n / 4 - 1; ++j) {
                closed[0][grid.cell(n / 4 + 1, j, k)] = 1;
                const uint32_t i = n / 2 + j / 4;
                closed[0][grid.cell(i, j, k)] = 1;
                if (j % 4 == 3) closed[1][grid.cell(i, j + 1, k)] = 1;
            }
        grid.set_solid({}, closed);
        for (double& u : grid.velocity[0].values) u = 1.0;
        grid.set_solid({}, closed);
        const double before = largest_divergence(grid);
        PressureProjection projection(grid);
        const ProjectionResult result = projection.project(grid, 1e-9);
        CHECK(result.converged);
        MESSAGE(n << " cells: " << result.iterations << " iterations");
        CHECK(result.iterations <= 16);
        CHECK(largest_divergence(grid) < 2e-9 * before);
        double through = 0.0, in = 0.0, out = 0.0;
        const GridField& u = grid.velocity[0];
        for (uint32_t k = 0; k < n / 2; ++k)
            for (uint32_t j = 0; j < n; ++j) {
                for (uint32_t i = 1; i < n; ++i)
                    if (closed[0][grid.cell(i, j, k)] != 0)
                        through = std::max(through, std::abs(u.values[u.index(i, j, k)]));
                in += u.values[u.index(0, j, k)];
                out += u.values[u.index(n, j, k)];
            }
        CHECK(through == 0.0);
        CHECK(out == doctest::Approx(in).epsilon(1e-8));
        // Right behind the plate the stream is almost still; beside it faster than before.
        CHECK(std::abs(u.values[u.index(n / 4 + 2, n / 2, n / 4)]) < 0.5);
        CHECK(u.values[u.index(n / 4 + 1, 1, n / 4)] > 1.0);
    }
}
