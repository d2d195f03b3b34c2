// Wind as the kernel sees it: sources at an instant (src/environment), their sum at a block of bodies. Formulas: docs/reference/wind_and_water.md.
#pragma once

#include "base/lane_arrays.h"

#include <cstddef>
#include <cstdint>

namespace lr {

// Bodies that are examined together: for the caller's own field, water and contact.
inline constexpr size_t field_block = 256;
static_assert(field_block % lane_block == 0);

// Sums over sources at the positions of lane_block bodies. Many bodies have an array of these.
struct FieldBlock {
    alignas(64) float position[3][lane_block]; // m, world
    float velocity[3][lane_block];             // m/s, of the bodies
    float wind[3][lane_block];                 // m/s
    float change[3][lane_block];               // m/s, of the uniform part over the substep
    float rate[3][lane_block];                 // m/s^2, partial derivative in time, without the uniform part
    float gradient[9][lane_block];             // 1/s, d wind_i / d x_j at 3 i + j
    float reference[lane_block];               // m/s, the speed of the field: the limit of a change over a substep
};

// Numbered as in snapshots. Gusts are part of the uniform wind.
struct SourceKinds {
    enum Kind : int32_t { gusts = 1, rankine, lamb_oseen, point_blower, line_blower, turbulence, grid, ground };
};

// A source (or an octave of turbulence) at an instant. Bodies farther than `reach` from `center` do not feel it; 0: no limit.
struct SourceInstant : SourceKinds {
    Kind kind;
    float center[3], reach;
    float position[3]; // of an axis, a nozzle, a plane, or of the first sample of a grid
    float axis[3], side[3];
    float motion[3]; // m/s, of the whole pattern

    float strength;          // vortex: circulation / 2 pi; blower: speed at the nozzle; turbulence: times a unit vector
    float core;              // vortex: core radius; blower: radius or half width of the nozzle
    float inverse_radius_sq; // vortex: 1/radius^2, 0 without a limit
    float inverse_length_sq; // vortex: 1/half length^2, 0 without a limit
    float spread, range;     // blower
    float half_length;       // line blower
    float inverse_roughness; // ground, 1/m
    float inverse_log;       // ground: 1/ln(1 + reference height / roughness)
    float inverse_spacing[3]; // grid; turbulence: 1/cell in the first
    float offset[3];          // turbulence: of the lattice, in cells, 0 to 1
    float lattice[9],
        basis[9];    // turbulence: lattice coordinates of places in m, row by row; world axes of them, in cells
    int32_t cell[3]; // turbulence: whole cells of it
    uint32_t seed;
    float turn, turn_rate; // turbulence: phase of the slowest beat in turns, 0 to 1; 1/s
    int32_t count[3];      // grid: samples
    int32_t outside;       // grid: LR_WIND_OUTSIDE_*
    const float* frame[2]; // grid: three floats a sample
    float part, part_rate; // grid: between the two frames; 1/s
};

struct FieldInstant {
    float wind[3];   // m/s, uniform part in the middle of the substep
    float change[3]; // m/s, of it over the substep
    float reference; // m/s
    uint32_t source_count;
    const SourceInstant* sources;
};

// The wind over the substeps of a call of the kernel.
struct WindAlong {
    const FieldInstant* instant; // of each substep
    FieldBlock* blocks;          // the winds of the one substep if `known`, else room for those of a vector
    bool everywhere;             // the same at all places
    bool known;
};

// A vector of bodies in a wind field, as the kernel enters and leaves it in each substep.
struct BodiesInWind {
    alignas(64) float x[3][lane_block]; // m, world
    float q[4][lane_block];
    float v[3][lane_block],
        u[3][lane_block];     // m/s, body axes, u of the spin times the length; between, v is through the fluid
    float length[lane_block]; // m
    // The fluid, in the middle of the substep.
    float wind[3][lane_block];        // m/s
    float half_change[3][lane_block]; // m/s, of the wind along the body's path over half the substep
    float weight[3][lane_block];      // of Held
    float gravity[3][lane_block];     // of Held
    float spin[3][lane_block];        // m/s, half the vorticity times the length
    float inverse_reference[lane_block],
        own_squared[lane_block]; // s/m; the fluid's own change over that speed, squared
};
} // namespace lr
