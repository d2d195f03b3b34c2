// Test meshes without thickness.
#pragma once

#include "mesh_shapes.h"

#include <functional>

namespace lr::test {

// [0, 1]^2 in nu x nv cells, taken into space.
inline Mesh patch(int nu, int nv, const std::function<Eigen::Vector3d(double, double)>& map) {
    Mesh mesh;
    for (int i = 0; i <= nu; ++i)
        for (int j = 0; j <= nv; ++j)
            mesh.vertices.push_back(map(static_cast<double>(i) / nu, static_cast<double>(j) / nv));
    for (int i = 0; i < nu; ++i)
        for (int j = 0; j < nv; ++j) {
            const auto at = [&](int di, int dj) { return static_cast<uint32_t>((i + di) * (nv + 1) + j + dj); };
            if ((i + j) % 2) {
                mesh.faces.push_back({at(0, 0), at(1, 0), at(0, 1)});
                mesh.faces.push_back({at(1, 0), at(1, 1), at(0, 1)});
            } else {
                mesh.faces.push_back({at(0, 0), at(1, 0), at(1, 1)});
                mesh.faces.push_back({at(0, 0), at(1, 1), at(0, 1)});
            }
        }
    return mesh;
}

inline Mesh rectangle(double a, double b, int nu, int nv) {
    return patch(nu, nv, [&](double u, double v) { return Eigen::Vector3d(a * (u - 0.5), b * (v - 0.5), 0.0); });
}

// Unit disc, 6 rings^2 triangles.
inline Mesh disc(int rings) {
    Mesh mesh;
    mesh.vertices.emplace_back(0.0, 0.0, 0.0);
    for (int r = 1; r <= rings; ++r)
        for (int i = 0; i < 6 * r; ++i) {
            const double angle = 2.0 * 3.14159265358979323846 * i / (6 * r), radius = static_cast<double>(r) / rings;
            mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
        }
    const auto at = [](int r, int i) { return r == 0 ? 0U : static_cast<uint32_t>(1 + 3 * r * (r - 1) + i % (6 * r)); };
    for (int r = 1; r <= rings; ++r)
        for (int s = 0; s < 6; ++s)
            for (int i = 0; i < r; ++i) {
                mesh.faces.push_back({at(r, s * r + i), at(r, s * r + i + 1), at(r - 1, s * (r - 1) + i)});
                if (i + 1 < r)
                    mesh.faces.push_back(
                        {at(r, s * r + i + 1), at(r - 1, s * (r - 1) + i + 1), at(r - 1, s * (r - 1) + i)});
            }
    return mesh;
}

inline Mesh joined(Mesh a, const Mesh& b) {
    const auto shift = static_cast<uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const Face& f : b.faces) a.faces.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
    baker::join_near_vertices(a, 1e-9);
    return a;
}

} // namespace lr::test
