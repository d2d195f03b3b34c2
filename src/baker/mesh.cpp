#include "baker/mesh.h"

#include "baker/obj_reader.h"
#include "baker/ply_reader.h"

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <Eigen/LU>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <numeric>

namespace lr::baker {
namespace {

constexpr uint64_t max_file_bytes = uint64_t{1} << 31;
constexpr std::size_t max_faces = 20'000'000;

void report(Faults& faults, FaultId id, Severity severity, std::string where, std::string what, std::string remedy) {
    faults.push_back({id, severity, std::move(where), std::move(what), std::move(remedy)});
}

std::string lower_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::filesystem::path to_path(const std::string& utf8) {
    return std::filesystem::path(std::u8string(utf8.begin(), utf8.end()));
}

bool read_bytes(const std::string& path_utf8, std::string& bytes, Faults& faults) {
    const std::filesystem::path path = to_path(path_utf8);
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        report(faults, FaultId::file_not_found, Severity::error, path_utf8, "There is no such file.",
               "Check the path and its spelling.");
        return false;
    }
    if (!std::filesystem::is_regular_file(status)) {
        report(faults, FaultId::file_read, Severity::error, path_utf8, "This is not a file.",
               "Give the path of a mesh file, not of a folder or a device.");
        return false;
    }
    const uintmax_t size = std::filesystem::file_size(path, error);
    if (!error && size > max_file_bytes) {
        report(faults, FaultId::file_too_large, Severity::error, path_utf8, "The file is larger than 2 GiB.",
               "Reduce the mesh before baking.");
        return false;
    }
    std::ifstream stream(path, std::ios::binary);
    if (!error && stream) {
        bytes.resize(static_cast<std::size_t>(size));
        stream.read(bytes.data(), static_cast<std::streamsize>(size));
    }
    if (error || !stream) {
        report(faults, FaultId::file_read, Severity::error, path_utf8, "The file cannot be read.",
               "Check that it may be read and that the disk is sound.");
        return false;
    }
    return true;
}

Eigen::Vector3d to_eigen(const aiVector3D& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

Eigen::Matrix4d to_eigen(const aiMatrix4x4& m) {
    Eigen::Matrix4d result;
    for (unsigned row = 0; row < 4; ++row)
        for (unsigned column = 0; column < 4; ++column)
            result(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
                static_cast<double>(m[row][column]);
    return result;
}

// Appends one instance of a mesh. A mirroring transform turns the faces over, so it is undone in their order.
void append_instance(const aiMesh& mesh, const Eigen::Matrix4d& transform, PolygonSoup& soup) {
    const auto base = static_cast<uint32_t>(soup.vertices.size());
    const bool mirrored = transform.topLeftCorner<3, 3>().determinant() < 0.0;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i)
        soup.vertices.emplace_back(transform.topLeftCorner<3, 3>() * to_eigen(mesh.mVertices[i]) +
                                   transform.topRightCorner<3, 1>());
    bool has_polygon = false;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices < 3) {
            ++soup.ignored_points;
            continue;
        }
        std::vector<uint32_t> polygon(face.mIndices, face.mIndices + face.mNumIndices);
        // An index beyond this mesh must stay beyond all of them.
        for (uint32_t& index : polygon) index = index < mesh.mNumVertices ? base + index : UINT32_MAX;
        if (mirrored) std::reverse(polygon.begin(), polygon.end());
        soup.polygons.push_back(std::move(polygon));
        has_polygon = true;
    }
    if (has_polygon) ++soup.parts;
}

void append_node(const aiScene& scene, const aiNode& node, const Eigen::Matrix4d& parent, int depth,
                 PolygonSoup& soup) {
    if (depth > 200 || soup.polygons.size() > max_faces) return;
    const Eigen::Matrix4d transform = parent * to_eigen(node.mTransformation);
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
        if (node.mMeshes[i] < scene.mNumMeshes) append_instance(*scene.mMeshes[node.mMeshes[i]], transform, soup);
    for (unsigned i = 0; i < node.mNumChildren; ++i) append_node(scene, *node.mChildren[i], transform, depth + 1, soup);
}

// No post-processing by assimp: its steps drop or reorder faces silently and trust indices.
bool read_with_assimp(const std::string& where, const std::string* path, const void* bytes, std::size_t size,
                      const std::string& extension, PolygonSoup& soup, Faults& faults) {
    const char* const remedy = "Export it again as OBJ, STL, PLY or glTF; check that the extension fits the content.";
    try {
        Assimp::Importer importer;
        importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
        const aiScene* scene =
            path ? importer.ReadFile(*path, 0) : importer.ReadFileFromMemory(bytes, size, 0, extension.c_str());
        if (!scene || !scene->mRootNode) {
            report(faults, FaultId::mesh_unreadable, Severity::error, where,
                   std::string("The file cannot be read as a mesh: ") + importer.GetErrorString(), remedy);
            return false;
        }
        append_node(*scene, *scene->mRootNode, Eigen::Matrix4d::Identity(), 0, soup);
        return true;
    } catch (const std::exception& error) {
        report(faults, FaultId::mesh_unreadable, Severity::error, where,
               std::string("The file cannot be read as a mesh: ") + error.what(), remedy);
        return false;
    }
}

bool finish(PolygonSoup& soup, bool joins_are_format, double unit_scale, const std::string& where, Mesh& out,
            Faults& faults) {
    if (soup.polygons.empty()) {
        report(faults, FaultId::mesh_empty, Severity::error, where, "The file holds no faces.",
               "Export the surface as triangles or polygons.");
        return false;
    }
    if (soup.polygons.size() > max_faces) {
        report(faults, FaultId::mesh_too_many_faces, Severity::error, where, "The mesh has more than 20 million faces.",
               "Reduce the mesh before baking.");
        return false;
    }
    for (std::size_t i = 0; i < soup.vertices.size(); ++i) {
        soup.vertices[i] *= unit_scale;
        if (soup.vertices[i].allFinite()) continue;
        report(faults, FaultId::mesh_not_finite, Severity::error, "vertex " + std::to_string(i),
               "A vertex position is not a finite number.", "Correct or delete this vertex.");
        return false;
    }
    if (!triangulate(soup, out, faults)) return false;
    if (soup.ignored_points > 0)
        report(faults, FaultId::mesh_empty, Severity::warning, where,
               std::to_string(soup.ignored_points) + " points or lines have no surface and were left out.",
               "Delete them to silence this.");
    if (soup.parts > 1)
        report(faults, FaultId::mesh_several_meshes, Severity::warning, where,
               std::to_string(soup.parts) + " objects were taken together as one body.",
               "Export one object per file if they are separate bodies.");
    const std::size_t joined = join_identical_vertices(out);
    if (joined > 0 && !joins_are_format)
        report(faults, FaultId::mesh_merged_vertices, Severity::warning, where,
               std::to_string(joined) + " vertices at exactly the same position as another were joined with it.",
               "Merge vertices by distance before export to silence this.");
    return true;
}

bool check_unit(double unit_scale, Faults& faults) {
    if (std::isfinite(unit_scale) && unit_scale > 0.0) return true;
    report(faults, FaultId::parameter_out_of_range, Severity::error, "unit",
           "The unit scale must be positive and finite.",
           "Use 1 for metres, 0.01 for centimetres, 0.001 for millimetres.");
    return false;
}

bool read_any(const std::string& where, const std::string* path, const void* bytes, std::size_t size,
              const std::string& extension, double unit_scale, Mesh& out, Faults& faults) {
    out.vertices.clear();
    out.faces.clear();
    if (!check_unit(unit_scale, faults)) return false;
    if (size == 0) {
        report(faults, FaultId::mesh_empty, Severity::error, where, "The file is empty.", "Export the mesh again.");
        return false;
    }
    PolygonSoup soup;
    try {
        const std::string_view text(static_cast<const char*>(bytes), size);
        bool read = false;
        if (extension == "obj")
            read = parse_obj(text, soup, faults);
        else if (extension == "ply")
            read = parse_ply(text, soup, faults);
        else
            read = read_with_assimp(where, path, bytes, size, extension, soup, faults);
        // STL repeats the corners of every triangle: joining them is reading, not repair.
        const bool joins_are_format = extension == "stl";
        return read && finish(soup, joins_are_format, unit_scale, where, out, faults);
    } catch (const std::bad_alloc&) {
        report(faults, FaultId::mesh_too_many_faces, Severity::error, where, "The mesh does not fit into memory.",
               "Reduce the mesh before baking.");
        return false;
    }
}

} // namespace

bool read_mesh(const std::string& path_utf8, double unit_scale, Mesh& out, Faults& faults) {
    std::string bytes;
    if (!read_bytes(path_utf8, bytes, faults)) return false;
    const std::filesystem::path path = to_path(path_utf8);
    const std::u8string extension_u8 = path.extension().u8string();
    std::string extension = lower_case(std::string(extension_u8.begin(), extension_u8.end()));
    if (!extension.empty()) extension.erase(0, 1);
    const std::u8string stem = path.stem().u8string();
    out.name.assign(stem.begin(), stem.end());
    return read_any(path_utf8, &path_utf8, bytes.data(), bytes.size(), extension, unit_scale, out, faults);
}

bool read_mesh_memory(const void* bytes, std::size_t size, const std::string& extension, double unit_scale, Mesh& out,
                      Faults& faults) {
    out.name = "memory";
    return read_any("memory", nullptr, bytes, bytes ? size : 0, lower_case(extension), unit_scale, out, faults);
}

std::size_t join_identical_vertices(Mesh& mesh) {
    const std::size_t n = mesh.vertices.size();
    std::vector<uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0U);
    // Comparison by value takes -0 and +0 as the same place.
    const auto compare = [&](uint32_t a, uint32_t b) {
        const Eigen::Vector3d &p = mesh.vertices[a], &q = mesh.vertices[b];
        for (int axis = 0; axis < 3; ++axis)
            if (p[axis] != q[axis]) return p[axis] < q[axis];
        return a < b;
    };
    std::sort(order.begin(), order.end(), compare);
    std::vector<uint32_t> first(n);
    for (std::size_t i = 0; i < n; ++i) {
        const bool same = i > 0 && mesh.vertices[order[i]] == mesh.vertices[order[i - 1]];
        first[order[i]] = same ? first[order[i - 1]] : order[i];
    }
    std::vector<uint32_t> renumbered(n);
    std::vector<Eigen::Vector3d> kept;
    for (std::size_t i = 0; i < n; ++i) {
        renumbered[i] = first[i] == i ? static_cast<uint32_t>(kept.size()) : renumbered[first[i]];
        if (first[i] == i) kept.push_back(mesh.vertices[i]);
    }
    for (Face& face : mesh.faces)
        for (uint32_t& index : face)
            if (index < n) index = renumbered[index];
    mesh.vertices = std::move(kept);
    return n - mesh.vertices.size();
}

} // namespace lr::baker
