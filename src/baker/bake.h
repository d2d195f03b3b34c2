// Bakes an asset from a mesh file, an image or three semi-axes.
#pragma once

#include "asset/asset_data.h"
#include "asset/input_faults.h"
#include "baker/card/card.h"
#include "baker/mesh/mesh.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lr::baker {

// file: the unit stated in the mesh file (Collada, FBX), else m.
enum class Unit { m, cm, mm, file };

double units_per_metre(Unit unit);
const char* unit_name(Unit unit);

// A mesh in memory: three coordinates per vertex, three indices per triangle.
struct MeshArrays {
    std::span<const double> positions;
    std::span<const uint32_t> indices;
};

// The thickness is default_thickness times a typical extent of the sheet's parts.
constexpr double choose_thickness = -1.0;

// The mesh is the middle surface of a sheet.
struct SheetOptions {
    double thickness = choose_thickness; // in `unit`
    std::optional<double> areal_density; // kg/m^2; without it, `density` times the thickness
};

// 0.24 mm for a leaf of 8 cm.
constexpr double default_thickness = 0.003;

// A second mesh that gives the mass. For a sheet: its layers, each face with the sheet's thickness and density, also where several coincide.
// Otherwise: solid parts of `density`.
struct MassOptions {
    std::string path;                 // UTF-8
    std::optional<MeshArrays> arrays; // instead of a path
};

struct BakeOptions {
    // A mesh file, or an ellipsoid if semi_axes is set.
    std::string mesh_path;                          // UTF-8
    std::optional<std::array<double, 3>> semi_axes; // in `unit`
    Unit unit = Unit::file; // of the mesh and of all lengths here; with `file` the lengths are in m
    // Of a mesh: largest side of its bounding box, in m. Scales the mesh, the mass mesh and center_of_mass; not the thickness.
    std::optional<double> size;
    UpAxis up = UpAxis::z;             // axis of the mesh that becomes +z
    std::optional<std::string> mesh;   // bake only the objects of this name
    std::optional<SheetOptions> sheet; // the mesh is a sheet, not the boundary of a solid
    std::optional<double> thickness;   // of open parts, without `sheet`, in `unit`; by default as in SheetOptions
    bool strict = false; // refuse anything but one clean solid (or sheet), instead of repairing it (find_parts)
    bool fill = false;   // close holes of open parts, which become solids; not with `sheet` or `strict`
    std::optional<CardOptions> card;           // the sheet is a card: mesh_path is an image, its width in `unit`
    double density = 800.0;                    // kg/m^3; leaf, paper
    double fluid_density = 1.2;                // kg/m^3; air
    double fluid_viscosity = 1.5e-5;           // m^2/s
    std::array<uint32_t, 3> cells{32, 32, 16}; // of the turbulence grid
    double intensity = 1.0;                    // of the turbulence in k0 = 3/2 (I U0)^2
    bool wake = false;                         // put the body into the stream of the turbulence table
    uint32_t stations = most_stations;         // at most; 1: the loads of a whole body
    // Centre of mass of a ballasted body, in `unit` and the frame of the mesh (after `up`); default: the centroid. The inertia stays that of the
    // uniform solid about its centroid; everything else is about this point.
    std::optional<std::array<double, 3>> center_of_mass;
    std::optional<MassOptions> mass; // meshes only, in the unit and frame of the mesh; excludes center_of_mass
    std::optional<std::string> name; // default: the file name without its extension
    // Contents used instead of the mesh file. mesh_path then gives only the name of the source and, for bytes, their format.
    std::optional<std::span<const uint8_t>> mesh_bytes;
    std::optional<MeshArrays> mesh_arrays;
};

// The options that affect the result, in a unique form of the command line.
std::string canonical_options(const BakeOptions& options);

using BakeTimings = std::vector<std::pair<std::string, double>>; // phase, s
// Called with 0 at the start of a phase and with 1 at its end.
using BakeProgress = std::function<void(const char* phase, double fraction)>;

// Difference of the loads from those of many stations: root mean square over streams and spins, the larger of forces and moments. Zero without
// comparison, for a flat compact plate and a thick body.
struct StationErrors {
    double with_stations = 0.0, without = 0.0;
};

struct BakeHooks {
    // Receives the repaired surface in the body frame; for an ellipsoid, a mesh of it.
    Mesh* body = nullptr;
    StationErrors* station_errors = nullptr;
    // Called with the number of faces before large allocations; can block.
    std::function<void(std::size_t faces)> before_solve;
    unsigned threads = 0; // of the solver for large meshes; 0: one per processor
};

// Deterministic. False if `faults` received an error; repairs are warnings.
bool bake(const BakeOptions& options, AssetData& out, Faults& faults, BakeTimings* timings = nullptr,
          const BakeProgress& progress = {}, const BakeHooks& hooks = {});

// The input_hash, name and source that a bake with these options would write now. No hash if the input cannot be read.
std::optional<uint64_t> find_input_hash(const BakeOptions& options);
std::string asset_name(const BakeOptions& options);
std::string source_name(const BakeOptions& options);

// "0.2.0+1a2b3c4d": the release and a hash of the sources that affect results.
const char* baker_version();
} // namespace lr::baker
