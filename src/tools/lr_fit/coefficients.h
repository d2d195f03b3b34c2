// The coefficients that are fitted: members of PlateCoefficients, whose values are the present ones.
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
// All of a disc's but the drag broadside, which is measured (steady-drag), and wake_reynolds, which falls of this size do not see.
std::span<const Coefficient> fitted_coefficients();

// Coefficients as a bake with `changed` would have them, from those of a baked disc in the plane z = 0: each field times the
// ratio that default_aerodynamics gives for a disc.
lr_aerodynamics rebaked(const lr_aerodynamics& disc, const PlateCoefficients& changed);

// The library's loads, with these coefficients for each batch of discs.
scorecard::Loads loads_with(const PlateCoefficients& changed);

// To four digits, as members().
PlateCoefficients rounded(PlateCoefficients coefficients);
// The lines of PlateCoefficients that give its members these values.
std::string members(const PlateCoefficients& coefficients);
} // namespace lr::fit
