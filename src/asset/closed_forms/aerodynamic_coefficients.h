// Quasi-steady coefficients of a body from the measures of its shape; docs/maintainers/physics.md, "AERODYNAMIC".
#pragma once

#include "asset/asset_data.h"

#include <array>

namespace lr::shape {

// Measures of a surface for the loads. n: outward unit normal; r: from the load centre; e_k: axes. Integrals run over the surface of a closed body,
// or over both sides of a sheet. Axes have no order: they are the body axes if these are principal, which saves a rotation.
struct AerodynamicGeometry {
    std::array<double, 9> axes{1, 0, 0, 0, 1, 0, 0, 0, 1}; // rows: principal axes, unit vectors in the body frame
    std::array<double, 3> extent{};                        // m, full, along the axes
    std::array<double, 3> area{};                          // m^2, silhouette along each axis
    std::array<double, 3> bluntness{}; // int |n.e_k|^2 dA / int |n.e_k| dA: 1 for flat faces, 2/3 for a sphere
    std::array<double, 3> edges{};     // share of the rim seen along each axis that is a sharp edge
    std::array<double, 3> center{};    // m, of the loads, from the centre of buoyancy, body frame
    double surface = 0.0;              // m^2, int dA
    double volume = 0.0;               // m^3, of the body
    // Strokes of a rotation about e_k, c = n.(e_k x r), the speed of the surface along its normal.
    std::array<double, 3> stroke2{}; // m^4, 1/2 int |c|^2 dA: a flat plate's second moment of area
    std::array<double, 3> stroke3{}; // m^5, 1/2 int |c|^3 dA: its third
    std::array<double, 3> rub{};     // m^5, int |e_k x r|^3 dA: scales skin friction against spin
};

// Loads and wake of a plate, for a disc and for long strips (docs/maintainers/physics.md, "Plates"). Fitted to measured falls of discs.
struct PlateCoefficients {
    double drag = 1.17;                  // C_D broadside
    double lift = 1.972, vortex = 2.872; // slope of the normal force; its part with the square of the incidence
    double stall = 0.6;                  // squared sine of the angle
    double separated_shedding = 0.8;     // share of the added momentum left in the wake
    double rotation = 1.121, rotation_span = 0.3327;         // C_R of a long strip; falls with chord over span
    double spin_disc = 0.8933, spin_strip = 2.5;             // C_M by span over chord
    double spin_stream = 1.192;                              // of stroke2
    double spin_stream_strip = 0.15, spin_stream_half = 0.5; // by span/chord - 1
    double start = 2.462;                                    // drag while the wake develops, over broadside drag
    double lag = 2.033, share = 0.7341;                      // of the wake's memory
    double strouhal = 0.159, growth = 0.3853, critical_reynolds = 96.35;
    double moment = 0.04745, rate_moment = -0.01302; // by shedding, of the area times the wake's length
    double noise = 4.3;                              // of shedding, over the intensity
    double intensity = 0.159, correlation = 0.9264;  // of gusts; in largest extents
    double wake_reynolds = 1600;
};

// The default coefficients: one set of rules for all shapes.
AerodynamicData default_aerodynamics(const AerodynamicGeometry& geometry, const PlateCoefficients& plate = {});

// The wing that a part belongs to, on which lift, stall and broadside drag depend.
struct Wing {
    double span = 0.0, chord = 0.0; // m, extents
    double area = 0.0;              // m^2
};

// The same rules for a part of a body alone, apart from its wing. Axes of the geometry: along the chord, along the span, the normal. Left at their
// defaults: creeping flow, which the caller shares between parts, place, added mass and camber.
StationData default_station(const AerodynamicGeometry& part, const Wing& wing, const PlateCoefficients& plate = {});
} // namespace lr::shape
