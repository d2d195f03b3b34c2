// Quasi-steady coefficients of a body from the measures of its shape; docs/maintainers/physics.md, "AERODYNAMIC".
#pragma once

#include "asset/asset_data.h"

#include <array>

namespace lr::shape {

// The measures of a surface that the loads need. n: outward unit normal; r: from the load centre; e_k: axes. Integrals run over the surface of a
// closed body, or over both sides of a sheet. Axes have no order: they are the body axes if these are principal, so that nothing needs a rotation.
struct AerodynamicGeometry {
    std::array<double, 9> axes{1, 0, 0, 0, 1, 0, 0, 0, 1}; // rows: principal axes, unit vectors in the body frame
    std::array<double, 3> extent{};                        // m, full, along the axes
    std::array<double, 3> area{};                          // m^2, silhouette along each axis
    std::array<double, 3> bluntness{}; // int |n.e_k|^2 dA / int |n.e_k| dA: 1 for flat faces, 2/3 for a sphere
    std::array<double, 3> center{};    // m, of the loads, from the centre of buoyancy, body frame
    double surface = 0.0;              // m^2, int dA
    double volume = 0.0;               // m^3, of the body
    // Strokes of a rotation about e_k, c = n.(e_k x r), the speed of the surface along its normal.
    std::array<double, 3> stroke2{}; // m^4, 1/2 int |c|^2 dA: a flat plate's second moment of area
    std::array<double, 3> stroke3{}; // m^5, 1/2 int |c|^3 dA: its third
    std::array<double, 3> rub{};     // m^5, int |e_k x r|^3 dA: scales skin friction against spin
};

// Additions of thin plates in free flight, from measured falls of discs (docs/maintainers/physics.md, "Plates in free flight"); else 0.
struct PlateCoefficients {
    double unsteady_disc = 2.536, unsteady_strip = 1.8; // drag broadside over that in a steady stream
    double edge_drag = 0.317, edge_strip = 0.6;         // C_D of the planform, edge on
    double lift_span = 1.68;                            // lift falls as r/(r + this), r span over chord
    double rotation = 1.1, rotation_span = 0.3327;      // C_R of a long strip; falls likewise
    double stall = -0.393;
    double moment = 0.0392, moment_stalled = 0.072; // of the planform times the chord
    double spin_disc = 1.076, spin_strip = 2.5;     // C_M by span over chord
    double spin_stream = 0.0152;                    // of stroke2
    double roll = 0.56;                             // damping of roll, of stroke2, for equal span and chord
    double spin_creeping = 0.3;                     // of the creeping couple
    double intensity = 0.0505, correlation = 0.48;  // of the wake; in largest extents
    double wake_reynolds = 600;
};

// The default coefficients: one set of rules for all shapes.
AerodynamicData default_aerodynamics(const AerodynamicGeometry& geometry, const PlateCoefficients& plate = {});
} // namespace lr::shape
