#include "contact/build_geometry.h"

#include "contact/geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace lr {
namespace {

using shape::HullPoint;

// Of a hull's largest extent: thinner ones have no inside to speak of.
constexpr double flat = 1e-4;
// Sine of the angle by which a surface may bend at an edge and still be flat.
constexpr double bend = 1e-3;

Double3 of(const HullPoint& p) {
    return {p[0], p[1], p[2]};
}
Double3 over(Double3 a, double b) {
    return {a.x / b, a.y / b, a.z / b};
}

bool all_finite(const float* values, size_t count) {
    return std::all_of(values, values + count, [](float v) { return std::isfinite(v); });
}

// For each vertex the first with its position, so that meshes whose triangles share none still have neighbours.
std::vector<uint32_t> welded(const float* vertices, uint32_t count) {
    std::vector<uint32_t> order(count), first(count);
    std::iota(order.begin(), order.end(), 0u);
    const auto at = [&](uint32_t i) { return vertices + size_t{3} * i; };
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
        for (uint32_t k = 0; k < 3; ++k)
            if (at(a)[k] < at(b)[k] || at(b)[k] < at(a)[k]) return at(a)[k] < at(b)[k];
        return a < b;
    });
    for (uint32_t n = 0; n < count; ++n) {
        const uint32_t i = order[n];
        const bool same = n > 0 && std::equal(at(i), at(i) + 3, at(order[n - 1]));
        first[i] = same ? first[order[n - 1]] : i;
    }
    return first;
}

struct Edge {
    uint32_t low, high; // welded vertices
    uint32_t triangle, number;
};

} // namespace

std::vector<HullPlane> hull_planes(const std::vector<HullPoint>& points, const shape::ConvexHull& hull) {
    const size_t count = hull.triangles.size();
    std::vector<Double3> normals(count);
    std::vector<double> areas(count);
    const auto at = [&](uint32_t corner) { return of(points[hull.points[corner]]); };
    double size = 0.0;
    for (const uint32_t i : hull.points) size = std::max(size, length(of(points[i]) - at(0)));
    for (size_t i = 0; i < count; ++i) {
        const auto& t = hull.triangles[i];
        normals[i] = cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0]));
        areas[i] = length(normals[i]);
        if (areas[i] > 0.0) normals[i] = over(normals[i], areas[i]);
    }
    std::vector<size_t> order(count);
    std::iota(order.begin(), order.end(), size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return areas[a] > areas[b]; });
    const double slack = 2.0 * hull.slack + 1e-6 * size;
    std::vector<char> taken(count, 0);
    std::vector<HullPlane> planes;
    for (const size_t i : order) {
        if (taken[i] || !(areas[i] > 0.0)) continue;
        HullPlane plane{normals[i], -std::numeric_limits<double>::infinity()};
        for (const uint32_t p : hull.points) plane.offset = std::max(plane.offset, dot(plane.normal, of(points[p])));
        for (size_t j = 0; j < count; ++j) {
            bool in = true;
            for (const uint32_t corner : hull.triangles[j])
                in = in && plane.offset - dot(plane.normal, at(corner)) <= slack;
            taken[j] = taken[j] || (in && (areas[j] <= 1e-6 * areas[i] || dot(plane.normal, normals[j]) > 0.5));
        }
        taken[i] = 1;
        planes.push_back(plane);
    }
    return planes;
}

bool build_hull(const float* vertices, uint32_t count, std::vector<float>& hull_vertices, std::vector<float>& faces) {
    hull_vertices.clear();
    faces.clear();
    if (count < 4 || count > most_hull_vertices || !all_finite(vertices, size_t{3} * count)) return false;
    std::vector<HullPoint> points(count);
    for (uint32_t i = 0; i < 3 * count; ++i) points[i / 3][i % 3] = wide(vertices[i]);
    shape::ConvexHull hull;
    if (shape::convex_hull(points, hull) != shape::HullOutcome::done || hull.flat) return false;
    double extent = 0.0;
    for (size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax_element(
            points.begin(), points.end(), [k](const HullPoint& a, const HullPoint& b) { return a[k] < b[k]; });
        extent = std::max(extent, (*high)[k] - (*low)[k]);
    }
    for (const HullPlane& plane : hull_planes(points, hull)) {
        double least = plane.offset;
        for (const uint32_t i : hull.points) least = std::min(least, dot(plane.normal, of(points[i])));
        if (!(plane.offset - least > flat * extent)) return false;
        for (const double n : {plane.normal.x, plane.normal.y, plane.normal.z}) faces.push_back(static_cast<float>(n));
        faces.push_back(static_cast<float>(plane.offset));
    }
    for (const uint32_t i : hull.points)
        hull_vertices.insert(hull_vertices.end(), vertices + size_t{3} * i, vertices + size_t{3} * i + 3);
    return all_finite(faces.data(), faces.size()) && faces.size() >= 16;
}

bool build_mesh(const float* vertices, uint32_t vertex_count, const uint32_t* indices, uint32_t triangle_count,
                std::vector<float>& normals, std::vector<uint8_t>& hidden_edges) {
    normals.assign(size_t{3} * triangle_count, 0.0f);
    hidden_edges.assign(triangle_count, 0);
    if (!all_finite(vertices, size_t{3} * vertex_count)) return false;
    if (std::any_of(indices, indices + size_t{3} * triangle_count, [&](uint32_t i) { return i >= vertex_count; }))
        return false;
    const auto at = [&](uint32_t triangle, uint32_t corner) {
        return to_double(vector_of(vertices + size_t{3} * indices[size_t{3} * triangle + corner % 3]));
    };
    bool any = false;
    std::vector<Double3> exact(triangle_count, Double3{});
    for (uint32_t t = 0; t < triangle_count; ++t) {
        const Double3 a = at(t, 1) - at(t, 0), b = at(t, 2) - at(t, 0), n = cross(a, b);
        const double area = length(n), c = length(b - a);
        const double longest = std::max({length(a), length(b), c});
        if (!(area > 1e-7 * longest * longest)) continue; // a line: its normal would be rounding
        any = true;
        exact[t] = over(n, area);
        put(to_float(exact[t]), normals.data() + size_t{3} * t);
    }
    if (!any) return false;

    const std::vector<uint32_t> names = welded(vertices, vertex_count);
    std::vector<Edge> edges;
    for (uint32_t t = 0; t < triangle_count; ++t)
        for (uint32_t k = 0; k < 3 && length(exact[t]) > 0.5; ++k) {
            const uint32_t a = names[indices[size_t{3} * t + k]], b = names[indices[size_t{3} * t + (k + 1) % 3]];
            edges.push_back({std::min(a, b), std::max(a, b), t, k});
        }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        if (a.low != b.low) return a.low < b.low;
        if (a.high != b.high) return a.high < b.high;
        return a.triangle != b.triangle ? a.triangle < b.triangle : a.number < b.number;
    });
    for (size_t from = 0; from < edges.size();) {
        size_t to = from;
        while (to < edges.size() && edges[to].low == edges[from].low && edges[to].high == edges[from].high) ++to;
        for (size_t i = from; i < to; ++i)
            for (size_t j = from; j < to; ++j) {
                const Edge &mine = edges[i], &other = edges[j];
                if (mine.triangle == other.triangle) continue;
                const Double3 out = at(other.triangle, other.number + 2) - at(other.triangle, other.number);
                const double rise = dot(exact[mine.triangle], out) / length(out);
                uint8_t& bits = hidden_edges[mine.triangle];
                if (rise > -bend) bits = static_cast<uint8_t>(bits | 1u << mine.number);
                if (rise < bend) bits = static_cast<uint8_t>(bits | 8u << mine.number);
            }
        from = to;
    }
    return true;
}

float steepest_secant(const uint32_t (&counts)[2], const float (&spacing)[2], const float* heights) {
    double most = 0.0; // square of the slope
    const auto slope = [&](size_t from, size_t to, uint32_t axis) {
        const double rise = static_cast<double>(heights[to]) - static_cast<double>(heights[from]);
        return rise * rise / (static_cast<double>(spacing[axis]) * static_cast<double>(spacing[axis]));
    };
    for (uint32_t k = 0; k + 1 < counts[1]; ++k)
        for (uint32_t i = 0; i + 1 < counts[0]; ++i) {
            const size_t at = i + size_t{counts[0]} * k, along_x = at + 1, along_z = at + counts[0];
            most = std::max(most, slope(at, along_x, 0) + slope(along_x, along_z + 1, 1));
            most = std::max(most, slope(at, along_z, 1) + slope(along_z, along_z + 1, 0));
        }
    return static_cast<float>(std::min(std::sqrt(1.0 + most) * 1.000001, 1e30));
}

bool build_coarse(const uint32_t (&counts)[2], const float* heights, std::vector<float>& coarse,
                  uint32_t (&coarse_counts)[2], float& lowest, float& highest) {
    constexpr uint32_t cells = HeightfieldGeometry::coarse_cells;
    if (counts[0] < 2 || counts[1] < 2) return false;
    const size_t samples = size_t{counts[0]} * counts[1];
    if (!all_finite(heights, samples)) return false;
    const auto [low, high] = std::minmax_element(heights, heights + samples);
    lowest = *low;
    highest = *high;
    for (uint32_t a = 0; a < 2; ++a) coarse_counts[a] = (counts[a] - 2) / cells + 1;
    coarse.assign(size_t{coarse_counts[0]} * coarse_counts[1], -std::numeric_limits<float>::infinity());
    // The squares around reach `cells` farther on each side.
    const auto from = [](uint32_t square) { return square > 0 ? (square - 1) * cells : 0; };
    const auto to = [&](uint32_t square, uint32_t a) {
        return static_cast<uint32_t>(std::min<uint64_t>((uint64_t{square} + 2) * cells, counts[a] - 1));
    };
    for (uint32_t sz = 0; sz < coarse_counts[1]; ++sz)
        for (uint32_t sx = 0; sx < coarse_counts[0]; ++sx) {
            float& most = coarse[size_t{sz} * coarse_counts[0] + sx];
            for (uint32_t k = from(sz); k <= to(sz, 1); ++k)
                for (uint32_t i = from(sx); i <= to(sx, 0); ++i)
                    most = std::max(most, heights[size_t{k} * counts[0] + i]);
        }
    return true;
}

} // namespace lr
