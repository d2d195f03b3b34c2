#include "baker/plot/plot_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace lr::baker {
namespace {

using Eigen::Vector3d;

constexpr std::size_t most_faces = 6000; // four views of them are about 1.5 MB
constexpr int shades = 24;

// Whether every edge occurs once in each direction; back faces are then hidden.
bool is_closed(const Mesh& mesh) {
    std::vector<std::pair<uint32_t, uint32_t>> edges, reversed;
    edges.reserve(3 * mesh.faces.size());
    for (const Face& f : mesh.faces)
        for (std::size_t k = 0; k < 3; ++k) edges.emplace_back(f[k], f[(k + 1) % 3]);
    reversed.reserve(edges.size());
    for (const auto& [a, b] : edges) reversed.emplace_back(b, a);
    std::sort(edges.begin(), edges.end());
    std::sort(reversed.begin(), reversed.end());
    return edges == reversed && std::adjacent_find(edges.begin(), edges.end()) == edges.end();
}

// Merges the vertices in each cell of a grid into their mean; removes faces with two corners in one cell.
Mesh clustered(const Mesh& mesh, int cells) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& v : mesh.vertices) box.extend(v);
    const double size = box.sizes().maxCoeff() / cells;
    std::map<std::array<int, 3>, uint32_t> index_of;
    std::vector<uint32_t> cluster;
    std::vector<double> count;
    Mesh out;
    for (const Vector3d& v : mesh.vertices) {
        const Vector3d at = (v - box.min()) / size;
        const std::array<int, 3> cell{static_cast<int>(at[0]), static_cast<int>(at[1]), static_cast<int>(at[2])};
        const auto [entry, fresh] = index_of.emplace(cell, static_cast<uint32_t>(out.vertices.size()));
        if (fresh) {
            out.vertices.push_back(Vector3d::Zero());
            count.push_back(0.0);
        }
        out.vertices[entry->second] += v;
        count[entry->second] += 1.0;
        cluster.push_back(entry->second);
    }
    for (std::size_t i = 0; i < out.vertices.size(); ++i) out.vertices[i] /= count[i];
    for (const Face& f : mesh.faces) {
        const Face g{cluster[f[0]], cluster[f[1]], cluster[f[2]]};
        if (g[0] != g[1] && g[1] != g[2] && g[2] != g[0]) out.faces.push_back(g);
    }
    // Removes copies of a triangle, which several small ones can leave.
    std::vector<std::pair<Face, std::size_t>> keys;
    for (std::size_t i = 0; i < out.faces.size(); ++i) {
        Face key = out.faces[i];
        std::rotate(key.begin(), std::min_element(key.begin(), key.end()), key.end());
        keys.emplace_back(key, i);
    }
    std::sort(keys.begin(), keys.end());
    std::vector<Face> faces;
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (i == 0 || keys[i].first != keys[i - 1].first) faces.push_back(keys[i].first);
    out.faces = std::move(faces);
    return out;
}
} // namespace

DrawnMesh::DrawnMesh(const Mesh& mesh) : closed_(is_closed(mesh)), thinned_(mesh.faces.size() > most_faces) {
    if (!thinned_) {
        mesh_ = mesh;
        return;
    }
    for (int cells = 192; cells >= 4; cells = cells * 4 / 5) {
        mesh_ = clustered(mesh, cells);
        if (mesh_.faces.size() <= most_faces) return;
    }
    mesh_.faces.clear();
}

std::string DrawnMesh::style() const {
    // Few faces have visible edges; the strokes of many only hide the gaps between them.
    const bool edges = mesh_.faces.size() <= 1500;
    std::string css = ".m{stroke-linejoin:round;stroke-width:" +
                      std::string(!closed_ ? "0.8"
                                  : edges  ? "0.35"
                                           : "0.5") +
                      "}";
    for (int i = 0; i < shades; ++i) {
        const int level = 148 + 98 * i / (shades - 1);
        const std::string gray =
            "rgb(" + std::to_string(level - 6) + "," + std::to_string(level) + "," + std::to_string(level - 8) + ")";
        css += ".s" + std::to_string(i) + "{fill:" + gray + ";stroke:" + (edges ? "#7c857c" : gray) + "}";
    }
    return css;
}

void DrawnMesh::draw(Svg& svg, const PlotView& view) const {
    const Vector3d toward = view.right.cross(view.up);
    const Vector3d light = (0.8 * toward + 0.5 * view.up - 0.35 * view.right).normalized();
    struct Drawn {
        double depth;
        std::size_t face;
        int shade;
    };
    std::vector<Drawn> order;
    for (std::size_t i = 0; i < mesh_.faces.size(); ++i) {
        const Face& f = mesh_.faces[i];
        const Vector3d &a = mesh_.vertices[f[0]], &b = mesh_.vertices[f[1]], &c = mesh_.vertices[f[2]];
        const Vector3d normal = (b - a).cross(c - a).normalized(); // Eigen leaves a zero vector unchanged
        if (closed_ && normal.dot(toward) < -1e-6) continue;
        const double bright = std::abs(normal.dot(light));
        order.push_back({toward.dot(a + b + c), i, std::clamp(static_cast<int>(bright * shades), 0, shades - 1)});
    }
    std::sort(order.begin(), order.end(),
              [](const Drawn& p, const Drawn& q) { return p.depth != q.depth ? p.depth < q.depth : p.face < q.face; });
    svg.begin_group(R"(class="m")");
    for (std::size_t i = 0; i < order.size();) {
        const int shade = order[i].shade;
        svg.begin_path();
        for (; i < order.size() && order[i].shade == shade; ++i) {
            std::array<SvgPoint, 3> corners;
            for (std::size_t k = 0; k < 3; ++k) corners[k] = view.at(mesh_.vertices[mesh_.faces[order[i].face][k]]);
            svg.add_to_path(corners);
        }
        svg.end_path("class=\"s" + std::to_string(shade) + "\"");
    }
    svg.end_group();
}
} // namespace lr::baker
