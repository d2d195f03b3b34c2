// Triangle meshes and how they are read from a file.
#pragma once

#include "asset/input_faults.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lr::baker {

class InputFiles;

using Face = std::array<uint32_t, 3>;

// Positions in metres, faces counter-clockwise seen from outside.
struct Mesh {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<Face> faces;
    std::string name;
};

// The axis of the file that is to become +z.
enum class UpAxis { x, y, z, minus_x, minus_y, minus_z };

// The smallest rotation that turns the axis to +z: about x for +-y, about y for +-x, half a turn about x for -z.
Eigen::Matrix3d up_rotation(UpAxis up);

// "-y"
const char* up_name(UpAxis up);

struct MeshReadOptions {
    // Metres in a unit of the file (0.01 for centimetres), whatever the file says about that. Nothing: what the file
    // says (Collada, FBX), else metres.
    std::optional<double> unit_scale;
    UpAxis up = UpAxis::z; // as authored
    // Only the objects of this name (of a mesh, a node or a node above it), instead of all as one.
    std::optional<std::string> mesh;
    std::size_t max_faces = 20'000'000; // fault 211, as soon as the file is parsed
};

// Two vertices closer than this part of the mesh's largest extent are one.
constexpr double join_tolerance = 1e-7;

// True if files with this extension say what their unit is.
bool declares_unit(const std::string& path_utf8);

// Reads any format assimp knows. OBJ and PLY have readers of our own: double precision, faults with line numbers, and
// no endless loop on damaged files, as assimp 5.2 has for PLY.
// Node transforms are applied, polygons triangulated, vertices at one place joined. What was changed is reported as
// warnings; false and an error fault if unusable. `files`, if given, is what was read: the file and those that it refers
// to.
bool read_mesh(const std::string& path_utf8, const MeshReadOptions& options, Mesh& out, Faults& faults,
               InputFiles* files = nullptr);
bool read_mesh(const std::string& path_utf8, double unit_scale, Mesh& out, Faults& faults);

// The same from memory. extension: "obj", "stl", ... without the dot; files that refer to other files cannot be read
// so.
bool read_mesh_memory(const void* bytes, std::size_t size, const std::string& extension, const MeshReadOptions& options,
                      Mesh& out, Faults& faults);
bool read_mesh_memory(const void* bytes, std::size_t size, const std::string& extension, double unit_scale, Mesh& out,
                      Faults& faults);

// The same from arrays in memory, as a program has them: three coordinates a vertex, three indices a triangle.
bool read_mesh_arrays(std::span<const double> positions, std::span<const uint32_t> indices,
                      const MeshReadOptions& options, Mesh& out, Faults& faults);

// Joins vertices at exactly the same position; the first of each group stays, order is kept. Returns how many went.
// Positions must be finite.
std::size_t join_identical_vertices(Mesh& mesh);

// The same for vertices within `tolerance` times the largest extent of the bounding box, and for chains of them.
std::size_t join_near_vertices(Mesh& mesh, double tolerance);

} // namespace lr::baker
