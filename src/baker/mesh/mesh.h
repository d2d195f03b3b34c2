// Triangle meshes and their readers.
#pragma once

#include "asset/input_faults.h"
#include "baker/mesh/mesh_source.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
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
    std::shared_ptr<MeshSource> source = nullptr; // for messages; shared by copies; null: made by the baker
};

// The axis of the file that becomes +z.
enum class UpAxis { x, y, z, minus_x, minus_y, minus_z };

// The smallest rotation that turns the axis to +z: about x for +-y, about y for +-x, half a turn about x for -z.
Eigen::Matrix3d up_rotation(UpAxis up);

// "-y"
const char* up_name(UpAxis up);

struct MeshReadOptions {
    // The file's unit in metres (0.01 for centimetres); replaces the unit that the file states. Nothing: the stated unit (Collada,
    // FBX), else metres.
    std::optional<double> unit_scale;
    UpAxis up = UpAxis::z; // z: no rotation
    // Read only the objects with this name (of a mesh, its node or a parent node) instead of all.
    std::optional<std::string> mesh;
    bool repair = false;                // leave out faces without a position, instead of a fault
    std::size_t max_faces = 20'000'000; // more: fault 211 right after parsing
};

// Vertices closer than this fraction of the mesh's largest extent are joined.
constexpr double join_tolerance = 1e-7;

// Whether files with this extension state their unit.
bool declares_unit(const std::string& path_utf8);

// Of the bounding box of all faces, m; zero without faces.
Eigen::Vector3d box_sides(const Mesh& mesh);

// Reads any format of assimp. OBJ, PLY and OFF have readers of our own: double precision, line numbers in faults, no endless loop
// on damaged files as in assimp 5.2 for PLY. Applies node transforms, triangulates polygons, joins coincident vertices. Changes
// are warnings; false and an error if the mesh is unusable. files: if given, receives the file and the files that it
// refers to, which must lie in its folder or below.
bool read_mesh(const std::string& path_utf8, const MeshReadOptions& options, Mesh& out, Faults& faults,
               InputFiles* files = nullptr);
bool read_mesh(const std::string& path_utf8, double unit_scale, Mesh& out, Faults& faults);

// The same from memory. extension: "obj", "stl", ... without the dot. Cannot read meshes that refer to other files.
bool read_mesh_memory(const void* bytes, std::size_t size, const std::string& extension, const MeshReadOptions& options,
                      Mesh& out, Faults& faults);
bool read_mesh_memory(const void* bytes, std::size_t size, const std::string& extension, double unit_scale, Mesh& out,
                      Faults& faults);

// The same from arrays in memory: three coordinates per vertex, three indices per triangle.
bool read_mesh_arrays(std::span<const double> positions, std::span<const uint32_t> indices,
                      const MeshReadOptions& options, Mesh& out, Faults& faults);

// Joins vertices with the same position; the first of each group stays, the order is kept. Returns the number of removed
// vertices. Positions must be finite.
std::size_t join_identical_vertices(Mesh& mesh);

// The same for vertices closer than `tolerance` times the largest extent of the bounding box, and for chains of them.
std::size_t join_near_vertices(Mesh& mesh, double tolerance);
} // namespace lr::baker
