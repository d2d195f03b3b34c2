#include "baker/added_mass/fast_system.h"

#include "baker/added_mass/conjugate_gradients.h"
#include "baker/parallel_for.h"

#include <algorithm>

namespace lr::baker {
namespace {

// Degree of the expansions for the coarse matrix; higher degrees change the number of iterations by one.
constexpr std::size_t coarse_order = 3;
} // namespace

FastSystem::FastSystem(const BoundaryOperators& op, const NearSingleLayer& near, const SurfaceBasis& basis,
                       unsigned threads)
    : threads_(thread_count(threads)), parts_(find_basis_parts(basis)), basis_(basis),
      blocks_(op.panels, op.self, near, basis_, parts_), matrix_(op.panels, parts_, threads_) {}

void FastSystem::assemble(const std::function<void(double)>& progress) {
    matrix_.assemble(blocks_, [&](double fraction) { progress(0.4 * fraction); });
    constants_ = std::make_unique<ConstantTerms>(basis_, matrix_);
    patches_ = std::make_unique<Schwarz>(matrix_, blocks_, *constants_, threads_,
                                         [&](double fraction) { progress(0.4 + 0.2 * fraction); });
    coarse_ = std::make_unique<CoarseSpace>(
        matrix_, [&](const ModeVectors& x, ModeVectors& y) { apply(x, y, coarse_order); },
        [&](double fraction) { progress(0.6 + 0.4 * fraction); });
}

void FastSystem::apply(const ModeVectors& x, ModeVectors& y, std::size_t order) {
    matrix_.apply(x, y, order);
    constants_->add(x, y);
}

ModeVectors FastSystem::to_tree(const Eigen::MatrixXd& x) const {
    const std::vector<uint32_t>& order = matrix_.tree().order;
    ModeVectors result(order.size() * mode_lanes, 0.0);
    for (std::size_t i = 0; i < order.size(); ++i)
        for (Eigen::Index m = 0; m < x.cols(); ++m)
            result[i * mode_lanes + static_cast<std::size_t>(m)] = x(static_cast<Eigen::Index>(order[i]), m);
    return result;
}

Eigen::MatrixXd FastSystem::from_tree(const ModeVectors& x, Eigen::Index columns) const {
    const std::vector<uint32_t>& order = matrix_.tree().order;
    Eigen::MatrixXd result(static_cast<Eigen::Index>(order.size()), columns);
    for (std::size_t i = 0; i < order.size(); ++i)
        for (Eigen::Index m = 0; m < columns; ++m)
            result(static_cast<Eigen::Index>(order[i]), m) = x[i * mode_lanes + static_cast<std::size_t>(m)];
    return result;
}

Eigen::MatrixXd FastSystem::multiply(const Eigen::MatrixXd& x) {
    ModeVectors y;
    matrix_.apply(to_tree(x), y);
    return from_tree(y, x.cols());
}

bool FastSystem::solve(const RigidModes& right, const std::function<void(double)>& progress, Result& out,
                       std::size_t max_iterations, double tolerance) {
    const std::vector<double>& diagonal = matrix_.diagonal();
    if (!std::all_of(diagonal.begin(), diagonal.end(), [](double d) { return d > 0.0 && std::isfinite(d); }))
        return false;
    ModeSolution solution;
    const bool solved = solve_modes([&](const ModeVectors& x, ModeVectors& y) { apply(x, y, expansion_order); },
                                    [&](const ModeVectors& r, ModeVectors& z) {
                                        patches_->apply(r, z);
                                        coarse_->add(r, z);
                                    },
                                    to_tree(right), tolerance, max_iterations, progress, solution);
    out = {from_tree(solution.value, 6), solution.iterations, solution.residual, solution.condition};
    return solved;
}
} // namespace lr::baker
