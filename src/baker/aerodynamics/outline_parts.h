// Parts of a surface by its outline, seen along the normal: compact pieces, and the line in which it is its own mirror image.
#pragma once

#include "baker/aerodynamics/surface_parts.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace lr::baker {

// Splits a part, seen along `normal`, into parts about as compact as a plate: the arms of a cross or star and the sides of a ring as sectors about
// the centroid, other shapes by straight cuts.
std::vector<Part> split_by_outline(Part part, const Eigen::Vector3d& normal, std::size_t most);

// area/(12 sqrt(det)) of a silhouette's second moments: 1 for any rectangle, 1.05 for an ellipse, 0.87 for a triangle, 0.63 for a cross five times as
// long as wide.
double compactness(const Part& part, const Eigen::Vector3d& normal);
inline constexpr double least_compactness = 0.8; // of a plate

// Of a part whose second moments define no axes, such as a blossom: the direction across `normal` of the line in which its silhouette and its height
// along the normal are most nearly their own mirror image; `like` if no other is better.
Eigen::Vector3d mirror_line(const Part& part, const Eigen::Vector3d& normal, const Eigen::Vector3d& like);
} // namespace lr::baker
