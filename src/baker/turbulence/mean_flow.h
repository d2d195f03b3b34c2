// The mean flow of Algorithm 1 (paper, lines 4 to 6): semi-Lagrangian advection, eddy diffusion, pressure projection.
#pragma once

#include "baker/turbulence/eddy_diffusion.h"
#include "baker/turbulence/mac_grid.h"
#include "baker/turbulence/pressure_projection.h"

#include <array>
#include <cstddef>
#include <vector>

namespace lr::baker {

class MeanFlow {
public:
    MacGrid grid;

    // initial: a grid with inflow, initial velocity and solids, which the constructor projects. Divergences up to `enough` remain.
    explicit MeanFlow(MacGrid initial, double enough = 0.0);

    // One step. viscosity: molecular plus eddy, one per cell; null: no diffusion, as in the paper. False if the pressure
    // solve did not converge.
    bool step(double dt, const std::vector<double>* viscosity);

    double last_change() const { return last_change_; } // largest change of a face velocity in the last step
    double max_divergence() const { return max_divergence_; }
    long pressure_iterations() const { return pressure_iterations_; }
    bool converged() const { return converged_; }

private:
    void advect(double dt);
    void diffuse(double dt, const std::vector<double>& viscosity);
    void project();

    PressureProjection projection_;
    double enough_;
    std::array<std::vector<double>, 3> previous_;
    EddyDiffusion diffusion_;
    std::array<std::vector<double>, 3> face_viscosity_;
    std::array<WallShares, 3> walls_;
    double last_change_ = 0.0, max_divergence_ = 0.0;
    long pressure_iterations_ = 0;
    bool converged_ = true;
};
} // namespace lr::baker
