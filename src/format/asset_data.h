// What an asset file says, as plain data: the one thing that the baker makes and the runtime reads.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace lr {

inline constexpr uint32_t asset_format_version = 1;

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
    std::array<double, 36> added_mass_error{};             // same units; zero where unknown
    double fluid_density = 0.0;                            // kg/m^3
    double fluid_viscosity = 0.0;                          // m^2/s
    double length_d = 0.0, length_b = 0.0, length_l = 0.0; // m
    double projected_area = 0.0;                           // m^2
    double u0 = 0.0;                                       // m/s
    TurbulenceData turbulence;
    HullData hull;
    ProvenanceData provenance;

    double reynolds() const { return u0 * length_d / fluid_viscosity; }
};

} // namespace lr
