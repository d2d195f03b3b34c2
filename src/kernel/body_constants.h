// Everything of a shape that the kernel needs, dimensionless and in single precision; docs/maintainers/physics.md, "Kernel units".
#pragma once

#include "asset/asset_data.h"

#include <cstddef>
#include <cstdint>

namespace lr {

enum class Loads : int32_t { none, langevin, aerodynamic };
// Turbulence follows the body's present speed, or the table at its age (docs/maintainers/physics.md).
enum class Clock : int32_t { speed, age };
enum class Integrator : int32_t { splitting, rk4 };

// Quasi-steady loads (AerodynamicData) in kernel units. A diagonal body's axes are those of the loads. T: float for a
// batch, a vector for bodies that differ (kernel/water/water_loads.cpp).
template <class T> struct AerodynamicConstantsOf {
    T viscosity; // nu, m^2/s
    T drag[3], drag_blunt[3], drag_layer[3], drag_stokes[3];
    T lift[3], lift_layer[3], lift_stokes[3], spin_lift[3], lift_moment[3];
    T broadside[3], lift_stall, lift_moment_stalled[3];
    T spin_drag[3], spin_drag_stream[3], spin_drag_stokes[3];
    T spin_weight[3]; // spin_drag over its largest
    T roll[3];        // square root of roll_damping
    // Full path. Q: body axes to those of the loads; P = Q (1, -[r]x): velocity of the centre of the loads.
    T axes[9], arm[3]; // Q; r: from the centre of mass to that of the loads, over d
    T mobility[6];     // P M^-1 P^T, upper triangle
    T mobility_adjugate[6];
    T modes[9];                  // columns: its eigenvectors
    T rate[3];                   // and eigenvalues
    T spin_response_to_force[9]; // Q (M^-1)_u P^T: spin for an impulse at the centre
    T spin_of_force[9];          // the same for a change of velocity by such an impulse
    T spin_mobility[6];          // Q (M^-1)_22 Q^T
    T spin_answer[6];        // its column over its diagonal entry, without that: for x in y, z; y in x, z; z in x, y
    T fall[18];              // what gravity along the body's axes gives in a uniform wind, P over Q (M^-1)_u, 6x3
    T velocity_of_couple[9]; // velocity of the centre for a change of spin by a couple
    T spin_response[18];     // twist for a change of spin by a couple, body axes, 6x3
    // The fluid's own velocity with the SPEED clock: correlation rate and variance, per speed and per square of it.
    T rate_of_gusts, variance_of_gusts;
    T wake_reynolds;
    T gust_gain; // multiplies the variance with the AGE clock
};

// Mass unit U = m + rho V, length unit d times the body's scale s. Spin is carried as u = d s w, a velocity, so that
// every entry below is of order one for confetti and banners alike, and scale enters only through 1/(d s).
template <class T> struct BodyConstantsOf {
    T length;      // d, m
    T unit_mass;   // U, kg
    T weight;      // (m - rho V)/U, multiplies gravity
    T buoyancy[3]; // -rho V r_b/(U d): torque = this x R^T g

    // Diagonal path: the diagonals. Full path: upper triangles, row by row.
    T mass[3], spin_mass[3];
    T inverse_mass[3], inverse_spin_mass[3];
    // Diagonal path: spin's rate of change along x is gyroscopic[0] u_y u_z + munk[0] v_y v_z, and so on; munk over the masses
    // of what turns P: along x over that of y, then over that of z.
    T gyroscopic[3], munk[3], munk_turn[6];
    T damping[3], spin_damping[3]; // rho(V + A)/U, rho D/(U d^2)

    T full_mass[21], full_inverse[21];
    T full_damping[6], full_spin_damping[6];

    // Splitting scheme. Rates of decay for alpha = 1: along the axes, or along modes that make mass 1 and damping
    // diagonal.
    T rate[6];
    T to_modes[36], from_modes[36]; // full path
    T modes_of_gravity[18];   // full path: of weight and buoyancy in a uniform wind, for gravity along the body's axes
    T modes_of_noise[36];     // full path: of the turbulent force and torque, for its six Gaussians
    T inverse_translation[6]; // full path: inverse of the mass matrix' block of v
    T slip[9], reduced_rotation[6]; // full path: C = M12^T M11^-1, S = M22 - C M12

    AerodynamicConstantsOf<T> aerodynamics;

    // LANGEVIN with the SPEED clock: alpha = speed_alpha |v_r|/(d s), beta^2 = speed_beta |v_r|^3/(d s).
    T speed_alpha, speed_beta;
    T noise_spin; // d/ell = 2: the angular noise is beta/ell
};
using AerodynamicConstants = AerodynamicConstantsOf<float>;
struct BodyConstants : BodyConstantsOf<float> {
    bool diagonal;
};

// Where a symmetric 6x6 matrix' entries are in its upper triangle.
inline constexpr size_t upper6[6][6] = {{0, 1, 2, 3, 4, 5},     {1, 6, 7, 8, 9, 10},    {2, 7, 11, 12, 13, 14},
                                        {3, 8, 12, 15, 16, 17}, {4, 9, 13, 16, 18, 19}, {5, 10, 14, 17, 19, 20}};

// LANGEVIN with the AGE clock: alpha (1/s) and beta^2 (m^2/s^3) at equally spaced ages.
struct TableConstants {
    const float* alpha;
    const float* beta_squared;
    float inverse_dt; // 1/s
    float last;       // count - 1
    bool loop;
};

struct TurbulenceSample {
    double chi, epsilon; // 1/s, m^2/s^3
    double u0, l, c0;
};

struct Gains {
    double damping = 1.0, noise = 1.0;                                // LANGEVIN
    double drag = 1.0, lift = 1.0, spin_drag = 1.0, turbulence = 1.0; // AERODYNAMIC
};

// diagonal: drop what lies off the diagonals, and the offset of buoyancy. False when the mass matrix cannot be
// inverted.
bool make_body_constants(const AssetData& asset, bool diagonal, double fluid_density, BodyConstants& out);

// `stationary`: the sample that the SPEED clock scales by the body's speed.
void set_speed_turbulence(const TurbulenceSample& stationary, const Gains& gains, BodyConstants& out);

// Fills out.aerodynamics; `out` comes from make_body_constants with the same arguments. False when the mass matrix
// cannot be inverted, or the loads act more than 2 d away.
bool make_aerodynamics(const AssetData& asset, const AerodynamicData& loads, const Gains& gains, bool diagonal,
                       double fluid_density, double viscosity, BodyConstants& out);
// The fluid's own velocity from a k-epsilon sample instead: Pope's alpha, and the stationary variance beta^2/(2 alpha).
void set_gust_turbulence(const TurbulenceSample& stationary, const Gains& gains, BodyConstants& out);

// Pope's coefficients (paper Eq. 9) with the gains folded in.
double langevin_alpha(double chi, double c0, const Gains& gains);
double langevin_beta_squared(double epsilon, double c0, const Gains& gains);

} // namespace lr
