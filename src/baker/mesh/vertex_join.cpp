#include "baker/mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace lr::baker {
namespace {

// first[i] <= i is the vertex that replaces vertex i.
std::size_t keep_first(Mesh& mesh, const std::vector<uint32_t>& first) {
    const std::size_t n = mesh.vertices.size();
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
} // namespace

std::size_t join_identical_vertices(Mesh& mesh) {
    const std::size_t n = mesh.vertices.size();
    std::vector<uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0U);
    // Comparison by value treats -0 and +0 as equal.
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
    return keep_first(mesh, first);
}

std::size_t join_near_vertices(Mesh& mesh, double tolerance) {
    const std::size_t n = mesh.vertices.size();
    Eigen::Vector3d low = Eigen::Vector3d::Constant(HUGE_VAL), high = -low;
    for (const Eigen::Vector3d& v : mesh.vertices) {
        low = low.cwiseMin(v);
        high = high.cwiseMax(v);
    }
    const double distance = n > 0 ? tolerance * (high - low).maxCoeff() : 0.0;
    if (!(distance > 0.0) || !std::isfinite(distance)) return 0;

    // Sweeps along a direction that is not normal to any likely plane of a model, so that few vertices are within reach at a time.
    const Eigen::Vector3d direction = Eigen::Vector3d(0.6180339887, 0.5403023059, 0.5708817929).normalized();
    std::vector<double> along(n);
    std::vector<uint32_t> order(n), first(n);
    for (std::size_t i = 0; i < n; ++i) along[i] = direction.dot(mesh.vertices[i] - low);
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](uint32_t a, uint32_t b) { return along[a] != along[b] ? along[a] < along[b] : a < b; });
    std::iota(first.begin(), first.end(), 0U);
    const auto root = [&](uint32_t i) {
        while (first[i] != i) i = first[i] = first[first[i]];
        return i;
    };
    const double reach = distance * (1.0 + 1e-6); // allows for the rounding of the sweep
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n && along[order[j]] - along[order[i]] <= reach; ++j) {
            if ((mesh.vertices[order[i]] - mesh.vertices[order[j]]).norm() > distance) continue;
            const uint32_t a = root(order[i]), b = root(order[j]);
            first[std::max(a, b)] = std::min(a, b);
        }
    for (std::size_t i = 0; i < n; ++i) first[i] = root(static_cast<uint32_t>(i));
    return keep_first(mesh, first);
}
} // namespace lr::baker
