// The measured bodies, baked from generated meshes.
#pragma once

#include "tools/lr_scorecard/runtime_handles.h"

#include <array>
#include <string>
#include <vector>

namespace lr::scorecard {

struct Fluid {
    double density = 1.2;      // kg/m^3
    double viscosity = 1.5e-5; // m^2/s, kinematic
};

inline constexpr Fluid water{1000.0, 1e-6};

struct Triangles {
    std::vector<double> positions;
    std::vector<uint32_t> indices;

    langevin_rigid::BakeResult bake(const langevin_rigid::BakeOptions& options) const;
};

// In the plane z = 0 about the origin: 6 rings^2 triangles with the area of the circle.
Triangles disc_mesh(double radius, uint32_t rings);

// Sides along x and y, divided into nx by ny cells, finer towards the edges.
Triangles rectangle_mesh(double x, double y, uint32_t nx, uint32_t ny);

// Options for a uniform sheet in a fluid. thickness: m; areal_density: kg/m^2.
langevin_rigid::BakeOptions sheet_options(double thickness, double areal_density, const Fluid& fluid);

// From closed forms, without the baker. Semi-axes and centre of mass: m.
Asset make_ellipsoid(const std::array<double, 3>& semi_axes, double density, const Fluid& fluid,
                     const std::array<double, 3>& center_of_mass = {});

// The paper's leaf: semi-axes 4 and 1 cm, 0.01 cm thick, 800 kg/m^3, in air.
Asset paper_leaf();

// The paper's ellipsoid: semi-axes 4, 2 and 1 cm, in water.
Asset rubber_ellipsoid();

// The upper page of one of the assets' closed sheets: its faces with a normal towards +z, as an open surface.
Triangles upper_page(const std::string& path);

// A disc of 0.1 mm in air, with the mass that sinks broadside at this Reynolds number.
Asset disc_sinking_at(double reynolds, double diameter);

Asset bake_disc(double radius, double thickness, double areal_density, const Fluid& fluid, uint32_t rings = 16);
} // namespace lr::scorecard
