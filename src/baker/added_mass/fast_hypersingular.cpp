#include "baker/added_mass/fast_hypersingular.h"

#include "baker/parallel_for.h"

#include <algorithm>
#include <numbers>

namespace lr::baker {
namespace {

// Smaller leaves move work from the near blocks to the expansions.
constexpr std::size_t vertices_of_leaf = 64;
// With this value and expansion_order the operator's error is about 1e-5 (docs/maintainers/numerics.md).
constexpr double vertex_separation = 0.65;
constexpr std::size_t moment_rows = 2 * expansion_terms;
} // namespace

FastHypersingular::FastHypersingular(const std::vector<Panel>& panels, const BasisParts& parts, unsigned threads)
    : panels_(panels), parts_(parts), threads_(threads) {
    place_unknowns();
    tree_ = build_cluster_tree(items_, vertices_of_leaf);
    find_cluster_pairs(tree_, vertex_separation);
}

void FastHypersingular::assemble(const HypersingularBlocks& blocks, const std::function<void(double)>& progress) {
    find_moments();
    progress(0.1);
    assemble_near(blocks, [&](double fraction) { progress(0.1 + 0.9 * fraction); });
}

std::size_t FastHypersingular::stored_entries() const {
    std::size_t entries = 0;
    for (const ClusterPair& pair : tree_.near) {
        const Cluster &a = tree_.clusters[pair.first], &b = tree_.clusters[pair.second];
        entries += std::size_t{a.end - a.begin} * (b.end - b.begin);
    }
    return entries + tree_.order.size() * moment_rows;
}

void FastHypersingular::place_unknowns() {
    items_.position.resize(parts_.start.size() - 1, Eigen::Vector3d::Zero());
    items_.start.assign(1, 0);
    for (std::size_t i = 0; i < items_.position.size(); ++i) {
        std::vector<Eigen::Vector3d> ring;
        for (const BasisPart& part : parts_.of(i)) {
            items_.position[i] = panels_[part.panel].corner[part.corner];
            for (std::size_t k = 1; k < 3; ++k) ring.push_back(panels_[part.panel].corner[(part.corner + k) % 3]);
        }
        // Each neighbour is a corner of two panels.
        const auto before = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
            return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
        };
        std::sort(ring.begin(), ring.end(), before);
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
        items_.support.insert(items_.support.end(), ring.begin(), ring.end());
        items_.start.push_back(items_.support.size());
    }
}

void FastHypersingular::find_moments() {
    moment_start_.assign(tree_.clusters.size(), 0);
    std::size_t size = 0;
    for (const uint32_t leaf : tree_.leaves) {
        moment_start_[leaf] = size;
        size += moment_rows * (tree_.clusters[leaf].end - tree_.clusters[leaf].begin);
    }
    moments_.assign(size, 0.0F);
    const TriangleRule small = six_point_rule(), large = dunavant_rule(0), largest = dunavant_rule(1);
    parallel_for(tree_.leaves.size(), threads_, [&](std::size_t index, unsigned) {
        const uint32_t leaf = tree_.leaves[index];
        const Cluster& cluster = tree_.clusters[leaf];
        const std::size_t n = cluster.end - cluster.begin;
        struct Use {
            BasisPart part;
            uint32_t column;
        };
        std::vector<Use> uses;
        for (uint32_t i = 0; i < n; ++i)
            for (const BasisPart& part : parts_.of(tree_.order[cluster.begin + i])) uses.push_back({part, i});
        std::stable_sort(uses.begin(), uses.end(),
                         [](const Use& a, const Use& b) { return a.part.panel < b.part.panel; });
        std::vector<double> sums(moment_rows * n, 0.0);
        for (std::size_t begin = 0; begin < uses.size();) {
            const Panel& panel = panels_[uses[begin].part.panel];
            const double ratio = panel.radius / cluster.radius;
            const TriangleRule& rule = ratio < 0.25 ? small : (ratio < 0.5 ? large : largest);
            std::array<Harmonics, 3> weighted{};
            for (std::size_t g = 0; g < rule.weights.size(); ++g) {
                const Eigen::Vector3d& node = rule.nodes[g];
                const Eigen::Vector3d x =
                    node[0] * panel.corner[0] + node[1] * panel.corner[1] + node[2] * panel.corner[2];
                const Harmonics r = regular_harmonics((x - cluster.centre) / cluster.radius);
                for (std::size_t k = 0; k < 3; ++k) {
                    const double weight = rule.weights[g] * node[static_cast<Eigen::Index>(k)];
                    for (std::size_t i = 0; i < term(expansion_order, 0); ++i) weighted[k][i] += weight * r[i];
                }
            }
            for (Harmonics& sum : weighted) sum = normal_derivatives(sum, panel.normal);
            std::size_t end = begin;
            for (; end < uses.size() && uses[end].part.panel == uses[begin].part.panel; ++end) {
                const Harmonics& sum = weighted[uses[end].part.corner];
                const double factor = uses[end].part.sign * panel.area / cluster.radius;
                for (std::size_t l = 1; l <= expansion_order; ++l)
                    for (std::size_t m = 0; m <= l; ++m) {
                        const std::size_t row = 2 * term(l, m);
                        sums[row * n + uses[end].column] += (m == 0 ? 0.5 : 1.0) * factor * sum[term(l, m)].real();
                        if (m > 0) sums[(row + 1) * n + uses[end].column] += factor * sum[term(l, m)].imag();
                    }
            }
            begin = end;
        }
        for (std::size_t i = 0; i < sums.size(); ++i) moments_[moment_start_[leaf] + i] = static_cast<float>(sums[i]);
    });
}

void FastHypersingular::assemble_near(const HypersingularBlocks& blocks, const std::function<void(double)>& progress) {
    std::size_t size = 0;
    near_.resize(tree_.clusters.size());
    const auto members = [&](uint32_t leaf) {
        const Cluster& cluster = tree_.clusters[leaf];
        return std::span<const uint32_t>(tree_.order.data() + cluster.begin, cluster.end - cluster.begin);
    };
    for (std::size_t i = 0; i < tree_.near.size(); ++i) {
        const auto [first, second] = tree_.near[i];
        block_start_.push_back(size);
        size += members(first).size() * members(second).size();
        near_[second].push_back({i, first, false});
        if (first != second) near_[first].push_back({i, second, true});
    }
    blocks_.resize(size);
    diagonal_.resize(tree_.order.size());
    std::vector<HypersingularBlocks::Workspace> work(threads_, HypersingularBlocks::Workspace(blocks));
    std::vector<Eigen::MatrixXd> matrix(threads_);
    const std::size_t stride = 64 * threads_;
    for (std::size_t begin = 0; begin < tree_.near.size(); begin += stride) {
        const std::size_t count = std::min(stride, tree_.near.size() - begin);
        parallel_for(count, threads_, [&](std::size_t i, unsigned thread) {
            const auto [first, second] = tree_.near[begin + i];
            Eigen::MatrixXd& block = matrix[thread];
            blocks.assemble(members(first), members(second), work[thread], block);
            float* const to = &blocks_[block_start_[begin + i]];
            for (Eigen::Index k = 0; k < block.size(); ++k) to[k] = static_cast<float>(block.data()[k]);
            if (first == second)
                for (Eigen::Index k = 0; k < block.rows(); ++k)
                    diagonal_[tree_.clusters[first].begin + static_cast<std::size_t>(k)] = block(k, k);
        });
        progress(static_cast<double>(begin + count) / static_cast<double>(tree_.near.size()));
    }
}

void FastHypersingular::apply_near(uint32_t leaf, const ModeVectors& x, double* y, std::vector<double>& scratch) const {
    const std::size_t size = tree_.clusters[leaf].end - tree_.clusters[leaf].begin;
    for (const Near& near : near_[leaf]) {
        const Cluster& other = tree_.clusters[near.leaf];
        const std::size_t count = other.end - other.begin;
        const double* const from = &x[other.begin * mode_lanes];
        const float* const block = &blocks_[block_start_[near.block]];
        scratch.resize(std::max(scratch.size(), size * count));
        if (near.transposed)
            multiply_transposed(block, count, size, from, y, scratch.data());
        else
            multiply_block(block, size, count, from, y, scratch.data());
    }
}

void FastHypersingular::apply(const ModeVectors& x, ModeVectors& y, std::size_t order) {
    const std::size_t rows = 2 * term(order + 1, 0);
    std::vector<std::vector<double>> scratch(threads_);
    multipoles_.resize(tree_.clusters.size() * expansion_size);
    const auto count = [&](const Cluster& cluster) { return std::size_t{cluster.end - cluster.begin}; };
    parallel_for(tree_.leaves.size(), threads_, [&](std::size_t i, unsigned thread) {
        const uint32_t leaf = tree_.leaves[i];
        const Cluster& cluster = tree_.clusters[leaf];
        double* const multipole = &multipoles_[leaf * expansion_size];
        std::fill_n(multipole, expansion_size, 0.0);
        scratch[thread].resize(std::max(scratch[thread].size(), moment_rows * count(cluster)));
        multiply_block(&moments_[moment_start_[leaf]], rows, count(cluster), &x[cluster.begin * mode_lanes], multipole,
                       scratch[thread].data());
        scale_degrees(cluster.radius, multipole);
    });
    evaluate_far(tree_, threads_, order, multipoles_, locals_);
    y.assign(x.size(), 0.0);
    parallel_for(tree_.leaves.size(), threads_, [&](std::size_t i, unsigned thread) {
        const uint32_t leaf = tree_.leaves[i];
        const Cluster& cluster = tree_.clusters[leaf];
        double* const local = &locals_[leaf * expansion_size];
        double* const to = &y[cluster.begin * mode_lanes];
        scale_degrees(cluster.radius, local);
        scratch[thread].resize(std::max(scratch[thread].size(), moment_rows * count(cluster)));
        multiply_transposed(&moments_[moment_start_[leaf]], rows, count(cluster), local, to, scratch[thread].data());
        for (std::size_t k = 0; k < count(cluster) * mode_lanes; ++k) to[k] *= -1.0 / (4.0 * std::numbers::pi);
        apply_near(leaf, x, to, scratch[thread]);
    });
}
} // namespace lr::baker
