// Closed test meshes with known geometry.
#pragma once

#include "baker/mesh/mesh.h"
#include "support/quick.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace lr::test {

using baker::Face;
using baker::Mesh;

// Accuracy is tested in release builds; with sanitizers other cases run the same code on smaller bodies.
inline const bool sanitized = quick();

inline void apply(Mesh& mesh, const Eigen::Matrix3d& linear, const Eigen::Vector3d& shift = Eigen::Vector3d::Zero()) {
    for (Eigen::Vector3d& v : mesh.vertices) v = linear * v + shift;
}

inline void append(Mesh& to, const Mesh& from) {
    const auto shift = static_cast<uint32_t>(to.vertices.size());
    to.vertices.insert(to.vertices.end(), from.vertices.begin(), from.vertices.end());
    for (const Face& f : from.faces) to.faces.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
}

inline Eigen::Matrix3d some_rotation() {
    return Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
}

// Unit sphere: an icosahedron, each level splitting every triangle in four: 20 * 4^levels triangles.
inline Mesh icosphere(int levels) {
    const double g = 0.5 * (1.0 + std::sqrt(5.0));
    Mesh mesh;
    mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                     {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                  {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                  {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (Eigen::Vector3d& v : mesh.vertices) v.normalize();
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
        const auto middle = [&](uint32_t a, uint32_t b) {
            const auto [entry, fresh] =
                middles.try_emplace(std::minmax(a, b), static_cast<uint32_t>(mesh.vertices.size()));
            if (fresh) mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
            return entry->second;
        };
        std::vector<Face> finer;
        for (const Face& f : mesh.faces) {
            const uint32_t a = middle(f[0], f[1]), b = middle(f[1], f[2]), c = middle(f[2], f[0]);
            finer.insert(finer.end(), {{f[0], a, c}, {f[1], b, a}, {f[2], c, b}, {a, b, c}});
        }
        mesh.faces = std::move(finer);
    }
    return mesh;
}

inline Mesh ellipsoid(double a, double b, double c, int levels) {
    Mesh mesh = icosphere(levels);
    apply(mesh, Eigen::Vector3d(a, b, c).asDiagonal());
    return mesh;
}

// Poles on z; 2 longitudes (latitudes - 1) triangles.
inline Mesh latitude_longitude(const Eigen::Vector3d& axes, int longitudes, int latitudes) {
    constexpr double pi = 3.14159265358979323846;
    Mesh mesh;
    const auto at = [&](int i, int j) { return static_cast<uint32_t>(1 + (i - 1) * longitudes + j % longitudes); };
    mesh.vertices.emplace_back(0.0, 0.0, 1.0);
    for (int i = 1; i < latitudes; ++i)
        for (int j = 0; j < longitudes; ++j) {
            const double polar = pi * i / latitudes, angle = 2.0 * pi * j / longitudes;
            mesh.vertices.emplace_back(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle),
                                       std::cos(polar));
        }
    const auto south = static_cast<uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(0.0, 0.0, -1.0);
    for (int j = 0; j < longitudes; ++j) {
        mesh.faces.push_back({0, at(1, j), at(1, j + 1)});
        mesh.faces.push_back({south, at(latitudes - 1, j + 1), at(latitudes - 1, j)});
        for (int i = 1; i + 1 < latitudes; ++i) {
            mesh.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    apply(mesh, axes.asDiagonal());
    return mesh;
}

// Position along an axis at grid line i of n, crowded towards both ends by `grading` in [0, 1] (1: cosine spacing).
inline double grid_line(int i, int n, double grading) {
    const double t = static_cast<double>(i) / n;
    return (1.0 - grading) * t + grading * 0.5 * (1.0 - std::cos(3.14159265358979323846 * t));
}

// Box centred on the origin, every side cut into n[0] x n[1] x n[2] cells of two triangles each.
inline Mesh box(const Eigen::Vector3d& size, const std::array<int, 3>& n, double grading = 0.0) {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            const int nu = n[static_cast<std::size_t>(u)], nv = n[static_cast<std::size_t>(v)];
            const auto base = static_cast<uint32_t>(mesh.vertices.size());
            for (int i = 0; i <= nu; ++i)
                for (int j = 0; j <= nv; ++j) {
                    Eigen::Vector3d p;
                    p[axis] = (side - 0.5) * size[axis];
                    p[u] = (grid_line(i, nu, grading) - 0.5) * size[u];
                    p[v] = (grid_line(j, nv, grading) - 0.5) * size[v];
                    mesh.vertices.push_back(p);
                }
            for (int i = 0; i < nu; ++i)
                for (int j = 0; j < nv; ++j) {
                    const auto corner = [&](int di, int dj) {
                        return base + static_cast<uint32_t>((i + di) * (nv + 1) + j + dj);
                    };
                    // Alternating diagonals: a single direction would add a handedness.
                    std::array<Face, 2> pair = {
                        {{corner(0, 0), corner(1, 0), corner(1, 1)}, {corner(0, 0), corner(1, 1), corner(0, 1)}}};
                    if ((i + j) % 2)
                        pair = {
                            {{corner(0, 0), corner(1, 0), corner(0, 1)}, {corner(1, 0), corner(1, 1), corner(0, 1)}}};
                    for (Face f : pair) {
                        if (side == 0) std::swap(f[1], f[2]);
                        mesh.faces.push_back(f);
                    }
                }
        }
    baker::join_identical_vertices(mesh);
    return mesh;
}

inline Mesh cube(int n) {
    return box({1.0, 1.0, 1.0}, {n, n, n});
}

// A leaf blade: lancet outline, camber across the midrib, closed by a rim; length 2, to be scaled by the caller.
inline Mesh leaf(int along, int across, double thickness, double camber) {
    Mesh mesh;
    const int columns = 2 * across + 1;
    for (int side = 0; side < 2; ++side)
        for (int i = 0; i <= along; ++i)
            for (int j = 0; j < columns; ++j) {
                const double x = -1.0 + 2.0 * i / along;
                const double half_width = 0.05 + 0.3 * (1.0 - x * x);
                const double y = half_width * (j - across) / across;
                mesh.vertices.emplace_back(x, y, camber * (y * y + 0.3 * x * x) + (side - 0.5) * thickness);
            }
    const auto at = [&](int side, int i, int j) {
        return static_cast<uint32_t>((side * (along + 1) + i) * columns + j);
    };
    for (int i = 0; i < along; ++i)
        for (int j = 0; j + 1 < columns; ++j) {
            mesh.faces.insert(mesh.faces.end(), {{at(1, i, j), at(1, i + 1, j), at(1, i + 1, j + 1)},
                                                 {at(1, i, j), at(1, i + 1, j + 1), at(1, i, j + 1)},
                                                 {at(0, i, j), at(0, i + 1, j + 1), at(0, i + 1, j)},
                                                 {at(0, i, j), at(0, i, j + 1), at(0, i + 1, j + 1)}});
        }
    const auto wall = [&](int i0, int j0, int i1, int j1) { // the solid lies to the left
        mesh.faces.push_back({at(0, i0, j0), at(0, i1, j1), at(1, i1, j1)});
        mesh.faces.push_back({at(0, i0, j0), at(1, i1, j1), at(1, i0, j0)});
    };
    for (int i = 0; i < along; ++i) {
        wall(i, 0, i + 1, 0);
        wall(i + 1, columns - 1, i, columns - 1);
    }
    for (int j = 0; j + 1 < columns; ++j) {
        wall(0, j + 1, 0, j);
        wall(along, j, along, j + 1);
    }
    return mesh;
}

// Around z, closed by fans: radius and height of each ring, from below.
inline Mesh wheel(const std::vector<std::array<double, 2>>& rings, int sides) {
    constexpr double pi = 3.14159265358979323846;
    Mesh mesh;
    const auto at = [&](std::size_t ring, int side) {
        return static_cast<uint32_t>(ring * static_cast<std::size_t>(sides)) + static_cast<uint32_t>(side % sides);
    };
    for (const auto& [radius, height] : rings)
        for (int i = 0; i < sides; ++i) {
            const double angle = 2.0 * pi * i / sides;
            mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
        }
    const auto below = static_cast<uint32_t>(mesh.vertices.size()), above = below + 1;
    mesh.vertices.emplace_back(0.0, 0.0, rings.front()[1]);
    mesh.vertices.emplace_back(0.0, 0.0, rings.back()[1]);
    const std::size_t last = rings.size() - 1;
    for (int i = 0; i < sides; ++i) {
        mesh.faces.push_back({below, at(0, i + 1), at(0, i)});
        mesh.faces.push_back({above, at(last, i), at(last, i + 1)});
        for (std::size_t k = 0; k < last; ++k) {
            mesh.faces.push_back({at(k, i), at(k, i + 1), at(k + 1, i + 1)});
            mesh.faces.push_back({at(k, i), at(k + 1, i + 1), at(k + 1, i)});
        }
    }
    return mesh;
}

// Each triangle in four, in its plane.
inline Mesh subdivided(const Mesh& mesh) {
    Mesh out{mesh.vertices, {}, {}};
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
    const auto middle = [&](uint32_t a, uint32_t b) {
        const auto [entry, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<uint32_t>(out.vertices.size()));
        if (fresh) out.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
        return entry->second;
    };
    for (const Face& f : mesh.faces) {
        const uint32_t a = middle(f[0], f[1]), b = middle(f[1], f[2]), c = middle(f[2], f[0]);
        out.faces.insert(out.faces.end(), {{f[0], a, c}, {f[1], b, a}, {f[2], c, b}, {a, b, c}});
    }
    return out;
}
} // namespace lr::test
