// Production of k and epsilon by strain, in closed form. Without strain: asset/closed_forms/turbulence_closure.h.
#pragma once

#include "asset/closed_forms/turbulence_closure.h"

namespace lr::shape {

inline constexpr double c_epsilon_1 = 1.44;
inline constexpr double sigma_k = 1.0;
inline constexpr double sigma_epsilon = 1.3;

// Paper Eq. 14: nu_T = C_mu k^2/epsilon, m^2/s.
double eddy_viscosity(TurbulenceState state);

// Exact solution of Eqs. 16 and 17 with the production of Eqs. 14 and 15 under constant strain. strain: 2 S_ij S_ij, 1/s^2.
// Positive for any time and strain, unlike an explicit step.
TurbulenceState evolve(TurbulenceState s0, double strain, double t);
} // namespace lr::shape
