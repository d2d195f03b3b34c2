#include "baker/mesh/crack_repair.h"

#include "baker/mesh/half_edges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace lr::baker {
namespace {

std::vector<HalfEdge> find_open_edges(const Mesh& mesh) {
    const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
    std::vector<HalfEdge> open;
    for (std::size_t i = 0; i < edges.size(); ++i)
        if ((i == 0 || !same_edge(edges[i], edges[i - 1])) &&
            (i + 1 == edges.size() || !same_edge(edges[i], edges[i + 1])))
            open.push_back(edges[i]);
    std::sort(open.begin(), open.end(), [](const HalfEdge& a, const HalfEdge& b) {
        return a.face != b.face ? a.face < b.face : a.side < b.side;
    });
    return open;
}

// Vertices sorted along each axis: an edge tests only those in the thinnest slice that contains it.
class RimVertices {
public:
    RimVertices(const Mesh& mesh, const std::vector<HalfEdge>& open) : mesh_(mesh) {
        std::vector<uint32_t> order;
        for (const HalfEdge& e : open) order.insert(order.end(), {e.low, e.high});
        std::sort(order.begin(), order.end());
        order.erase(std::unique(order.begin(), order.end()), order.end());
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            std::vector<Place>& places = along_[static_cast<std::size_t>(axis)];
            for (const uint32_t v : order) places.push_back({mesh.vertices[v], v});
            std::stable_sort(places.begin(), places.end(),
                             [&](const Place& a, const Place& b) { return a.at[axis] < b.at[axis]; });
        }
    }

    // Vertices inside the edge from a to b, in this order.
    std::vector<uint32_t> on_edge(uint32_t a, uint32_t b, double reach) const {
        const Eigen::Vector3d &start = mesh_.vertices[a], &end = mesh_.vertices[b];
        const Eigen::Vector3d along = end - start;
        const double square = along.squaredNorm();
        const Eigen::AlignedBox3d box(start.cwiseMin(end).array() - reach, start.cwiseMax(end).array() + reach);
        std::span<const Place> slice = along_[0];
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const std::vector<Place>& places = along_[static_cast<std::size_t>(axis)];
            const auto first = std::lower_bound(places.begin(), places.end(), box.min()[axis],
                                                [&](const Place& p, double x) { return p.at[axis] < x; });
            const auto last = std::upper_bound(first, places.end(), box.max()[axis],
                                               [&](double x, const Place& p) { return x < p.at[axis]; });
            if (static_cast<std::size_t>(last - first) <= slice.size()) slice = {first, last};
        }
        std::vector<std::pair<double, uint32_t>> found;
        for (const auto& [at, v] : slice) {
            if (!box.contains(at) || v == a || v == b) continue;
            const Eigen::Vector3d to = at - start;
            const double share = to.dot(along) / square;
            if (!(share > 0.0 && share < 1.0) || (to - share * along).squaredNorm() > reach * reach) continue;
            const double from_ends = std::min(share, 1.0 - share);
            if (from_ends * from_ends * square > reach * reach) found.emplace_back(share, v);
        }
        std::sort(found.begin(), found.end());
        std::vector<uint32_t> vertices;
        for (const auto& [share, vertex] : found) vertices.push_back(vertex);
        return vertices;
    }

private:
    struct Place {
        Eigen::Vector3d at;
        uint32_t vertex;
    };

    const Mesh& mesh_;
    std::array<std::vector<Place>, 3> along_; // sorted along each axis
};
} // namespace

std::size_t close_cracks(Mesh& mesh, double tolerance) {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Eigen::Vector3d& v : mesh.vertices) {
        low = low.cwiseMin(v);
        high = high.cwiseMax(v);
    }
    const double reach = tolerance * (high - low).maxCoeff();
    std::size_t joined = 0;
    // Each round repairs one side of a face; the new faces can have cracks on other sides.
    constexpr int max_rounds = 8;
    for (int round = 0; round < max_rounds; ++round) {
        const std::vector<HalfEdge> open = find_open_edges(mesh);
        if (open.empty()) break;
        const RimVertices rim(mesh, open);
        std::size_t before = joined;
        uint32_t last = UINT32_MAX;
        for (const HalfEdge& e : open) {
            if (e.face == last) continue;
            const Face face = mesh.faces[e.face];
            const uint32_t a = face[e.side], b = face[(e.side + 1) % 3], c = face[(e.side + 2) % 3];
            std::vector<uint32_t> points = rim.on_edge(a, b, reach);
            points.erase(std::remove(points.begin(), points.end(), c), points.end());
            if (points.empty()) continue;
            last = e.face;
            joined += points.size();
            points.push_back(b);
            mesh.faces[e.face] = {a, points[0], c};
            for (std::size_t i = 0; i + 1 < points.size(); ++i) mesh.faces.push_back({points[i], points[i + 1], c});
        }
        if (joined == before) break;
    }
    return joined;
}
} // namespace lr::baker
