// The fitted coefficients: members of PlateCoefficients, with their present values.
#pragma once

#include "asset/closed_forms/aerodynamic_coefficients.h"
#include "tools/lr_scorecard/runtime_handles.h"

#include <span>
#include <string>

namespace lr::fit {

using shape::PlateCoefficients;

struct Coefficient {
    const char* name;
    double PlateCoefficients::*member;
    double least, most; // the search stays between these
};
// All coefficients of a disc but the broadside drag, which is measured (steady-drag), and wake_reynolds, which has no effect at this size.
std::span<const Coefficient> fitted_coefficients();

// Coefficients of a bake with `changed`, from those of a baked disc in the plane z = 0: each field times its ratio in default_aerodynamics for a
// disc.
lr_aerodynamics rebaked(const lr_aerodynamics& disc, const PlateCoefficients& changed);

// The library's loads, with these coefficients set for each batch of discs.
scorecard::Loads loads_with(const PlateCoefficients& changed);

// To the four digits of members().
PlateCoefficients rounded(PlateCoefficients coefficients);
// Source lines of PlateCoefficients with these values.
std::string members(const PlateCoefficients& coefficients);
} // namespace lr::fit
