// Stations of generated bodies, by the steps of a bake.
#pragma once

#include "baker/aerodynamics/mesh_geometry.h"
#include "baker/aerodynamics/principal_axes.h"
#include "baker/aerodynamics/stations.h"
#include "baker/mesh/convex_hull.h"
#include "baker/mesh/mass_properties.h"
#include "sheet_shapes.h"

#include <Eigen/Core>

#include <cmath>
#include <cstddef>

namespace lr::test {

using namespace lr::baker;
using Eigen::Vector3d;

inline constexpr double viscosity = 1.5e-5;

struct Made {
    Stations stations;
    AerodynamicData loads;
    Vector3d center; // of the loads
    double area, size;
};

// The same steps as in a bake. thickness 0: a solid. weight: centre of mass.
inline Made made(Mesh mesh, double thickness, const Vector3d* weight = nullptr, std::size_t most = most_stations) {
    const MassProperties body =
        thickness > 0.0 ? compute_sheet_mass_properties(mesh, thickness) : compute_mass_properties(mesh);
    const Vector3d center = weight ? *weight : body.centroid;
    for (Vector3d& v : mesh.vertices) v -= center;
    std::array<double, 9> inertia{};
    for (std::size_t i = 0; i < 9; ++i)
        inertia[i] = body.inertia(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3));
    const std::array<double, 9> axes = shape::principal_axes(inertia, mesh.vertices);
    const Vector3d buoyancy = body.centroid - center;
    shape::AerodynamicGeometry g =
        thickness > 0.0 ? sheet_geometry(mesh, thickness, axes, buoyancy) : mesh_geometry(mesh, axes, buoyancy);
    g.volume = body.volume;
    Made out;
    out.loads = shape::default_aerodynamics(g);
    out.center = buoyancy + Vector3d(g.center[0], g.center[1], g.center[2]);
    StationOptions how;
    how.solid_faces = thickness > 0.0 ? 0 : mesh.faces.size();
    how.volume = body.volume;
    ConvexHull hull;
    Faults faults;
    if (compute_convex_hull(mesh.vertices, hull, faults))
        for (const Face& f : hull.faces)
            how.hull_volume += hull.vertices[f[0]].dot(hull.vertices[f[1]].cross(hull.vertices[f[2]])) / 6.0;
    how.length = out.size = body.extents.maxCoeff();
    how.viscosity = viscosity;
    how.most = most;
    out.area = thickness > 0.0 ? body.area : 0.5 * body.area;
    out.stations = make_stations(mesh, out.loads, out.center, how);
    return out;
}

inline Vector3d place(const StationData& s) {
    return {s.place[0], s.place[1], s.place[2]};
}

inline Vector3d row(const StationData& s, std::size_t k) {
    return {s.axes[3 * k], s.axes[3 * k + 1], s.axes[3 * k + 2]};
}

inline Mesh cap(double rise, int rings) {
    Mesh mesh = disc(rings);
    const double height = 2.0 * rise, radius = (1.0 + height * height) / (2.0 * height);
    for (Vector3d& v : mesh.vertices) v.z() = std::sqrt(radius * radius - v.head<2>().squaredNorm()) - radius;
    return mesh;
}

// A sheet bent about its long side, over this angle.
inline Mesh curled(double angle, int n) {
    return patch(2 * n, n, [=](double u, double v) {
        const double t = angle * (v - 0.5);
        return Vector3d(3.0 * (u - 0.5), std::sin(t) / angle, std::cos(t) / angle);
    });
}
} // namespace lr::test
