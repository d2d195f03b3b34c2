#include "scorecard/card_asset.h"

#include "format/asset_file.h" // no mesh has the 6x6 of a strip without ends

#include <cmath>
#include <numbers>

namespace lr::scorecard {

CardBody make_card(const CardModel& model) {
    using std::numbers::pi;
    // Any units do: a of 1 cm in a fluid of density 1000, a span of 2 cm of the endless strip, 1 % thick, 0.1 m/s.
    const double a = 0.01, span = 0.02, b = 0.01 * a, rho = 1000.0, nu = 1e-6, speed = 0.1;
    const double unit = pi * a * a * span; // of added mass at density 1
    AssetData data;
    data.name = "card";
    data.volume = pi * a * b * span;
    data.mass = model.inertia * rho * unit;
    data.density = data.mass / data.volume;
    const double about_span = 0.25 * data.mass * a * a, across = data.mass * span * span / 12.0;
    // Flat up to a thousandth, so that rounding does not take it past what a body can have.
    data.inertia = {across, 0, 0, 0, across + 0.999 * about_span, 0, 0, 0, about_span};
    const double none = 1e-6 * unit;
    const double diagonal[6] = {none, unit, none, unit * span * span / 12.0, none * a * a, unit * a * a / 8.0};
    for (size_t i = 0; i < 6; ++i) data.added_mass[7 * i] = diagonal[i];
    data.fluid_density = rho;
    data.fluid_viscosity = nu;
    data.length_d = 2.0 * a;
    data.length_b = 2.0 * b;
    data.length_l = 0.5 * pi * a / 4.0;
    data.projected_area = 2.0 * a * span;
    data.u0 = speed;
    data.turbulence.chi = {1.0};
    data.turbulence.epsilon = {1.0};
    // Term by term: docs/measures.md. (i, j, k) is (chord, normal, span).
    data.has_aerodynamics = true;
    AerodynamicData& loads = data.aerodynamics;
    loads.drag = {2.0 * a * span * (model.a - model.b), 2.0 * a * span * (model.a + model.b), 0.0};
    loads.lift = {0.0, 0.0, 2.0 * a * span * model.ct};
    loads.spin_lift = {0.0, 0.0, 2.0 * a * a * span * model.cr};
    loads.spin_drag = {0.0, 0.0, pi * std::pow(a, 4.0) * span * model.mu2};
    loads.spin_drag_stokes = {0.0, 0.0, pi * a * a * a * span * model.mu1 * speed / nu};
    loads.length = 2.0 * a;
    const std::vector<uint8_t> bytes = write_asset(data);
    lr_asset* asset = nullptr;
    require(lr_asset_load_memory(bytes.data(), bytes.size(), &asset), "lr_asset_load_memory of the card");
    return {Asset(asset), speed * speed * rho * unit / ((data.mass - rho * data.volume) * a), a, speed};
}

} // namespace lr::scorecard
