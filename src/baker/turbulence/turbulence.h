// The turbulence table of a body: Algorithm 1 of the paper on a MAC grid, as repaired in docs/maintainers/physics.md sections 3, 6.
//
// The tracked particle: the paper's stream moves at the body's mean falling velocity (Eq. 19), so a particle that starts at the body's position stays
// with the falling body. The table is the history of (chi, epsilon) along this particle's path: it begins with the inflow state of Eq. 18 and
// includes the strain along the path, and after the particle has left through the outflow it continues as the closed-form decay. With a solid in the
// stream the body is fixed in the flow and no particle stays with it. The table is then the mean of k and epsilon over the fluid around the body and
// one d behind it, which develops in time and becomes steady.
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
    // Length of the table in l/U0. 0: until chi of a decaying parcel is a tenth of chi0; with a solid, at least four passages of
    // the domain. A wake: four passages.
    double duration_star = 0.0;
    uint32_t samples = 128; // of the table, 2 to 65536
    // One per cell, x fastest; non-zero: solid. Empty: no solid. The first and last layers in x must be fluid. The body's
    // centre is at body_position().
    std::vector<uint8_t> solid;
    // Closed faces between fluid cells: a sheet, or the surface of a body, whose inside becomes solid.
    ClosedFaces closed_faces;
    // Lowest and highest corner of the body in the domain, m. Required with closed_faces; otherwise the box of the solid cells.
    std::array<GridPoint, 2> body_box{};
    // Mean velocity, m/s at a point in m, at the start and at x = 0 at all times. Empty: the uniform stream (U0, 0, 0).
    std::function<std::array<double, 3>(const std::array<double, 3>&)> initial_velocity;
    // In a flow with strain, nu + nu_T acts on the mean flow, and k and epsilon diffuse as in Eq. 13 (the paper omits both). No effect on the uniform
    // stream; a wake needs it to converge with the grid. Must be off for homogeneous shear, which the slip walls would diffuse away.
    bool diffusion = true;
};

struct TurbulenceTable {
    double dt = 0.0; // between samples, s
    double u0 = 0.0, l = 0.0, intensity = 0.0;
    double c0 = 0.0, r_lambda = 0.0;        // of the stationary state
    std::vector<double> t, chi, epsilon, k; // s, 1/s, m^2/s^3, m^2/s^2
    // Sample of the SPEED clock. Without a solid k only decays, and a moving body keeps renewing its initial state: sample 0. With a body it is the
    // first sample of the steady mean; with vortex shedding, or without settling, it is the last sample, the mean over a period or over the last
    // half.
    uint32_t stationary_index = 0;
    double stationary_chi_star = 0.0, stationary_epsilon_star = 0.0;
    bool settled = false;                  // a stationary point or loop was reached
    uint32_t loop_begin = 0, loop_end = 0; // samples [begin, end) repeat; equal: no loop
    bool wake = false;
    std::array<double, 3> domain_lengths{}; // in d
    // The options of the computation.
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

// False, with fault 301 and the table untouched, if a parameter is out of range. progress: 0 to 1; can be empty.
bool compute_turbulence_table(const TurbulenceOptions& options, TurbulenceTable& table, Faults& faults,
                              const std::function<void(double)>& progress = {});
} // namespace lr::baker
