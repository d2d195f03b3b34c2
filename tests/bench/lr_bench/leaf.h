// The body of all subjects: the leaf of the paper, an ellipsoid of 8 cm x 2 cm x 0.1 mm.
#pragma once

#include "langevin_rigid.h"

namespace lr_bench {

constexpr double leaf_semi_axes[3] = {0.04, 0.01, 0.00005};
constexpr double leaf_density = 800.0;
constexpr double air_density = 1.2;
constexpr double air_viscosity = 1.5e-5;

// The caller releases it; null after an error. `ballasted`: its weight off centre, which needs the full 6x6 matrix.
lr_asset* leaf_asset(bool ballasted);

// Ballasted, with this many strips across its span that share its loads.
lr_asset* leaf_asset_of_stations(uint32_t count);

// Coefficients of the LANGEVIN equations along the body axes; docs/maintainers/physics.md, sections 3 and 4. SI.
struct LeafConstants {
    float weight;     // m - rho V
    float mass[3];    // m + rho A
    float inertia[3]; // J0 + rho D
    float carried[3]; // rho (V + A): the mass for the turbulent force
    float turned[3];  // rho D'
    float alpha;      // damping over speed, 1/m
    float beta2;      // noise intensity over speed^3, 1/m
    float ell;        // m
    float drag;       // 1/2 rho C S of a plain quadratic drag, kg/m, for peers without a fluid
};
LeafConstants leaf_constants();

} // namespace lr_bench
