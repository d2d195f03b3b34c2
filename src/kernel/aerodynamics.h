// From an asset's quasi-steady loads to the kernel's constants.
#pragma once

#include "kernel/constants.h"

namespace lr {

// Finite, not beyond what bodies of this library can have, axes orthonormal and right-handed, no negative drag.
bool is_usable(const AerodynamicData& loads);

// Null when a batch can have them, else what is wrong. diagonal: as BodyConstants::diagonal.
const char* wrong_in(const AerodynamicData& loads);

// Fills out.aerodynamics; `out` comes from make_body_constants with the same arguments. False when the mass matrix
// cannot be inverted.
bool make_aerodynamics(const AssetData& asset, const AerodynamicData& loads, const Gains& gains, bool diagonal,
                       double fluid_density, double viscosity, BodyConstants& out);

// The fluid's own velocity from a k-epsilon sample instead: Pope's alpha, and the stationary variance beta^2/(2 alpha).
void set_gust_turbulence(const TurbulenceSample& stationary, const Gains& gains, BodyConstants& out);

} // namespace lr
