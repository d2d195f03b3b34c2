// The water surface as the kernel sees it, and a batch's bodies in water. Formulas: docs/reference/wind_and_water.md.
#pragma once

#include "base/lane_arrays.h"
#include "kernel/body_constants.h"
#include "kernel/wind/sample_wind.h"
#include "langevin_rigid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace lr {

struct StepInput;

struct WaveInstant {
    float direction[3]; // unit, in the plane
    float turns_per_m;  // 1/length
    float turn;         // phase at the plane's point, in turns, 0 to 1
    float number;       // k, 1/m
    float amplitude;    // m
    float speed, rate;  // a omega, m/s, and a omega^2, m/s^2
};

struct SurfaceInstant {
    float point[3], up[3]; // of the plane
    float current[3];      // m/s
    uint32_t wave_count;
    WaveInstant waves[LR_MAX_WAVES];
};

// Surface and motion of the water at a block of bodies.
struct SurfaceBlock {
    alignas(64) float position[3][field_block]; // m, world
    float height[field_block];                  // m above the plane
    float normal[3][field_block];               // unit
    float velocity[3][field_block];             // m/s
    float rate[3][field_block];                 // m/s^2
};

// Constants of a batch's bodies in water. Lengths and masses at scale 1.
struct WaterBody {
    BodyConstants water;              // constants wholly in water
    float mass, air_mass, water_mass; // kg: m, rho_a V, rho_w V
    float air_density, water_density; // kg/m^3
    float axes[9];                    // rows: axes of the equivalent ellipsoid in the body frame
    float semi_axes_squared[3];       // m^2
    float thin;                       // m: the smallest semi-axis
    float draught;                    // of the ellipsoid's centre, afloat at rest, over its half height: -1 to 1
    float center[3];                  // m: of buoyancy, from the centre of mass
    float radius;                     // m: bound of the ellipsoid's distance from the centre of mass
    float fall;                       // |m - rho V|/|M + A|: acceleration from rest over gravity (contact.md, 4)
    // Modes of the mass matrices: X^T M_a X = 1, X^T (M_w U_w/U_a - M_a) X = lambda, so with the share f in water a mode's mass is 1 + f lambda; X^-1
    // takes twists to modes. On the diagonal path, which excludes AERODYNAMIC loads, X is diagonal and not used.
    float lambda[6], to[36], from[36];
    bool diagonal;
    // Whether a body with this share in water is nearer to the water's mass matrix than to the air's, by their ratio in the mode of largest lambda.
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
    float* fraction;                  // submerged in the middle of the substep; after the last update, at its end
};

// Marks with 1 the bodies of [begin, end) that can touch the water within `dt`, others with 0.
using NearFunction = void(const SurfaceInstant&, float highest, const WaterBody&, float dt, float gravity,
                          const BatchArrays&, size_t begin, size_t end, uint32_t* near);
// Positions of bodies after `h`, and plane and built-in waves there.
using SurfaceFunction = void(const SurfaceInstant&, const WaterBody&, const BatchArrays&, size_t count, float h,
                             SurfaceBlock&);
// One substep of bodies near water, with the change of added mass at its end.
using WetFunction = void(const StepInput&, const WetSubstep&, const BatchArrays&, size_t count);

struct SurfaceTarget {
    NearFunction* near;
    SurfaceFunction* surface;
    WetFunction *step, *settle;
};

// From an asset and its loads in use; `air`: the batch's constants. False if a mass matrix has no inverse.
bool make_water_body(const AssetData& asset, const AerodynamicData& loads, const Gains& gains,
                     const TurbulenceSample& stationary, bool diagonal, double air_density, double water_density,
                     double water_viscosity, Loads model, const BodyConstants& air, WaterBody& out);
} // namespace lr
