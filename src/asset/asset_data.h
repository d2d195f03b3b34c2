// The contents of an asset file as plain data: written by the baker, read by the runtime.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace lr {

inline constexpr uint32_t asset_format_version = 2;

// Non-dimensional k-epsilon samples: t* = t u0/l, chi* = chi l/u0, epsilon* = epsilon l/u0^3.
struct TurbulenceData {
    double dt = 1.0;
    std::vector<double> chi;
    std::vector<double> epsilon;
    uint32_t stationary = 0;
    double c0 = 6.5;
    double intensity = 1.0;
    std::array<uint32_t, 3> cells{0, 0, 0};
    uint32_t loop_begin = 0, loop_end = 0; // samples [begin, end) repeat; equal: no loop
    bool wake = false;                     // made with the body in the stream
    bool settled = true;                   // stationary point or loop reached
    std::array<double, 3> domain{};        // of the grid, in d; zero: not known
    double max_divergence = 0.0;           // largest |div u| d/u0 left in the mean flow
};

// Its numbers, X(name, least, most).
#define LR_TURBULENCE_NUMBERS(X)                                                                                       \
    X(dt, 1e-9, 1e9)                                                                                                   \
    X(c0, 0.0, 100.0)                                                                                                  \
    X(intensity, 0.0, 100.0)                                                                                           \
    X(max_divergence, 0.0, 1e12)                                                                                       \
    X(stationary, 0, 65535) X(loop_begin, 0, 65536) X(loop_end, 0, 65536) X(wake, 0, 1) X(settled, 0, 1)

// Quasi-steady loads at scale 1 (docs/maintainers/physics.md section 5), about `center`, along `axes`. s: speed through the fluid; (i, j, k) cyclic.
struct AerodynamicData {
    std::array<double, 9> axes{1, 0, 0, 0, 1, 0, 0, 0, 1}; // rows: unit vectors in the body frame, right-handed
    // Drag opposes v_r: rho sum_i (v_i/s)^2 [1/2 (drag_i + drag_blunt_i Re/(Re + 8710)) s + layer_i sqrt(nu s) + stokes_i nu] v_r, Re = s d/nu.
    std::array<double, 3> drag{};        // m^2, C_D times area
    std::array<double, 3> drag_blunt{};  // m^2
    std::array<double, 3> drag_layer{};  // m^(3/2)
    std::array<double, 3> drag_stokes{}; // m
    // Lift rho Gamma x v_r, Gamma_k = spin_lift_k w_k - lift_k v_i v_j/s.
    std::array<double, 3> lift{};      // m^2, positive if j is the thinner direction
    std::array<double, 3> spin_lift{}; // m^3
    // Spin drag -rho [spin_drag_k |w| + spin_drag_stream_k s + spin_drag_layer_k sqrt(nu (s + |w| d/2)) + spin_drag_stokes_k nu] w_k.
    std::array<double, 3> spin_drag{};        // m^5
    std::array<double, 3> spin_drag_stream{}; // m^4
    std::array<double, 3> spin_drag_layer{};  // m^(7/2)
    std::array<double, 3> spin_drag_stokes{}; // m^3
    // A plate with its normal n along the largest broadside: docs/maintainers/physics.md, "Plates". One value for streams along each axis.
    std::array<double, 3> plate_lift{};    // m^2, slope of the attached normal force times area
    std::array<double, 3> plate_vortex{};  // m^2, part proportional to the square of the incidence
    std::array<double, 3> plate_stall{};   // squared sine of the stall angle
    double plate_separated_shedding = 0.0; // share of the added momentum along n that a separated stream sheds
    double plate_drag = 0.0;               // m^2, broadside
    double start_drag = 0.0;               // while the wake develops
    // The plate's wake: wake_length long, a memory of the stream wake_lag lengths ago. The lift's stream is wake_share of that memory.
    double wake_length = 1.0; // m
    double wake_lag = 1.0, wake_share = 0.0;
    // Vortex shedding, above a Reynolds number: frequency strouhal s/wake_length.
    double strouhal = 0.0, shedding_growth = 0.0, shedding_reynolds = 0.0, shedding_noise = 0.0;
    double shedding_moment = 0.0, shedding_rate_moment = 0.0; // m^3
    // Gusts: velocity of the fluid in the wake, per axis intensity times s Re/(Re + wake_reynolds) sum_i broadside_i (v_i/s)^2, correlated over
    // length/s. At Re below some 100s the wake is laminar.
    std::array<double, 3> broadside{};
    double intensity = 0.0;
    double wake_reynolds = 0.0;
    double length = 1.0;            // m
    std::array<double, 3> center{}; // m, from the centre of buoyancy, body frame

    bool operator==(const AerodynamicData&) const = default;
};

// Its vectors and numbers for loops, X(name, least, most, power): limits in units of d^power. Folded surfaces have many times the area of their
// silhouette.
#define LR_AERODYNAMIC_VECTORS(X)                                                                                      \
    X(drag, 0.0, 1e6, 2.0)                                                                                             \
    X(drag_blunt, 0.0, 1e6, 2.0)                                                                                       \
    X(drag_layer, 0.0, 1e6, 1.5)                                                                                       \
    X(drag_stokes, 0.0, 1e6, 1.0)                                                                                      \
    X(lift, -1e6, 1e6, 2.0)                                                                                            \
    X(spin_lift, -1e6, 1e6, 3.0)                                                                                       \
    X(spin_drag, 0.0, 1e6, 5.0)                                                                                        \
    X(spin_drag_stream, 0.0, 1e6, 4.0)                                                                                 \
    X(spin_drag_layer, 0.0, 1e6, 3.5)                                                                                  \
    X(spin_drag_stokes, 0.0, 1e6, 3.0)                                                                                 \
    X(broadside, 0.0, 1.0, 0.0)                                                                                        \
    X(plate_lift, 0.0, 1e6, 2.0)                                                                                       \
    X(plate_vortex, 0.0, 1e6, 2.0)                                                                                     \
    X(plate_stall, 0.0, 1.0, 0.0)                                                                                      \
    X(center, -2.0, 2.0, 1.0)
#define LR_AERODYNAMIC_NUMBERS(X)                                                                                      \
    X(intensity, 0.0, 10.0, 0.0)                                                                                       \
    X(length, 1e-9, 1e6, 0.0)                                                                                          \
    X(wake_reynolds, 0.0, 1e9, 0.0)                                                                                    \
    X(plate_separated_shedding, 0.0, 1.0, 0.0)                                                                         \
    X(plate_drag, 0.0, 1e6, 2.0)                                                                                       \
    X(start_drag, 0.0, 10.0, 0.0)                                                                                      \
    X(wake_length, 1e-9, 1e6, 0.0)                                                                                     \
    X(wake_lag, 1e-3, 1e6, 0.0)                                                                                        \
    X(wake_share, 0.0, 1.0, 0.0)                                                                                       \
    X(strouhal, 0.0, 10.0, 0.0)                                                                                        \
    X(shedding_growth, 0.0, 100.0, 0.0)                                                                                \
    X(shedding_reynolds, 0.0, 1e9, 0.0)                                                                                \
    X(shedding_noise, 0.0, 10.0, 0.0)                                                                                  \
    X(shedding_moment, -1e6, 1e6, 3.0)                                                                                 \
    X(shedding_rate_moment, -1e6, 1e6, 3.0)

// A part of a bent, pierced or long body that sees its own stream: docs/maintainers/physics.md, "Stations". Coefficients are those of AerodynamicData
// for the part alone, with the lift of its wing; they act at `place`, along `axes`.
struct StationData {
    // Rows: along the chord, along the span, the normal; body frame, right-handed.
    std::array<double, 9> axes{1, 0, 0, 0, 1, 0, 0, 0, 1};
    std::array<double, 3> place{};                      // m, from the centre of mass, body frame
    std::array<double, 3> drag{}, drag_blunt{};         // m^2
    std::array<double, 3> drag_layer{};                 // m^(3/2)
    std::array<double, 3> drag_stokes{};                // m
    std::array<double, 3> plate_lift{}, plate_vortex{}; // m^2, for streams along chord and span
    std::array<double, 3> plate_stall{};
    std::array<double, 3> spin_lift{};        // m^3
    std::array<double, 3> spin_drag{};        // m^5
    std::array<double, 3> spin_drag_stream{}; // m^4
    std::array<double, 3> spin_drag_stokes{}; // m^3
    double plate_drag = 0.0;                  // m^2
    // m, along chord and span: distance aft of `place` at which attached lift acts, besides Munk's moment.
    std::array<double, 3> lift_arm{};
    // m^3, part of the added mass along the normal whose momentum a separated stream leaves behind.
    double separated_shedding = 0.0;
    // Along chord, span and normal, towards the convex side of a bowl: a stream u has the normal force times 1 - hollow.u/|u|.
    std::array<double, 3> hollow{};
    double camber = 0.0; // minus the incidence of zero lift of a stream along the chord
};
inline constexpr size_t most_stations = 8;

// As those of AerodynamicData.
#define LR_STATION_VECTORS(X)                                                                                          \
    X(place, -2.0, 2.0, 1.0)                                                                                           \
    X(drag, 0.0, 1e6, 2.0)                                                                                             \
    X(drag_blunt, 0.0, 1e6, 2.0)                                                                                       \
    X(drag_layer, 0.0, 1e6, 1.5)                                                                                       \
    X(drag_stokes, 0.0, 1e6, 1.0)                                                                                      \
    X(plate_lift, 0.0, 1e6, 2.0)                                                                                       \
    X(plate_vortex, 0.0, 1e6, 2.0)                                                                                     \
    X(plate_stall, 0.0, 1.0, 0.0)                                                                                      \
    X(spin_lift, -1e6, 1e6, 3.0)                                                                                       \
    X(spin_drag, 0.0, 1e6, 5.0)                                                                                        \
    X(spin_drag_stream, 0.0, 1e6, 4.0)                                                                                 \
    X(spin_drag_stokes, 0.0, 1e6, 3.0)                                                                                 \
    X(lift_arm, -1.0, 1.0, 1.0)                                                                                        \
    X(hollow, -1.0, 1.0, 0.0)
#define LR_STATION_NUMBERS(X)                                                                                          \
    X(plate_drag, 0.0, 1e6, 2.0)                                                                                       \
    X(separated_shedding, 0.0, 100.0, 3.0)                                                                             \
    X(camber, -1.0, 1.0, 0.0)

// Null if a body of any size can have these loads, else the reason, which lasts until the thread's next one.
const char* wrong_in(const AerodynamicData& loads);

struct HullData {
    std::vector<float> vertices;     // m, body frame, 3 a vertex
    std::vector<uint32_t> triangles; // 3 a triangle
};

struct ProvenanceData {
    std::string tool;
    std::string tool_version;
    std::string source;
    uint64_t input_hash = 0;
    std::string options;
    uint32_t faces = 0;
    uint32_t vertices = 0;
};

struct AssetData {
    std::string name;
    double mass = 0.0;                                     // kg
    double volume = 0.0;                                   // m^3
    double density = 0.0;                                  // kg/m^3
    std::array<double, 3> center_of_mass{};                // m, mesh frame
    std::array<double, 3> center_of_buoyancy{};            // m, from the centre of mass
    std::array<double, 9> inertia{};                       // kg m^2, row-major
    std::array<double, 36> added_mass{};                   // fluid density 1, row-major, order vx vy vz wx wy wz
    std::array<double, 36> added_mass_error{};             // same units; zero: unknown
    double fluid_density = 0.0;                            // kg/m^3
    double fluid_viscosity = 0.0;                          // m^2/s
    double length_d = 0.0, length_b = 0.0, length_l = 0.0; // m
    double projected_area = 0.0;                           // m^2
    double u0 = 0.0;                                       // m/s
    TurbulenceData turbulence;
    AerodynamicData aerodynamics;
    std::vector<StationData> stations; // two or more, instead of the loads of `aerodynamics`; or none
    HullData hull;
    ProvenanceData provenance;

    double reynolds() const { return u0 * length_d / fluid_viscosity; }
};
} // namespace lr
