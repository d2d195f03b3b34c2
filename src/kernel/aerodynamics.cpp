#include "kernel/aerodynamics.h"

#include "kernel/modes.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

using Columns3 = std::array<std::array<double, 3>, 6>; // 6x3

void narrow(const std::array<double, 3>& from, double factor, float out[3]) {
    for (size_t i = 0; i < 3; ++i) out[i] = static_cast<float>(from[i] * factor);
}

// Eigenvalues and, as columns, orthonormal eigenvectors of a symmetric 3x3 matrix.
bool eigen3(const double n[3][3], double values[3], double vectors[3][3]) {
    Matrix6 unit{}, padded{};
    for (size_t i = 0; i < 6; ++i) unit[i * 7] = 1.0;
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) padded[i * 6 + j] = n[i][j];
    Modes modes;
    if (!find_modes(unit, padded, modes)) return false;
    for (size_t i = 0; i < 3; ++i) {
        values[i] = modes.rate[i];
        for (size_t j = 0; j < 3; ++j) vectors[i][j] = modes.from[i * 6 + j];
    }
    return true;
}

bool invert3(const double m[3][3], double out[3][3]) {
    Matrix6 padded{}, inverse;
    for (size_t i = 0; i < 6; ++i) padded[i * 7] = 1.0;
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) padded[i * 6 + j] = m[i][j];
    if (!invert_spd(padded, inverse)) return false;
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) out[i][j] = inverse[i * 6 + j];
    return true;
}

// M^-1 p^T
Columns3 response_to(const Matrix6& inverse_mass, const double p[3][6]) {
    Columns3 out{};
    for (size_t i = 0; i < 6; ++i)
        for (size_t j = 0; j < 3; ++j)
            for (size_t k = 0; k < 6; ++k) out[i][j] += inverse_mass[i * 6 + k] * p[j][k];
    return out;
}

void mobility_of(const double p[3][6], const Columns3& response, double out[3][3]) {
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) {
            out[i][j] = 0.0;
            for (size_t k = 0; k < 6; ++k) out[i][j] += p[i][k] * response[k][j];
        }
}

Columns3 product(const Columns3& a, const double b[3][3]) {
    Columns3 out{};
    for (size_t i = 0; i < 6; ++i)
        for (size_t j = 0; j < 3; ++j)
            for (size_t k = 0; k < 3; ++k) out[i][j] += a[i][k] * b[k][j];
    return out;
}

void store(const Columns3& from, float out[18]) {
    for (size_t i = 0; i < 18; ++i) out[i] = static_cast<float>(from[i / 3][i % 3]);
}

void product3(const double a[3][3], const double b[3][3], float out[9]) {
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j)
            out[i * 3 + j] = static_cast<float>(a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j]);
}

void upper_triangle3(const double m[3][3], float out[6]) {
    size_t n = 0;
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = i; j < 3; ++j) out[n++] = static_cast<float>(m[i][j]);
}

bool make_frame(const AssetData& a, const AerodynamicData& loads, const Matrix6& mass, double rho,
                AerodynamicConstants& out) {
    Matrix6 inverse;
    if (!invert_spd(mass, inverse)) return false;
    const auto& q = loads.axes;
    double r[3], to[3][6] = {}, spin[3][6] = {};
    for (size_t i = 0; i < 3; ++i) {
        r[i] = (a.center_of_buoyancy[i] + loads.center[i]) / a.length_d;
        out.arm[i] = static_cast<float>(r[i]);
    }
    for (size_t i = 0; i < 9; ++i) out.axes[i] = static_cast<float>(q[i]);
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) {
            to[i][j] = spin[i][j + 3] = q[i * 3 + j];
            // u x r = (r_z u_y - r_y u_z, ...), row j of it against column k of u
            const size_t k = (j + 1) % 3, l = (j + 2) % 3;
            to[i][3 + k] += q[i * 3 + j] * r[l];
            to[i][3 + l] -= q[i * 3 + j] * r[k];
        }
    const Columns3 response = response_to(inverse, to), spin_response = response_to(inverse, spin);
    double n[3][3], n_spin[3][3], mixed[3][3], n_inverse[3][3], spin_inverse[3][3], values[3], vectors[3][3];
    mobility_of(to, response, n);
    mobility_of(to, spin_response, mixed); // velocity for a couple; transposed, spin for an impulse
    mobility_of(spin, spin_response, n_spin);
    if (!invert3(n, n_inverse) || !invert3(n_spin, spin_inverse) || !eigen3(n, values, vectors)) return false;
    upper_triangle3(n, out.mobility);
    double adjugate[3][3];
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) {
            const size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            adjugate[i][j] = n[i1][j1] * n[i2][j2] - n[i1][j2] * n[i2][j1]; // of a symmetric matrix: its cofactors
        }
    upper_triangle3(adjugate, out.mobility_adjugate);
    upper_triangle3(n_spin, out.spin_mobility);
    double turned[3][3];
    for (size_t i = 0; i < 3; ++i) {
        out.rate[i] = static_cast<float>(values[i]);
        for (size_t j = 0; j < 3; ++j) {
            out.modes[i * 3 + j] = static_cast<float>(vectors[i][j]);
            turned[i][j] = mixed[j][i];
            out.spin_response_to_force[i * 3 + j] = static_cast<float>(turned[i][j]);
        }
        for (size_t j = 0, k = 0; j < 3; ++j)
            if (j != i) out.spin_answer[i * 2 + k++] = static_cast<float>(n_spin[j][i] / n_spin[i][i]);
    }
    const double unit = a.mass + rho * a.volume, weight = (a.mass - rho * a.volume) / unit;
    double b[3];
    for (size_t i = 0; i < 3; ++i) b[i] = -rho * a.volume * a.center_of_buoyancy[i] / (unit * a.length_d);
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) {
            // Force weight e_j, torque b x e_j.
            const size_t k = (j + 1) % 3, l = (j + 2) % 3;
            const auto answer = [&](const Columns3& to_twist) {
                return static_cast<float>(weight * to_twist[j][i] + b[l] * to_twist[k + 3][i] -
                                          b[k] * to_twist[l + 3][i]);
            };
            out.fall[i * 3 + j] = answer(response);
            out.fall[9 + i * 3 + j] = answer(spin_response);
        }
    product3(turned, n_inverse, out.spin_of_force);
    product3(mixed, spin_inverse, out.velocity_of_couple);
    store(product(spin_response, spin_inverse), out.spin_response);
    return true;
}

bool within(const std::array<double, 3>& values, double low, double high) {
    return std::all_of(values.begin(), values.end(), [&](double v) { return v >= low && v <= high; });
}

// Bodies are up to 1000 m: nothing has a larger length to the fifth power.
constexpr double most = 1e16;

// A wake's velocity counts in the speed that it goes with. On a body that is not carried along, E s^2 = v^2 + 3 I^2 E s^2:
// from I^2 = 1/3 on it would feed itself.
constexpr double most_variance = 0.16;

} // namespace

bool is_usable(const AerodynamicData& a) {
    for (const auto* v : {&a.drag, &a.drag_blunt, &a.drag_layer, &a.drag_stokes, &a.spin_drag, &a.spin_drag_stream,
                          &a.spin_drag_stokes, &a.roll_damping})
        if (!within(*v, 0.0, most)) return false;
    if (!within(a.broadside, 0.0, 1.0) || !(std::abs(a.lift_stall) <= 10.0)) return false;
    for (const auto* v : {&a.lift, &a.spin_lift, &a.lift_moment, &a.lift_moment_stalled})
        if (!within(*v, -most, most)) return false;
    if (!(a.intensity >= 0.0 && a.intensity <= 10.0) || !(a.length > 0.0 && a.length <= 1e6) ||
        !(a.wake_reynolds >= 0.0 && a.wake_reynolds <= 1e9))
        return false;
    return is_rotation(a.axes, 1e-6); // a caller may have single precision
}

const char* wrong_in(const AerodynamicData& a) {
    return is_usable(a) ? nullptr : "a value is out of its range, or the axes are no rotation";
}

bool make_aerodynamics(const AssetData& a, const AerodynamicData& loads, const Gains& gains, bool diagonal, double rho,
                       double viscosity, BodyConstants& body) {
    if (!within(loads.center, -2.0 * a.length_d, 2.0 * a.length_d)) return false; // as check_asset
    AerodynamicConstants& out = body.aerodynamics;
    out = AerodynamicConstants{};
    out.viscosity = static_cast<float>(viscosity);
    const double d = a.length_d, unit = a.mass + rho * a.volume, per_unit = rho / unit;
    narrow(loads.drag, 0.5 * gains.drag * per_unit * d, out.drag);
    narrow(loads.drag_blunt, 0.5 * gains.drag * per_unit * d, out.drag_blunt);
    const double layer = gains.drag * per_unit * d * std::sqrt(d), stokes = gains.drag * per_unit * d * d;
    narrow(loads.drag_layer, layer, out.drag_layer);
    narrow(loads.drag_stokes, stokes, out.drag_stokes);
    narrow(loads.lift, gains.lift * per_unit * d, out.lift);
    narrow(loads.spin_lift, gains.lift * per_unit, out.spin_lift);
    narrow(loads.lift_moment, gains.lift * per_unit, out.lift_moment);
    narrow(loads.lift_moment_stalled, gains.lift * per_unit, out.lift_moment_stalled);
    narrow(loads.broadside, 1.0, out.broadside);
    out.lift_stall = static_cast<float>(loads.lift_stall);
    narrow(loads.spin_drag, gains.spin_drag * per_unit / (d * d), out.spin_drag);
    narrow(loads.spin_drag_stream, gains.spin_drag * per_unit / d, out.spin_drag_stream);
    narrow(loads.spin_drag_stokes, gains.spin_drag * per_unit, out.spin_drag_stokes);
    const double strongest = std::max({loads.spin_drag[0], loads.spin_drag[1], loads.spin_drag[2]});
    for (size_t k = 0; k < 3; ++k) {
        const size_t i = (k + 1) % 3, j = (k + 2) % 3;
        out.lift_layer[k] = static_cast<float>(layer * (loads.drag_layer[j] - loads.drag_layer[i]));
        out.lift_stokes[k] = static_cast<float>(stokes * (loads.drag_stokes[j] - loads.drag_stokes[i]));
        out.roll[k] = static_cast<float>(std::sqrt(gains.spin_drag * per_unit / d * loads.roll_damping[k]));
        out.spin_weight[k] = static_cast<float>(strongest > 0.0 ? loads.spin_drag[k] / strongest : 0.0);
    }
    out.rate_of_gusts = static_cast<float>(d / loads.length);
    const double intensity = loads.intensity * gains.turbulence * gains.noise;
    out.variance_of_gusts = static_cast<float>(std::min(intensity * intensity, most_variance));
    out.wake_reynolds = static_cast<float>(loads.wake_reynolds);
    out.gust_gain = static_cast<float>(gains.turbulence * gains.turbulence);
    return make_frame(a, loads, kernel_mass(a, diagonal, rho), rho, out);
}

void set_gust_turbulence(const TurbulenceSample& s, const Gains& gains, BodyConstants& out) {
    const double chi_star = s.chi * s.l / s.u0, epsilon_star = s.epsilon * s.l / (s.u0 * s.u0 * s.u0);
    const double alpha = langevin_alpha(chi_star, s.c0, {}),
                 beta_squared = langevin_beta_squared(epsilon_star, s.c0, {});
    out.aerodynamics.rate_of_gusts = static_cast<float>(alpha * static_cast<double>(out.length) / s.l);
    out.aerodynamics.wake_reynolds = 0.0f;
    const double gain = gains.noise * gains.turbulence;
    out.aerodynamics.variance_of_gusts =
        static_cast<float>(alpha > 0.0 ? std::min(gain * gain * beta_squared / (2.0 * alpha), most_variance) : 0.0);
}

} // namespace lr
