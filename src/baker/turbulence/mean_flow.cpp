#include "baker/turbulence/mean_flow.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lr::baker {

namespace {

constexpr double residual_left = 1e-5; // of the diffusion, in units of U0
} // namespace

MeanFlow::MeanFlow(MacGrid initial, double enough) : grid(std::move(initial)), projection_(grid), enough_(enough) {
    for (size_t a = 0; a < 3; ++a) {
        previous_[a] = grid.velocity[a].values;
        face_viscosity_[a].resize(previous_[a].size());
        walls_[a] = find_wall_shares(grid, a);
    }
    project();
}

bool MeanFlow::step(double dt, const std::vector<double>* viscosity) {
    advect(dt);
    if (viscosity != nullptr) {
        projection_.precorrect(grid);
        diffuse(dt, *viscosity);
    }
    project();
    last_change_ = 0.0;
    for (size_t a = 0; a < 3; ++a)
        for (size_t f = 0; f < previous_[a].size(); ++f)
            last_change_ = std::max(last_change_, std::abs(grid.velocity[a].values[f] - previous_[a][f]));
    return converged_;
}

void MeanFlow::project() {
    const ProjectionResult result = projection_.project(grid, 1e-9, enough_);
    converged_ = converged_ && result.converged;
    pressure_iterations_ += result.iterations;
    max_divergence_ = std::max(max_divergence_, result.max_divergence);
}

// Into previous_, then swapped, because every trace reads the velocity of the last step.
void MeanFlow::advect(double dt) {
    for (size_t a = 0; a < 3; ++a) {
        const GridField& field = grid.velocity[a];
        for (uint32_t k = 0; k < field.count[2]; ++k)
            for (uint32_t j = 0; j < field.count[1]; ++j)
                for (uint32_t i = 0; i < field.count[0]; ++i) {
                    const size_t f = field.index(i, j, k);
                    previous_[a][f] =
                        grid.prescribed[a][f] != 0
                            ? field.values[f]
                            : field.interpolate_cubic(field.locate(grid.trace_back(field.position(i, j, k), dt)));
                }
    }
    for (size_t a = 0; a < 3; ++a) previous_[a].swap(grid.velocity[a].values);
}

// The paper uses nu_T only for G. Without nu_T in the mean flow a shear layer is as thin as a cell, and G grows without bound as the grid is refined.
void MeanFlow::diffuse(double dt, const std::vector<double>& viscosity) {
    const std::array<uint32_t, 3>& n = grid.cells;
    for (size_t a = 0; a < 3; ++a) {
        GridField& field = grid.velocity[a];
        // A face has the mean viscosity of its fluid cells; zero inside a solid.
        for (uint32_t k = 0; k < field.count[2]; ++k)
            for (uint32_t j = 0; j < field.count[1]; ++j)
                for (uint32_t i = 0; i < field.count[0]; ++i) {
                    const uint32_t at[3] = {field.inflow_column && i > 0 ? i - 1 : i, j, k};
                    uint32_t after[3], before[3];
                    for (size_t b = 0; b < 3; ++b) {
                        after[b] = std::min(at[b], n[b] - 1);
                        before[b] = (b == a && at[b] > 0) ? at[b] - 1 : after[b];
                    }
                    const double x = viscosity[grid.cell(after[0], after[1], after[2])];
                    const double y = viscosity[grid.cell(before[0], before[1], before[2])];
                    face_viscosity_[a][field.index(i, j, k)] = (x > 0.0 && y > 0.0) ? 0.5 * (x + y) : std::max(x, y);
                }
        diffusion_.apply_unsplit(field, previous_[a], grid.prescribed[a], face_viscosity_[a],
                                 EddyDiffusion::Wall::no_slip, dt, walls_[a], residual_left);
    }
}
} // namespace lr::baker
