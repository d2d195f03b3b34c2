// Triangulates a flat region with holes into well-shaped triangles of about equal size.
#pragma once

#include "baker/card/outline.h"
#include "baker/mesh/mesh.h"

namespace lr::baker {

struct PlanarMesh {
    std::vector<Eigen::Vector2d> vertices;
    std::vector<Face> faces; // counter-clockwise
};

// loops: must not touch or cross; the region is on their left. Edges are about `edge` long, shorter in narrow parts. Angles are at least 25 degrees
// except at sharper corners of the outline and in parts narrower than a few hundredths of `edge`. False if that needs more than `max_faces`, or if loops
// touch.
bool triangulate_region(const std::vector<Loop>& loops, double edge, std::size_t max_faces, PlanarMesh& out);

// Degrees.
double smallest_angle(const PlanarMesh& mesh);
} // namespace lr::baker
