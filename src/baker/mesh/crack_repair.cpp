#include "baker/mesh/crack_repair.h"

#include "baker/mesh/half_edges.h"

#include <algorithm>
#include <limits>

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

// Vertices sorted along one axis, so that an edge tests only a slice of them.
class RimVertices {
public:
    RimVertices(const Mesh& mesh, const std::vector<HalfEdge>& open, Eigen::Index axis) : mesh_(mesh), axis_(axis) {
        for (const HalfEdge& e : open) order_.insert(order_.end(), {e.low, e.high});
        std::sort(order_.begin(), order_.end(),
                  [&](uint32_t a, uint32_t b) { return at(a) != at(b) ? at(a) < at(b) : a < b; });
        order_.erase(std::unique(order_.begin(), order_.end()), order_.end());
    }

    // Vertices inside the edge from a to b, in this order.
    std::vector<uint32_t> on_edge(uint32_t a, uint32_t b, double reach) const {
        const Eigen::Vector3d& start = mesh_.vertices[a];
        const Eigen::Vector3d along = mesh_.vertices[b] - start;
        const double square = along.squaredNorm(), low = std::min(at(a), at(b)) - reach;
        const double high = std::max(at(a), at(b)) + reach;
        std::vector<std::pair<double, uint32_t>> found;
        auto v = std::lower_bound(order_.begin(), order_.end(), low, [&](uint32_t i, double x) { return at(i) < x; });
        for (; v != order_.end() && at(*v) <= high; ++v) {
            if (*v == a || *v == b) continue;
            const Eigen::Vector3d to = mesh_.vertices[*v] - start;
            const double share = to.dot(along) / square;
            if (!(share > 0.0 && share < 1.0) || (to - share * along).squaredNorm() > reach * reach) continue;
            const double from_ends = std::min(share, 1.0 - share);
            if (from_ends * from_ends * square > reach * reach) found.emplace_back(share, *v);
        }
        std::sort(found.begin(), found.end());
        std::vector<uint32_t> vertices;
        for (const auto& [share, vertex] : found) vertices.push_back(vertex);
        return vertices;
    }

private:
    double at(uint32_t v) const { return mesh_.vertices[v][axis_]; }

    const Mesh& mesh_;
    Eigen::Index axis_;
    std::vector<uint32_t> order_;
};
} // namespace

std::size_t close_cracks(Mesh& mesh, double tolerance) {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Eigen::Vector3d& v : mesh.vertices) {
        low = low.cwiseMin(v);
        high = high.cwiseMax(v);
    }
    Eigen::Index axis = 0;
    const double reach = tolerance * (high - low).maxCoeff(&axis);
    std::size_t joined = 0;
    // Each round repairs one side of a face; the new faces can have cracks on other sides.
    constexpr int max_rounds = 8;
    for (int round = 0; round < max_rounds; ++round) {
        const std::vector<HalfEdge> open = find_open_edges(mesh);
        if (open.empty()) break;
        const RimVertices rim(mesh, open, axis);
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
