#include "baker/turbulence/turbulence_production.h"

#include "base/portable_math.h"

#include <algorithm>
#include <cmath>

namespace lr::shape {

double eddy_viscosity(TurbulenceState state) {
    return c_mu * state.k * (state.k / state.epsilon);
}

// With G = C_mu (k^2/epsilon) strain, Eqs. 16 and 17 separate into a Riccati equation and a quadrature,
//     chi' = a - b chi^2,  (ln k)' = a/((C1-1) chi) - chi,  a = (C1-1) C_mu strain,  b = C2-1,
// whose solution uses h = tanh(z)/z, z = sqrt(a b) t, so that a -> 0 gives the decay without cancellation:
//     chi = chi0 qn/qd,  qn = 1 + a t h/chi0,  qd = 1 + b chi0 t h,
//     k = k0 (qn cosh z)^(1/(C1-1)) (qd cosh z)^(-1/b).
TurbulenceState evolve(TurbulenceState s0, double strain, double t) {
    if (!(s0.k > 0.0)) return {0.0, 0.0}; // strain only amplifies existing turbulence
    constexpr double g = c_epsilon_1 - 1.0;
    constexpr double b = c_epsilon_2 - 1.0;
    const double a = g * c_mu * strain;
    const double z = std::sqrt(a * b) * t;
    if (!(z > 1e-9)) return decay(s0, t);
    const double chi0 = turbulent_frequency(s0);
    const double e = portable_exp(-2.0 * std::min(z, 300.0));
    const double z2 = z * z;
    const double h = z > 0.02 ? (1.0 - e) / ((1.0 + e) * z) : 1.0 - z2 * (1.0 / 3.0 - z2 * (2.0 / 15.0));
    const double log_cosh = z + portable_log(1.0 + e) - 0.69314718055994530942;
    const double qn = 1.0 + a * t * h / chi0;
    const double qd = 1.0 + b * chi0 * t * h;
    const double growth = (log_cosh + portable_log(qn)) / g - (log_cosh + portable_log(qd)) / b;
    // e^230 = 1e100 keeps k finite under lasting strain.
    const double k = s0.k * portable_exp(std::clamp(growth, -230.0, 230.0));
    return {k, k * (chi0 * (qn / qd))};
}
} // namespace lr::shape
