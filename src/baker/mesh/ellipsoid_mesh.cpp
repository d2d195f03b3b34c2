#include "baker/mesh/ellipsoid_mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <utility>

namespace lr::baker {

// Subdivided octahedron. Uses only square roots, which are the same on every machine.
Mesh ellipsoid_mesh(const std::array<double, 3>& semi_axes, const std::array<double, 3>& origin, int levels) {
    Mesh mesh;
    mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (const uint32_t x : {0u, 1u})
        for (const uint32_t y : {2u, 3u})
            for (const uint32_t z : {4u, 5u})
                mesh.faces.push_back((x + y + z) % 2 == 0 ? Face{x, y, z} : Face{x, z, y});
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
        const auto middle = [&](uint32_t a, uint32_t b) {
            const auto [entry, fresh] =
                middles.try_emplace(std::minmax(a, b), static_cast<uint32_t>(mesh.vertices.size()));
            if (fresh) mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
            return entry->second;
        };
        std::vector<Face> finer;
        finer.reserve(4 * mesh.faces.size());
        for (const Face& f : mesh.faces) {
            const uint32_t a = middle(f[0], f[1]), b = middle(f[1], f[2]), c = middle(f[2], f[0]);
            finer.insert(finer.end(), {{f[0], a, c}, {f[1], b, a}, {f[2], c, b}, {a, b, c}});
        }
        mesh.faces = std::move(finer);
    }
    for (Eigen::Vector3d& v : mesh.vertices)
        for (Eigen::Index a = 0; a < 3; ++a) {
            const auto k = static_cast<std::size_t>(a);
            v[a] = v[a] * semi_axes[k] - origin[k];
        }
    return mesh;
}
} // namespace lr::baker
