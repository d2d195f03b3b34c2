// The water's surface as the kernel sees it, and a batch's bodies in water. Formulas: docs/reference/wind_and_water.md.
#pragma once

#include "base/lane_arrays.h"
#include "kernel/body_constants.h"
#include "kernel/wind/sample_wind.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace lr {

struct StepInput;

inline constexpr uint32_t most_waves = 8;

struct WaveInstant {
    float direction[3]; // unit, in the plane
    float turns_per_m;  // 1/length
    float turn;         // phase at the point of the plane, in turns, 0 to 1
    float number;       // k, 1/m
    float amplitude;    // m
    float speed, rate;  // a omega, m/s, and a omega^2, m/s^2
};

struct SurfaceInstant {
    float point[3], up[3]; // of the plane
    float current[3];      // m/s
    uint32_t wave_count;
    WaveInstant waves[most_waves];
};

// The surface, and the water's motion, at a block of bodies.
struct SurfaceBlock {
    alignas(64) float position[3][field_block]; // m, world
    float height[field_block];                  // m above the plane
    float normal[3][field_block];               // unit
    float velocity[3][field_block];             // m/s
    float rate[3][field_block];                 // m/s^2
};

// A batch's bodies in water. Lengths and masses at scale 1.
struct WaterBody {
    BodyConstants water;              // the body wholly in water
    float mass, air_mass, water_mass; // kg: m, rho_a V, rho_w V
    float air_density, water_density; // kg/m^3
    float axes[9];                    // rows: of the equivalent ellipsoid, in the body frame
    float semi_axes_squared[3];       // m^2
    float center[3];                  // m, of buoyancy, from the centre of mass
    float radius;                     // m: no part of the ellipsoid is farther from the centre of mass
    float fall;                       // share of gravity with which it falls or rises from rest, across its widest side
    // Modes of the mass matrices: X^T M_a X = 1, X^T (M_w U_w/U_a - M_a) X = lambda, so with the fraction f in water X^-1 twists scale with 1 + f
    // lambda. On the diagonal path, never with AERODYNAMIC loads, X is diagonal and not used.
    float lambda[6], to[36], from[36];
    bool diagonal;
    // The water's mass matrix is nearer to that of a body with such a part in it than the air's, by the mode in which they differ most.
    bool carries(float part) const {
        return part * (1.0f + std::sqrt(1.0f + *std::max_element(lambda, lambda + 6))) > 1.0f;
    }
};

struct WetSubstep {
    const WaterBody* body;
    const SurfaceInstant* plane;
    const SurfaceBlock* begin;
    const SurfaceBlock* middle;
    const SurfaceBlock* end;
    const float (*wind)[field_block]; // m/s, of the upper fluid at the bodies
    const float* gravity;             // m/s^2, the world's
    float* fraction;                  // submerged in the middle of the substep; after the settling at its end
};

// Marks with 1 in `near` the bodies of [begin, end) that can touch the water within `dt`; others get 0.
using NearFunction = void(const SurfaceInstant&, float highest, const WaterBody&, float dt, float gravity,
                          const BatchArrays&, size_t begin, size_t end, uint32_t* near);
// Positions of bodies after `h`.
using AheadFunction = void(const BatchArrays&, size_t count, float h, SurfaceBlock&);
// Plane and built-in waves at the block's positions.
using SurfaceFunction = void(const SurfaceInstant&, size_t count, SurfaceBlock&);
// One substep of bodies that can touch the water, and the change of added mass at its end.
using WetFunction = void(const StepInput&, const WetSubstep&, const BatchArrays&, size_t count);

struct SurfaceTarget {
    NearFunction* near;
    AheadFunction* ahead;
    SurfaceFunction* surface;
    WetFunction *step, *settle;
};

// From an asset and the loads in use; `air` are the batch's constants. False if a mass matrix has no inverse.
bool make_water_body(const AssetData& asset, const AerodynamicData& loads, const Gains& gains,
                     const TurbulenceSample& stationary, bool diagonal, double air_density, double water_density,
                     double water_viscosity, Loads model, const BodyConstants& air, WaterBody& out);
} // namespace lr
