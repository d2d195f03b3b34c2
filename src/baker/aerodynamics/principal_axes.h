// The axes of the quasi-steady loads.
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace lr::shape {

// Principal axes of a symmetric positive matrix (row-major, an inertia): rows are unit vectors, right-handed, row i nearest to body axis i; exactly
// the body axes if these are principal within rounding. If two or three moments agree within a hundredth (disc, square, cube), the matrix does not
// define the axes. They then follow the body axes as closely as the remaining axis allows, not the noise of a mesh. Same bits with every C library.
std::array<double, 9> principal_axes(const std::array<double, 9>& inertia);

// For a surface. Where two moments agree, those axes follow the sides of the smallest rectangle around its corners instead, unless it saves less than
// a hundredth (disc): the extents, and so the loads, of a square would depend on how it lies in its file.
std::array<double, 9> principal_axes(const std::array<double, 9>& inertia, const std::vector<Eigen::Vector3d>& corners);
} // namespace lr::shape
