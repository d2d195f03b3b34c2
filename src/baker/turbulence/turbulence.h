// The turbulence table of a body: Algorithm 1 of the paper on a MAC grid, as repaired in docs/maintainers/physics.md sections 3, 6.
//
// Which particle is tracked. The paper's stream moves at the body's mean falling velocity (Eq. 19), so a particle
// carried by it from where the body is stays with the falling body, and the table is the history of (chi, epsilon)
// along that particle's path, beginning with the inflow state of Eq. 18 and fed by whatever strain it meets. Once it
// has left through the outflow it meets none, and the history goes on as the closed-form decay. With a solid in the
// stream the body stands still in the flow and no particle stays with it: there the table is the mean of k and
// epsilon over the fluid around the body and one d behind it, which develops in time and becomes steady.
#pragma once

#include "asset/input_faults.h"
#include "baker/turbulence/mac_grid.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace lr::baker {

struct TurbulenceOptions {
    std::array<uint32_t, 3> cells{32, 32, 16}; // 4 to 512 along an axis, 2^22 in all
    double intensity = 1.0;                    // I of k0 = 3/2 (I U0)^2; the paper has 1. From 1e-6 to 10
    double u0 = 0.0;                           // mean falling speed, paper Eq. 1, m/s
    double length_l = 0.0;                     // l of Eq. 18, a length of the body, m
    double length_d = 0.0;                     // characteristic length of the body, m: the domain is measured in it
    double viscosity = 0.0;                    // molecular, m^2/s
    // Domain in multiples of d, so that a finer grid resolves the same flow. Cubic cells on the default grid.
    std::array<double, 3> domain_lengths{8.0, 8.0, 4.0};
    // Length of the table in l/U0. 0: until chi of a decaying parcel is a tenth of chi0, and with a solid at least
    // four passages of the domain. A wake: four passages.
    double duration_star = 0.0;
    uint32_t samples = 128; // of the table, 2 to 65536
    // One per cell, x fastest, non-zero: solid. Empty: no solid. The first and last layers in x must be fluid. The
    // body's centre is at body_position().
    std::vector<uint8_t> solid;
    // Closed faces between fluid cells: a sheet, or the surface of a body, whose inside then becomes solid.
    ClosedFaces closed_faces;
    // Lowest and highest corner of the body in the domain, m, needed with closed faces; else the box of the solid cells.
    std::array<GridPoint, 2> body_box{};
    // Mean velocity at the start, and at x = 0 for ever, in m/s at a point in m; empty: the uniform stream (U0, 0, 0).
    std::function<std::array<double, 3>(const std::array<double, 3>&)> initial_velocity;
    // In a flow with strain, let nu + nu_T act on the mean flow, and diffuse k and epsilon as in Eq. 13 (the paper
    // drops both). The uniform stream does not notice; a wake needs it to converge with the grid. Off for homogeneous
    // shear, which the slip walls would otherwise wear away.
    bool diffusion = true;
};

struct TurbulenceTable {
    double dt = 0.0; // between samples, s
    double u0 = 0.0, l = 0.0, intensity = 0.0;
    double c0 = 0.0, r_lambda = 0.0;        // of the stationary state
    std::vector<double> t, chi, epsilon, k; // s, 1/s, m^2/s^3, m^2/s^2
    // For the SPEED clock. Without a solid k can only decay, and a moving body keeps renewing the state that it makes:
    // the stationary point is sample 0. With a body, the table keeps the mean of the steady part from there on; if it
    // sheds vortices, or does not settle, the mean over a period, or over the last half, is the last sample.
    uint32_t stationary_index = 0;
    double stationary_chi_star = 0.0, stationary_epsilon_star = 0.0;
    bool settled = false;                  // the stationary point or loop was reached
    uint32_t loop_begin = 0, loop_end = 0; // samples [begin, end) repeat; equal: no loop
    bool wake = false;
    std::array<double, 3> domain_lengths{}; // in d
    // How it was made.
    std::array<uint32_t, 3> cells{};
    uint32_t steps = 0;
    double max_divergence = 0.0; // largest |div u| d/U0 left by any projection
    uint32_t pressure_iterations = 0;

    double t_star(size_t n) const { return t[n] * u0 / l; }
    double chi_star(size_t n) const { return chi[n] * l / u0; }
    double epsilon_star(size_t n) const { return epsilon[n] * l / (u0 * u0 * u0); }
};

// Centre of the body in the domain, m: a quarter of the way down the stream, halfway across.
std::array<double, 3> body_position(const TurbulenceOptions& options);

// False, with fault 301 and the table untouched, if a parameter is out of range. `progress` (0 to 1) may be empty.
bool compute_turbulence_table(const TurbulenceOptions& options, TurbulenceTable& table, Faults& faults,
                              const std::function<void(double)>& progress = {});

} // namespace lr::baker
