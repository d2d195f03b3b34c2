// Measures of a triangulated surface for the quasi-steady loads; docs/maintainers/physics.md, "Aerodynamic measures of a shape".
#pragma once

#include "asset/closed_forms/aerodynamic_coefficients.h"

#include <array>

namespace lr::shape {

// Sums over triangles. All but `rub` are exact, since n is constant and n.(e_k x r) linear on a triangle.
class SurfaceMeasures {
public:
    using Point = std::array<double, 3>;

    // axes: rows, unit vectors; centre: of the loads, in the frame of the points; size: approximate largest extent, m.
    SurfaceMeasures(const std::array<double, 9>& axes, const Point& centre, double size);

    // sides: 2 for a face of a sheet, which has fluid on both sides. Winding has no effect.
    void add(const Point& a, const Point& b, const Point& c, double sides);

    // Silhouettes are half of the projected surface, exact for convex bodies.
    AerodynamicGeometry geometry() const;

private:
    std::array<double, 9> axes_;
    Point centre_;
    double size_;
    Point low_, high_;
    double surface_ = 0.0;
    std::array<double, 3> projected_{}, squared_{}, stroke2_{}, stroke3_{}, rub_{};
};
} // namespace lr::shape
