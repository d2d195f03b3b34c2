// Pressure projection: makes the velocity of a MAC grid divergence-free (paper, Algorithm 1, line 6).
#pragma once

#include "baker/turbulence/mac_grid.h"
#include "baker/turbulence/pressure_multigrid.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace lr::baker {

struct ProjectionResult {
    bool converged;
    int iterations;
    double max_divergence; // after the projection, over the fluid cells, computed from the velocities
};

// Conjugate gradients on the 7-point Laplacian of the fluid cells, preconditioned by multigrid. Neumann at prescribed faces
// (inflow, sides, solids, closed faces), zero pressure on the outflow. Starts from the potential of the last call, so that a
// steady flow takes few iterations and a uniform flow none.
class PressureProjection {
public:
    // Reads the solid cells of the grid once.
    explicit PressureProjection(const MacGrid& grid);

    // Subtracts the gradient of the last potential from the velocity before the diffusion, so that `project` only finds the change
    // of the potential. In a steady flow the projection then does nothing, and leaves no slip of dt times the pressure gradient at
    // the walls (Van Kan 1986).
    void precorrect(MacGrid& grid);

    // Iterates until the largest divergence has fallen by `tolerance`, or to `enough`, or to rounding error (max |u|/cell
    // times 1e-14).
    ProjectionResult project(MacGrid& grid, double tolerance = 1e-9, double enough = 0.0);

private:
    void multiply(const std::vector<double>& x, std::vector<double>& y) const;
    void subtract_gradient(MacGrid& grid, const std::vector<double>& potential) const;

    bool precorrected_ = false;
    std::array<uint32_t, 3> cells_;
    std::array<double, 3> spacing_;
    std::optional<PressureMultigrid> multigrid_; // created on first use
    // Vectors have a layer of zeros before and after the cells, so that neighbours need no bounds test.
    size_t nx_, layer_, first_, last_;
    std::vector<double> diagonal_, link_[3]; // link: to the next cell along the axis, as a positive number
    std::vector<double> potential_, change_, residual_, old_residual_, direction_, image_, preconditioned_;
};
} // namespace lr::baker
