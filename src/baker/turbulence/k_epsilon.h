// Transport of k and epsilon by a mean flow (paper Eqs. 13 to 17), on the cells of its MAC grid.
#pragma once

#include "baker/turbulence/eddy_diffusion.h"
#include "baker/turbulence/mac_grid.h"
#include "baker/turbulence/turbulence_production.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace lr::baker {

class KEpsilon {
public:
    // k and epsilon start as the inflow state. k is limited to `most_k`, or (0) to below overflow: the strain of a step does not include the energy
    // that the mean flow has already lost, so a sudden start would raise almost no turbulence to a k of many U0^2.
    KEpsilon(const MacGrid& grid, shape::TurbulenceState inflow, double most_k = 0.0);

    // Computes the strain of Eq. 15 and the parcels' origins; call whenever the mean flow has changed. Around a body the geometric
    // mean of 2 S_ij S_ij and 2 Omega_ij Omega_ij replaces the former (Kato and Launder 1993): equal in shear, but zero at
    // stagnation points, where Eqs. 14 to 17 are known to overproduce k.
    void follow(const MacGrid& grid, double dt);
    // Semi-Lagrangian advection, then the exact local solution of Eqs. 16 and 17 over dt, or over the time since the parcel entered
    // through the inflow. Around a body the length k^(3/2)/epsilon is at least that of the inflow, as at a wall of that roughness
    // (Richards and Hoxey 1993): at a smooth wall epsilon grows as the inverse distance, and its mean with every refinement of the
    // grid.
    void step(double dt);
    // Diffusion of Eq. 13, which Eqs. 16 and 17 omit. A flow with walls needs it, because slow parcels along the walls accumulate k without limit,
    // faster on finer grids. viscosity: molecular.
    void diffuse(double dt, double viscosity);

    shape::TurbulenceState at(const GridPoint& p) const;
    shape::TurbulenceState in_cell(uint32_t i, uint32_t j, uint32_t k) const;
    double strain_at(uint32_t i, uint32_t j, uint32_t k) const; // G = nu_T times it
    double largest_strain() const { return largest_strain_; }
    // nu_T of Eq. 14 in every cell, zero in solids.
    void eddy_viscosity(std::vector<double>& out) const;

private:
    void find_strain(const MacGrid& grid);
    void find_origins(const MacGrid& grid, double dt);
    void fill_solids();

    struct SolidCell { // beside the fluid: has the mean of its fluid neighbours, for parcels that touch the wall
        uint32_t sample;
        uint32_t count;
        std::array<uint32_t, 6> neighbours;
    };

    std::array<uint32_t, 3> cells_;
    std::vector<uint8_t> solid_;
    shape::TurbulenceState inflow_;
    double most_k_;
    GridField k_, epsilon_;
    std::vector<double> next_k_, next_epsilon_;
    std::vector<GridStencil> origin_;
    std::vector<double> age_; // fraction of the step that the parcel spent in the domain
    std::vector<double> strain_;
    EddyDiffusion diffusion_;
    std::vector<uint8_t> prescribed_;                  // samples of k_ on the inflow or inside solids
    std::vector<double> diffusivity_, eddy_viscosity_; // per sample of k_
    std::array<std::vector<double>, 3> centred_;
    std::vector<SolidCell> solid_cells_;
    WallShares walls_;
    // Of each cell: bits 0 to 5 for walls before and after it along x, y, z; empty: no body.
    std::vector<uint8_t> wall_sides_;
    double largest_strain_ = 0.0;
};
} // namespace lr::baker
