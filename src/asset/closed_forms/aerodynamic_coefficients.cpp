#include "asset/closed_forms/aerodynamic_coefficients.h"

#include "asset/closed_forms/ellipsoid_formulas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lr::shape {
namespace {

// The coefficients of the rule. docs/maintainers/physics.md, "AERODYNAMIC", gives the meaning and the measurement of each.
constexpr double streamlined_drag = 0.05;                   // the least C_D
constexpr double blunt_slope = 2.0, blunt_offset = -0.8985; // C_D over bluntness: sphere 0.43, flat face 1.10
constexpr double aspect_gain = 0.7, aspect_half = 20.0;     // a long silhouette lets less flow around its ends
constexpr double drag_blunt_share = 0.445;                  // part of a sphere's C_D that comes with Re of some 8710
constexpr double layer_friction = 0.558;                    // Blasius, 0.664 a side, over chord/sqrt(2)
constexpr double layer_pressure = 0.42, layer_separation = 0.414; // faces across the stream; rounded faces
constexpr double turbulent_friction = 0.004;                      // of the surface along the stream
constexpr double translation_lift = 1.2;                          // C_T of a plate in two dimensions
constexpr double magnus = 0.5;                                    // of the volume, about an axis of revolution
constexpr double strip_half = 4.0;                                // span over chord, less 1, half-way to a strip
constexpr double roll_half = 4.0;                                 // span over chord
constexpr double spin_friction = 0.008;

// 0 for a flat face, 1 for a face as round as a sphere or rounder.
double roundness(double bluntness) {
    return std::clamp(3.0 * (1.0 - bluntness), 0.0, 1.0);
}

// x/(x + y), 0 if both vanish.
double share(double x, double y) {
    return x > 0.0 ? x / (x + y) : 0.0;
}

// How much the silhouette along k exceeds the next: 1 for a sheet, 0 for rods, round bodies and the other axes of a sheet.
double sheetness(const AerodynamicGeometry& g, size_t k) {
    const double other = std::max(g.area[(k + 1) % 3], g.area[(k + 2) % 3]);
    return g.area[k] > other ? 1.0 - other / g.area[k] : 0.0;
}

// Span over chord, less one, in the plane across k.
double slenderness(double a, double b) {
    const double narrow = std::min(a, b);
    return narrow > 0.0 ? std::max(a, b) / narrow - 1.0 : 0.0;
}

// From a disc's coefficient to that of a long strip.
double by_slenderness(double disc, double strip, double slenderness) {
    return disc + (strip - disc) * share(slenderness, strip_half);
}

void set_drag(const AerodynamicGeometry& g, size_t k, const PlateCoefficients& plate, AerodynamicData& out) {
    const size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double beta = g.bluntness[k], area = g.area[k], round = roundness(beta);
    const double wide = std::max(g.extent[i], g.extent[j]), narrow = std::min(g.extent[i], g.extent[j]);
    const double sheet = sheetness(g, k) * sheetness(g, k);
    const double unsteady =
        1.0 + sheet * (by_slenderness(plate.unsteady_disc, plate.unsteady_strip, slenderness(wide, narrow)) - 1.0);
    const double coefficient = std::max(streamlined_drag, blunt_slope * beta + blunt_offset) *
                               (1.0 + aspect_gain * share(wide, aspect_half * narrow)) * unsteady;
    const double across = 2.0 * beta * area; // int n_k^2 dA
    const double along = std::max(0.0, g.surface - across);
    const double blunt = drag_blunt_share * round;
    out.drag[k] += (1.0 - blunt) * coefficient * area + turbulent_friction * along;
    out.drag_blunt[k] = blunt * coefficient * area;
    // Edge on, a sheet's own layers of vorticity slow it more than friction does.
    const double edge_drag = by_slenderness(plate.edge_drag, plate.edge_strip, slenderness(wide, narrow));
    for (const size_t edge : {i, j}) out.drag[edge] += edge_drag * sheet * (area - g.area[edge]);
    // The layer grows along the body, and from the middle of its front to the rim.
    const double width2 = 4.0 / std::numbers::pi * area;
    const double run = std::sqrt(0.5 * (g.extent[k] * g.extent[k] + width2));
    const double faces = layer_friction * along + (layer_pressure + layer_separation * round) * across;
    out.drag_layer[k] = run > 0.0 ? faces / std::sqrt(run) : 0.0;
}

// Circulation about the axis k in a stream along i and j.
void set_lift(const AerodynamicGeometry& g, size_t k, const PlateCoefficients& plate, AerodynamicData& out) {
    const size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double plan = std::max(g.area[i], g.area[j]), span = g.extent[k];
    const double total = g.area[i] + g.area[j], difference = g.area[j] - g.area[i];
    const double flatness = total > 0.0 ? std::abs(difference) / total : 0.0;
    // The extent along the flat side; of a body that is as thick as wide, the mean of both.
    const double chord = total > 0.0 ? (g.area[j] * g.extent[i] + g.area[i] * g.extent[j]) / total : 0.0;
    out.lift[k] = translation_lift * difference * share(span, plate.lift_span * chord);
    out.spin_lift[k] = 0.5 * plate.rotation * plan * chord * flatness * share(span, plate.rotation_span * chord) +
                       magnus * g.volume * (1.0 - flatness);
    const double sheet = std::max(sheetness(g, i), sheetness(g, j));
    out.lift_moment[k] = plate.moment * sheet * difference * chord;
    out.lift_moment_stalled[k] = plate.moment_stalled * sheet * difference * chord;
    const double moment =
        by_slenderness(plate.spin_disc, plate.spin_strip, chord > 0.0 ? std::max(0.0, span / chord - 1.0) : 0.0);
    out.spin_drag[k] = 0.5 * (moment * g.stroke3[k] + spin_friction * g.rub[k]);
    out.spin_drag_stream[k] = plate.spin_stream * g.stroke2[k];
    // A wing of the span across the stream, rolling about it: lifting-line theory's span over chord.
    const double wing = g.extent[g.area[i] > g.area[j] ? j : i];
    out.roll_damping[k] = plate.roll * sheet * g.stroke2[k] * (1.0 + roll_half) * share(wing, roll_half * g.extent[k]);
}
} // namespace

AerodynamicData default_aerodynamics(const AerodynamicGeometry& g, const PlateCoefficients& plate) {
    AerodynamicData out;
    out.axes = g.axes;
    out.center = g.center;
    const double largest = std::max({g.area[0], g.area[1], g.area[2]});
    double sheet = 0.0;
    for (size_t k = 0; k < 3; ++k) {
        set_drag(g, k, plate, out);
        set_lift(g, k, plate, out);
        out.broadside[k] = largest > 0.0 ? g.area[k] / largest : 0.0;
        sheet = std::max(sheet, sheetness(g, k));
    }
    const StokesResistance stokes = stokes_resistance({0.5 * g.extent[0], 0.5 * g.extent[1], 0.5 * g.extent[2]});
    out.drag_stokes = stokes.translation;
    out.spin_drag_stokes = stokes.rotation;
    for (double& couple : out.spin_drag_stokes) couple *= 1.0 - (1.0 - plate.spin_creeping) * sheet;
    out.lift_stall = plate.stall * sheet;
    out.intensity = plate.intensity;
    out.length = plate.correlation * std::max({g.extent[0], g.extent[1], g.extent[2]});
    out.wake_reynolds = plate.wake_reynolds;
    return out;
}
} // namespace lr::shape
