// Galerkin boundary element matrices on a closed triangle mesh or on a sheet, with continuous linear elements.
#pragma once

#include "baker/added_mass/panel_integrals.h"
#include "baker/added_mass/surface_basis.h"

#include <functional>
#include <limits>

namespace lr::baker {

// One column for each of vx vy vz wx wy wz.
using RigidModes = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor>;

// With the elements psi_i of the unknowns, G = 1/(4 pi r), n outward, and the normal velocity q_m of rigid mode m
// about the origin: n for the translations, x cross n for the rotations.
struct BoundaryOperators {
    std::vector<Panel> panels;
    Eigen::MatrixXd hypersingular; // W_ij = double integral of curl psi_i . curl psi_j G
    RigidModes moments;            // integral psi_i q_m
    // -integral q_m (1/2 + K) psi_i, K the double layer. On a sheet both sides cancel in K: -integral psi_i q_m.
    RigidModes right_side;
    std::vector<double> self; // double integral of G over each panel
};

// Bounds of the work on near panels: among needles and nearly coincident layers, all panels are near each other.
struct NearLimits {
    std::size_t pairs = 40000000; // 2.5 GB; a sphere of a million panels needs a quarter of it
    double points = std::numeric_limits<double>::infinity(); // of the closed forms, about 10 ns each
};

// The matrix is empty if the integrals over near panels would need more than the limits.
BoundaryOperators assemble_boundary_operators(const Mesh& mesh, const SurfaceBasis& basis,
                                              const std::function<void(double)>& progress,
                                              const NearLimits& limits = {});

// The single layer of near panels: double integral of G for each pair, in both orders.
struct NearSingleLayer {
    std::vector<std::size_t> start; // of each panel's list
    std::vector<uint32_t> panel;    // ascending
    std::vector<double> value;
};

// Assembles everything except the matrix, in linear time and memory: `near` receives the matrix's integrals of near panels;
// far parts of the right side use expansions (fast_double_layer.h). False if the near panels are beyond the limits. threads 0:
// one per processor.
bool assemble_without_matrix(const Mesh& mesh, const SurfaceBasis& basis, unsigned threads,
                             const std::function<void(double)>& progress, BoundaryOperators& out, NearSingleLayer& near,
                             const NearLimits& limits = {});

// Surface curl grad psi x n of the hat functions at the corners of a panel.
inline Eigen::Vector3d hat_curl(const Panel& panel, std::size_t corner) {
    // The opposite edge over twice the area, without the rounding of a cross product.
    return (panel.corner[(corner + 2) % 3] - panel.corner[(corner + 1) % 3]) / (2.0 * panel.area);
}
} // namespace lr::baker
