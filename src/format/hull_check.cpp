#include "format/hull_check.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

using Vec = std::array<double, 3>;

Vec minus(const Vec& a, const Vec& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vec& a, const Vec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// From one vertex to another, along a triangle, with its third vertex.
struct Edge {
    uint32_t from, to, opposite;
    size_t triangle;
};
bool before(const Edge& a, const Edge& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
}

} // namespace

HullFlaw find_flaw(const HullData& hull, double length, size_t& triangle) {
    const auto vertex = [&](uint32_t i) {
        const float* const v = hull.vertices.data() + 3 * size_t{i};
        return Vec{static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
    };
    std::vector<Edge> edges;
    edges.reserve(hull.triangles.size());
    double volume = 0.0; // six times
    for (size_t t = 0; t + 2 < hull.triangles.size(); t += 3) {
        const uint32_t* const corner = hull.triangles.data() + t;
        triangle = t / 3;
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) return HullFlaw::open;
        for (size_t k = 0; k < 3; ++k) edges.push_back({corner[k], corner[(k + 1) % 3], corner[(k + 2) % 3], t / 3});
        volume += dot(vertex(corner[0]), cross(vertex(corner[1]), vertex(corner[2])));
    }
    std::sort(edges.begin(), edges.end(), before);
    for (size_t i = 0; i < edges.size(); ++i) {
        const Edge& edge = edges[i];
        triangle = edge.triangle;
        if (i + 1 < edges.size() && !before(edge, edges[i + 1])) return HullFlaw::open;
        const Edge back{edge.to, edge.from, 0, 0};
        const auto found = std::lower_bound(edges.begin(), edges.end(), back, before);
        if (found == edges.end() || before(back, *found)) return HullFlaw::open;
    }
    triangle = 0;
    if (volume < -1e-9 * length * length * length) return HullFlaw::inside_out;
    for (const Edge& edge : edges) {
        triangle = edge.triangle;
        const auto found = std::lower_bound(edges.begin(), edges.end(), Edge{edge.to, edge.from, 0, 0}, before);
        // Slivers have no normal to speak of.
        const Vec a = vertex(edge.from), normal = cross(minus(vertex(edge.to), a), minus(vertex(edge.opposite), a));
        const double size = std::sqrt(dot(normal, normal));
        if (size > 1e-6 * length * length && dot(normal, minus(vertex(found->opposite), a)) > 1e-4 * length * size)
            return HullFlaw::dented;
    }
    return HullFlaw::none;
}

} // namespace lr
