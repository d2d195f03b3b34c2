#include "baker/mesh/ellipsoid_mesh.h"

#include <cmath>
#include <cstdint>

namespace lr::baker {

Mesh ellipsoid_mesh(const std::array<double, 3>& semi_axes, const std::array<double, 3>& origin) {
    constexpr uint32_t around = 48, rings = 23;
    constexpr double pi = 3.14159265358979323846;
    Mesh mesh;
    const auto add = [&](double latitude, double longitude) {
        mesh.vertices.emplace_back(semi_axes[0] * std::cos(latitude) * std::cos(longitude) - origin[0],
                                   semi_axes[1] * std::cos(latitude) * std::sin(longitude) - origin[1],
                                   semi_axes[2] * std::sin(latitude) - origin[2]);
    };
    for (uint32_t i = 0; i < rings; ++i)
        for (uint32_t j = 0; j < around; ++j) add(pi * ((i + 1.0) / (rings + 1.0) - 0.5), 2.0 * pi * j / around);
    const uint32_t south = rings * around, north = south + 1;
    add(-0.5 * pi, 0.0);
    add(0.5 * pi, 0.0);
    for (uint32_t j = 0; j < around; ++j) {
        const uint32_t k = (j + 1) % around;
        mesh.faces.push_back({south, k, j});
        for (uint32_t i = 0; i + 1 < rings; ++i) {
            const uint32_t a = i * around, b = a + around;
            mesh.faces.push_back({a + j, a + k, b + k});
            mesh.faces.push_back({a + j, b + k, b + j});
        }
        const uint32_t last = (rings - 1) * around;
        mesh.faces.push_back({last + j, last + k, north});
    }
    return mesh;
}

} // namespace lr::baker
