/*
 * The baker as a library: bakes assets as `lr_bake` does, for importers of editors and engines with meshes in memory.
 *
 * SPDX-License-Identifier: MIT
 *
 * A static library beside the runtime: find_package(langevin_rigid COMPONENTS baker), langevin_rigid::baker. C++17.
 *
 * How to use it: fill BakeOptions, call one of the bake_ functions, and check BakeResult. Then write its `asset` to an
 * .lrb file, or pass it to lr_asset_load_memory.
 *
 * Units        SI, except lengths of the mesh and fields marked "in `unit`".
 * Results      The bytes of an asset file: for the same input and options the same bytes as from lr_bake.
 * Errors       Numbered faults that say where, what, and how to fix it; docs/reference/asset_format.md lists them.
 *              Nothing throws, aborts or prints. Running out of memory is a fault; without memory even for that, the
 *              result has no faults.
 * Threads      Any number of threads may call any function at the same time. A call works on its caller's thread, and
 *              possibly on threads of its own that end before it returns.
 * Files        Only bake_file opens files, for reading.
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

// file: the unit that the mesh file states (Collada, FBX), else metres.
enum class Unit : std::int32_t { file, metre, centimetre, millimetre };

// The axis of the mesh that is rotated to +z; z rotates nothing.
enum class UpAxis : std::int32_t { x, y, z, minus_x, minus_y, minus_z };

// Treats the mesh as the middle surface of a sheet. It may be open or closed; winding does not matter.
struct BakeSheet {
    double thickness = 0.0;              // in `unit`
    std::optional<double> areal_density; // kg/m^2; default: density times thickness
};

// Cuts a card out by the alpha channel of a PNG image: the middle surface of a sheet. BakeOptions::sheet gives its
// thickness.
struct BakeCard {
    double width = 0.0;             // of the whole image, in `unit`
    double alpha = 0.5;             // opacity at the outline
    std::uint32_t triangles = 2000; // approximate number
    bool luminance = false;         // the image is a black-and-white mask
    std::uint32_t piece = 0;        // of several regions, the n-th by size; 0: the largest, with a warning
    bool all_pieces = false;        // bakes all regions as one body instead
    double speck = 1e-3;            // drops regions and holes below this fraction of the largest region
};

// A second mesh that gives the mass, while the first gives the surface. Unit and frame are those of the first. For a
// sheet it holds the layers: each face has the sheet's thickness and density, also where several coincide. Otherwise it
// holds the solid parts, of `density`.
struct BakeMass {
    std::string path;                   // a mesh file, UTF-8; for bake_file only
    std::vector<double> positions;      // for any function, if path is empty: as in bake_triangles
    std::vector<std::uint32_t> indices; // three per triangle
};

// The options of lr_bake under the same names. New fields are only ever appended.
struct BakeOptions {
    Unit unit = Unit::file; // of the mesh
    UpAxis up = UpAxis::z;
    std::string mesh;                                // bakes only the mesh, node or object of this name; empty: all
    double density = 800.0;                          // of the body, kg/m^3
    double fluid_density = 1.2;                      // kg/m^3; air
    double fluid_viscosity = 1.5e-5;                 // kinematic, m^2/s
    std::array<std::uint32_t, 3> grid{{32, 32, 16}}; // cells of the turbulence grid
    double intensity = 1.0;                          // of the turbulence; 1 is the paper's 100 %
    // For ballast: in `unit`, in the frame of the mesh after `up`. Default: that of the uniform body.
    std::optional<std::array<double, 3>> center_of_mass;
    std::string name;               // stored in the asset; empty: the file's, "mesh" or "ellipsoid"
    std::optional<BakeSheet> sheet; // the mesh is a sheet, not the boundary of a solid
    std::optional<BakeCard> card;   // the input is an image; not for triangles and ellipsoids
    bool wake = false;              // puts the body into the stream of the turbulence table
    std::optional<BakeMass> mass;   // for meshes; not with center_of_mass
    std::uint32_t stations = 8;     // at most; 1: loads as one plate, twice as fast
    bool strict = false;            // refuses meshes that are not closed, sound and one body, instead of repairing them
    double thickness = 0.0;         // of open parts without `sheet`, in `unit`; 0: 0.3 % of their typical length
    // Of a mesh: the largest side of its bounding box, in m. Scales the mesh, `mass` and center_of_mass from whatever unit
    // they are in; `unit` then only counts for the thickness of a sheet.
    std::optional<double> size;
    bool fill = false; // closes the holes of open parts, which then are solid; not with `sheet` or `strict`
};

struct BakeFault {
    std::uint32_t number = 0; // never changes meaning
    bool is_error = false;    // false: a warning. The bake continued with the change that it names
    std::string where, what, remedy;
};

// "error 206 at edge 3-17: The surface has a boundary edge. Close the hole or give the sheet a thickness."
std::string to_string(const BakeFault& fault);

enum class BakeStatus : std::int32_t { done, failed, cancelled };

struct BakeResult {
    BakeStatus status = BakeStatus::failed;
    std::vector<std::uint8_t> asset; // the bytes of an .lrb file; empty unless done
    std::string report;              // JSON, as from lr_bake --report; empty unless done
    std::vector<BakeFault> faults;   // warnings; at least one error if failed

    explicit operator bool() const { return status == BakeStatus::done; }
};

// Called on the bake's thread from time to time, with the current phase in English and the fraction done, 0 to 1, which
// never decreases. Return false to cancel: the bake soon ends with BakeStatus::cancelled. An exception cancels too.
using BakeProgress = std::function<bool(const char* phase, double fraction)>;

// Bakes a mesh file of any format that lr_bake reads, with the files that it refers to. path: UTF-8.
BakeResult bake_file(const std::string& path, const BakeOptions& options, const BakeProgress& progress = {}) noexcept;

// Bakes the bytes of such a file, which are not kept. Files that refer to other files need bake_file. file_name: UTF-8;
// its extension gives the format, its stem names the asset.
BakeResult bake_memory(const void* bytes, std::size_t size, const std::string& file_name, const BakeOptions& options,
                       const BakeProgress& progress = {}) noexcept;

// Bakes triangles: three coordinates per vertex, three indices per triangle, counter-clockwise from outside. Vertices
// at the same position, as at texture seams, are merged. The arrays are not kept; a pointer may be null if its count is
// 0.
BakeResult bake_triangles(const float* positions, std::size_t vertices, const std::uint32_t* indices,
                          std::size_t triangles, const BakeOptions& options,
                          const BakeProgress& progress = {}) noexcept;
BakeResult bake_triangles(const double* positions, std::size_t vertices, const std::uint32_t* indices,
                          std::size_t triangles, const BakeOptions& options,
                          const BakeProgress& progress = {}) noexcept;

// Bakes a solid ellipsoid from closed forms. semi_axes: in `unit`. Ignores `up`, `mesh`, `sheet`, `card` and `mass`.
BakeResult bake_ellipsoid(const std::array<double, 3>& semi_axes, const BakeOptions& options,
                          const BakeProgress& progress = {}) noexcept;

// Version of the baker, such as "0.2.0+1a2b3c4d". A cache of baked assets needs it in its key, with input and options.
const char* baker_version() noexcept;

} // namespace langevin_rigid

#endif
