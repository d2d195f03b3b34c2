// A batch's state as a structure of arrays, which the kernel reads and writes.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lr {

// Arrays are padded to a multiple of this, so that the vectors of every target cover them without tail code.
inline constexpr size_t lane_block = 32;

enum Field : size_t {
    field_x,
    field_y,
    field_z, // m, world
    field_qx,
    field_qy,
    field_qz,
    field_qw, // body to world
    field_vx,
    field_vy,
    field_vz, // m/s, body frame, of the centre of mass
    field_wx,
    field_wy,
    field_wz, // rad/s, body frame
    field_scale,
    field_age,           // s
    field_age_remainder, // s, rounding error of the age so far
    field_gust_x,
    field_gust_y,
    field_gust_z, // m/s, world: the body's own gust, AERODYNAMIC loads only
    // The wake, AERODYNAMIC loads only, along the load axes.
    field_lag_x,
    field_lag_y,
    field_lag_z, // m/s, the stream in the wake's memory
    field_shedding_0,
    field_shedding_1, // the wake's oscillator, along the two axes after the plate's normal
    field_shedding_rate_0,
    field_shedding_rate_1, // its rate over the shedding frequency
    field_count
};
// Gust and wake, of AERODYNAMIC loads only.
inline constexpr size_t wake_fields = field_count - field_gust_x;

// External forces in SI units, on the body at its true size: a vector of each kind in each frame. Accelerations ignore all masses.
enum ForceKind : size_t { force_newton, force_torque, force_acceleration, force_spin, force_kinds };
inline constexpr size_t force_components = size_t{6} * force_kinds;
// The x component. frame: 0 for the world's, 1 for the body's.
constexpr size_t force_component(size_t frame, size_t kind) {
    return 3 * (force_kinds * frame + kind);
}

struct WindAlong;

struct BatchArrays {
    float* field[field_count];
    uint32_t* noise_seed;
    uint32_t* floor;       // MeshFloor::up of each body, packed; null: not recorded
    const WindAlong* wind; // null: the uniform wind of the step
};
} // namespace lr
