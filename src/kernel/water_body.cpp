#include "kernel/aerodynamics.h"
#include "kernel/modes.h"
#include "kernel/surface.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

// The ellipsoid with the body's moments of inertia, as if it were solid: a^2 = 5/(2 m) (J_j + J_k - J_i).
bool equivalent_ellipsoid(const AssetData& a, WaterBody& out) {
    Matrix6 unit{}, inertia{};
    for (size_t i = 0; i < 6; ++i) unit[i * 7] = 1.0;
    bool aligned = true;
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) {
            inertia[i * 6 + j] = a.inertia[i * 3 + j] / (a.mass * a.length_d * a.length_d);
            aligned = aligned && (i == j || a.inertia[i * 3 + j] == 0.0);
        }
    double moment[3], axes[3][3] = {};
    if (aligned) {
        for (size_t i = 0; i < 3; ++i) moment[i] = inertia[i * 7], axes[i][i] = 1.0;
    } else {
        // Padding has no inertia: the body's own three modes are those along its axes.
        Modes modes;
        if (!find_modes(unit, inertia, modes)) return false;
        size_t n = 0;
        for (size_t m = 0; m < 6 && n < 3; ++m) {
            double share = 0.0;
            for (size_t k = 0; k < 3; ++k) share += modes.from[k * 6 + m] * modes.from[k * 6 + m];
            if (share < 0.5) continue;
            moment[n] = modes.rate[m];
            for (size_t k = 0; k < 3; ++k) axes[n][k] = modes.from[k * 6 + m];
            ++n;
        }
        if (n < 3) return false;
    }
    // A sheet's thickness is lost in the difference of its moments.
    const double least = 0.5 * a.length_b;
    double longest = 0.0, offset = 0.0;
    for (size_t i = 0; i < 3; ++i) {
        const double squared = 2.5 * (moment[(i + 1) % 3] + moment[(i + 2) % 3] - moment[i]) * a.length_d * a.length_d;
        out.semi_axes_squared[i] = static_cast<float>(std::max(squared, least * least));
        longest = std::max(longest, static_cast<double>(out.semi_axes_squared[i]));
        offset += a.center_of_buoyancy[i] * a.center_of_buoyancy[i];
        out.center[i] = static_cast<float>(a.center_of_buoyancy[i]);
        for (size_t k = 0; k < 3; ++k) out.axes[i * 3 + k] = static_cast<float>(axes[i][k]);
    }
    out.radius = static_cast<float>(std::sqrt(longest) + std::sqrt(offset));
    return true;
}

} // namespace

bool make_water_body(const AssetData& a, const AerodynamicData& loads, const Gains& gains,
                     const TurbulenceSample& stationary, bool diagonal, double air_density, double water_density,
                     double water_viscosity, const BodyConstants& air, WaterBody& out) {
    out = WaterBody{};
    if (!make_body_constants(a, diagonal, water_density, out.water) ||
        !make_aerodynamics(a, loads, gains, diagonal, water_density, water_viscosity, out.water) ||
        !equivalent_ellipsoid(a, out))
        return false;
    if (stationary.u0 > 0.0) set_gust_turbulence(stationary, gains, out.water);
    out.water.speed_alpha = air.speed_alpha;
    out.water.speed_beta = air.speed_beta;
    out.mass = static_cast<float>(a.mass);
    out.air_mass = static_cast<float>(air_density * a.volume);
    out.water_mass = static_cast<float>(water_density * a.volume);
    out.air_density = static_cast<float>(air_density);
    out.water_density = static_cast<float>(water_density);
    if (diagonal) std::fill_n(out.center, 3, 0.0f);

    const double ratio = (a.mass + water_density * a.volume) / (a.mass + air_density * a.volume);
    const Matrix6 dry = kernel_mass(a, diagonal, air_density), wet = kernel_mass(a, diagonal, water_density);
    if (air.diagonal) {
        for (size_t i = 0; i < 6; ++i) out.lambda[i] = static_cast<float>(ratio * wet[i * 7] / dry[i * 7] - 1.0);
        return true;
    }
    Matrix6 more;
    for (size_t i = 0; i < 36; ++i) more[i] = ratio * wet[i] - dry[i];
    Modes modes;
    if (!find_modes(dry, more, modes)) return false;
    for (size_t i = 0; i < 6; ++i) out.lambda[i] = static_cast<float>(modes.rate[i]);
    for (size_t i = 0; i < 36; ++i) {
        out.to[i] = static_cast<float>(modes.to[i]);
        out.from[i] = static_cast<float>(modes.from[i]);
    }
    return true;
}

} // namespace lr
