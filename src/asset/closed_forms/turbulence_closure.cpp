#include "asset/closed_forms/turbulence_closure.h"

#include "base/portable_math.h"

#include <cmath>

namespace lr::shape {

double turbulent_frequency(TurbulenceState state) {
    return state.epsilon / state.k;
}

TurbulenceState inflow_state(double u0, double intensity, double l) {
    const double root_k = std::sqrt(1.5) * intensity * u0;
    const double c_mu_3_4 = std::sqrt(c_mu * std::sqrt(c_mu));
    return {root_k * root_k, c_mu_3_4 * root_k * root_k * root_k / l};
}

TurbulenceState decay(TurbulenceState s0, double t) {
    constexpr double b = c_epsilon_2 - 1.0;
    const double chi0 = turbulent_frequency(s0);
    const double q = 1.0 + b * chi0 * t;
    if (!std::isfinite(q)) return {0.0, 0.0}; // there was none, or it has decayed
    const double k = s0.k * portable_pow(q, -1.0 / b);
    return {k, k * (chi0 / q)};
}

double taylor_reynolds(TurbulenceState state, double viscosity) {
    return state.k * std::sqrt(20.0 / (3.0 * state.epsilon * viscosity));
}

double kolmogorov_c0(double r_lambda) {
    if (!(r_lambda > 0.0)) return 0.0;
    if (!std::isfinite(r_lambda)) return 6.5;
    // (1 + 140 R^(-4/3))^(-3/4) as R (R^(4/3) + 140)^(-3/4), which does not overflow at small R.
    const double r_4_3 = r_lambda * portable_pow(r_lambda, 1.0 / 3.0);
    if (!std::isfinite(r_4_3)) return 6.5;
    const double q = std::sqrt(std::sqrt(r_4_3 / (r_4_3 + 140.0)));
    return 6.5 * q * q * q;
}
} // namespace lr::shape
