#include "baker/added_mass/sheet_coarsening.h"

#include "baker/added_mass/near_panels.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>

namespace lr::baker {

Mesh merge_cells(const Mesh& mesh, double cell) {
    constexpr double narrowest = 1e-4; // height over longest side of a face
    struct Members {
        uint32_t number;
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        double count = 0.0;
    };
    std::map<std::array<int64_t, 3>, Members> cells;
    std::vector<uint32_t> number;
    number.reserve(mesh.vertices.size());
    for (const Eigen::Vector3d& v : mesh.vertices) {
        std::array<int64_t, 3> key{};
        for (std::size_t k = 0; k < 3; ++k)
            key[k] = static_cast<int64_t>(std::floor(v[static_cast<Eigen::Index>(k)] / cell));
        Members& members = cells.try_emplace(key, Members{static_cast<uint32_t>(cells.size())}).first->second;
        members.sum += v;
        members.count += 1.0;
        number.push_back(members.number);
    }
    std::vector<Eigen::Vector3d> middle(cells.size());
    for (const auto& [key, members] : cells) middle[members.number] = members.sum / members.count;

    Mesh out;
    out.name = mesh.name;
    std::set<Face> seen;
    std::vector<uint32_t> used(middle.size(), UINT32_MAX);
    for (const Face& f : mesh.faces) {
        Face face{number[f[0]], number[f[1]], number[f[2]]};
        if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) continue;
        const Eigen::Vector3d &a = middle[face[0]], &b = middle[face[1]], &c = middle[face[2]];
        const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
        if (!((b - a).cross(c - a).norm() > narrowest * longest)) continue;
        Face sorted = face;
        std::sort(sorted.begin(), sorted.end());
        if (!seen.insert(sorted).second) continue;
        for (uint32_t& v : face) {
            if (used[v] == UINT32_MAX) {
                used[v] = static_cast<uint32_t>(out.vertices.size());
                out.vertices.push_back(middle[v]);
            }
            v = used[v];
        }
        out.faces.push_back(face);
    }
    return out;
}

bool is_cheap_sheet(const Mesh& mesh) {
    // Five times those of a regular mesh, and for small meshes some seconds.
    const std::size_t most_pairs = std::max<std::size_t>(4000000, 60 * mesh.faces.size());
    const double most_points = std::max(1.5e8, 1500.0 * static_cast<double>(mesh.faces.size())); // of all quadratures
    constexpr std::array<double, 3> points{12.0, 48.0, 192.0}; // of dunavant_rule, by level
    constexpr double points_apart = 6.0;
    std::vector<Panel> panels;
    panels.reserve(mesh.faces.size());
    for (const Face& f : mesh.faces)
        panels.push_back(make_panel(mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]]));
    std::vector<std::vector<NearPair>> pairs;
    std::vector<std::size_t> level;
    if (!find_near_panels(panels, most_pairs, pairs, level)) return false;
    double sum = 0.0;
    for (std::size_t t = 0; t < pairs.size(); ++t)
        for (const NearPair& pair : pairs[t]) sum += pair.touching || level[t] > 0 ? points[level[t]] : points_apart;
    return sum <= most_points;
}
} // namespace lr::baker
