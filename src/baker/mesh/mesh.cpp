#include "baker/mesh/mesh.h"

#include "baker/fault_text.h"
#include "baker/file_faults.h"
#include "baker/mesh/assimp_reader.h"
#include "baker/mesh/collada_check.h"
#include "baker/mesh/gltf_file.h"
#include "baker/mesh/input_files.h"
#include "baker/mesh/obj_reader.h"
#include "baker/mesh/off_reader.h"
#include "baker/mesh/ply_reader.h"
#include "baker/mesh/stl_reader.h"
#include "baker/mesh/threemf_reader.h"
#include "baker/mesh/unknown_file.h"
#include "baker/printable_text.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <new>
#include <set>
#include <string_view>

namespace lr::baker {

const char* up_name(UpAxis up) {
    const char* const names[] = {"x", "y", "z", "-x", "-y", "-z"};
    return names[static_cast<std::size_t>(up)];
}

namespace {

void report(Faults& faults, FaultId id, Severity severity, std::string where, std::string what, std::string remedy) {
    faults.push_back({id, severity, std::move(where), std::move(what), std::move(remedy)});
}

std::string lower_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::string all_names(const std::vector<std::string>& names) {
    const std::string text = list_names(names, 20);
    return text.empty() ? "objects without names" : text;
}

std::string object_name(const SoupPart& part) {
    for (const std::string& name : part.own_names)
        if (!name.empty()) return name;
    return {};
}

bool has_name(const SoupPart& part, const std::string& name) {
    const auto among = [&](const std::vector<std::string>& names) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    return among(part.own_names) || among(part.group_names);
}

bool has_name(const PolygonSoup& soup, const std::string& name) {
    return std::any_of(soup.parts.begin(), soup.parts.end(), [&](const SoupPart& p) { return has_name(p, name); });
}

// Keeps the wanted parts, and removes vertices that only other parts use. Returns the names of the other parts.
std::vector<std::string> keep_parts(PolygonSoup& soup, const std::function<bool(const SoupPart&)>& wanted) {
    enum : uint8_t { unused, dropped, kept };
    std::vector<uint8_t> use(soup.vertices.size(), unused);
    std::vector<std::vector<uint32_t>> polygons;
    std::vector<SoupPart> parts;
    std::vector<std::string> left_out;
    for (std::size_t i = 0; i < soup.parts.size(); ++i) {
        SoupPart& part = soup.parts[i];
        const std::size_t end = i + 1 < soup.parts.size() ? soup.parts[i + 1].first_polygon : soup.polygons.size();
        const bool keep = wanted(part);
        const std::size_t first = polygons.size();
        for (std::size_t k = part.first_polygon; k < end; ++k) {
            for (const uint32_t v : soup.polygons[k])
                if (v < use.size()) use[v] = std::max<uint8_t>(use[v], keep ? kept : dropped);
            if (keep) polygons.push_back(std::move(soup.polygons[k]));
        }
        if (keep) {
            part.first_polygon = first;
            parts.push_back(std::move(part));
        } else {
            left_out.push_back(object_name(part));
        }
    }
    std::vector<uint32_t> renumbered(soup.vertices.size(), UINT32_MAX);
    std::size_t n = 0;
    for (std::size_t i = 0; i < soup.vertices.size(); ++i)
        if (use[i] != dropped) {
            renumbered[i] = static_cast<uint32_t>(n);
            soup.vertices[n++] = soup.vertices[i];
        }
    soup.vertices.resize(n);
    for (std::vector<uint32_t>& polygon : polygons)
        for (uint32_t& v : polygon) v = v < renumbered.size() ? renumbered[v] : v;
    soup.polygons = std::move(polygons);
    soup.parts = std::move(parts);
    return left_out;
}

bool select(PolygonSoup& soup, const std::string& name, const std::string& where, Faults& faults) {
    if (!has_name(soup, name)) {
        std::vector<std::string> names;
        for (const SoupPart& part : soup.parts) names.insert(names.end(), part.own_names.begin(), part.own_names.end());
        report(faults, FaultId::parameter_unknown, Severity::error, "mesh",
               "The file has no mesh, node or object named '" + printable(name) + "'.",
               "It has: " + all_names(names) + ".");
        return false;
    }
    const std::vector<std::string> left_out = keep_parts(soup, [&](const SoupPart& p) { return has_name(p, name); });
    if (!left_out.empty())
        report(faults, FaultId::mesh_several_meshes, Severity::warning, where,
               "Only '" + printable(name) + "' was baked; ignored: " + all_names(left_out) + ".",
               "None needed if intended; without --mesh all form one body.");
    return true;
}

// Engines hide some objects by name: levels of detail, "oak_LOD1" coarser than "oak_LOD0" or "oak", and collision shapes, "UCX_oak" (Unreal) and
// "oak-colonly" (Godot). Blender ends copies with ".001".
struct EngineName {
    bool collision = false;
    std::string stem; // name without the level of detail
    int level = -1;
};

EngineName engine_name(std::string name) {
    EngineName out;
    const auto is_digit = [&](std::size_t i) { return i < name.size() && name[i] >= '0' && name[i] <= '9'; };
    const std::size_t copy = name.find_last_not_of("0123456789");
    if (copy != std::string::npos && name[copy] == '.') name.resize(copy);
    const std::string small = lower_case(name);
    for (const char* prefix : {"ucx_", "ubx_", "usp_", "ucp_", "mcdcx_"}) out.collision |= small.starts_with(prefix);
    for (const char* ending : {"colonly", "_collision", "_collider"}) out.collision |= small.ends_with(ending);
    out.stem = small;
    for (std::size_t at = small.find("lod"); at != std::string::npos; at = small.find("lod", at + 1)) {
        const auto is_letter = [&](std::size_t i) { return i < small.size() && small[i] >= 'a' && small[i] <= 'z'; };
        std::size_t digit = at + 3;
        if (digit < name.size() && !is_digit(digit) && !is_letter(digit)) ++digit; // LOD_0
        const std::size_t end = digit + 1 + is_digit(digit + 1);
        const bool begins_word = at == 0 || !is_letter(at - 1) || (name[at] == 'L' && name[at - 1] == small[at - 1]);
        if (!begins_word || !is_digit(digit) || is_digit(end) || is_letter(end)) continue;
        out.level = std::stoi(name.substr(digit, end - digit));
        const std::string before = small.substr(0, at);
        out.stem = before.substr(0, before.find_last_not_of(" _-.") + 1) + small.substr(end);
        break;
    }
    return out;
}

void drop_engine_copies(PolygonSoup& soup, const std::string& where, Faults& faults) {
    std::map<std::string, int> finest;
    const auto note = [&](const std::string& stem, int level) {
        int& least = finest.try_emplace(stem, level).first->second;
        least = std::min(least, level);
    };
    for (const SoupPart& part : soup.parts) {
        bool has_level = false;
        for (const auto* names : {&part.own_names, &part.group_names})
            for (const std::string& name : *names)
                if (const EngineName e = engine_name(name); e.level >= 0) {
                    note(e.stem, e.level);
                    has_level = true;
                }
        for (const std::string& name : part.own_names)
            if (!has_level && !name.empty()) note(engine_name(name).stem, 0);
    }
    const auto seen = [&](const SoupPart& part) {
        for (const auto* names : {&part.own_names, &part.group_names})
            for (const std::string& name : *names)
                if (const EngineName e = engine_name(name); e.collision || (e.level >= 0 && e.level > finest[e.stem]))
                    return false;
        return true;
    };
    if (std::none_of(soup.parts.begin(), soup.parts.end(), seen) ||
        std::all_of(soup.parts.begin(), soup.parts.end(), seen))
        return;
    const std::vector<std::string> left_out = keep_parts(soup, seen);
    report(faults, FaultId::mesh_several_meshes, Severity::warning, where,
           "Left out as coarser levels of detail or collision shapes: " + all_names(left_out) + ".",
           "None needed; --mesh bakes one of them.");
}

std::string largest_object(const PolygonSoup& soup) {
    const SoupPart* largest = nullptr;
    std::size_t most = 0;
    for (std::size_t i = 0; i < soup.parts.size(); ++i) {
        const std::size_t end = i + 1 < soup.parts.size() ? soup.parts[i + 1].first_polygon : soup.polygons.size();
        if (end - soup.parts[i].first_polygon <= most) continue;
        most = end - soup.parts[i].first_polygon;
        largest = &soup.parts[i];
    }
    const std::string name = largest ? object_name(*largest) : std::string();
    return name.empty() ? "no object has a name"
                        : "the largest object is '" + printable(name) + "' with " + std::to_string(most);
}

void report_several(const PolygonSoup& soup, const std::string& where, Faults& faults) {
    std::set<std::size_t> objects;
    std::vector<std::string> names;
    for (const SoupPart& part : soup.parts) {
        objects.insert(part.object);
        names.push_back(object_name(part));
    }
    if (objects.size() > 1)
        report(faults, FaultId::mesh_several_meshes, Severity::warning, where,
               std::to_string(objects.size()) + " objects were baked as one body: " + all_names(names) + ".",
               "Choose one with --mesh if they are separate bodies.");
}

// The unit of the positions in metres.
double scale_of(const PolygonSoup& soup, const MeshReadOptions& options, const std::string& where, Faults& faults) {
    const double declared = soup.declared_unit;
    if (!options.unit_scale) {
        if (declared > 0.0 && declared != 1.0)
            report(faults, FaultId::mesh_turned_or_scaled, Severity::warning, where,
                   "The file's unit is " + shortest(declared) + " m; positions were scaled to metres by this factor.",
                   "Give --unit if the file states the wrong unit.");
        return declared > 0.0 ? declared : 1.0;
    }
    if (declared > 0.0 && std::abs(declared - *options.unit_scale) > 1e-6 * declared)
        report(faults, FaultId::mesh_turned_or_scaled, Severity::warning, where,
               "The file's unit is " + shortest(declared) + " m; --unit replaced it.",
               "Omit --unit if the file states the right unit.");
    return *options.unit_scale;
}

// Removes vertices without a finite position, and the polygons that use them.
void drop_not_finite(PolygonSoup& soup, const std::string& where, Faults& faults) {
    std::vector<uint32_t> renumbered(soup.vertices.size(), UINT32_MAX);
    std::size_t n = 0;
    for (std::size_t i = 0; i < soup.vertices.size(); ++i)
        if (soup.vertices[i].allFinite()) {
            renumbered[i] = static_cast<uint32_t>(n);
            soup.vertices[n++] = soup.vertices[i];
        }
    if (n == soup.vertices.size()) return;
    const std::size_t vertices = soup.vertices.size() - n, before = soup.polygons.size();
    soup.vertices.resize(n);
    std::size_t kept = 0, part = 0;
    for (std::size_t i = 0; i < before; ++i) {
        for (; part < soup.parts.size() && soup.parts[part].first_polygon <= i; ++part)
            soup.parts[part].first_polygon = kept;
        bool finite = true;
        for (uint32_t& v : soup.polygons[i]) {
            if (v >= renumbered.size()) continue; // refused later
            v = renumbered[v];
            finite = finite && v != UINT32_MAX;
        }
        if (finite) std::swap(soup.polygons[kept++], soup.polygons[i]);
    }
    soup.polygons.resize(kept);
    report(faults, FaultId::mesh_not_finite, Severity::warning, where,
           counted(vertices, "vertex has no position", "vertices have no position") + " (not a number, or infinite); " +
               counted(before - kept, "face there was left out.", "faces there were left out."),
           "Delete these vertices and fill the hole, if it matters.");
}

// Formats whose importers deliver corner by corner, and whose exporters duplicate vertices for each normal and texture coordinate: joining those is
// part of reading and needs no warning.
bool repeats_corners(const std::string& extension) {
    const std::string_view by_corner[] = {"", "stl", "dae", "fbx", "3mf", "gltf", "glb"};
    return std::find(std::begin(by_corner), std::end(by_corner), extension) != std::end(by_corner);
}

bool finish(PolygonSoup& soup, const std::string& extension, const MeshReadOptions& options, const std::string& where,
            Mesh& out, Faults& faults) {
    if (soup.polygons.empty()) {
        const std::string points = std::to_string(std::max(soup.vertices.size(), soup.ignored_points));
        report(faults, FaultId::mesh_empty, Severity::error, where,
               soup.vertices.empty()
                   ? "The file has no polygons."
                   : "The file has " + points + " points, lines or curves, but no polygons between them.",
               "Convert curves, surfaces and instances to a mesh (Blender: Object, Convert, Mesh), select it, and "
               "export it "
               "again.");
        return false;
    }
    if (options.mesh && !select(soup, *options.mesh, where, faults)) return false;
    if (!options.mesh && options.repair) drop_engine_copies(soup, where, faults);
    if (soup.polygons.size() > options.max_faces) {
        report(faults, FaultId::mesh_too_many_faces, Severity::error, where,
               "The mesh has " + std::to_string(soup.polygons.size()) + " faces, more than " +
                   std::to_string(options.max_faces) + "; " + largest_object(soup) + ".",
               "Reduce it before baking (decimate), or leave parts out with --mesh.");
        return false;
    }
    if (options.repair) drop_not_finite(soup, where, faults);
    if (soup.polygons.empty()) {
        report(faults, FaultId::mesh_not_finite, Severity::error, where,
               "Each face has a vertex whose position is not a finite number.", "Export the file again.");
        return false;
    }
    const double unit_scale = scale_of(soup, options, where, faults);
    const Eigen::Matrix3d rotation = up_rotation(options.up);
    for (std::size_t i = 0; i < soup.vertices.size(); ++i) {
        soup.vertices[i] *= unit_scale;
        if (options.up != UpAxis::z) soup.vertices[i] = rotation * soup.vertices[i];
        if (soup.vertices[i].allFinite()) continue;
        report(faults, FaultId::mesh_not_finite, Severity::error, "vertex " + std::to_string(i),
               "A vertex position is not a finite number.", "Correct or delete this vertex.");
        return false;
    }
    if (options.up != UpAxis::z)
        report(faults, FaultId::mesh_turned_or_scaled, Severity::warning, where,
               std::string("The mesh was turned: its ") + up_name(options.up) + " axis is now +z.",
               "None needed if intended.");
    std::vector<std::size_t> first_face;
    if (!triangulate(soup, out, first_face, faults)) return false;
    std::vector<MeshSource::Part> parts;
    for (std::size_t i = 0; i < soup.parts.size(); ++i)
        parts.push_back({first_face[i], object_name(soup.parts[i]), soup.parts[i].material});
    out.source = std::make_shared<MeshSource>(out, std::move(parts), unit_scale, rotation);
    if (soup.ignored_points > 0)
        report(faults, FaultId::mesh_empty, Severity::warning, where,
               std::to_string(soup.ignored_points) + " points or lines have no surface and were ignored.",
               "Delete them to silence this.");
    report_several(soup, where, faults);
    const std::size_t joined = join_identical_vertices(out);
    if (joined > 0 && !repeats_corners(extension))
        report(faults, FaultId::mesh_merged_vertices, Severity::warning, where,
               counted(joined, "vertex", "vertices") + " with the same position as another vertex were joined with it.",
               "Merge vertices by distance before export to silence this.");
    const std::size_t near_joined = join_near_vertices(out, join_tolerance);
    if (near_joined > 0)
        report(faults, FaultId::mesh_merged_vertices, Severity::warning, where,
               std::to_string(near_joined) + " vertices within " + shortest(join_tolerance) +
                   " of the mesh's extent of another vertex were joined with it.",
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

bool read_any(SceneFile file, const MeshReadOptions& options, Mesh& out, Faults& faults) {
    out.vertices.clear();
    out.faces.clear();
    if (!check_unit(options.unit_scale.value_or(1.0), faults)) return false;
    if (file.size == 0) {
        report(faults, FaultId::mesh_empty, Severity::error, file.where, "The file is empty.",
               "Export the mesh again.");
        return false;
    }
    PolygonSoup soup;
    try {
        const std::string_view text(static_cast<const char*>(file.bytes), file.size);
        std::string storage;
        bool read = false;
        if (is_placeholder(text)) {
            report(faults, FaultId::mesh_unreadable, Severity::error, file.where,
                   "This is a placeholder of Git LFS, not the model itself.", "Fetch the model: git lfs pull.");
        } else if (file.extension == "obj") {
            read = parse_obj(as_utf8(text, storage), soup, faults);
        } else if (file.extension == "ply") {
            read = parse_ply(as_utf8(text, storage), soup, faults);
        } else if (file.extension == "off") {
            read = parse_off(as_utf8(text, storage), soup, faults);
        } else if (file.extension == "stl" && is_text_stl(as_utf8(text, storage))) {
            read = parse_stl(as_utf8(text, storage), soup, faults);
        } else if (file.extension == "3mf") {
            read = read_3mf(file.bytes, file.size, file.where, soup, faults);
        } else if (file.extension == "zae") {
            report(faults, FaultId::mesh_unreadable, Severity::error, file.where, "This is packed Collada.",
                   "Unpack it (it is a zip archive) and bake the .dae inside.");
        } else if (const std::string_view extension = unread_gltf_extension(text); !extension.empty()) {
            report(faults, FaultId::mesh_unreadable, Severity::error, file.where,
                   "Its mesh is packed (" + std::string(extension) + "), which is not read here.",
                   "Export it again without this compression (Draco is read), or unpack it: gltfpack -noq -i "
                   "packed.glb -o "
                   "model.glb.");
        } else {
            if (is_collada(text)) file.extension = "dae"; // assimp recognises Collada with any extension
            read = (file.extension != "dae" || check_collada(text, faults)) && read_with_assimp(file, soup, faults);
            if (read && options.mesh && file.extension == "dae" && !has_name(soup, *options.mesh)) {
                PolygonSoup by_id;
                file.collada_ids = true;
                Faults ignored;
                if (read_with_assimp(file, by_id, ignored) && has_name(by_id, *options.mesh)) soup = std::move(by_id);
            }
        }
        return read && finish(soup, file.extension, options, file.where, out, faults);
    } catch (const std::bad_alloc&) {
        report(faults, FaultId::mesh_too_many_faces, Severity::error, file.where, "The mesh does not fit into memory.",
               "Reduce the mesh before baking.");
        return false;
    }
}

std::string extension_of(const std::string& path_utf8) {
    const std::u8string text = to_path(path_utf8).extension().u8string();
    std::string extension = lower_case(std::string(text.begin(), text.end()));
    if (!extension.empty()) extension.erase(0, 1);
    return extension;
}

MeshReadOptions only_scale(double unit_scale) {
    MeshReadOptions options;
    options.unit_scale = unit_scale;
    return options;
}
} // namespace

Eigen::Vector3d box_sides(const Mesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Face& f : mesh.faces)
        for (const uint32_t i : f) box.extend(mesh.vertices[i]);
    return box.isEmpty() ? Eigen::Vector3d(0.0, 0.0, 0.0) : Eigen::Vector3d(box.sizes());
}

Eigen::Matrix3d up_rotation(UpAxis up) {
    Eigen::Matrix3d r;
    switch (up) {
    case UpAxis::x:
        r << 0, 0, -1, 0, 1, 0, 1, 0, 0;
        return r;
    case UpAxis::y:
        r << 1, 0, 0, 0, 0, -1, 0, 1, 0;
        return r;
    case UpAxis::minus_x:
        r << 0, 0, 1, 0, 1, 0, -1, 0, 0;
        return r;
    case UpAxis::minus_y:
        r << 1, 0, 0, 0, 0, 1, 0, -1, 0;
        return r;
    case UpAxis::minus_z:
        r << 1, 0, 0, 0, -1, 0, 0, 0, -1;
        return r;
    case UpAxis::z:
        break;
    }
    return Eigen::Matrix3d::Identity();
}

bool declares_unit(const std::string& path_utf8) {
    const std::string extension = extension_of(path_utf8);
    return extension == "dae" || extension == "fbx" || extension == "3mf";
}

bool read_mesh(const std::string& path_utf8, const MeshReadOptions& options, Mesh& out, Faults& faults,
               InputFiles* files) {
    InputFiles own;
    if (!files) files = &own;
    const std::shared_ptr<const InputFiles::Bytes> bytes = files->read(path_utf8, &faults);
    if (!bytes) return false;
    const std::u8string stem = to_path(path_utf8).stem().u8string();
    out.name.assign(stem.begin(), stem.end());
    const bool good = read_any({path_utf8, &path_utf8, files, bytes->data(), bytes->size(), extension_of(path_utf8)},
                               options, out, faults);
    files->forget_bytes();
    return good;
}

bool read_mesh(const std::string& path_utf8, double unit_scale, Mesh& out, Faults& faults) {
    return read_mesh(path_utf8, only_scale(unit_scale), out, faults);
}

bool read_mesh_memory(const void* bytes, std::size_t size, const std::string& extension, const MeshReadOptions& options,
                      Mesh& out, Faults& faults) {
    out.name = "memory";
    return read_any({"memory", nullptr, nullptr, bytes, bytes ? size : 0, lower_case(extension)}, options, out, faults);
}

bool read_mesh_memory(const void* bytes, std::size_t size, const std::string& extension, double unit_scale, Mesh& out,
                      Faults& faults) {
    return read_mesh_memory(bytes, size, extension, only_scale(unit_scale), out, faults);
}

bool read_mesh_arrays(std::span<const double> positions, std::span<const uint32_t> indices,
                      const MeshReadOptions& options, Mesh& out, Faults& faults) {
    const std::string where = "arrays";
    out = {};
    if (!check_unit(options.unit_scale.value_or(1.0), faults)) return false;
    if (positions.size() % 3 != 0 || indices.size() % 3 != 0 || positions.size() / 3 >= UINT32_MAX) {
        report(faults, FaultId::mesh_bad_index, Severity::error, where,
               "The number of coordinates or indices is not a multiple of three.", "Check the lengths of both arrays.");
        return false;
    }
    try {
        PolygonSoup soup;
        soup.vertices.reserve(positions.size() / 3);
        for (std::size_t i = 0; i < positions.size(); i += 3)
            soup.vertices.emplace_back(positions[i], positions[i + 1], positions[i + 2]);
        soup.polygons.reserve(indices.size() / 3);
        for (std::size_t i = 0; i < indices.size(); i += 3)
            soup.polygons.push_back({indices[i], indices[i + 1], indices[i + 2]});
        return finish(soup, "", options, where, out, faults);
    } catch (const std::bad_alloc&) {
        report(faults, FaultId::mesh_too_many_faces, Severity::error, where, "The mesh does not fit into memory.",
               "Reduce the mesh before baking.");
        return false;
    }
}
} // namespace lr::baker
