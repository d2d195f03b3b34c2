#include "kernel/constants.h"

#include "format/matrix6.h"
#include "kernel/modes.h"

#include <algorithm>

namespace lr {
namespace {

// Added inertia vanishes about an axis of revolution, and with it the turbulent damping of that spin. Real fluid slows
// it through the boundary layer; 0.02 of the dragged fluid at the body's own gyration radius is of the size of the
// turbulent skin friction on a spinning disc (docs/maintainers/physics.md, "Viscous floor").
constexpr double viscous_floor = 0.02;

void upper_triangle(const Matrix6& m, float out[21]) {
    size_t n = 0;
    for (size_t i = 0; i < 6; ++i)
        for (size_t j = i; j < 6; ++j) out[n++] = static_cast<float>(m[i * 6 + j]);
}

} // namespace

Matrix6 kernel_mass(const AssetData& a, bool diagonal, double rho) {
    Matrix6 mass = rigid_mass_matrix(a.mass, a.inertia);
    for (size_t i = 0; i < 36; ++i) mass[i] += rho * a.added_mass[i];
    scale_to_unit(mass, a.mass + rho * a.volume, a.length_d);
    if (diagonal)
        for (size_t i = 0; i < 6; ++i)
            for (size_t j = 0; j < 6; ++j)
                if (i != j) mass[i * 6 + j] = 0.0;
    return mass;
}

bool make_body_constants(const AssetData& a, bool diagonal, double rho, BodyConstants& out) {
    out = BodyConstants{};
    const double d = a.length_d;
    const double unit = a.mass + rho * a.volume;
    out.length = static_cast<float>(d);
    out.unit_mass = static_cast<float>(unit);
    out.weight = static_cast<float>((a.mass - rho * a.volume) / unit);
    for (size_t i = 0; i < 3; ++i)
        out.buoyancy[i] = static_cast<float>(-rho * a.volume * a.center_of_buoyancy[i] / (unit * d));

    const Matrix6 mass = kernel_mass(a, diagonal, rho);

    // rho (V I + A) and rho (D + floor): symmetric 3x3 weights of the turbulent loads, without the coupling block.
    Matrix6 load{};
    const double broadside = std::max({a.added_mass[0], a.added_mass[7], a.added_mass[14]});
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) {
            load[i * 6 + j] = a.added_mass[i * 6 + j] + (i == j ? a.volume : 0.0);
            load[(i + 3) * 6 + j + 3] = a.added_mass[(i + 3) * 6 + j + 3] +
                                        viscous_floor * (a.volume + broadside) * a.inertia[i * 3 + j] / a.mass;
        }
    for (double& v : load) v *= rho;
    scale_to_unit(load, unit, d);

    if (diagonal)
        for (size_t i = 0; i < 6; ++i)
            for (size_t j = 0; j < 6; ++j)
                if (i != j) load[i * 6 + j] = 0.0;
    Matrix6 inverse;
    if (!invert_spd(mass, inverse)) return false;

    upper_triangle(mass, out.full_mass);
    upper_triangle(inverse, out.full_inverse);
    size_t n = 0;
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = i; j < 3; ++j, ++n) {
            out.full_damping[n] = static_cast<float>(load[i * 6 + j]);
            out.full_spin_damping[n] = static_cast<float>(load[(i + 3) * 6 + j + 3]);
        }
    for (size_t i = 0; i < 3; ++i) {
        out.mass[i] = static_cast<float>(mass[i * 7]);
        out.spin_mass[i] = static_cast<float>(mass[(i + 3) * 7]);
        out.inverse_mass[i] = static_cast<float>(inverse[i * 7]);
        out.inverse_spin_mass[i] = static_cast<float>(inverse[(i + 3) * 7]);
        out.damping[i] = static_cast<float>(load[i * 7]);
        out.spin_damping[i] = static_cast<float>(load[(i + 3) * 7]);
    }
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const double spin = mass[(i + 3) * 7], munk = (mass[j * 7] - mass[k * 7]) / spin;
        out.gyroscopic[i] = static_cast<float>((mass[(j + 3) * 7] - mass[(k + 3) * 7]) / spin);
        out.munk[i] = static_cast<float>(munk);
        out.munk_turn[i] = static_cast<float>(munk / mass[j * 7]);
        out.munk_turn[i + 3] = static_cast<float>(munk / mass[k * 7]);
    }
    Modes modes;
    if (!find_modes(mass, load, modes)) return false;
    for (size_t i = 0; i < 6; ++i)
        out.rate[i] = static_cast<float>(diagonal ? load[i * 7] / mass[i * 7] : modes.rate[i]);
    for (size_t i = 0; i < 36; ++i) {
        out.to_modes[i] = static_cast<float>(modes.to[i]);
        out.from_modes[i] = static_cast<float>(modes.from[i]);
    }
    // from^T takes forces to the modes: weight and b x gravity, and the load matrix of the six Gaussians.
    const double noise_spin = 2.0;
    for (size_t m = 0; m < 6; ++m)
        for (size_t j = 0; j < 3; ++j) {
            const size_t k = (j + 1) % 3, l = (j + 2) % 3;
            const double weight = (a.mass - rho * a.volume) / unit, per = -rho * a.volume / (unit * d);
            const auto* const b = a.center_of_buoyancy.data();
            // (b x g)_l has b_k g_j with a minus sign, (b x g)_k has b_l g_j.
            out.modes_of_gravity[m * 3 + j] =
                static_cast<float>(weight * modes.from[j * 6 + m] +
                                   per * (b[l] * modes.from[(k + 3) * 6 + m] - b[k] * modes.from[(l + 3) * 6 + m]));
            for (size_t half = 0; half < 2; ++half) {
                double sum = 0.0;
                for (size_t i = 0; i < 3; ++i)
                    sum += modes.from[(i + 3 * half) * 6 + m] * load[(i + 3 * half) * 6 + j + 3 * half];
                out.modes_of_noise[m * 6 + j + 3 * half] = static_cast<float>(half ? noise_spin * sum : sum);
            }
        }
    Matrix6 translation{}, inverse_translation;
    for (size_t i = 0; i < 6; ++i) translation[i * 7] = 1.0;
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) translation[i * 6 + j] = mass[i * 6 + j];
    if (!invert_spd(translation, inverse_translation)) return false;
    n = 0;
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = i; j < 3; ++j, ++n)
            out.inverse_translation[n] = static_cast<float>(inverse_translation[i * 6 + j]);
    double slip[3][3] = {};
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) {
            for (size_t k = 0; k < 3; ++k) slip[i][j] += mass[k * 6 + i + 3] * inverse_translation[k * 6 + j];
            out.slip[i * 3 + j] = static_cast<float>(slip[i][j]);
        }
    n = 0;
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = i; j < 3; ++j, ++n) {
            double reduced = mass[(i + 3) * 6 + j + 3];
            for (size_t k = 0; k < 3; ++k) reduced -= slip[i][k] * mass[k * 6 + j + 3];
            out.reduced_rotation[n] = static_cast<float>(reduced);
        }
    out.noise_spin = static_cast<float>(noise_spin);
    out.diagonal = diagonal;
    return true;
}

double langevin_alpha(double chi, double c0, const Gains& gains) {
    return (0.5 + 0.75 * c0) * chi * gains.damping;
}

double langevin_beta_squared(double epsilon, double c0, const Gains& gains) {
    return c0 * epsilon * gains.noise * gains.noise;
}

void set_speed_turbulence(const TurbulenceSample& s, const Gains& gains, BodyConstants& out) {
    // chi = chi* s/l and epsilon = epsilon* s^3/l with the speed s; the length unit d is put back by the kernel.
    const double chi_star = s.chi * s.l / s.u0, epsilon_star = s.epsilon * s.l / (s.u0 * s.u0 * s.u0);
    const double d_over_l = static_cast<double>(out.length) / s.l;
    out.speed_alpha = static_cast<float>(langevin_alpha(chi_star, s.c0, gains) * d_over_l);
    out.speed_beta = static_cast<float>(langevin_beta_squared(epsilon_star, s.c0, gains) * d_over_l);
}

} // namespace lr
