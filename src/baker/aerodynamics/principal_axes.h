// The axes that the quasi-steady loads are taken along.
#pragma once

#include <array>

namespace lr::shape {

// Principal axes of a symmetric positive matrix (row-major, an inertia): rows are unit vectors, right-handed, each the
// one nearest to the body axis of its number. The body axes themselves, exactly, where they are principal within
// rounding. Where two or three moments agree within a hundredth, the matrix does not say where the axes point (disc,
// square, cube): then they follow the body axes as closely as the remaining one lets them, and not the noise of a mesh.
// Portable: the same bits with every C library.
std::array<double, 9> principal_axes(const std::array<double, 9>& inertia);

} // namespace lr::shape
