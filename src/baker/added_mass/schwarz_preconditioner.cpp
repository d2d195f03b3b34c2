#include "baker/added_mass/schwarz_preconditioner.h"

#include "baker/parallel_for.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace lr::baker {
namespace {

// Overlap of a patch beyond its leaf, in diagonals of the leaf.
constexpr double overlap = 0.2;
constexpr std::size_t most_members = 384;
} // namespace

ConstantTerms::ConstantTerms(const SurfaceBasis& basis, const FastHypersingular& matrix) {
    const std::vector<uint32_t>& order = matrix.tree().order;
    const std::vector<double>& diagonal = matrix.diagonal();
    std::vector<uint32_t> place(order.size());
    for (uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
    start_.assign(order.size() + 1, 0);
    for (const ConstantPotential& constant : basis.constants) {
        double energy = 0.0;
        for (const int32_t unknown : constant.unknowns) energy += diagonal[place[static_cast<std::size_t>(unknown)]];
        constants_.emplace_back();
        for (std::size_t k = 0; k < constant.unknowns.size(); ++k) {
            const uint32_t i = place[static_cast<std::size_t>(constant.unknowns[k])];
            constants_.back().push_back({i, constant.signs[k] * diagonal[i] / std::sqrt(energy)});
            ++start_[i + 1];
        }
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    entries_.resize(start_.back());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (uint32_t c = 0; c < constants_.size(); ++c)
        for (const Entry& entry : constants_[c]) entries_[next[entry.other]++] = {c, entry.value};
}

void ConstantTerms::add(const ModeVectors& x, ModeVectors& y) const {
    for (const std::vector<Entry>& constant : constants_) {
        std::array<double, mode_lanes> sum{};
        for (const Entry& entry : constant)
            for (std::size_t m = 0; m < mode_lanes; ++m) sum[m] += entry.value * x[entry.other * mode_lanes + m];
        for (const Entry& entry : constant)
            for (std::size_t m = 0; m < mode_lanes; ++m) y[entry.other * mode_lanes + m] += entry.value * sum[m];
    }
}

void ConstantTerms::add(std::span<const uint32_t> unknowns, Eigen::MatrixXd& block) const {
    struct Found {
        uint32_t constant;
        Eigen::Index at;
        double value;
    };
    std::vector<Found> found;
    for (std::size_t i = 0; i < unknowns.size(); ++i)
        for (std::size_t k = start_[unknowns[i]]; k < start_[unknowns[i] + 1]; ++k)
            found.push_back({entries_[k].other, static_cast<Eigen::Index>(i), entries_[k].value});
    std::stable_sort(found.begin(), found.end(),
                     [](const Found& a, const Found& b) { return a.constant < b.constant; });
    for (std::size_t begin = 0, end = 0; begin < found.size(); begin = end) {
        while (end < found.size() && found[end].constant == found[begin].constant) ++end;
        for (std::size_t j = begin; j < end; ++j)
            for (std::size_t i = begin; i < end; ++i)
                block(found[i].at, found[j].at) += found[i].value * found[j].value;
    }
}

Schwarz::Schwarz(const FastHypersingular& matrix, const HypersingularBlocks& blocks, const ConstantTerms& constants,
                 unsigned threads, const std::function<void(double)>& progress)
    : threads_(threads) {
    choose_members(matrix);
    std::vector<HypersingularBlocks::Workspace> work(threads_, HypersingularBlocks::Workspace(blocks));
    const std::size_t stride = 16 * threads_;
    for (std::size_t begin = 0; begin < patches_.size(); begin += stride) {
        const std::size_t count = std::min(stride, patches_.size() - begin);
        parallel_for(count, threads_, [&](std::size_t i, unsigned thread) {
            invert(blocks, matrix, constants, patches_[begin + i], work[thread]);
        });
        progress(static_cast<double>(begin + count) / static_cast<double>(patches_.size()));
    }
}

void Schwarz::choose_members(const FastHypersingular& matrix) {
    const ClusterTree& tree = matrix.tree();
    const std::vector<Eigen::Vector3d>& positions = matrix.positions();
    std::vector<std::vector<uint32_t>> near(tree.clusters.size());
    for (const ClusterPair& pair : tree.near) {
        near[pair.first].push_back(pair.second);
        if (pair.first != pair.second) near[pair.second].push_back(pair.first);
    }
    patches_.resize(tree.leaves.size());
    std::size_t size = 0;
    std::vector<uint32_t> count(tree.order.size(), 0);
    for (std::size_t p = 0; p < patches_.size(); ++p) {
        const Cluster& leaf = tree.clusters[tree.leaves[p]];
        Eigen::AlignedBox3d box;
        for (uint32_t i = leaf.begin; i < leaf.end; ++i) box.extend(positions[tree.order[i]]);
        const double reach = overlap * box.diagonal().norm();
        std::vector<std::pair<double, uint32_t>> found; // square of the distance, unknown
        for (const uint32_t other : near[tree.leaves[p]])
            for (uint32_t i = tree.clusters[other].begin; i < tree.clusters[other].end; ++i) {
                const double square = box.squaredExteriorDistance(positions[tree.order[i]]);
                const bool own = i >= leaf.begin && i < leaf.end;
                if (own || square <= reach * reach) found.emplace_back(own ? -1.0 : square, i);
            }
        std::sort(found.begin(), found.end());
        found.resize(std::min(found.size(), std::max<std::size_t>(most_members, leaf.end - leaf.begin)));
        Patch& patch = patches_[p];
        for (const auto& entry : found) patch.members.push_back(entry.second);
        std::sort(patch.members.begin(), patch.members.end());
        patch.start = size;
        size += patch.members.size();
        for (const uint32_t i : patch.members) ++count[i];
    }
    use_start_.assign(count.size() + 1, 0);
    std::partial_sum(count.begin(), count.end(), use_start_.begin() + 1);
    uses_.resize(size);
    std::vector<std::size_t> next(use_start_.begin(), use_start_.end() - 1);
    for (const Patch& patch : patches_)
        for (std::size_t k = 0; k < patch.members.size(); ++k) uses_[next[patch.members[k]]++] = patch.start + k;
    for (const uint32_t n : count) share_.push_back(1.0 / std::sqrt(static_cast<double>(n)));
    results_.resize(size * mode_lanes);
}

void Schwarz::invert(const HypersingularBlocks& blocks, const FastHypersingular& matrix, const ConstantTerms& constants,
                     Patch& patch, HypersingularBlocks::Workspace& work) const {
    const std::size_t n = patch.members.size();
    const auto size = static_cast<Eigen::Index>(n);
    std::vector<uint32_t> unknowns;
    for (const uint32_t i : patch.members) unknowns.push_back(matrix.tree().order[i]);
    Eigen::MatrixXd block;
    blocks.assemble(unknowns, unknowns, work, block);
    const std::vector<double>& diagonal = matrix.diagonal();
    Eigen::VectorXd scale(size);
    for (std::size_t j = 0; j < n; ++j)
        scale[static_cast<Eigen::Index>(j)] = 1.0 / std::sqrt(diagonal[patch.members[j]]);
    constants.add(patch.members, block);
    block = scale.asDiagonal() * block * scale.asDiagonal();
    const Eigen::LLT<Eigen::MatrixXd> factor(block);
    if (factor.info() == Eigen::Success)
        block = factor.solve(Eigen::MatrixXd::Identity(size, size));
    else
        block.setIdentity(); // quadrature errors made the patch indefinite; the iteration solves it
    for (std::size_t j = 0; j < n; ++j) scale[static_cast<Eigen::Index>(j)] *= share_[patch.members[j]];
    patch.inverse.resize(n * n);
    for (Eigen::Index j = 0; j < size; ++j)
        for (Eigen::Index i = 0; i <= j; ++i) {
            const auto value = static_cast<float>(0.5 * (block(i, j) + block(j, i)) * scale[i] * scale[j]);
            patch.inverse[static_cast<std::size_t>(j * size + i)] = value;
            patch.inverse[static_cast<std::size_t>(i * size + j)] = value;
        }
}

void Schwarz::apply(const ModeVectors& r, ModeVectors& z) {
    std::vector<std::vector<double>> gathered(threads_), scratch(threads_);
    parallel_for(patches_.size(), threads_, [&](std::size_t p, unsigned thread) {
        const Patch& patch = patches_[p];
        const std::size_t n = patch.members.size();
        std::vector<double>& local = gathered[thread];
        local.resize(n * mode_lanes);
        for (std::size_t k = 0; k < n; ++k)
            std::copy_n(&r[patch.members[k] * mode_lanes], mode_lanes, &local[k * mode_lanes]);
        scratch[thread].resize(std::max(scratch[thread].size(), n * n));
        double* const result = &results_[patch.start * mode_lanes];
        std::fill_n(result, n * mode_lanes, 0.0);
        multiply_block(patch.inverse.data(), n, n, local.data(), result, scratch[thread].data());
    });
    z.assign(r.size(), 0.0);
    for (std::size_t i = 0; i + 1 < use_start_.size(); ++i)
        for (std::size_t k = use_start_[i]; k < use_start_[i + 1]; ++k)
            for (std::size_t m = 0; m < mode_lanes; ++m) z[i * mode_lanes + m] += results_[uses_[k] * mode_lanes + m];
}
} // namespace lr::baker
