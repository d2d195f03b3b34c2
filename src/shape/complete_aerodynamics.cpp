#include "shape/aerodynamics.h"
#include "shape/principal_axes.h"
#include "shape/surface_measures.h"

#include <algorithm>
#include <cmath>

namespace lr::shape {
namespace {

AerodynamicGeometry hull_geometry(const AssetData& asset, const std::array<double, 9>& axes) {
    SurfaceMeasures measures(axes, asset.center_of_buoyancy, asset.length_d);
    const auto point = [&](size_t corner) {
        const float* v = asset.hull.vertices.data() + 3 * size_t{asset.hull.triangles[corner]};
        return SurfaceMeasures::Point{static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
    };
    for (size_t i = 0; i + 2 < asset.hull.triangles.size(); i += 3)
        measures.add(point(i), point(i + 1), point(i + 2), 1.0);
    return measures.geometry();
}

// A file may hold a hull that bounds nothing: all in one point, or on a line.
bool is_usable(const AerodynamicGeometry& g, double length_d) {
    std::array<double, 3> size = g.extent;
    std::sort(size.begin(), size.end());
    return g.surface > 0.0 && size[1] > 1e-6 * size[2] && size[2] > 1e-3 * length_d;
}

// A uniform ellipsoid has the moments m/5 (b^2 + c^2).
AerodynamicGeometry inertia_geometry(const AssetData& asset, const std::array<double, 9>& axes) {
    std::array<double, 3> moment{}, square{};
    for (size_t k = 0; k < 3; ++k)
        for (size_t i = 0; i < 3; ++i)
            for (size_t j = 0; j < 3; ++j)
                moment[k] += axes[3 * k + i] * asset.inertia[3 * i + j] * axes[3 * k + j] / asset.mass;
    const double all = moment[0] + moment[1] + moment[2];
    for (size_t k = 0; k < 3; ++k) square[k] = 2.5 * (all - 2.0 * moment[k]);
    // Ballast may leave moments that no solid has.
    const double least = 1e-8 * std::max({square[0], square[1], square[2]});
    std::array<double, 3> semi_axes{};
    for (size_t k = 0; k < 3; ++k) semi_axes[k] = std::sqrt(std::max(square[k], least));
    AerodynamicGeometry out = ellipsoid_geometry(semi_axes);
    out.axes = axes;
    return out;
}

} // namespace

void complete_aerodynamics(AssetData& asset) {
    if (asset.has_aerodynamics) return;
    const std::array<double, 9> axes = principal_axes(asset.inertia);
    AerodynamicGeometry geometry = hull_geometry(asset, axes);
    if (!is_usable(geometry, asset.length_d)) geometry = inertia_geometry(asset, axes);
    geometry.volume = asset.volume;
    asset.aerodynamics = default_aerodynamics(geometry);
    asset.has_aerodynamics = true;
}

} // namespace lr::shape
