#include "tools/lr_fit/coefficients.h"

#include "asset/closed_forms/ellipsoid_formulas.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <stdexcept>

namespace lr::fit {
namespace {

double scaled(double value, double from, double to) {
    if (from == to) return value;
    if (from == 0.0) throw std::logic_error("a coefficient whose present value is 0 cannot be scaled");
    return value * (to / from);
}

template <size_t n> void scale(double (&value)[n], const std::array<double, n>& from, const std::array<double, n>& to) {
    for (size_t i = 0; i < n; ++i) value[i] = scaled(value[i], from[i], to[i]);
}

void scale(double& value, double from, double to) {
    value = scaled(value, from, to);
}

std::string digits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}
} // namespace

std::span<const Coefficient> fitted_coefficients() {
    using P = PlateCoefficients;
    static constexpr Coefficient all[] = {{"lift", &P::lift, 1.2, 4.0},
                                          {"vortex", &P::vortex, 0.5, 8.0},
                                          {"stall", &P::stall, 0.15, 0.95},
                                          {"separated_shedding", &P::separated_shedding, 0.0, 1.0},
                                          {"rotation", &P::rotation, 0.2, 2.5},
                                          {"spin_disc", &P::spin_disc, 0.2, 10.0},
                                          {"spin_stream", &P::spin_stream, 0.15, 6.0},
                                          {"start", &P::start, 0.0, 5.0},
                                          {"lag", &P::lag, 0.3, 6.0},
                                          {"share", &P::share, 0.0, 1.0},
                                          {"strouhal", &P::strouhal, 0.12, 0.2},
                                          {"growth", &P::growth, 0.05, 2.0},
                                          {"critical_reynolds", &P::critical_reynolds, 90.0, 110.0},
                                          {"moment", &P::moment, -0.15, 0.15},
                                          {"rate_moment", &P::rate_moment, -0.15, 0.15},
                                          {"noise", &P::noise, 0.1, 10.0},
                                          {"intensity", &P::intensity, 0.03, 0.4},
                                          {"correlation", &P::correlation, 0.4, 2.0}};
    return all;
}

lr_aerodynamics rebaked(const lr_aerodynamics& disc, const PlateCoefficients& changed) {
    if (disc.broadside[2] != 1.0) throw std::logic_error("the disc must be in the plane z = 0");
    const shape::AerodynamicGeometry flat = shape::ellipsoid_geometry({1.0, 1.0, 1e-6});
    const AerodynamicData from = shape::default_aerodynamics(flat), to = shape::default_aerodynamics(flat, changed);
    lr_aerodynamics out = disc;
#define LR_SCALE(name, ...) scale(out.name, from.name, to.name);
    LR_AERODYNAMIC_VECTORS(LR_SCALE)
    LR_AERODYNAMIC_NUMBERS(LR_SCALE)
#undef LR_SCALE
    return out;
}

scorecard::Loads loads_with(const PlateCoefficients& changed) {
    scorecard::Loads loads;
    loads.configure = [changed](lr_world* world, lr_batch batch) {
        lr_aerodynamics a = scorecard::initialised(lr_aerodynamics_init);
        scorecard::require(lr_batch_get_aerodynamics(world, batch, &a), "lr_batch_get_aerodynamics");
        a = rebaked(a, changed);
        scorecard::require(lr_batch_set_aerodynamics(world, batch, &a), "lr_batch_set_aerodynamics");
    };
    return loads;
}

PlateCoefficients rounded(PlateCoefficients coefficients) {
    for (const Coefficient& c : fitted_coefficients())
        coefficients.*c.member = std::strtod(digits(coefficients.*c.member).c_str(), nullptr);
    return coefficients;
}

std::string members(const PlateCoefficients& coefficients) {
    std::string text;
    for (const Coefficient& c : fitted_coefficients())
        text += std::string("    double ") + c.name + " = " + digits(coefficients.*c.member) + ";\n";
    return text;
}
} // namespace lr::fit
