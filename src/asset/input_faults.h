// Numbered faults of a mesh, an asset file or a parameter: the place, the problem and the remedy.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace lr {

enum class Severity : int32_t { warning = 1, error = 2 };

// Numbers are stable across releases; see docs/reference/asset_format.md. Never reuse one.
enum class FaultId : uint32_t {
    // 1xx: the file could not be read or written
    file_not_found = 101,
    file_read = 102,
    file_write = 103,
    file_too_large = 104,
    file_outside = 105,
    // 2xx: the mesh
    mesh_unreadable = 201,
    mesh_empty = 202,
    mesh_not_finite = 203,
    mesh_bad_index = 204,
    mesh_degenerate_face = 205,
    mesh_open_edge = 206,
    mesh_non_manifold_edge = 207,
    mesh_inconsistent_winding = 208,
    mesh_inside_out = 209,
    mesh_zero_volume = 210,
    mesh_too_many_faces = 211,
    mesh_duplicate_face = 212,
    mesh_isolated_vertex = 213,
    mesh_several_components = 214,
    mesh_merged_vertices = 215,
    mesh_several_meshes = 216,
    mesh_ill_conditioned = 217,
    mesh_turned_or_scaled = 218,
    // 22x: the image of a card
    image_unreadable = 221,
    image_no_outline = 222,
    image_several_pieces = 223,
    image_specks = 224,
    image_too_ragged = 225,
    // 226: the mesh again
    mesh_self_intersection = 226,
    // 3xx: a parameter of the bake
    parameter_out_of_range = 301,
    parameter_unknown = 302,
    parameter_not_denser = 303,
    parameter_implausible = 304,
    wake_unsettled = 310,
    loads_uncertain = 311,
    // 4xx: the asset file
    asset_too_short = 401,
    asset_foreign = 402,
    asset_newer_version = 403,
    asset_corrupt = 404,
    asset_checksum = 405,
    asset_missing_field = 406,
    asset_wrong_length = 407,
    asset_not_finite = 408,
    asset_out_of_range = 409,
    asset_not_symmetric = 410,
    asset_not_positive = 411,
    asset_bad_hull = 412,
    asset_inconsistent = 413,
    asset_bad_axes = 414,
    asset_open_hull = 415,
    asset_hull_not_convex = 416,
};

struct Fault {
    FaultId id;
    Severity severity;
    std::string where;  // file, face, vertex, field: as narrow as known
    std::string what;   // one sentence
    std::string remedy; // one sentence, an instruction
};

using Faults = std::vector<Fault>;

// Adds an error. Returns false.
inline bool fail(Faults& faults, FaultId id, std::string where, std::string what,
                 std::string remedy = "Bake the asset again.") {
    faults.push_back({id, Severity::error, std::move(where), std::move(what), std::move(remedy)});
    return false;
}

// The fewest digits that read back as the same number, in any locale. std::to_chars() of doubles came late to the libraries of Apple and Emscripten.
inline std::string shortest(double value) {
    char buffer[32] = {};
    for (int digits : {15, 16, 17}) {
        std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
        if (std::strtod(buffer, nullptr) == value) break;
    }
    std::string text;
    for (const char* c = buffer; *c != 0; ++c) // replaces the locale's decimal point, of one or more bytes
        if (std::strchr("+-0123456789einfa", *c))
            text += *c;
        else if (text.back() != '.')
            text += '.';
    return text;
}
} // namespace lr
