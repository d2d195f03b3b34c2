#include "asset/closed_forms/aerodynamic_coefficients.h"

#include "asset/closed_forms/ellipsoid_formulas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lr::shape {
namespace {

// The coefficients of the rules. docs/maintainers/physics.md, "AERODYNAMIC", has the meaning and the measurement of each.
constexpr double streamlined_drag = 0.05;                   // the least C_D
constexpr double blunt_slope = 2.0, blunt_offset = -0.8985; // C_D over bluntness: sphere 0.43, flat face 1.10
// C_D of faces inclined to the stream, if it leaves at their edges: octahedron 0.87, tetrahedron 1.2.
constexpr double edge_drag = 0.85;
// Of the front's width: over this length behind its edges the sides lie in the wake.
constexpr double shadow_length = 4.0;
constexpr double cross_flow = 1.1; // of stroke2: C_D of parts moved by the spin of a rod or a round body
constexpr double aspect_gain = 0.7, aspect_half = 20.0; // less flow passes around the ends of a long silhouette
constexpr double drag_blunt_share = 0.445;              // part of a sphere's C_D that sets in at Re of some 8710
constexpr double layer_friction = 0.558;                // Blasius, 0.664 a side, over chord/sqrt(2)
constexpr double layer_pressure = 0.42, layer_separation = 0.414; // faces across the stream; rounded faces
constexpr double turbulent_friction = 0.004;                      // of the surface along the stream
constexpr double translation_lift = 1.2,
                 lift_span = 1.68; // C_T of a plate in two dimensions; falls with chord over span
// Magnus force about an axis of revolution, over the volume: of plates; of round bodies, C_L 0.8 times the rim's speed over the stream's, as of balls
// with 0.09 + 0.6 of it (Sawicki, Hubbard and Stronge 2003).
constexpr double magnus_plate = 0.5, magnus_round = 0.3;
constexpr double strip_half = 4.0; // span over chord, less 1, half-way to a strip
constexpr double disc_aspect = 4.0 / std::numbers::pi;
constexpr double strip_stall = 0.09;                                 // squared sine of 17.5 degrees
constexpr double spin_friction = 0.008, spin_friction_round = 0.002; // without the layer
// Friction on a sphere that spins in a stream: by the analogy of momentum and heat its layer is d/(0.552 Re^(1/2)) thick (Froessling 1938), in creeping
// flow d/6.
constexpr double spin_layer = 0.552 / 6.0;

// 0 for a flat face, 1 for a face as round as a sphere or rounder.
double roundness(double bluntness) {
    return std::clamp(3.0 * (1.0 - bluntness), 0.0, 1.0);
}

// x/(x + y), 0 if both vanish.
double share(double x, double y) {
    return x > 0.0 ? x / (x + y) : 0.0;
}

// Relative excess of the silhouette along k over the next: 1 for a sheet, 0 for rods, round bodies and the other axes of a sheet.
double flatness(const AerodynamicGeometry& g, size_t k) {
    const double other = std::max(g.area[(k + 1) % 3], g.area[(k + 2) % 3]);
    return g.area[k] > other ? 1.0 - other / g.area[k] : 0.0;
}

// Zero up to 0.05, then linear to 1: bodies thinner than 0.05 are sheets.
double beyond_thin(double share) {
    return std::max(0.0, (share - 0.05) / 0.95);
}

// Degree to which a body is a plate across k: a thick body with a round rim is less of a plate than one with edges.
double sheetness(const AerodynamicGeometry& g, size_t k) {
    const double flat = flatness(g, k), lost = beyond_thin(1.0 - flat) * (1.0 - g.edges[k]);
    return flat * std::max(0.0, 1.0 - 2.25 * lost * lost);
}

// 1 for rods and round bodies, 0 for plates.
double compactness(const AerodynamicGeometry& g) {
    const double rest = beyond_thin(1.0 - std::max({sheetness(g, 0), sheetness(g, 1), sheetness(g, 2)}));
    return rest * rest * (3.0 - 2.0 * rest);
}

// Lift slope of a wing over that of a long one, by its aspect ratio (Helmbold 1942).
double slope_of(double aspect) {
    return aspect / (2.0 + std::sqrt(aspect * aspect + 4.0));
}

// edges: degree to which the stream leaves at edges, 0 to 1.
template <class Loads> void set_drag(const AerodynamicGeometry& g, size_t k, double edges, Loads& out) {
    const size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double beta = g.bluntness[k], area = g.area[k];
    const double round = (1.0 - edges) * roundness(beta), thick = 1.0 - sheetness(g, k);
    const double wide = std::max(g.extent[i], g.extent[j]), narrow = std::min(g.extent[i], g.extent[j]);
    const double faces_drag = std::max(streamlined_drag, blunt_slope * beta + blunt_offset);
    const double coefficient = thick * (faces_drag + edges * std::max(0.0, edge_drag - faces_drag)) *
                               (1.0 + aspect_gain * share(wide, aspect_half * narrow));
    const double across = 2.0 * beta * area; // int n_k^2 dA
    const double shadow = share(shadow_length * narrow, g.extent[k]);
    const double along = (1.0 - edges * shadow * shadow) * std::max(0.0, g.surface - across);
    const double blunt = drag_blunt_share * round;
    out.drag[k] = (1.0 - blunt) * coefficient * area + turbulent_friction * along;
    out.drag_blunt[k] = blunt * coefficient * area;
    // The boundary layer grows along the body, and from the middle of its front to the rim.
    const double width2 = 4.0 / std::numbers::pi * area;
    const double run = std::sqrt(0.5 * (g.extent[k] * g.extent[k] + width2));
    const double faces = layer_friction * along + thick * (layer_pressure + layer_separation * round) * across;
    out.drag_layer[k] = run > 0.0 ? faces / std::sqrt(run) : 0.0;
}

// Normal force of a plate of this extent across the axis n. area: its part of the silhouette `plan`.
template <class Loads>
void set_normal_force(const std::array<double, 3>& extent, double plan, double area, size_t n,
                      const PlateCoefficients& plate, Loads& out) {
    const size_t i = (n + 1) % 3, j = (n + 2) % 3;
    const double wide = std::max(extent[i], extent[j]), narrow = std::min(extent[i], extent[j]);
    const auto aspect_drag = [](double ratio) { return 1.0 + aspect_gain * share(ratio, aspect_half); };
    out.plate_drag = plate.drag * area * aspect_drag(wide / narrow) / aspect_drag(1.0);
    for (const size_t along : {i, j}) {
        const double span = extent[along == i ? j : i], aspect = span * span / plan;
        const double slope = slope_of(aspect), disc = slope_of(disc_aspect), relative = aspect / disc_aspect;
        out.plate_lift[along] = plate.lift * area * slope / disc;
        out.plate_vortex[along] = plate.vortex * area * 4.0 / (3.0 + relative);
        const double low = (1.0 + disc_aspect * disc_aspect / 2.25) / (1.0 + aspect * aspect / 2.25);
        out.plate_stall[along] = std::min(strip_stall + (plate.stall - strip_stall) * low, 1.0);
    }
}

// The plate across the axis of the largest silhouette.
void set_plate(const AerodynamicGeometry& g, const PlateCoefficients& plate, AerodynamicData& out) {
    const size_t n = static_cast<size_t>(std::max_element(g.area.begin(), g.area.end()) - g.area.begin());
    const size_t i = (n + 1) % 3, j = (n + 2) % 3;
    const double wide = std::max(g.extent[i], g.extent[j]), narrow = std::min(g.extent[i], g.extent[j]);
    if (!(narrow > 0.0)) return;
    const double sheet = sheetness(g, n), area = sheet * g.area[n];
    set_normal_force(g.extent, g.area[n], area, n, plate, out);
    out.plate_separated_shedding = flatness(g, n) * plate.separated_shedding;
    out.start_drag = plate.start;
    out.wake_length = 4.0 / std::numbers::pi * g.area[n] / wide;
    out.wake_lag = plate.lag;
    out.wake_share = plate.share;
    out.strouhal = plate.strouhal;
    out.shedding_growth = plate.growth;
    out.shedding_reynolds = plate.critical_reynolds;
    out.shedding_noise = plate.noise;
    out.shedding_moment = plate.moment * area * out.wake_length;
    out.shedding_rate_moment = plate.rate_moment * area * out.wake_length;
}

struct Circulation {
    double lift, spin_lift;
};

// Circulation about the axis k in a stream along i and j, and the drag of spin about k. compact: compactness() of the whole body.
template <class Loads>
Circulation set_spin(const AerodynamicGeometry& g, size_t k, double span, double compact,
                     const PlateCoefficients& plate, Loads& out) {
    const size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double plan = std::max(g.area[i], g.area[j]);
    const double total = g.area[i] + g.area[j];
    const double uneven = total > 0.0 ? std::abs(g.area[j] - g.area[i]) / total : 0.0;
    // Extent along the flat side; of a body as thick as wide, the mean of both.
    const double chord = total > 0.0 ? (g.area[j] * g.extent[i] + g.area[i] * g.extent[j]) / total : 0.0;
    const double thick = 1.0 - std::max(sheetness(g, i), sheetness(g, j));
    const auto over = [&](double width) { return width > 0.0 ? std::max(0.0, span / width - 1.0) : 0.0; };
    const double moment = plate.spin_disc + (plate.spin_strip - plate.spin_disc) * share(over(chord), strip_half);
    // Not over the chord, by which a disc would be the slenderer the thicker it is.
    const double slenderness = over(std::max(g.extent[i], g.extent[j]));
    const double damping = plate.spin_stream_strip +
                           (plate.spin_stream - plate.spin_stream_strip) / (1.0 + slenderness / plate.spin_stream_half);
    const double friction = spin_friction + (spin_friction_round - spin_friction) * compact;
    out.spin_drag[k] = 0.5 * (moment * g.stroke3[k] + friction * g.rub[k]);
    out.spin_drag_stream[k] = (damping * (1.0 - thick) + cross_flow * compact) * g.stroke2[k];
    // A rod or a round body has no edge for the stream to leave at, so its spin makes no circulation of this kind.
    return {thick * translation_lift * (g.area[j] - g.area[i]) * share(span, lift_span * chord),
            0.5 * plate.rotation * plan * chord * uneven * (1.0 - compact) * share(span, plate.rotation_span * chord) +
                (magnus_plate + (magnus_round - magnus_plate) * compact) * g.volume * (1.0 - uneven)};
}
} // namespace

AerodynamicData default_aerodynamics(const AerodynamicGeometry& g, const PlateCoefficients& plate) {
    AerodynamicData out;
    out.axes = g.axes;
    out.center = g.center;
    const double largest = std::max({g.area[0], g.area[1], g.area[2]});
    for (size_t k = 0; k < 3; ++k) {
        set_drag(g, k, g.edges[k] * g.edges[k], out);
        const Circulation circulation = set_spin(g, k, g.extent[k], compactness(g), plate, out);
        out.lift[k] = circulation.lift;
        out.spin_lift[k] = circulation.spin_lift;
        out.broadside[k] = largest > 0.0 ? g.area[k] / largest : 0.0;
    }
    set_plate(g, plate, out);
    const StokesResistance stokes = stokes_resistance({0.5 * g.extent[0], 0.5 * g.extent[1], 0.5 * g.extent[2]});
    out.drag_stokes = stokes.translation;
    out.spin_drag_stokes = stokes.rotation;
    for (size_t k = 0; k < 3; ++k) {
        const double across = std::sqrt(g.extent[(k + 1) % 3] * g.extent[(k + 2) % 3]);
        out.spin_drag_layer[k] = spin_layer * compactness(g) * std::sqrt(across) * stokes.rotation[k];
    }
    out.intensity = plate.intensity;
    out.length = plate.correlation * std::max({g.extent[0], g.extent[1], g.extent[2]});
    out.wake_reynolds = plate.wake_reynolds;
    return out;
}

StationData default_station(const AerodynamicGeometry& part, const Wing& wing, const PlateCoefficients& plate) {
    AerodynamicGeometry g = part;
    g.edges = {1.0, 1.0, 1.0}; // parts of flat bodies; only their rims could be round
    StationData out;
    out.axes = g.axes;
    // Boundary layers run along the whole wing.
    AerodynamicGeometry in_wing = g;
    in_wing.extent[0] = std::max(g.extent[0], wing.chord);
    in_wing.extent[1] = std::max(g.extent[1], wing.span);
    for (size_t k = 0; k < 3; ++k) {
        set_drag(in_wing, k, 0.0, out);
        // Circulation about the span runs along the whole wing.
        out.spin_lift[k] = set_spin(g, k, k == 1 ? in_wing.extent[1] : g.extent[k], 0.0, plate, out).spin_lift;
    }
    out.plate_stall = {1.0, 1.0, 0.0};
    if (wing.span > 0.0 && wing.chord > 0.0 && wing.area > 0.0)
        set_normal_force({wing.chord, wing.span, 0.0}, wing.area, sheetness(g, 2) * g.area[2], 2, plate, out);
    return out;
}
} // namespace lr::shape
