// The area that a body hides from a distant viewer: of the union of its projected triangles.
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

} // namespace lr::baker
