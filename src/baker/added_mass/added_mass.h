// Added mass of a closed body or of a sheet in an unbounded ideal fluid, by a boundary element method.
#pragma once

#include "baker/added_mass/rim_refinement.h"
#include "baker/mesh/mesh.h"

#include <functional>

namespace lr::baker {

// [[A, B], [B^T, D]] for fluid density 1 about `centre`, axes of the mesh, order vx vy vz wx wy wz.
// Units: A m^3, B m^4, D m^5.
struct AddedMass {
    Eigen::Matrix<double, 6, 6> value = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 6> error = Eigen::Matrix<double, 6, 6>::Zero(); // estimated, per entry, same units
    double condition_estimate = 0.0; // of the linear system; if iterative, of the preconditioned system
    double asymmetry = 0.0;          // largest |M - M^T| before symmetrising, over the scale of its entry
    double residual = 0.0;           // of the linear system, relative
    std::size_t iterations = 0;      // of conjugate gradients; 0: Cholesky

    // Of translation: the largest error over the largest entry.
    double largest_share() const {
        return error.topLeftCorner<3, 3>().maxCoeff() / value.topLeftCorner<3, 3>().diagonal().maxCoeff();
    }
};

using Progress = std::function<void(double fraction)>;

struct AddedMassOptions {
    // Triangles up to which the matrix is dense. Above, expansions make time and memory grow about linearly.
    std::size_t max_dense = 8000;
    unsigned threads = 0; // with expansions; 0: one per processor. Does not affect the result.
    // False: gives up where it would take more than some seconds or a gigabyte, as for needles and nearly coincident layers.
    bool patient = true;
    // For references: one solution on the given panels (of a sheet, refined ones), without curvature, finer panels or error of shape.
    bool as_given = false;
};

// The mesh must be closed and outward (check_and_repair). If false, `out` is zero or, without patience, has an error above 5 %.
bool compute_added_mass(const Mesh& mesh, const Eigen::Vector3d& centre, AddedMass& out, Faults& faults,
                        const Progress& progress = {}, const AddedMassOptions& options = {});

// For a surface without thickness, open or closed, wound in any way (check_sheet). Refines coarse surfaces first.
bool compute_sheet_added_mass(const Mesh& mesh, const Eigen::Vector3d& centre, const Refinement& refinement,
                              AddedMass& out, Faults& faults, const Progress& progress = {},
                              const AddedMassOptions& options = {});
} // namespace lr::baker
