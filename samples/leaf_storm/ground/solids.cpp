// SPDX-License-Identifier: MIT
#include "ground/solids.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace {

Vertex vertex_at(const Vector& position, const Vector& normal) {
    Vertex vertex{};
    for (std::size_t k = 0; k < 3; ++k) {
        vertex.position[k] = static_cast<float>(position[k]);
        vertex.normal[k] = static_cast<float>(normal[k]);
    }
    return vertex;
}

// Each triangle has its own normal, so edges stay sharp.
void add_triangle(Mesh& mesh, const Vector& a, const Vector& b, const Vector& c) {
    const Vector normal = unit(cross(minus(b, a), minus(c, a)));
    for (const Vector& corner : {a, b, c}) {
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        mesh.vertices.push_back(vertex_at(corner, normal));
    }
}

} // namespace

Mesh box_mesh(const Vector& half_extents) {
    std::vector<Vector> corners;
    for (unsigned bits = 0; bits < 8; ++bits) {
        Vector corner = half_extents;
        for (unsigned axis = 0; axis < 3; ++axis)
            if (!(bits >> axis & 1u)) corner[axis] = -corner[axis];
        corners.push_back(corner);
    }
    Mesh mesh;
    const unsigned faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& face : faces) {
        add_triangle(mesh, corners[face[0]], corners[face[1]], corners[face[2]]);
        add_triangle(mesh, corners[face[0]], corners[face[2]], corners[face[3]]);
    }
    return mesh;
}

Mesh capsule_mesh(double radius, double half_length) {
    constexpr std::uint32_t around = 48, rings = 24; // rings: an even number, half of them for each cap
    Mesh mesh;
    for (std::uint32_t ring = 0; ring <= rings + 1; ++ring) {
        const std::uint32_t step = ring > rings / 2 ? ring - 1 : ring; // the middle ring is there twice
        const double polar = std::numbers::pi * step / rings;
        for (std::uint32_t k = 0; k <= around; ++k) {
            const double turn = 2.0 * std::numbers::pi * k / around;
            const Vector normal{std::sin(polar) * std::cos(turn), std::cos(polar), std::sin(polar) * std::sin(turn)};
            Vector position = times(radius, normal);
            position[1] += ring > rings / 2 ? -half_length : half_length;
            mesh.vertices.push_back(vertex_at(position, normal));
            if (ring == 0 || k == around) continue;
            const auto here = static_cast<std::uint32_t>(mesh.vertices.size()) - 1, above = here - around - 1;
            mesh.indices.insert(mesh.indices.end(), {above, above + 1, here, here, above + 1, here + 1});
        }
    }
    return mesh;
}

Mesh hull_mesh(const std::vector<Vector>& points) {
    Mesh mesh;
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 1; j < count; ++j) {
            for (std::size_t k = j + 1; k < count; ++k) {
                // A face of the hull has all other points on one side.
                const Vector normal = cross(minus(points[j], points[i]), minus(points[k], points[i]));
                const auto inside = [&](double sign) {
                    return std::all_of(points.begin(), points.end(), [&](const Vector& p) {
                        return sign * dot(normal, minus(p, points[i])) <= 1e-9 * dot(normal, normal);
                    });
                };
                if (inside(1.0)) add_triangle(mesh, points[i], points[j], points[k]);
                if (inside(-1.0)) add_triangle(mesh, points[i], points[k], points[j]);
            }
        }
    }
    return mesh;
}
