// Analytic potentials of flat triangles, and quadrature rules on them.
#pragma once

#include "baker/mesh/mesh.h"

#include <vector>

namespace lr::baker {

// A flat triangle with the quantities of the closed forms. Edge k runs from corner k to corner k+1.
struct Panel {
    std::array<Eigen::Vector3d, 3> corner;
    Eigen::Vector3d centroid;
    Eigen::Vector3d normal;                     // unit, outward
    std::array<Eigen::Vector3d, 3> edge_normal; // unit, in the plane, out of the triangle
    std::array<double, 3> edge_length;
    std::array<Eigen::Vector3d, 3> gradient; // of the barycentric coordinate of corner k
    double area;
    double radius; // of the circle around the centroid that contains the corners
};

Panel make_panel(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

struct PanelPotential {
    double single_layer;                // integral of 1/r
    std::array<double, 3> double_layer; // integral of lambda_k d/dn_y (1/r), lambda_k the barycentric coordinates
};

double square_distance(const Panel& panel, const Eigen::Vector3d& point);

// Potentials of unit source density and of linear doublet densities at a point. On the panel the double layer is the mean of
// both sides, zero.
PanelPotential panel_potential(const Panel& panel, const Eigen::Vector3d& point);

// Integral of 1/r over a panel times itself, in closed form.
double self_interaction(const Panel& panel);

// Barycentric nodes and weights (sum 1).
struct TriangleRule {
    std::vector<Eigen::Vector3d> nodes;
    std::vector<double> weights;
};

// Exact to degree 6 (Dunavant 1985, 12 points), on 4^levels equal parts of the triangle.
TriangleRule dunavant_rule(int levels);

// A part of a triangle that is cut into quarters again and again. Part i has its quarters at 4 i + 1 to 4 i + 4.
struct TrianglePart {
    TriangleRule rule; // dunavant_rule(0) on the part; weights add up to its share of the area
    Eigen::Vector3d centre;
    double size; // relative to the triangle
};
// The triangle, its 4 quarters, their 16, and so on.
std::vector<TrianglePart> triangle_parts(int levels);

// Exact to degree 4 (Dunavant 1985, 6 points).
TriangleRule six_point_rule();
} // namespace lr::baker
