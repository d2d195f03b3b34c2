// One batch's state as structure of arrays: what the kernel reads and writes.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lr {

// Arrays are padded to a multiple of this, so that every target's vectors cover whole lanes and no tail code exists.
inline constexpr size_t lane_block = 16;

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
    field_age, // s
    field_count
};

struct FluidSample;

struct BatchArrays {
    float* field[field_count];
    uint32_t* key;
    // Null: the uniform wind of the step. Else one substep is taken, and this is the fluid at the bodies that it steps.
    const FluidSample* fluid;
};

} // namespace lr
