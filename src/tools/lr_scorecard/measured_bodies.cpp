#include "tools/lr_scorecard/measured_bodies.h"

#include <Eigen/Geometry>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace lr::scorecard {

langevin_rigid::BakeResult Triangles::bake(const langevin_rigid::BakeOptions& options) const {
    return langevin_rigid::bake_triangles(positions.data(), positions.size() / 3, indices.data(), indices.size() / 3,
                                          options);
}

Triangles disc_mesh(double radius, uint32_t rings) {
    Triangles mesh;
    const double sides = 6.0 * rings, step = 2.0 * std::numbers::pi / sides;
    const double circumradius = radius * std::sqrt(step / std::sin(step));
    const auto vertex = [](uint32_t ring, uint32_t i) {
        return ring == 0 ? 0U : 1 + 3 * ring * (ring - 1) + i % (6 * ring);
    };
    mesh.positions.assign(3, 0.0);
    for (uint32_t ring = 1; ring <= rings; ++ring) {
        for (uint32_t i = 0; i < 6 * ring; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / (6.0 * ring), r = circumradius * ring / rings;
            mesh.positions.insert(mesh.positions.end(), {r * std::cos(angle), r * std::sin(angle), 0.0});
        }
        for (uint32_t sector = 0; sector < 6; ++sector)
            for (uint32_t i = 0; i < ring; ++i) {
                const uint32_t outer = sector * ring + i, inner = sector * (ring - 1) + i;
                mesh.indices.insert(mesh.indices.end(),
                                    {vertex(ring, outer), vertex(ring, outer + 1), vertex(ring - 1, inner)});
                if (i + 1 < ring)
                    mesh.indices.insert(mesh.indices.end(), {vertex(ring, outer + 1), vertex(ring - 1, inner + 1),
                                                             vertex(ring - 1, inner)});
            }
    }
    return mesh;
}

Triangles rectangle_mesh(double x, double y, uint32_t nx, uint32_t ny) {
    Triangles mesh;
    // Chebyshev points, because the flow is singular at the edges.
    const auto place = [](uint32_t i, uint32_t n) { return -0.5 * std::cos(std::numbers::pi * i / n); };
    for (uint32_t i = 0; i <= nx; ++i)
        for (uint32_t j = 0; j <= ny; ++j)
            mesh.positions.insert(mesh.positions.end(), {x * place(i, nx), y * place(j, ny), 0.0});
    for (uint32_t i = 0; i < nx; ++i)
        for (uint32_t j = 0; j < ny; ++j) {
            const uint32_t a = i * (ny + 1) + j, b = a + ny + 1;
            if ((i + j) % 2)
                mesh.indices.insert(mesh.indices.end(), {a, b, a + 1, b, b + 1, a + 1});
            else
                mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
        }
    return mesh;
}

langevin_rigid::BakeOptions sheet_options(double thickness, double areal_density, const Fluid& fluid) {
    langevin_rigid::BakeOptions options;
    options.unit = langevin_rigid::Unit::metre;
    options.fluid_density = fluid.density;
    options.fluid_viscosity = fluid.viscosity;
    options.sheet = langevin_rigid::BakeSheet{thickness, areal_density};
    return options;
}

Asset make_ellipsoid(const std::array<double, 3>& semi_axes, double density, const Fluid& fluid,
                     const std::array<double, 3>& center_of_mass) {
    lr_ellipsoid_desc d = initialised(lr_ellipsoid_desc_init);
    for (size_t i = 0; i < 3; ++i) {
        d.semi_axes[i] = semi_axes[i];
        d.center_of_mass[i] = center_of_mass[i];
    }
    d.density = density;
    d.fluid_density = fluid.density;
    d.fluid_viscosity = fluid.viscosity;
    lr_asset* asset = nullptr;
    require(lr_asset_create_ellipsoid(&d, &asset), "lr_asset_create_ellipsoid");
    return Asset(asset);
}

Asset paper_leaf() {
    return make_ellipsoid({0.04, 0.01, 5e-5}, 800.0, Fluid{});
}

Asset rubber_ellipsoid() {
    return make_ellipsoid({0.04, 0.02, 0.01}, 1100.0, water);
}

Triangles upper_page(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    Triangles mesh;
    const auto vertex = [&](uint32_t i) { return Eigen::Vector3d(&mesh.positions.at(size_t{3} * i)); };
    for (std::string line; std::getline(file, line);) {
        std::istringstream text(line);
        std::string kind;
        text >> kind;
        if (kind == "v")
            for (double x = 0.0; text >> x;) mesh.positions.push_back(x);
        if (kind != "f") continue;
        std::array<uint32_t, 3> f{};
        for (uint32_t& i : f) {
            std::string corner; // "vertex/texture"
            text >> corner;
            i = static_cast<uint32_t>(std::stoul(corner)) - 1;
        }
        const Eigen::Vector3d a = vertex(f[0]), normal = (vertex(f[1]) - a).cross(vertex(f[2]) - a);
        if (normal.z() > 0.0) mesh.indices.insert(mesh.indices.end(), f.begin(), f.end());
    }
    return mesh;
}

Asset disc_sinking_at(double reynolds, double diameter) {
    const Fluid air;
    const double speed = reynolds * air.viscosity / diameter, drag_coefficient = 1.17 + 20.4 / reynolds;
    return bake_disc(0.5 * diameter, 1e-4, 0.5 * air.density * speed * speed * drag_coefficient / 9.81, air);
}

Asset bake_disc(double radius, double thickness, double areal_density, const Fluid& fluid, uint32_t rings) {
    return load(disc_mesh(radius, rings).bake(sheet_options(thickness, areal_density, fluid)));
}
} // namespace lr::scorecard
