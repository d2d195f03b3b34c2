// Triangle meshes and how they are read from a file.
#pragma once

#include "format/fault.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace lr::baker {

using Face = std::array<uint32_t, 3>;

// Positions in metres, faces counter-clockwise seen from outside.
struct Mesh {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<Face> faces;
    std::string name;
};

// Reads any format assimp knows. OBJ and PLY have readers of our own: double precision, faults with line numbers, and
// no endless loop on damaged files, as assimp 5.2 has for PLY.
// Positions are multiplied by unit_scale (0.01 for centimetres); node transforms are applied, polygons triangulated,
// exactly equal positions joined. What was changed is reported as warnings; false and an error fault if unusable.
bool read_mesh(const std::string& path_utf8, double unit_scale, Mesh& out, Faults& faults);

// The same from memory. extension: "obj", "stl", ... without the dot; files that refer to other files cannot be read
// so.
bool read_mesh_memory(const void* bytes, std::size_t size, const std::string& extension, double unit_scale, Mesh& out,
                      Faults& faults);

// Joins vertices at exactly the same position; the first of each group stays, order is kept. Returns how many went.
// Positions must be finite.
std::size_t join_identical_vertices(Mesh& mesh);

} // namespace lr::baker
