// All properties of a shape that the kernel needs, dimensionless, in single precision (docs/maintainers/physics.md, "Kernel units").
#pragma once

#include "asset/asset_data.h"

#include <cstddef>
#include <cstdint>

namespace lr {

// A station of a body in kernel units, without the fluid's density: AerodynamicConstantsOf::fluid has that.
struct StationConstants {
    float along[3][6]; // velocities along chord, span and normal by the body's velocity and spin
    float axes[9], place[3];
    float spread[6];   // |r|^2 - r r^T, r: the place; upper triangle
    float outer[3][6]; // upper triangles of e e^T, e: the axes
    float drag[3], drag_blunt[3], drag_layer[3], drag_stokes[3];
    float spin_lift[3], spin_drag[3], spin_drag_stream[3], spin_drag_stokes[3], spin_weight[3];
    float lift[2], vortex[2], stall[2]; // along chord and span; stall: the inverse
    float plate_drag, start_drag;
    float lift_arm[2], separated_shedding, shed_length, plate_share;
    float hollow[3], camber;
};

struct StationSet {
    StationConstants station[most_stations];
    uint32_t count = 0;
};

// None if `loads` are not the asset's own: others replace its stations.
void make_stations(const AssetData& asset, const AerodynamicData& loads, StationSet& out);

enum class Loads : int32_t { none, langevin, aerodynamic };
// Turbulence follows the body's present speed, or a table by its age (docs/maintainers/physics.md).
enum class Clock : int32_t { speed, age };
enum class Integrator : int32_t { splitting, rk4 };

// Quasi-steady loads (AerodynamicData) in kernel units, along the load axes, of which the last is the normal of a plate: the asset's axes in cyclic
// order. T: float, or a vector for bodies in two fluids. First the numbers that scale with the fluid's density.
template <class T> struct FluidLoadsOf {
    T drag[3], drag_blunt[3], drag_layer[3], drag_stokes[3];
    T lift[3], lift_layer[3], lift_stokes[3], spin_lift[3];
    T spin_drag[3], spin_drag_stream[3], spin_drag_layer[3], spin_drag_stokes[3];
    T plate_lift[2], plate_vortex[2], plate_drag, start_drag;
    T separated_shed, most_shed;  // of the added mass along the normal
    T streaming, steady_reynolds; // of a light plate's wake; below the second no momentum is shed
    T shedding_moment, shedding_rate_moment;
    // Of stations: the fluid's density over the mass unit, with the gains of drag, lift and spin drag, and alone.
    T fluid[4];
};
// These do not depend on the fluid.
template <class T> struct ShapeLoadsOf {
    T broadside[3];
    T spin_weight[3];                                                    // spin_drag over its largest
    T normal[3], normal_arm[3];                                          // of a plate: body axes; arm x normal
    T plate_stall[2];                                                    // the inverse
    T wake_rate, wake_share;                                             // over d: 1/(wake_lag wake_length)
    T shedding_rate, shedding_growth, shedding_reynolds, shedding_noise; // rate: 2 pi strouhal/wake_length
    // Q: from body axes to load axes. P = Q (1, -[r]x): velocity of the load centre.
    T axes[9], arm[3]; // Q; r: from the centre of mass to the load centre, over d
    // Gusts with the SPEED clock: correlation rate per speed, variance per square of the speed.
    T rate_of_gusts, variance_of_gusts;
    T wake_reynolds;
    T gust_gain; // multiplies the variance with the AGE clock
};
template <class T> struct AerodynamicConstantsOf : FluidLoadsOf<T>, ShapeLoadsOf<T> {
    T viscosity;             // nu, m^2/s
    T centre_mass[6];        // (P M^-1 P^T)^-1, upper triangle
    T spin_of_force[9];      // spin per change of velocity by an impulse at the load centre
    T spin_mobility[6];      // Q (M^-1)_22 Q^T
    T spin_answer[6];        // its columns over their diagonal entry, without it: x's y, z; y's x, z; z's x, y
    T velocity_of_couple[9]; // velocity of the load centre per change of spin by a couple
    // Responses of the load centre's velocity and of the spin, 6x3: to a force at the centre of mass along body axes, and to gravity in a uniform wind.
    T push[18], fall[18];
};

// Mass unit U = m + rho V, length unit d times the body's scale s. Spin is stored as u = d s w, a velocity: every entry below is of order one for
// confetti and banners alike, and scale enters only through 1/(d s).
template <class T> struct BodyConstantsOf {
    T length;      // d, m
    T unit_mass;   // U, kg
    T weight;      // (m - rho V)/U, multiplies gravity
    T buoyancy[3]; // -rho V r_b/(U d): torque = this x R^T g

    // Diagonal path: the diagonals. Full path: upper triangles, row by row.
    T mass[3], spin_mass[3];
    T inverse_mass[3], inverse_spin_mass[3];
    // Diagonal path, along x: u' = gyroscopic[0] u_y u_z + munk[0] v_y v_z. munk_turn: munk over the mass along y, z, x, then along z, x, y.
    T gyroscopic[3], munk[3], munk_turn[6];
    T damping[3], spin_damping[3]; // rho(V + A)/U, rho D/(U d^2)

    T full_mass[21], full_inverse[21];
    T full_damping[6], full_spin_damping[6];

    // Splitting scheme. Decay rates for alpha = 1, along the axes or along modes in which mass is 1 and damping diagonal.
    T rate[6];
    T to_modes[36], from_modes[36]; // full path
    T modes_of_gravity[18];         // full path: weight and buoyancy in a uniform wind, per gravity along body axes
    T modes_of_noise[36];           // full path: turbulent force and torque of six Gaussians
    T inverse_translation[6];       // full path: inverse of the mass matrix's v block
    T slip[9], reduced_rotation[6]; // full path: C = M12^T M11^-1, S = M22 - C M12

    AerodynamicConstantsOf<T> aerodynamics;

    // LANGEVIN with the SPEED clock: alpha = speed_alpha |v_r|/(d s), beta^2 = speed_beta |v_r|^3/(d s).
    T speed_alpha, speed_beta;
    T noise_spin; // d/ell = 2: the angular noise is beta/ell
};
using AerodynamicConstants = AerodynamicConstantsOf<float>;
struct BodyConstants : BodyConstantsOf<float> {
    bool diagonal;
    float wake_length; // m, of a plate
    StationSet stations;
};

// A body that is its own mirror image in the plane of its load centre across the last load axis, as flat sheets and all diagonal bodies are: along the load
// axes, with the load centre as origin, v_x, v_y, u_z and v_z, u_x, u_y do not mix in its mass matrix. The constants are those of this frame, but
// `axes` is as before, and `arm` along the load axes.
struct SheetConstants : BodyConstantsOf<float> {
    bool present = false;
    float turn[4]; // the frame's orientation in the body's
};

// Index of entry (i, j) of a symmetric 6x6 matrix in its upper triangle.
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

// diagonal: drop all entries off the diagonals, and the offset of buoyancy. False if the mass matrix has no inverse.
bool make_body_constants(const AssetData& asset, bool diagonal, double fluid_density, BodyConstants& out);

// How many steps of the motion a substep of h seconds takes with AERODYNAMIC loads: none is longer than a third of the time in which a body at rest falls
// by half the length of its wake, but there are four at most. gravity: m/s^2.
uint32_t motions_in_substep(const BodyConstants& body, float gravity, float h);

// `stationary`: the sample that the SPEED clock scales by the body's speed.
void set_speed_turbulence(const TurbulenceSample& stationary, const Gains& gains, BodyConstants& out);

// Fills out.aerodynamics of make_body_constants with the same arguments. False if the mass matrix has no inverse or the load centre is over 2 d away.
bool make_aerodynamics(const AssetData& asset, const AerodynamicData& loads, const Gains& gains, bool diagonal,
                       double fluid_density, double viscosity, BodyConstants& out);
// Sets gusts from a k-epsilon sample instead: Pope's alpha, and the stationary variance beta^2/(2 alpha).
void set_gust_turbulence(const TurbulenceSample& stationary, const Gains& gains, BodyConstants& out);
// From all constants of a body, made with the same arguments.
void make_sheet(const AssetData& asset, const AerodynamicData& loads, bool diagonal, double fluid_density,
                const BodyConstants& body, SheetConstants& out);

// Pope's coefficients (paper Eq. 9) with the gains folded in.
double langevin_alpha(double chi, double c0, const Gains& gains);
double langevin_beta_squared(double epsilon, double c0, const Gains& gains);
} // namespace lr
