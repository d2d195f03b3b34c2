/*
 * The baker in process: what `lr_bake` does, for the importers of editors and engines, which have their meshes in memory.
 *
 * SPDX-License-Identifier: MIT
 *
 * A static library beside the runtime: find_package(langevin_rigid COMPONENTS baker), langevin_rigid::baker. C++17.
 *
 * Units        SI, except lengths of the mesh and those marked "in `unit`".
 * Results      The bytes of an asset file, for lr_asset_load_memory or to be written as they are: the same bytes, for the
 *              same input and options, as those of lr_bake.
 * Errors       Numbered faults that say where, what, and what to do; docs/reference/asset_format.md lists them. Nothing throws, aborts or
 *              prints. Out of memory is a fault (or, if there is not even memory for that, a result without faults).
 * Threads      Every function may be called by any number of threads at once. Each works in its caller's thread, and
 *              possibly in more that it ends before it returns.
 * Files        Only bake_file opens any, to read.
 */
#ifndef LANGEVIN_RIGID_BAKER_HPP
#define LANGEVIN_RIGID_BAKER_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace langevin_rigid {

// file: what the mesh says about itself (Collada, FBX), else metres.
enum class Unit : std::int32_t { file, metre, centimetre, millimetre };

// The axis of the mesh that is turned to +z; z turns nothing.
enum class UpAxis : std::int32_t { x, y, z, minus_x, minus_y, minus_z };

// The mesh is the middle surface of a sheet: open or closed, wound in any way.
struct BakeSheet {
    double thickness = 0.0;              // in `unit`
    std::optional<double> areal_density; // kg/m^2; without it, `density` times the thickness
};

// What the alpha channel of a PNG image leaves of a card is the middle surface of a sheet, which gives its thickness.
struct BakeCard {
    double width = 0.0;             // of the whole image, in `unit`
    double alpha = 0.5;             // the outline runs where the opacity has this value
    std::uint32_t triangles = 2000; // about as many
    bool luminance = false;         // the image is a black-and-white mask
    std::uint32_t piece = 0;        // of several regions the n-th by size; 0: the largest, and a warning
    bool all_pieces = false;        // instead, all as one body
    double speck = 1e-3;            // regions and holes below this part of the largest region are left out
};

// A second mesh that has the mass, as the first has the surface; unit and frame are the same. Of a sheet it is the layers,
// each face as thick and heavy as the sheet is said to be, however many lie in one place; else the solid parts, of
// `density`.
struct BakeMass {
    std::string path;                   // UTF-8, a mesh file: for bake_file
    std::vector<double> positions;      // for all, without a path: as those of bake_triangles
    std::vector<std::uint32_t> indices; // three for each triangle
};

// As the options of the same names of lr_bake. New ones are only ever appended.
struct BakeOptions {
    Unit unit = Unit::file; // of the mesh
    UpAxis up = UpAxis::z;
    std::string mesh;                                // only the mesh, node or object of this name; empty: all
    double density = 800.0;                          // of the body, kg/m^3
    double fluid_density = 1.2;                      // kg/m^3; air
    double fluid_viscosity = 1.5e-5;                 // kinematic, m^2/s
    std::array<std::uint32_t, 3> grid{{32, 32, 16}}; // cells of the turbulence grid
    double intensity = 1.0;                          // of the turbulence; 1 is the paper's 100 %
    // For a ballasted body: in `unit`, frame of the mesh after `up`. Without it that of the uniform body.
    std::optional<std::array<double, 3>> center_of_mass;
    std::string name;               // in the asset; empty: that of the file, "mesh" or "ellipsoid"
    std::optional<BakeSheet> sheet; // instead of the boundary of a solid
    std::optional<BakeCard> card;   // file or bytes are an image; not for triangles and ellipsoids
    bool wake = false;              // put the body into the stream of the turbulence table
    std::optional<BakeMass> mass;   // of meshes; not with center_of_mass
};

struct BakeFault {
    std::uint32_t number = 0; // stable
    bool is_error = false;    // else a warning: done, with the change named
    std::string where, what, remedy;
};

// "error 206 at edge 3-17: The surface has a boundary edge. Close the hole or give the sheet a thickness."
std::string to_string(const BakeFault& fault);

enum class BakeStatus : std::int32_t { done, failed, cancelled };

struct BakeResult {
    BakeStatus status = BakeStatus::failed;
    std::vector<std::uint8_t> asset; // the bytes of an .lrb file; empty unless done
    std::string report;              // JSON, as of lr_bake --report; empty unless done
    std::vector<BakeFault> faults;   // warnings, and when failed at least one error

    explicit operator bool() const { return status == BakeStatus::done; }
};

// Called in the thread of the bake, now and then, with a phase in English and the part of the whole that is done (0 to 1,
// never falling). False cancels: the bake ends soon after with BakeStatus::cancelled. An exception out of it cancels too.
using BakeProgress = std::function<bool(const char* phase, double fraction)>;

// A mesh file of any format that lr_bake reads, and the files that it refers to. path: UTF-8.
BakeResult bake_file(const std::string& path, const BakeOptions& options, const BakeProgress& progress = {}) noexcept;

// The bytes of such a file. file_name: UTF-8; its extension says what format they have, and its stem names the asset.
// Files that refer to others cannot be baked so. The bytes are not kept.
BakeResult bake_memory(const void* bytes, std::size_t size, const std::string& file_name, const BakeOptions& options,
                       const BakeProgress& progress = {}) noexcept;

// Triangles: three coordinates for each vertex, three indices for each triangle, counter-clockwise from outside. Vertices at
// one place, as at seams of texture coordinates, are one. The arrays are not kept. Pointers may be null where their count is
// zero.
BakeResult bake_triangles(const float* positions, std::size_t vertices, const std::uint32_t* indices,
                          std::size_t triangles, const BakeOptions& options,
                          const BakeProgress& progress = {}) noexcept;
BakeResult bake_triangles(const double* positions, std::size_t vertices, const std::uint32_t* indices,
                          std::size_t triangles, const BakeOptions& options,
                          const BakeProgress& progress = {}) noexcept;

// A solid ellipsoid, from closed forms. semi_axes: in `unit`. `up`, `mesh`, `sheet`, `card` and `mass` are not used.
BakeResult bake_ellipsoid(const std::array<double, 3>& semi_axes, const BakeOptions& options,
                          const BakeProgress& progress = {}) noexcept;

// "0.1.0+1a2b3c4d": what a cache of baked assets should have in its key beside the input and the options.
const char* baker_version() noexcept;

} // namespace langevin_rigid

#endif
