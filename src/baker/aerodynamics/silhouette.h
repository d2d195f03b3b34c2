// The silhouette of a body: the union of its projected triangles.
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace lr::baker {

using FlatTriangle = std::array<Eigen::Vector2d, 3>;

// Sums over lines along the shorter side of the bounding box, one in each slab between neighbouring corners; the union is exact on each line. The sum
// is exact unless edges cross within a slab, where the error is about 1e-6 of the whole. Meshes with more than a few thousand corners get evenly
// spaced lines. Winding and triangles without area have no effect.
double union_area(std::vector<FlatTriangle> triangles);

struct Silhouette {
    double area = 0.0;
    Eigen::Vector2d centroid = Eigen::Vector2d::Zero(); // zero for a union without area
};

// Also the centroid, with an error of the square of the line spacing: 1e-7 of the extent.
Silhouette union_silhouette(std::vector<FlatTriangle> triangles);
} // namespace lr::baker
