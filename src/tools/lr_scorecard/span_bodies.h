// Bodies of parts that meet the air at different angles, from generated meshes: a winged seed, darts, caps, curled leaves, discs with holes, strips,
// crosses and snow crystals.
#pragma once

#include "tools/lr_scorecard/measured_bodies.h"

namespace lr::scorecard {

// A samara. Body axes: x from the nut to the tip, y from the leading to the trailing edge, z normal to the wing.
struct SeedShape {
    double mass = 232e-6;    // kg, 72 % of it in the nut
    double radius = 0.0447;  // m, from the centre of mass to the tip
    double chord = 0.257;    // mean chord, over the radius
    double nut_place = 0.31; // centre of the nut behind the leading edge, over the widest chord
};
struct Seed {
    Triangles mesh; // m; the centre of the nut is at x = 0, the leading edge at y = 0
    double density; // kg/m^3
    double widest;  // m, chord
};
Seed seed_mesh(const SeedShape& shape);
Asset bake_seed(const Seed& seed);

// A dart of 20 cm, 10.5 cm wide, of 5 g: two wings that rise to the sides, a keel, the last tenth of the wings bent up, more layers of paper at the
// nose. Nose towards +x, left +y, up +z.
struct DartShape {
    double weight_place = 0.475; // centre of mass behind the nose, over the length
    double flap = 6.0;           // degrees, trailing edges up
    double twist = 0.0;          // degrees, nose up, of the left wing
};
Asset bake_dart(const DartShape& shape);

// Part of a sphere, open towards +z. rise: of the diameter.
Asset bake_cap(double diameter, double rise, double areal_density);

// A cone, its tip down, or, with half_angle (degrees) 0, half a sphere; open towards +z.
Asset bake_bowl(double diameter, double half_angle, double areal_density);

// An ellipse, y along its rib. curl, twist: 1/m; z = curl x^2/2 + twist x y.
Asset bake_curled_leaf(double width, double length, double curl, double twist, double areal_density);

// hole: of the diameter.
Asset bake_ring(double diameter, double hole, double areal_density);

// A rectangle, y along its length, bent to an arc towards +z. rise: of the length.
Asset bake_strip(double width, double length, double rise, double areal_density);

// Two bars of this length that cross at right angles. width: of a bar.
Asset bake_cross(double length, double width, double areal_density);

// Six arms with side branches. Mass of plane dendrites (Nakaya and Terada 1935): 3.8 micrograms times (diameter/mm)^2.
inline constexpr Fluid cold_air{1.32, 1.28e-5}; // -5 degrees C
Asset bake_snow_crystal(double diameter);
} // namespace lr::scorecard
