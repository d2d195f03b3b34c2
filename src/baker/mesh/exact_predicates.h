// Exact signs of determinants of points.
#pragma once

#include <Eigen/Core>

namespace lr::baker {

// +1 when a, b, c turn left, -1 when they turn right, 0 on one line.
int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

// The sign of (b - a) . ((c - a) x (d - a)): 0 when the four points are in one plane. Coordinates and products of three of them must
// neither overflow nor underflow.
int orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d);
} // namespace lr::baker
