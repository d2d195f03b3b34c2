#include "baker/added_mass/coarse_space.h"

#include "baker/eigensystem.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace lr::baker {
namespace {

constexpr std::size_t cells = 128;
// Overlap of a function beyond its cell, in diagonals of the cell. Functions span both sides of a thin solid: potentials common to both sides have so
// little energy that patches alone would need hundreds of iterations.
constexpr double reach = 0.4;
} // namespace

CoarseSpace::CoarseSpace(const FastHypersingular& matrix, const ModeOperator& apply,
                         const std::function<void(double)>& progress) {
    choose_functions(matrix);
    const auto n = static_cast<Eigen::Index>(size_);
    Eigen::MatrixXd product(n, n);
    ModeVectors x, y;
    for (std::size_t first = 0; first < size_; first += mode_lanes) {
        x.assign((start_.size() - 1) * mode_lanes, 0.0);
        for (std::size_t i = 0; i + 1 < start_.size(); ++i)
            for (std::size_t k = start_[i]; k < start_[i + 1]; ++k)
                if (weights_[k].function >= first && weights_[k].function < first + mode_lanes)
                    x[i * mode_lanes + weights_[k].function - first] = weights_[k].value;
        apply(x, y);
        const std::size_t lanes = std::min(mode_lanes, size_ - first);
        product.middleCols(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(lanes)).setZero();
        for (std::size_t i = 0; i + 1 < start_.size(); ++i)
            for (std::size_t k = start_[i]; k < start_[i + 1]; ++k)
                for (std::size_t lane = 0; lane < lanes; ++lane)
                    product(weights_[k].function, static_cast<Eigen::Index>(first + lane)) +=
                        weights_[k].value * y[i * mode_lanes + lane];
        progress(static_cast<double>(first + lanes) / static_cast<double>(size_));
    }
    // Omits directions with almost no energy: functions can be linearly dependent, and expansions of low degree have errors.
    const Eigen::VectorXd scale = product.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = scale.asDiagonal() * (0.5 * (product + product.transpose())) * scale.asDiagonal();
    const Eigensystem<Eigen::MatrixXd> solver = eigensystem(scaled);
    Eigen::VectorXd inverse = solver.values;
    for (double& value : inverse) value = value > 1e-4 ? 1.0 / value : 0.0;
    inverse_ =
        scale.asDiagonal() * solver.vectors * inverse.asDiagonal() * solver.vectors.transpose() * scale.asDiagonal();
}

void CoarseSpace::choose_functions(const FastHypersingular& matrix) {
    const ClusterTree& tree = matrix.tree();
    const std::vector<Eigen::Vector3d>& positions = matrix.positions();
    std::vector<uint32_t> chosen{0};
    while (chosen.size() < cells) {
        const auto widest = std::max_element(chosen.begin(), chosen.end(), [&](uint32_t a, uint32_t b) {
            const Cluster &p = tree.clusters[a], &q = tree.clusters[b];
            const double x = p.is_leaf() ? 0.0 : p.radius, y = q.is_leaf() ? 0.0 : q.radius;
            return x != y ? x < y : a > b;
        });
        const Cluster& cluster = tree.clusters[*widest];
        if (cluster.is_leaf()) break;
        *widest = static_cast<uint32_t>(cluster.first_child);
        chosen.push_back(static_cast<uint32_t>(cluster.second_child));
    }
    std::sort(chosen.begin(), chosen.end());
    struct Cell {
        Eigen::AlignedBox3d box;
        double reach;
    };
    std::vector<Cell> boxes;
    for (const uint32_t at : chosen) {
        Cell cell;
        for (uint32_t i = tree.clusters[at].begin; i < tree.clusters[at].end; ++i)
            cell.box.extend(positions[tree.order[i]]);
        cell.reach = reach * cell.box.diagonal().norm();
        boxes.push_back(cell);
    }
    size_ = boxes.size();
    start_.assign(1, 0);
    for (const uint32_t unknown : tree.order) {
        double sum = 0.0;
        const std::size_t begin = weights_.size();
        for (std::size_t c = 0; c < boxes.size(); ++c) {
            const double distance = std::sqrt(boxes[c].box.squaredExteriorDistance(positions[unknown]));
            const double value = distance <= 0.0 ? 1.0 : 1.0 - distance / boxes[c].reach;
            if (!(value > 0.0)) continue;
            weights_.push_back({static_cast<uint32_t>(c), value});
            sum += value;
        }
        for (std::size_t k = begin; k < weights_.size(); ++k) weights_[k].value /= sum;
        start_.push_back(weights_.size());
    }
}

void CoarseSpace::add(const ModeVectors& r, ModeVectors& z) const {
    const auto n = static_cast<Eigen::Index>(size_);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(mode_lanes, n);
    for (std::size_t i = 0; i + 1 < start_.size(); ++i)
        for (std::size_t k = start_[i]; k < start_[i + 1]; ++k)
            for (std::size_t m = 0; m < mode_lanes; ++m)
                sum(static_cast<Eigen::Index>(m), weights_[k].function) += weights_[k].value * r[i * mode_lanes + m];
    const Eigen::MatrixXd solved = sum * inverse_;
    for (std::size_t i = 0; i + 1 < start_.size(); ++i)
        for (std::size_t k = start_[i]; k < start_[i + 1]; ++k)
            for (std::size_t m = 0; m < mode_lanes; ++m)
                z[i * mode_lanes + m] += weights_[k].value * solved(static_cast<Eigen::Index>(m), weights_[k].function);
}
} // namespace lr::baker
