// Triangulation of a flat region with holes: well-shaped triangles of about one size.
#pragma once

#include "baker/card/outline.h"
#include "baker/mesh/mesh.h"

namespace lr::baker {

struct PlanarMesh {
    std::vector<Eigen::Vector2d> vertices;
    std::vector<Face> faces; // counter-clockwise
};

// Degrees; kept wherever neither a sharper corner of the outline nor a part of it narrower than a few hundredths of the edge
// length stands against it.
constexpr double wanted_angle = 25.0;

// Loops that neither touch nor cross, the region to their left. Edges are about `edge` long, shorter where the region is narrow.
// False if it cannot be done within `max_faces`, or with loops that do touch.
bool triangulate_region(const std::vector<Loop>& loops, double edge, std::size_t max_faces, PlanarMesh& out);

// Degrees.
double smallest_angle(const PlanarMesh& mesh);

} // namespace lr::baker
