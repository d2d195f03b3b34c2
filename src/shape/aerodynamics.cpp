#include "shape/aerodynamics.h"

#include "shape/stokes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lr::shape {
namespace {

// The coefficients of the rule; docs/physics.md, "AERODYNAMIC", says what each stands for and where it was measured.
constexpr double streamlined_drag = 0.05;                         // the least C_D
constexpr double blunt_slope = 2.0, blunt_offset = -0.8985;       // C_D over bluntness: sphere 0.43, flat face 1.10
constexpr double aspect_gain = 0.7, aspect_half = 20.0;           // a long silhouette lets less flow around its ends
constexpr double drag_blunt_share = 0.445;                        // of a sphere's C_D, that comes with Re of some 8710
constexpr double layer_friction = 0.558;                          // Blasius, 0.664 a side, over chord/sqrt(2)
constexpr double layer_pressure = 0.42, layer_separation = 0.414; // of faces across the stream, of rounded ones
constexpr double turbulent_friction = 0.004;                      // of the surface along the stream
constexpr double translation_lift = 1.2, rotation_lift = std::numbers::pi; // C_T, C_R of a plate in two dimensions
constexpr double finite_span = 2.4;                                        // lift falls as AR/(AR + this)
constexpr double magnus = 0.5;                                             // of the volume, about an axis of revolution
constexpr double spin_disc = 0.94, spin_strip = 2.5, spin_half = 10.0;     // C_M by span over chord
constexpr double spin_friction = 0.008;
constexpr double wake_intensity = 0.03;

// 0 for a flat face, 1 where it is as round as a sphere or rounder.
double roundness(double bluntness) {
    return std::clamp(3.0 * (1.0 - bluntness), 0.0, 1.0);
}

// x/(x + y), 0 where both vanish.
double share(double x, double y) {
    return x > 0.0 ? x / (x + y) : 0.0;
}

void set_drag(const AerodynamicGeometry& g, size_t k, AerodynamicData& out) {
    const size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double beta = g.bluntness[k], area = g.area[k], round = roundness(beta);
    const double wide = std::max(g.extent[i], g.extent[j]), narrow = std::min(g.extent[i], g.extent[j]);
    const double coefficient = std::max(streamlined_drag, blunt_slope * beta + blunt_offset) *
                               (1.0 + aspect_gain * share(wide, aspect_half * narrow));
    const double across = 2.0 * beta * area; // int n_k^2 dA
    const double along = std::max(0.0, g.surface - across);
    const double blunt = drag_blunt_share * round;
    out.drag[k] = (1.0 - blunt) * coefficient * area + turbulent_friction * along;
    out.drag_blunt[k] = blunt * coefficient * area;
    // The layer grows along the body, and from the middle of its front to the rim.
    const double width2 = 4.0 / std::numbers::pi * area;
    const double run = std::sqrt(0.5 * (g.extent[k] * g.extent[k] + width2));
    const double faces = layer_friction * along + (layer_pressure + layer_separation * round) * across;
    out.drag_layer[k] = run > 0.0 ? faces / std::sqrt(run) : 0.0;
}

// Circulation about the axis k in a stream along i and j.
void set_lift(const AerodynamicGeometry& g, size_t k, AerodynamicData& out) {
    const size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double plan = std::max(g.area[i], g.area[j]), span = g.extent[k];
    const double ends = share(span * span, finite_span * plan);
    const double total = g.area[i] + g.area[j];
    const double flatness = total > 0.0 ? std::abs(g.area[j] - g.area[i]) / total : 0.0;
    // The extent along the flat side; of a body that is as thick as wide, the mean of both.
    const double chord = total > 0.0 ? (g.area[j] * g.extent[i] + g.area[i] * g.extent[j]) / total : 0.0;
    out.lift[k] = translation_lift * (g.area[j] - g.area[i]) * ends;
    out.spin_lift[k] = 0.5 * rotation_lift * plan * chord * flatness * ends + magnus * g.volume * (1.0 - flatness);
    const double slender = chord > 0.0 ? std::max(0.0, span / chord - 1.0) : 0.0;
    const double moment = spin_disc + (spin_strip - spin_disc) * share(slender, spin_half);
    out.spin_drag[k] = 0.5 * (moment * g.stroke3[k] + spin_friction * g.rub[k]);
}

} // namespace

AerodynamicData default_aerodynamics(const AerodynamicGeometry& g) {
    AerodynamicData out;
    out.axes = g.axes;
    for (size_t k = 0; k < 3; ++k) {
        set_drag(g, k, out);
        set_lift(g, k, out);
    }
    const StokesResistance stokes = stokes_resistance({0.5 * g.extent[0], 0.5 * g.extent[1], 0.5 * g.extent[2]});
    out.drag_stokes = stokes.translation;
    out.spin_drag_stokes = stokes.rotation;
    out.intensity = wake_intensity;
    out.length = std::max({g.extent[0], g.extent[1], g.extent[2]});
    return out;
}

} // namespace lr::shape
