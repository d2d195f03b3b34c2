#include "baker/added_mass/curved_refinement.h"

#include "baker/added_mass/mesh_edge.h"
#include "baker/added_mass/quad_diagonal.h"
#include "baker/added_mass/surface_correction.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace lr::baker {
namespace {

// Largest distance of a midpoint from its edge, over the edge's length: a limit for rough meshes.
constexpr double max_sagitta = 0.15;

// Midpoints of the edges to be split.
class EdgeMidpoints {
public:
    EdgeMidpoints(const Mesh& mesh, double turn) {
        const std::vector<std::array<CornerNormal, 3>> normals = corner_normals(mesh);
        struct Side {
            std::size_t face, corner;
        };
        std::vector<FaceBends> bends;
        for (std::size_t t = 0; t < mesh.faces.size(); ++t) bends.push_back(bends_of(mesh, mesh.faces[t], normals[t]));
        std::map<Edge, Side> seen;
        for (std::size_t t = 0; t < mesh.faces.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const uint32_t a = mesh.faces[t][k], b = mesh.faces[t][(k + 1) % 3];
                const auto [first, fresh] = seen.try_emplace(make_edge(a, b), Side{t, k});
                if (fresh) continue;
                const Eigen::Vector3d along = mesh.vertices[b] - mesh.vertices[a];
                Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero();
                Eigen::Vector3d right = Eigen::Vector3d::Zero();
                double largest = 0.0;
                const auto add = [&](std::size_t face, std::size_t corner) {
                    const Eigen::Vector3d normal =
                        (normals[face][corner].round + normals[face][(corner + 1) % 3].round).normalized();
                    const double change = bends[face].used[corner];
                    largest = std::max(largest, std::abs(change));
                    normal_matrix += normal * normal.transpose();
                    right += normal * change / 8.0;
                };
                add(t, k);
                add(first->second.face, first->second.corner);
                if (largest <= turn * along.norm()) continue;
                const Eigen::Vector3d move = least_motion(normal_matrix, right);
                const double limit = max_sagitta * along.norm(), length = move.norm();
                points_[first->first] =
                    0.5 * (mesh.vertices[a] + mesh.vertices[b]) + (length > limit ? limit / length : 1.0) * move;
            }
    }

    const std::map<Edge, Eigen::Vector3d>& points() const { return points_; }

    std::size_t panels_of(const Mesh& mesh) const {
        std::size_t count = mesh.faces.size();
        for (const Face& f : mesh.faces)
            for (std::size_t k = 0; k < 3; ++k) count += points_.count(make_edge(f[k], f[(k + 1) % 3]));
        return count;
    }

private:
    std::map<Edge, Eigen::Vector3d> points_;
};

Mesh split(const Mesh& mesh, const EdgeMidpoints& middles, std::vector<uint32_t>* origin) {
    Mesh out;
    out.name = mesh.name;
    out.vertices = mesh.vertices;
    std::map<Edge, uint32_t> number;
    for (const auto& [edge, point] : middles.points()) {
        number[edge] = static_cast<uint32_t>(out.vertices.size());
        out.vertices.push_back(point);
    }
    std::vector<uint32_t> origins;
    for (std::size_t t = 0; t < mesh.faces.size(); ++t) {
        const Face& f = mesh.faces[t];
        std::array<uint32_t, 3> middle{};
        std::size_t count = 0, last = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto found = number.find(make_edge(f[k], f[(k + 1) % 3]));
            middle[k] = found == number.end() ? UINT32_MAX : found->second;
            if (middle[k] == UINT32_MAX) continue;
            ++count;
            last = k;
        }
        if (count == 0) {
            out.faces.push_back(f);
        } else if (count == 3) {
            out.faces.insert(out.faces.end(), {{f[0], middle[0], middle[2]},
                                               {f[1], middle[1], middle[0]},
                                               {f[2], middle[2], middle[1]},
                                               {middle[0], middle[1], middle[2]}});
        } else if (count == 1) {
            const uint32_t a = f[last], b = f[(last + 1) % 3], c = f[(last + 2) % 3], m = middle[last];
            out.faces.insert(out.faces.end(), {{a, m, c}, {m, b, c}});
        } else {
            std::size_t whole = 0;
            while (middle[whole] != UINT32_MAX) ++whole;
            // Edge a b is not split; p is on b c, q on c a.
            const uint32_t a = f[whole], b = f[(whole + 1) % 3], c = f[(whole + 2) % 3];
            const uint32_t p = middle[(whole + 1) % 3], q = middle[(whole + 2) % 3];
            out.faces.push_back({p, c, q});
            if (prefers_diagonal(out.vertices, a, p, b, q))
                out.faces.insert(out.faces.end(), {{a, b, p}, {a, p, q}});
            else
                out.faces.insert(out.faces.end(), {{a, b, q}, {b, p, q}});
        }
        if (origin) origins.resize(out.faces.size(), (*origin)[t]);
    }
    if (origin) *origin = std::move(origins);
    return out;
}
} // namespace

Mesh refine_curved(const Mesh& mesh, double turn, std::size_t panel_limit, std::vector<uint32_t>* origin) {
    constexpr int max_levels = 4;
    Mesh fine = mesh;
    for (int level = 0; level < max_levels; ++level) {
        const EdgeMidpoints middles(fine, turn);
        if (middles.points().empty() || middles.panels_of(fine) > panel_limit) break;
        fine = split(fine, middles, origin);
    }
    return fine;
}
} // namespace lr::baker
