#include "tools/lr_scorecard/card_asset.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lr::scorecard {

CardBody make_card(const CardModel& model) {
    using std::numbers::pi;
    // The units are arbitrary: a = 1 cm in a fluid of density 1000, 2 cm of the infinite strip, 1 % thick, 0.1 m/s.
    const double a = 0.01, span = 0.02, b = 0.01 * a, rho = 1000.0, nu = 1e-6, speed = 0.1;
    const double unit = pi * a * a * span; // added mass at density 1
    lr_rigid_desc card = initialised(lr_rigid_desc_init);
    card.volume = pi * a * b * span;
    card.mass = model.inertia * rho * unit;
    const double about_span = 0.25 * card.mass * a * a, across = card.mass * span * span / 12.0;
    card.inertia[0] = across;
    card.inertia[4] = across + about_span;
    card.inertia[8] = about_span;
    card.added_mass[7] = rho * unit;
    card.added_mass[21] = rho * unit * span * span / 12.0;
    card.added_mass[35] = rho * unit * a * a / 8.0;
    card.fluid_density = rho;
    card.fluid_viscosity = nu;
    const double extents[3] = {2.0 * a, 2.0 * b, span};
    std::copy(extents, extents + 3, card.extents);
    // docs/maintainers/measurements.md derives each term. (i, j, k) is (chord, normal, span).
    lr_aerodynamics loads = initialised(lr_aerodynamics_init);
    loads.drag[0] = 2.0 * a * span * (model.a - model.b);
    loads.drag[1] = 2.0 * a * span * (model.a + model.b);
    loads.lift[2] = 2.0 * a * span * model.ct;
    loads.spin_lift[2] = 2.0 * a * a * span * model.cr;
    loads.spin_drag[2] = pi * std::pow(a, 4.0) * span * model.mu2;
    loads.spin_drag_stokes[2] = pi * a * a * a * span * model.mu1 * speed / nu;
    loads.length = 2.0 * a;
    card.aerodynamics = &loads;
    lr_asset* asset = nullptr;
    require(lr_asset_create_rigid(&card, &asset), "lr_asset_create_rigid of the card");
    return {Asset(asset), speed * speed * rho * unit / ((card.mass - rho * card.volume) * a), a, speed};
}
} // namespace lr::scorecard
