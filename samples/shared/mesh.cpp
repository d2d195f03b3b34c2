// SPDX-License-Identifier: MIT
#include "mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <tuple>

#include "failure.h"
#include "vectors.h"

namespace {

struct Corner {
    std::size_t position;
    long uv; // -1: none
};

struct Surface {
    std::vector<Vector> positions;
    std::vector<std::array<double, 2>> uvs;
    std::vector<std::array<Corner, 3>> faces;
};

// A corner of a face: position, position/uv, position//normal or position/uv/normal; negative indices count from the end.
Corner parse_corner(const std::string& word, const Surface& surface) {
    std::istringstream stream(word);
    long position = 0, uv = 0;
    stream >> position;
    if (stream.get() == '/' && stream.peek() != '/') stream >> uv;
    const auto resolve = [](long index, std::size_t size) {
        return index < 0 ? static_cast<long>(size) + index : index - 1;
    };
    const long at = resolve(position, surface.positions.size());
    if (at < 0 || at >= static_cast<long>(surface.positions.size())) throw std::out_of_range("vertex " + word);
    const long texture = uv == 0 ? -1 : resolve(uv, surface.uvs.size());
    if (texture >= static_cast<long>(surface.uvs.size())) throw std::out_of_range("texture coordinate " + word);
    return {static_cast<std::size_t>(at), texture};
}

Surface read_obj(std::istream& file) {
    Surface surface;
    std::string line, word;
    while (std::getline(file, line)) {
        std::istringstream stream(line);
        if (!(stream >> word)) continue;
        if (word == "v") {
            Vector p{};
            if (!(stream >> p[0] >> p[1] >> p[2])) throw std::invalid_argument("line \"" + line + "\"");
            surface.positions.push_back(p);
        } else if (word == "vt") {
            std::array<double, 2> uv{};
            if (!(stream >> uv[0] >> uv[1])) throw std::invalid_argument("line \"" + line + "\"");
            surface.uvs.push_back(uv);
        } else if (word == "f") {
            std::vector<Corner> corners;
            while (stream >> word) corners.push_back(parse_corner(word, surface));
            for (std::size_t i = 2; i < corners.size(); ++i)
                surface.faces.push_back({corners[0], corners[i - 1], corners[i]});
        }
    }
    if (surface.faces.empty()) throw std::invalid_argument("it has no faces");
    return surface;
}

// Smooth, except over edges sharper than 60 degrees: otherwise normals at the rim of a leaf would point sideways.
Mesh with_normals(const Surface& surface) {
    std::vector<Vector> face_normals;
    std::vector<std::vector<std::size_t>> around(surface.positions.size());
    for (const auto& face : surface.faces) {
        const Vector& a = surface.positions[face[0].position];
        face_normals.push_back(
            cross(minus(surface.positions[face[1].position], a), minus(surface.positions[face[2].position], a)));
        for (const Corner& corner : face) around[corner.position].push_back(face_normals.size() - 1);
    }
    double low = surface.positions[0][0], high = low;
    for (const Vector& p : surface.positions) {
        low = std::min(low, p[0]);
        high = std::max(high, p[0]);
    }
    const double size = std::max(high - low, 1e-9);
    Mesh mesh;
    std::map<std::tuple<std::size_t, long, int, int, int>, std::uint32_t> known;
    for (std::size_t f = 0; f < surface.faces.size(); ++f) {
        for (const Corner& corner : surface.faces[f]) {
            Vector sum{};
            for (const std::size_t other : around[corner.position]) {
                if (dot(unit(face_normals[f]), unit(face_normals[other])) < 0.5) continue;
                for (std::size_t k = 0; k < 3; ++k) sum[k] += face_normals[other][k];
            }
            const Vector n = unit(sum), p = surface.positions[corner.position];
            const auto key =
                std::make_tuple(corner.position, corner.uv, static_cast<int>(std::lround(n[0] * 200)),
                                static_cast<int>(std::lround(n[1] * 200)), static_cast<int>(std::lround(n[2] * 200)));
            const auto [place, fresh] = known.try_emplace(key, static_cast<std::uint32_t>(mesh.vertices.size()));
            if (fresh) {
                Vertex vertex{};
                for (std::size_t k = 0; k < 3; ++k) {
                    vertex.position[k] = static_cast<float>(p[k]);
                    vertex.normal[k] = static_cast<float>(n[k]);
                }
                const bool has = corner.uv >= 0;
                const auto uv = has ? surface.uvs[static_cast<std::size_t>(corner.uv)]
                                    : std::array<double, 2>{(p[0] - low) / size, 0.5 + p[1] / size};
                vertex.uv[0] = static_cast<float>(uv[0]);
                vertex.uv[1] = static_cast<float>(uv[1]);
                mesh.vertices.push_back(vertex);
            }
            mesh.indices.push_back(place->second);
        }
    }
    return mesh;
}

} // namespace

float Mesh::radius() const {
    float squared = 0.0f;
    for (const Vertex& v : vertices) {
        squared = std::max(squared, v.position[0] * v.position[0] + v.position[1] * v.position[1] +
                                        v.position[2] * v.position[2]);
    }
    return std::sqrt(squared);
}

Mesh load_obj(const std::string& path, const lr_asset_info& info) {
    try {
        std::ifstream file(path);
        if (!file) throw std::invalid_argument("cannot open it");
        Surface surface = read_obj(file);
        for (Vector& p : surface.positions) {
            for (std::size_t k = 0; k < 3; ++k) p[k] -= info.center_of_mass[k];
        }
        return with_normals(surface);
    } catch (const std::logic_error& error) {
        throw Failure("mesh " + path + ": " + error.what(), "give --mesh a Wavefront OBJ");
    }
}

Mesh ellipse_card(const lr_asset_info& info) {
    // Semi-axes from the principal moments: I_x = m (b^2 + c^2) / 5, and cyclically.
    const double* i = info.inertia;
    const double half_trace = 0.5 * (i[0] + i[4] + i[8]);
    std::array<double, 3> axes{};
    for (std::size_t k = 0; k < 3; ++k) axes[k] = std::sqrt(std::max(0.0, 5.0 * (half_trace - i[4 * k]) / info.mass));
    const std::size_t thin = static_cast<std::size_t>(std::min_element(axes.begin(), axes.end()) - axes.begin());
    const std::size_t u = axes[(thin + 1) % 3] >= axes[(thin + 2) % 3] ? (thin + 1) % 3 : (thin + 2) % 3,
                      v = 3 - thin - u;
    const double turn = (u + 1) % 3 == v ? 1.0 : -1.0; // so that the normal is + thin axis
    constexpr std::uint32_t sides = 40;
    Mesh mesh;
    for (std::uint32_t k = 0; k <= sides; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / sides, reach = k == sides ? 0.0 : 1.0;
        const double x = reach * axes[u] * std::cos(angle), y = reach * turn * axes[v] * std::sin(angle);
        Vertex vertex{};
        vertex.position[u] = static_cast<float>(x);
        vertex.position[v] = static_cast<float>(y);
        vertex.normal[thin] = 1.0f;
        vertex.uv[0] = static_cast<float>(0.5 + 0.5 * x / axes[u]);
        vertex.uv[1] = static_cast<float>(0.5 + 0.5 * y / axes[u]);
        mesh.vertices.push_back(vertex);
        if (k < sides) mesh.indices.insert(mesh.indices.end(), {sides, k, (k + 1) % sides});
    }
    return mesh;
}

Mesh coarser(const Mesh& mesh, float cell) {
    struct Cell {
        std::uint32_t index;
        float squared;
    };
    std::map<std::array<long, 3>, Cell> cells;
    std::vector<std::uint32_t> moved;
    Mesh result;
    for (const Vertex& v : mesh.vertices) {
        const auto slot = [cell](float x) { return std::lround(x / cell); };
        // The farthest vertex represents its cell: a mean would shrink the outline.
        const float squared =
            v.position[0] * v.position[0] + v.position[1] * v.position[1] + v.position[2] * v.position[2];
        const auto [place, fresh] =
            cells.try_emplace({slot(v.position[0]), slot(v.position[1]), slot(v.position[2])},
                              Cell{static_cast<std::uint32_t>(result.vertices.size()), squared});
        if (fresh) {
            result.vertices.push_back(v);
        } else if (squared > place->second.squared) {
            place->second.squared = squared;
            result.vertices[place->second.index] = v;
        }
        moved.push_back(place->second.index);
    }
    std::set<std::array<std::uint32_t, 3>> known; // top and bottom of a sheet coincide: keep one
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::array<std::uint32_t, 3> face{moved[mesh.indices[i]], moved[mesh.indices[i + 1]],
                                                moved[mesh.indices[i + 2]]};
        auto sorted = face;
        std::sort(sorted.begin(), sorted.end());
        if (sorted[0] == sorted[1] || sorted[1] == sorted[2] || !known.insert(sorted).second) continue;
        result.indices.insert(result.indices.end(), face.begin(), face.end());
    }
    return result.indices.empty() ? mesh : result;
}
