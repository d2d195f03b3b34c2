// The equations of the added mass for meshes too large for a dense matrix.
#pragma once

#include "baker/added_mass/boundary_operators.h"
#include "baker/added_mass/coarse_space.h"
#include "baker/added_mass/schwarz_preconditioner.h"

#include <memory>

namespace lr::baker {

class FastSystem {
public:
    // Keeps references to `op` and `near` (assemble_without_matrix); uses the panels and self terms of `op`. The basis can be
    // that of a closed surface or of a sheet. threads 0: one per processor.
    FastSystem(const BoundaryOperators& op, const NearSingleLayer& near, const SurfaceBasis& basis, unsigned threads);
    FastSystem(const FastSystem&) = delete;
    FastSystem& operator=(const FastSystem&) = delete;

    // Numbers that the matrix will keep in memory: linear in the number of panels, unless many long panels are close to much of the surface.
    std::size_t stored_entries() const { return matrix_.stored_entries(); }
    // Pairs of clusters that interact through expansions in each iteration.
    std::size_t far_pairs() const { return matrix_.tree().far.size(); }

    // Call once, before multiply and solve.
    void assemble(const std::function<void(double)>& progress);

    // W x, for up to eight columns.
    Eigen::MatrixXd multiply(const Eigen::MatrixXd& x);

    struct Result {
        RigidModes value;
        std::size_t iterations = 0;
        double residual = 0.0, condition = 0.0; // as in ModeSolution
    };
    // Solves W x = right with the constants of closed parts fixed. False if the iteration does not converge. The error of the energy,
    // which gives the added mass, is the square of the tolerance.
    bool solve(const RigidModes& right, const std::function<void(double)>& progress, Result& out,
               std::size_t max_iterations = 500, double tolerance = 1e-6);

private:
    ModeVectors to_tree(const Eigen::MatrixXd& x) const;
    Eigen::MatrixXd from_tree(const ModeVectors& x, Eigen::Index columns) const;
    void apply(const ModeVectors& x, ModeVectors& y, std::size_t order);

    unsigned threads_;
    BasisParts parts_;
    SurfaceBasis basis_;
    HypersingularBlocks blocks_;
    FastHypersingular matrix_;
    std::unique_ptr<ConstantTerms> constants_;
    std::unique_ptr<Schwarz> patches_;
    std::unique_ptr<CoarseSpace> coarse_;
};
} // namespace lr::baker
