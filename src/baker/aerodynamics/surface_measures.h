// Measures of a triangulated surface for the quasi-steady loads; docs/maintainers/physics.md, "Aerodynamic measures of a shape".
#pragma once

#include "asset/closed_forms/aerodynamic_coefficients.h"

#include <array>

namespace lr::shape {

// Sums over triangles. All but `rub` are exact: n is constant and n.(e_k x r) linear on a triangle.
class SurfaceMeasures {
public:
    using Point = std::array<double, 3>;

    // axes: rows, unit vectors; centre: of the loads, in the frame of the points; size: m, about the largest extent.
    SurfaceMeasures(const std::array<double, 9>& axes, const Point& centre, double size);

    // `sides`: 2 for a face of a sheet, which the fluid touches on both. Winding does not matter.
    void add(const Point& a, const Point& b, const Point& c, double sides);

    // A silhouette here is half of what the surface projects to, which is exact for convex bodies.
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
