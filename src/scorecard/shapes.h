// The bodies that are measured, baked from meshes made here.
#pragma once

#include "scorecard/runtime.h"

#include <vector>

namespace lr::scorecard {

struct Fluid {
    double density = 1.2;      // kg/m^3
    double viscosity = 1.5e-5; // m^2/s, kinematic
};

struct Triangles {
    std::vector<double> positions;
    std::vector<uint32_t> indices;

    langevin_rigid::BakeResult bake(const langevin_rigid::BakeOptions& options) const;
};

// Flat, in the plane z = 0, centre at the origin. Of 6 rings^2 triangles; the polygon has the area of the circle.
Triangles disc_mesh(double radius, uint32_t rings);

// Sides along x and y, in nx times ny cells that are finer towards the edges.
Triangles rectangle_mesh(double x, double y, uint32_t nx, uint32_t ny);

// A sheet of even mass in a fluid, by the baker. thickness: m; areal_density: kg/m^2.
langevin_rigid::BakeOptions sheet_options(double thickness, double areal_density, const Fluid& fluid);

Asset bake_disc(double radius, double thickness, double areal_density, const Fluid& fluid, uint32_t rings = 16);

} // namespace lr::scorecard
