// What a body hides from a distant viewer: the union of its projected triangles.
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace lr::baker {

using FlatTriangle = std::array<Eigen::Vector2d, 3>;

// By lines along the shorter side of the bounding box, on each of which the union is exact, one in each slab between
// neighbouring corners: exact but where edges cross within a slab, and there to about 1e-6 of the whole. Meshes with more
// than a few thousand corners get evenly spaced lines. Winding does not matter, nor do triangles without area.
double union_area(std::vector<FlatTriangle> triangles);

struct Silhouette {
    double area = 0.0;
    Eigen::Vector2d centroid = Eigen::Vector2d::Zero(); // of a union without area: zero
};

// The same with its centroid, which between two lines is good to their distance squared: 1e-7 of the extent.
Silhouette union_silhouette(std::vector<FlatTriangle> triangles);

} // namespace lr::baker
