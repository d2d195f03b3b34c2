#include "kernel/compiled_once.h"

#include "kernel/body_constants.h"

#include "asset/asset_file.h"
#include "base/matrix6.h"
#include "kernel/derived_constants-inl.h"
#include "kernel/water/water_loads.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace lr {
namespace {

namespace derived = HWY_NAMESPACE;

// Added inertia vanishes about an axis of revolution, and with it the turbulent damping of that spin. Real fluid damps it through the boundary layer:
// a floor of 0.02 is about the turbulent skin friction on a spinning disc (docs/maintainers/physics.md, "Viscous floor").
constexpr double viscous_floor = 0.02;

// Gusts scale with a speed that includes them: E s^2 = v^2 + 3 I^2 E s^2 for a body not carried along. From I^2 = 1/3 on they would feed themselves.
constexpr double most_variance = 0.16;

// Computed in double, stored in single precision: both types contain numbers alone.
template <template <class> class Constants> void narrow(const Constants<double>& from, Constants<float>& to) {
    constexpr size_t count = sizeof from / sizeof(double);
    static_assert(sizeof to == count * sizeof(float));
    double wide[count];
    float narrow[count];
    std::memcpy(wide, &from, sizeof wide);
    for (size_t i = 0; i < count; ++i) narrow[i] = static_cast<float>(wide[i]);
    std::memcpy(&to, narrow, sizeof narrow);
}
template <size_t N> void narrow(const std::array<double, N>& from, float (&to)[N]) {
    for (size_t i = 0; i < N; ++i) to[i] = static_cast<float>(from[i]);
}

// The diagonal block that begins at row and column `at`.
void upper_triangle(const Matrix6& m, size_t at, size_t size, double* out) {
    for (size_t i = at; i < at + size; ++i)
        for (size_t j = i; j < at + size; ++j) *out++ = m[i * 6 + j];
}
void drop_couplings(Matrix6& m) {
    for (size_t i = 0; i < 36; ++i)
        if (i % 7 != 0) m[i] = 0.0;
}

// Mass matrix of body and fluid in kernel units. The diagonal path drops all entries off the diagonal.
Matrix6 kernel_mass(const AssetData& a, bool diagonal, double rho) {
    Matrix6 mass = rigid_mass_matrix(a.mass, a.inertia);
    for (size_t i = 0; i < 36; ++i) mass[i] += rho * a.added_mass[i];
    scale_to_unit(mass, a.mass + rho * a.volume, a.length_d);
    if (diagonal) drop_couplings(mass);
    return mass;
}

void set_weight(const AssetData& a, double rho, BodyConstantsOf<double>& c) {
    c.length = a.length_d;
    c.unit_mass = a.mass + rho * a.volume;
    c.weight = (a.mass - rho * a.volume) / c.unit_mass;
    for (size_t i = 0; i < 3; ++i)
        c.buoyancy[i] = -rho * a.volume * a.center_of_buoyancy[i] / (c.unit_mass * a.length_d);
}

// Weight and buoyancy torque for unit gravity along a body axis, projected on a twist.
double seen_along(const double (&twist)[6], const BodyConstantsOf<double>& c, size_t axis) {
    // (b x g)_l has b_k g_j with a minus sign, (b x g)_k has b_l g_j.
    const size_t k = (axis + 1) % 3, l = (axis + 2) % 3;
    return c.weight * twist[axis] + (c.buoyancy[l] * twist[k + 3] - c.buoyancy[k] * twist[l + 3]);
}

// rho (V I + A) and rho (D + floor): symmetric 3x3 weights of the turbulent loads, without the coupling block.
Matrix6 turbulent_load(const AssetData& a, bool diagonal, double rho) {
    Matrix6 load{};
    const double broadside = std::max({a.added_mass[0], a.added_mass[7], a.added_mass[14]});
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) {
            load[i * 6 + j] = a.added_mass[i * 6 + j] + (i == j ? a.volume : 0.0);
            load[(i + 3) * 6 + j + 3] = a.added_mass[(i + 3) * 6 + j + 3] +
                                        viscous_floor * (a.volume + broadside) * a.inertia[i * 3 + j] / a.mass;
        }
    for (double& v : load) v *= rho;
    scale_to_unit(load, a.mass + rho * a.volume, a.length_d);
    if (diagonal) drop_couplings(load);
    return load;
}

// chi = chi* s/l and epsilon = epsilon* s^3/l at the speed s. The kernel applies the length unit d.
double chi_star(const TurbulenceSample& s) {
    return s.chi * s.l / s.u0;
}
double epsilon_star(const TurbulenceSample& s) {
    return s.epsilon * s.l / (s.u0 * s.u0 * s.u0);
}
} // namespace

bool make_body_constants(const AssetData& a, bool diagonal, double rho, BodyConstants& out) {
    out = BodyConstants{};
    out.diagonal = diagonal;
    BodyConstantsOf<double> c{};
    set_weight(a, rho, c);
    c.noise_spin = 2.0;
    const Matrix6 mass = kernel_mass(a, diagonal, rho), load = turbulent_load(a, diagonal, rho);
    Matrix6 inverse;
    Modes modes;
    if (!invert_spd(mass, inverse) || !find_modes(mass, load, modes)) return false;
    upper_triangle(mass, 0, 6, c.full_mass);
    upper_triangle(inverse, 0, 6, c.full_inverse);
    upper_triangle(load, 0, 3, c.full_damping);
    upper_triangle(load, 3, 3, c.full_spin_damping);
    for (size_t i = 0; i < 3; ++i) {
        c.mass[i] = mass[i * 7];
        c.spin_mass[i] = mass[(i + 3) * 7];
        c.inverse_mass[i] = inverse[i * 7];
        c.inverse_spin_mass[i] = inverse[(i + 3) * 7];
        c.damping[i] = load[i * 7];
        c.spin_damping[i] = load[(i + 3) * 7];
    }
    for (size_t i = 0; i < 6; ++i) c.rate[i] = diagonal ? load[i * 7] / mass[i * 7] : modes.rate[i];
    std::copy(modes.to.begin(), modes.to.end(), c.to_modes);
    std::copy(modes.from.begin(), modes.from.end(), c.from_modes);
    // from^T takes forces to the modes: weight and b x gravity, and the load matrix of the six Gaussians.
    for (size_t m = 0; m < 6; ++m) {
        double mode[6];
        for (size_t i = 0; i < 6; ++i) mode[i] = modes.from[i * 6 + m];
        for (size_t j = 0; j < 3; ++j) c.modes_of_gravity[m * 3 + j] = seen_along(mode, c, j);
    }
    derived::set_turning(c);
    derived::set_slip(1.0, c);
    derived::set_noise_of_modes(c);
    narrow(c, out);
    return true;
}

double langevin_alpha(double chi, double c0, const Gains& gains) {
    return (0.5 + 0.75 * c0) * chi * gains.damping;
}

double langevin_beta_squared(double epsilon, double c0, const Gains& gains) {
    return c0 * epsilon * gains.noise * gains.noise;
}

uint32_t motions_in_substep(const BodyConstants& body, float gravity, float h) {
    constexpr double longest = 0.31, most = 4.0; // docs/maintainers/numerics.md, "Steps of the motion"
    if (!(body.wake_length > 0.0f) || body.aerodynamics.plate_drag <= 0.0f) return 1;
    const double pull = std::abs(static_cast<double>(body.weight)) * static_cast<double>(gravity);
    const double steps = static_cast<double>(h) / longest * std::sqrt(pull / static_cast<double>(body.wake_length));
    return steps < most ? static_cast<uint32_t>(steps) + 1 : static_cast<uint32_t>(most);
}

void set_speed_turbulence(const TurbulenceSample& s, const Gains& gains, BodyConstants& out) {
    const double d_over_l = static_cast<double>(out.length) / s.l;
    out.speed_alpha = static_cast<float>(langevin_alpha(chi_star(s), s.c0, gains) * d_over_l);
    out.speed_beta = static_cast<float>(langevin_beta_squared(epsilon_star(s), s.c0, gains) * d_over_l);
}

namespace {
// In cyclic order, so that the widest face is across the last axis.
AerodynamicData widest_last(const AerodynamicData& from) {
    AerodynamicData to = from;
    const size_t first = widest_axis(from) + 1;
#define LR_TURN(name, ...)                                                                                             \
    for (size_t i = 0; i < 3; ++i) to.name[i] = from.name[(first + i) % 3];
    LR_AERODYNAMIC_VECTORS(LR_TURN)
#undef LR_TURN
    to.center = from.center; // along the body's axes
    for (size_t i = 0; i < 9; ++i) to.axes[i] = from.axes[(first + i / 3) % 3 * 3 + i % 3];
    return to;
}

// The fluid's share of the moment of inertia, about that axis in the plate where it is larger. mass: with the fluid, of `unit` kg m^2/rho.
double fluid_inertia(const AssetData& a, const AerodynamicData& loads, const Matrix6& mass, double unit) {
    double most = 0.0;
    for (size_t axis = 0; axis < 2; ++axis) {
        const double* const q = loads.axes.data() + 3 * axis;
        double all = 0.0, fluid = 0.0;
        for (size_t i = 0; i < 3; ++i)
            for (size_t j = 0; j < 3; ++j) {
                all += q[i] * mass[(i + 3) * 6 + j + 3] * q[j];
                fluid += q[i] * a.added_mass[(i + 3) * 6 + j + 3] * q[j];
            }
        most = std::max(most, fluid / (all * unit));
    }
    return most;
}

template <class T> void put(const std::array<double, 3>& from, double factor, T (&to)[3]) {
    for (size_t i = 0; i < 3; ++i) to[i] = static_cast<T>(from[i] * factor);
}

// Coefficients that bodies and stations have alike. drag, lift, spin_drag: rho over the mass unit with the gains; 1 for a station.
template <class Loads, class Constants>
void set_coefficients(const Loads& loads, double d, double drag, double lift, double spin_drag, Constants& out) {
    put(loads.drag, 0.5 * drag * d, out.drag);
    put(loads.drag_blunt, 0.5 * drag * d, out.drag_blunt);
    put(loads.drag_layer, drag * d * std::sqrt(d), out.drag_layer);
    put(loads.drag_stokes, drag * d * d, out.drag_stokes);
    put(loads.spin_lift, lift, out.spin_lift);
    put(loads.spin_drag, spin_drag / (d * d), out.spin_drag);
    put(loads.spin_drag_stream, spin_drag / d, out.spin_drag_stream);
    put(loads.spin_drag_stokes, spin_drag, out.spin_drag_stokes);
}

// Of the drag broadside.
template <class Loads> double plate_share(const Loads& loads) {
    const double whole = loads.plate_drag + loads.drag[2] + loads.drag_blunt[2];
    return whole > 0.0 ? loads.plate_drag / whole : 0.0;
}

// drag, lift: rho over the mass unit, with the gains.
void set_plate(const AssetData& a, const AerodynamicData& loads, const Matrix6& mass, double drag, double lift,
               double rho, BodyConstantsOf<double>& c) {
    AerodynamicConstantsOf<double>& out = c.aerodynamics;
    const double d = a.length_d;
    for (size_t i = 0; i < 3; ++i) out.normal[i] = loads.axes[6 + i];
    derived::cross3(out.arm, out.normal, out.normal_arm);
    double added = 0.0; // along the normal
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) added += out.normal[i] * a.added_mass[i * 6 + j] * out.normal[j];
    added *= rho / c.unit_mass;
    for (size_t i = 0; i < 2; ++i) {
        out.plate_lift[i] = 0.5 * lift * d * loads.plate_lift[i];
        out.plate_vortex[i] = 0.5 * lift * d * loads.plate_vortex[i];
        out.plate_stall[i] = 1.0 / std::max(loads.plate_stall[i], 1e-3);
    }
    out.most_shed = added;
    out.separated_shed = added * loads.plate_separated_shedding;
    out.plate_drag = 0.5 * drag * d * loads.plate_drag;
    // The wake of a light plate is that of its swing, not of a stream: docs/maintainers/physics.md, "Light plates".
    constexpr double half_light = 2.0 / 3.0, swing = 30.0;
    const double light = fluid_inertia(a, loads, mass, c.unit_mass * d * d / rho);
    const double square = light * light / (half_light * half_light);
    out.streaming = 1.0 / (1.0 + square * square);
    for (size_t i = 0; i < 2; ++i) out.spin_lift[i] *= 1.0 - plate_share(loads) * (1.0 - out.streaming);
    out.start_drag = out.streaming * loads.start_drag * out.plate_drag;
    out.wake_rate = d / (loads.wake_lag * loads.wake_length);
    out.wake_share = loads.wake_share;
    out.shedding_rate = 2.0 * std::numbers::pi * loads.strouhal * d / loads.wake_length;
    out.shedding_growth = loads.shedding_growth;
    out.shedding_reynolds = loads.shedding_reynolds * d / loads.wake_length;
    out.steady_reynolds = out.shedding_reynolds * std::sqrt(swing * light / (1.0 + swing * light));
    out.shedding_noise = loads.shedding_noise;
    out.shedding_moment = lift * loads.shedding_moment;
    out.shedding_rate_moment = lift * loads.shedding_rate_moment;
}
} // namespace

bool make_aerodynamics(const AssetData& a, const AerodynamicData& data, const Gains& gains, bool diagonal, double rho,
                       double viscosity, BodyConstants& body) {
    const AerodynamicData loads = widest_last(data);
    const double d = a.length_d;
    for (double v : loads.center)
        if (!(std::abs(v) <= 2.0 * d)) return false; // the limit of check_asset
    BodyConstantsOf<double> c{};
    set_weight(a, rho, c);
    AerodynamicConstantsOf<double>& out = c.aerodynamics;
    out.viscosity = viscosity;
    const double per_unit = rho / c.unit_mass, drag = gains.drag * per_unit, lift = gains.lift * per_unit;
    const double layer = drag * d * std::sqrt(d), stokes = drag * d * d, spin_drag = gains.spin_drag * per_unit;
    set_coefficients(loads, d, drag, lift, spin_drag, out);
    put(loads.lift, lift * d, out.lift);
    put(loads.broadside, 1.0, out.broadside);
    put(loads.spin_drag_layer, spin_drag / std::sqrt(d), out.spin_drag_layer);
    const double strongest = std::max({loads.spin_drag[0], loads.spin_drag[1], loads.spin_drag[2]});
    for (size_t k = 0; k < 3; ++k) {
        const size_t i = (k + 1) % 3, j = (k + 2) % 3;
        out.lift_layer[k] = layer * (loads.drag_layer[j] - loads.drag_layer[i]);
        out.lift_stokes[k] = stokes * (loads.drag_stokes[j] - loads.drag_stokes[i]);
        out.spin_weight[k] = strongest > 0.0 ? loads.spin_drag[k] / strongest : 0.0;
        out.arm[k] = (a.center_of_buoyancy[k] + loads.center[k]) / d;
    }
    std::copy(loads.axes.begin(), loads.axes.end(), out.axes);
    const Matrix6 mass = kernel_mass(a, diagonal, rho);
    set_plate(a, loads, mass, drag, lift, rho, c);
    out.fluid[0] = drag;
    out.fluid[1] = lift;
    out.fluid[2] = spin_drag;
    out.fluid[3] = per_unit;
    make_stations(a, data, body.stations);
    body.wake_length = static_cast<float>(loads.wake_length);
    out.rate_of_gusts = d / loads.length;
    const double intensity = loads.intensity * gains.turbulence * gains.noise;
    out.variance_of_gusts = std::min(intensity * intensity, most_variance);
    out.wake_reynolds = loads.wake_reynolds;
    out.gust_gain = gains.turbulence * gains.turbulence;

    Matrix6 inverse;
    if (!invert_spd(mass, inverse)) return false;
    upper_triangle(inverse, 0, 6, c.full_inverse);
    derived::set_frame(0.0, 1.0, c);
    // M^-1 P^T for each direction of P: the response to a force or couple.
    for (size_t i = 0; i < 6; ++i) {
        const double* const q = out.axes + i % 3 * 3;
        double along[6] = {}, response[6];
        std::copy_n(q, 3, i < 3 ? along : along + 3);
        if (i < 3) derived::cross3(out.arm, q, along + 3);
        derived::times_symmetric6(c.full_inverse, along, response);
        for (size_t j = 0; j < 3; ++j) out.fall[i * 3 + j] = seen_along(response, c, j);
    }
    narrow(out, body.aerodynamics);
    return true;
}

namespace {
// Rotation matrix, rows first, to quaternion (Shepperd 1978).
void quaternion_of(const double* m, float (&out)[4]) {
    const double trace = m[0] + m[4] + m[8];
    size_t largest = 3;
    for (size_t i = 0; i < 3; ++i)
        if (m[4 * i] > (largest == 3 ? trace : m[4 * largest])) largest = i;
    double q[4];
    if (largest == 3) {
        q[0] = m[7] - m[5], q[1] = m[2] - m[6], q[2] = m[3] - m[1], q[3] = 1.0 + trace;
    } else {
        const size_t i = largest, j = (i + 1) % 3, k = (i + 2) % 3;
        q[i] = 1.0 + m[4 * i] - m[4 * j] - m[4 * k];
        q[j] = m[3 * i + j] + m[3 * j + i];
        q[k] = m[3 * i + k] + m[3 * k + i];
        q[3] = m[3 * k + j] - m[3 * j + k];
    }
    const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (size_t i = 0; i < 4; ++i) out[i] = static_cast<float>(q[i] / norm);
}
constexpr bool apart[6] = {false, false, true, true, true, false}; // v_z, u_x, u_y
} // namespace

void make_sheet(const AssetData& asset, const AerodynamicData& loads, bool diagonal, double rho,
                const BodyConstants& body, SheetConstants& out) {
    out.present = false;
    if (body.stations.count != 0 || mirror_coupling(asset, loads) > no_coupling) return;
    const AerodynamicConstants& a = body.aerodynamics;
    double q[9], arm[3], to[36] = {}, pushed[18], falls[18];
    std::copy(a.axes, a.axes + 9, q);
    // Twists of the load centre along the load axes.
    for (size_t i = 0; i < 3; ++i) {
        arm[i] = 0.0;
        double r[3];
        std::copy(a.arm, a.arm + 3, r);
        for (size_t k = 0; k < 3; ++k) {
            arm[i] += q[3 * i + k] * r[k];
            to[i * 6 + k] = to[(i + 3) * 6 + k + 3] = q[3 * i + k];
        }
        derived::cross3(r, q + 3 * i, to + i * 6 + 3);
        for (size_t part = 0; part < 18; part += 9)
            for (size_t j = 0; j < 3; ++j) {
                double &push = pushed[part + 3 * i + j] = 0.0, &fall = falls[part + 3 * i + j] = 0.0;
                for (size_t k = 0; k < 3; ++k) {
                    push += static_cast<double>(a.push[part + 3 * i + k]) * q[3 * j + k];
                    fall += static_cast<double>(a.fall[part + 3 * i + k]) * q[3 * j + k];
                }
            }
    }
    Matrix6 centre, mobility{}, mass;
    if (!invert_spd(kernel_mass(asset, diagonal, rho), centre)) return;
    for (size_t i = 0; i < 6; ++i)
        for (size_t j = 0; j < 6; ++j)
            for (size_t k = 0; k < 36; ++k) mobility[i * 6 + j] += to[i * 6 + k / 6] * centre[k] * to[j * 6 + k % 6];
    for (size_t i = 0; i < 36; ++i)
        if (apart[i / 6] != apart[i % 6]) mobility[i] = 0.0;
    if (!invert_spd(mobility, mass)) return;

    BodyConstantsOf<double> c{};
    upper_triangle(mass, 0, 6, c.full_mass);
    upper_triangle(mobility, 0, 6, c.full_inverse);
    derived::set_slip(1.0, c);
    SheetConstants made;
    narrow(c, made);
    made.length = body.length;
    made.unit_mass = body.unit_mass;
    made.weight = body.weight;
    made.aerodynamics = a;
    for (size_t i = 0; i < 18; ++i) {
        made.aerodynamics.push[i] = static_cast<float>(pushed[i]);
        made.aerodynamics.fall[i] = static_cast<float>(falls[i]);
    }
    for (size_t i = 0; i < 3; ++i) {
        made.aerodynamics.arm[i] = static_cast<float>(arm[i]);
        made.aerodynamics.normal[i] = i == 2 ? 1.0f : 0.0f;
        made.aerodynamics.normal_arm[i] = 0.0f;
    }
    const double back[9] = {q[0], q[3], q[6], q[1], q[4], q[7], q[2], q[5], q[8]};
    quaternion_of(back, made.turn);
    made.present = true;
    out = made;
}

void set_gust_turbulence(const TurbulenceSample& s, const Gains& gains, BodyConstants& out) {
    const double alpha = langevin_alpha(chi_star(s), s.c0, {}),
                 beta_squared = langevin_beta_squared(epsilon_star(s), s.c0, {});
    out.aerodynamics.rate_of_gusts = static_cast<float>(alpha * static_cast<double>(out.length) / s.l);
    out.aerodynamics.wake_reynolds = 0.0f;
    const double gain = gains.noise * gains.turbulence;
    out.aerodynamics.variance_of_gusts =
        static_cast<float>(alpha > 0.0 ? std::min(gain * gain * beta_squared / (2.0 * alpha), most_variance) : 0.0);
}

namespace {

// The solid ellipsoid with the body's moments of inertia: a^2 = 5/(2 m) (J_j + J_k - J_i).
void equivalent_ellipsoid(const AssetData& a, WaterBody& out) {
    double inertia[3][3], axes[3][3];
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) inertia[i][j] = a.inertia[i * 3 + j] / (a.mass * a.length_d * a.length_d);
    eigen3(inertia, axes);
    const double moment[3] = {inertia[0][0], inertia[1][1], inertia[2][2]};
    // A sheet's thickness cancels in the difference of its moments.
    const double least = 0.5 * a.length_b;
    double longest = 0.0, offset = 0.0;
    for (size_t i = 0; i < 3; ++i) {
        const double squared = 2.5 * (moment[(i + 1) % 3] + moment[(i + 2) % 3] - moment[i]) * a.length_d * a.length_d;
        out.semi_axes_squared[i] = static_cast<float>(std::max(squared, least * least));
        longest = std::max(longest, static_cast<double>(out.semi_axes_squared[i]));
        offset += a.center_of_buoyancy[i] * a.center_of_buoyancy[i];
        for (size_t k = 0; k < 3; ++k) out.axes[i * 3 + k] = static_cast<float>(axes[k][i]);
    }
    out.thin = std::sqrt(*std::min_element(out.semi_axes_squared, out.semi_axes_squared + 3));
    out.radius = static_cast<float>(std::sqrt(longest) + std::sqrt(offset));
}
} // namespace

bool make_water_body(const AssetData& a, const AerodynamicData& loads, const Gains& gains,
                     const TurbulenceSample& stationary, bool diagonal, double air_density, double water_density,
                     double water_viscosity, Loads model, const BodyConstants& air, WaterBody& out) {
    out = WaterBody{};
    if (!make_body_constants(a, diagonal, water_density, out.water) ||
        !make_aerodynamics(a, loads, gains, diagonal, water_density, water_viscosity, out.water))
        return false;
    equivalent_ellipsoid(a, out);
    if (stationary.u0 > 0.0) set_gust_turbulence(stationary, gains, out.water);
    out.water.speed_alpha = air.speed_alpha;
    out.water.speed_beta = air.speed_beta;
    out.mass = static_cast<float>(a.mass);
    out.air_mass = static_cast<float>(air_density * a.volume);
    out.water_mass = static_cast<float>(water_density * a.volume);
    out.air_density = static_cast<float>(air_density);
    out.water_density = static_cast<float>(water_density);
    if (!diagonal) narrow(a.center_of_buoyancy, out.center);
    double high = 1.0, draught = -1.0;
    for (int i = 0; i < 30; ++i) {
        const double s = 0.5 * (draught + high), share = 0.25 * (2.0 + s * (3.0 - s * s));
        (a.volume * (air_density + share * (water_density - air_density)) < a.mass ? draught : high) = s;
    }
    out.draught = static_cast<float>(draught);

    const double ratio = (a.mass + water_density * a.volume) / (a.mass + air_density * a.volume);
    const Matrix6 dry = kernel_mass(a, diagonal, air_density), wet = kernel_mass(a, diagonal, water_density);
    double squares = 0.0; // of the translations' mass: the largest counts most
    for (size_t i = 0; i < 9; ++i) squares += wet[i / 3 * 6 + i % 3] * wet[i / 3 * 6 + i % 3];
    out.fall = static_cast<float>(std::max(std::abs(static_cast<double>(out.water.weight)) / std::sqrt(squares), 1e-4));
    out.diagonal = air.diagonal && model != Loads::aerodynamic;
    if (out.diagonal) {
        for (size_t i = 0; i < 6; ++i) out.lambda[i] = static_cast<float>(ratio * wet[i * 7] / dry[i * 7] - 1.0);
        return true;
    }
    Matrix6 more;
    for (size_t i = 0; i < 36; ++i) more[i] = ratio * wet[i] - dry[i];
    Modes modes;
    if (!find_modes(dry, more, modes)) return false;
    narrow(modes.rate, out.lambda);
    narrow(modes.to, out.to);
    narrow(modes.from, out.from);
    return true;
}

namespace {

// Upper triangle of s + sign a a^T.
void put_outer(double s, double sign, const double* a, float* to) {
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = i; j < 3; ++j) *to++ = static_cast<float>((i == j ? s : 0.0) + sign * a[i] * a[j]);
}

void make_station(const StationData& from, double d, double start_drag, StationConstants& to) {
    double r[3], along[6];
    for (size_t i = 0; i < 3; ++i) {
        r[i] = from.place[i] / d;
        to.place[i] = static_cast<float>(r[i]);
    }
    for (size_t k = 0; k < 3; ++k) {
        const double* const axis = from.axes.data() + 3 * k;
        std::copy_n(axis, 3, along);
        derived::cross3(r, axis, along + 3);
        for (size_t i = 0; i < 6; ++i) to.along[k][i] = static_cast<float>(along[i]);
        put_outer(0.0, 1.0, axis, to.outer[k]);
    }
    narrow(from.axes, to.axes);
    put_outer(r[0] * r[0] + r[1] * r[1] + r[2] * r[2], -1.0, r, to.spread);
    set_coefficients(from, d, 1.0, 1.0, 1.0, to);
    const double strongest = std::max({from.spin_drag[0], from.spin_drag[1], from.spin_drag[2]});
    put(from.spin_drag, strongest > 0.0 ? 1.0 / strongest : 0.0, to.spin_weight);
    for (size_t k = 0; k < 2; ++k) {
        to.lift[k] = static_cast<float>(0.5 * d * from.plate_lift[k]);
        to.vortex[k] = static_cast<float>(0.5 * d * from.plate_vortex[k]);
        to.lift_arm[k] = static_cast<float>(from.lift_arm[k] / d);
        to.stall[k] = static_cast<float>(1.0 / std::max(from.plate_stall[k], 1e-3));
    }
    to.plate_share = static_cast<float>(plate_share(from));
    to.plate_drag = static_cast<float>(0.5 * d * from.plate_drag);
    to.start_drag = static_cast<float>(0.5 * d * from.plate_drag * start_drag);
    to.separated_shedding = static_cast<float>(from.separated_shedding);
    // m/plate_drag, as separated_shedding is 0.8 m; bounded, since its square with the spin would overflow.
    const double shed_length = from.plate_drag > 0.0 ? 1.25 * from.separated_shedding / from.plate_drag : 0.0;
    to.shed_length = static_cast<float>(std::min(shed_length / d, 1e3));
    narrow(from.hollow, to.hollow);
    to.camber = static_cast<float>(from.camber);
}
} // namespace

void make_stations(const AssetData& asset, const AerodynamicData& loads, StationSet& out) {
    const bool own = loads == asset.aerodynamics;
    out.count = own ? static_cast<uint32_t>(std::min(asset.stations.size(), most_stations)) : 0;
    for (size_t i = 0; i < out.count; ++i)
        make_station(asset.stations[i], asset.length_d, asset.aerodynamics.start_drag, out.station[i]);
}
} // namespace lr
