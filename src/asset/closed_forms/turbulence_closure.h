// Closed forms of the k-epsilon and Langevin closures: shared by the baker's tables and the analytic assets.
#pragma once

namespace lr::shape {

// Standard k-epsilon constants (paper, at Eqs. 13 and 14); those of production and diffusion: baker/turbulence/turbulence_production.h.
inline constexpr double c_mu = 0.09;
inline constexpr double c_epsilon_2 = 1.92;

struct TurbulenceState {
    double k;       // turbulent kinetic energy, m^2/s^2
    double epsilon; // its dissipation rate, m^2/s^3
};

// chi = epsilon/k, 1/s.
double turbulent_frequency(TurbulenceState state);

// Paper Eq. 18 with the intensity as a parameter: k0 = 3/2 (I U0)^2, epsilon0 = C_mu^(3/4) k0^(3/2)/l. The paper has I = 1, and the grid cell for l,
// so that half the cell doubles chi0; here l is a length of the body (docs/maintainers/physics.md section 7).
TurbulenceState inflow_state(double u0, double intensity, double l);

// Eqs. 16 and 17 without production, exactly: k = k0 (1 + (C2-1) chi0 t)^(-1/(C2-1)), chi = chi0/(1 + (C2-1) chi0 t).
TurbulenceState decay(TurbulenceState s0, double t);

// Taylor-scale Reynolds number sqrt(20 k^2/(3 epsilon nu)), nu the molecular viscosity in m^2/s.
double taylor_reynolds(TurbulenceState state, double viscosity);

// Paper Eq. 10, read with the Taylor-scale Reynolds number (docs/maintainers/physics.md section 7). 0 at rest, 6.5 at most.
double kolmogorov_c0(double r_lambda);
} // namespace lr::shape
