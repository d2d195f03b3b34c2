// The whole bake: from a mesh file or three semi-axes to an asset.
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

// file: what a mesh file says about itself (Collada, FBX), else m.
enum class Unit { m, cm, mm, file };

double units_per_metre(Unit unit);
const char* unit_name(Unit unit);

// As programs have them: three coordinates a vertex, three indices a triangle.
struct MeshArrays {
    std::span<const double> positions;
    std::span<const uint32_t> indices;
};

// The mesh is the middle surface of a sheet.
struct SheetOptions {
    double thickness = 0.0;              // in `unit`
    std::optional<double> areal_density; // kg/m^2; without it, `density` times the thickness
};

// A second mesh that has the mass, as the first has the surface: of a sheet its layers, each face as thick and heavy as the
// sheet is said to be, however many lie in one place; else the solid parts, of `density`.
struct MassOptions {
    std::string path;                 // UTF-8
    std::optional<MeshArrays> arrays; // instead
};

struct BakeOptions {
    // Either a mesh file, or an ellipsoid when there are semi-axes.
    std::string mesh_path;                          // UTF-8
    std::optional<std::array<double, 3>> semi_axes; // in `unit`
    Unit unit = Unit::file;                         // of the mesh and of every length here, which `file` leaves in m
    UpAxis up = UpAxis::z;                          // axis of the mesh that becomes +z
    std::optional<std::string> mesh;                // only what has this name in the file
    std::optional<SheetOptions> sheet;              // instead of the boundary of a solid
    std::optional<CardOptions> card;                // of a sheet: mesh_path is an image, its width in `unit`
    double density = 800.0;                         // kg/m^3; leaf, paper
    double fluid_density = 1.2;                     // kg/m^3; air
    double fluid_viscosity = 1.5e-5;                // m^2/s
    std::array<uint32_t, 3> cells{32, 32, 16};      // of the turbulence grid
    double intensity = 1.0;                         // of the turbulence in k0 = 3/2 (I U0)^2
    bool wake = false;                              // put the body into the stream of the turbulence table
    // In `unit`, frame of the mesh (turned by `up`). A ballasted body: the inertia stays that of the uniform solid about its own
    // centroid, everything else is about this point. Without it the centre is that of the uniform solid.
    std::optional<std::array<double, 3>> center_of_mass;
    std::optional<MassOptions> mass; // of meshes; unit and frame are those of the mesh. Not with center_of_mass
    std::optional<std::string> name; // instead of the file name without its extension
    // Instead of the mesh file, whose name then only says what the source is called and, for bytes, what format they have.
    std::optional<std::span<const uint8_t>> mesh_bytes;
    std::optional<MeshArrays> mesh_arrays;
};

// The options that change the result, written as on the command line, in one way only.
std::string canonical_options(const BakeOptions& options);

using BakeTimings = std::vector<std::pair<std::string, double>>; // phase, s
// Called with 0 when a phase begins and with 1 when it ends.
using BakeProgress = std::function<void(const char* phase, double fraction)>;

struct BakeHooks {
    // Receives the surface in the body frame: repaired, and for an ellipsoid sampled.
    Mesh* body = nullptr;
    // Called before what takes memory, with the number of faces; it may wait.
    std::function<void(std::size_t faces)> before_solve;
    unsigned threads = 0; // of the solver for large meshes; 0: as many as the machine runs at once
};

// The same bytes and options give the same asset. False when `faults` received an error; repairs are warnings.
bool bake(const BakeOptions& options, AssetData& out, Faults& faults, BakeTimings* timings = nullptr,
          const BakeProgress& progress = {}, const BakeHooks& hooks = {});

// The input_hash that a bake with these options would put into the asset now, without baking; and the name and source.
// Nothing if the input cannot be read.
std::optional<uint64_t> find_input_hash(const BakeOptions& options);
std::string asset_name(const BakeOptions& options);
std::string source_name(const BakeOptions& options);

// "0.1.0+1a2b3c4d": the release, and a hash of the sources that results depend on.
const char* baker_version();

} // namespace lr::baker
