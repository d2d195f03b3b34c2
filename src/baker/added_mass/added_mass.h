// Added mass of a closed body or of a sheet in an unbounded ideal fluid, by a boundary element method.
#pragma once

#include "baker/added_mass/rim_refinement.h"
#include "baker/mesh/mesh.h"

#include <functional>

namespace lr::baker {

// [[A, B], [B^T, D]] for fluid density 1 about `centre`, axes of the mesh, order vx vy vz wx wy wz.
// Units: A m^3, B m^4, D m^5.
struct AddedMass {
    Eigen::Matrix<double, 6, 6> value;
    Eigen::Matrix<double, 6, 6> error; // estimated, per entry, same units
    double condition_estimate = 0.0;   // of the linear system; with iterations, of the preconditioned one
    double asymmetry = 0.0;            // largest |M - M^T| before symmetrising, over the scale of its entry
    double residual = 0.0;             // of the linear system, relative
    std::size_t iterations = 0;        // of conjugate gradients; 0: solved by Cholesky
};

using Progress = std::function<void(double fraction)>;

struct AddedMassOptions {
    // Up to so many triangles with a dense matrix, beyond with expansions: time and memory then grow about linearly.
    std::size_t max_dense = 8000;
    unsigned threads = 0; // of the latter; 0: as many as the machine runs at once. The same bits for any number.
};

// The mesh must be closed and outward (check_and_repair).
bool compute_added_mass(const Mesh& mesh, const Eigen::Vector3d& centre, AddedMass& out, Faults& faults,
                        const Progress& progress = {}, const AddedMassOptions& options = {});

// Of a surface without thickness, open or closed, wound in any way (check_sheet). Coarse ones are refined first.
bool compute_sheet_added_mass(const Mesh& mesh, const Eigen::Vector3d& centre, const Refinement& refinement,
                              AddedMass& out, Faults& faults, const Progress& progress = {},
                              const AddedMassOptions& options = {});

} // namespace lr::baker
