// Pressure projection: makes the velocity of a MAC grid divergence-free (paper, Algorithm 1, line 6).
#pragma once

#include "baker/mac_grid.h"

#include <cstddef>
#include <vector>

namespace lr::baker {

struct ProjectionResult {
    bool converged;
    int iterations;
    double max_divergence; // afterwards, over the fluid cells, from the velocities themselves
};

// Conjugate gradients on the 7-point Laplacian of the fluid cells, preconditioned by a modified incomplete Cholesky
// factorisation without fill-in. Neumann at prescribed faces (inflow, sides, solids), pressure zero on the outflow.
// Starts from the potential of the last call: a steady flow costs few iterations and a uniform one none.
class PressureProjection {
public:
    // The solid cells of the grid are read here once.
    explicit PressureProjection(const MacGrid& grid);

    // Until the largest divergence has fallen by `tolerance`, or to rounding error (max |u|/cell times 1e-14).
    ProjectionResult project(MacGrid& grid, double tolerance = 1e-9, int max_iterations = 5000);

private:
    void factorise();
    void multiply(const std::vector<double>& x, std::vector<double>& y) const;
    void precondition(const std::vector<double>& r, std::vector<double>& z);
    void subtract_gradient(MacGrid& grid) const;

    // Vectors carry a layer of zeros before and after the cells, so that neighbours need no bounds test.
    size_t nx_, layer_, first_, last_;
    std::vector<double> diagonal_, link_[3]; // link: to the next cell along the axis, as a positive number
    std::vector<double> pivot_, lower_[3];   // the factor: reciprocal pivots, links times pivots
    std::vector<double> potential_, residual_, direction_, image_, preconditioned_;
};

} // namespace lr::baker
