#include "baker/added_mass/fast_double_layer.h"

#include "baker/added_mass/multipole.h"
#include "baker/parallel_for.h"

#include <algorithm>
#include <array>
#include <atomic>

namespace lr::baker {
namespace {

constexpr std::size_t leaf_size = 96;
constexpr double separation = 0.6;

class DoubletSum {
public:
    DoubletSum(DoubletArrays& arrays, std::size_t count, unsigned threads) : arrays_(arrays), threads_(threads) {
        ClusterItems items;
        for (std::size_t e = 0; e < count; ++e) items.position.push_back(point(arrays.position, e));
        tree_ = build_cluster_tree(items, leaf_size);
        find_cluster_pairs(tree_, separation);
        near_.resize(tree_.clusters.size());
        for (const ClusterPair& pair : tree_.near) {
            near_[pair.first].push_back(pair.second);
            if (pair.first != pair.second) near_[pair.second].push_back(pair.first);
        }
        charges_.resize(count * charge_fields);
        for (std::size_t i = 0; i < count; ++i) {
            const uint32_t e = tree_.order[i];
            double* const to = &charges_[i * charge_fields];
            for (std::size_t k = 0; k < 3; ++k) to[k] = arrays.position[k][e];
            for (std::size_t m = 0; m < 6; ++m) to[3 + m] = arrays.moment[m][e];
        }
    }

    void run(const std::function<void(double)>& progress) {
        Expansions multipoles(tree_.clusters.size() * expansion_size, 0.0), locals;
        parallel_for(tree_.leaves.size(), threads_, [&](std::size_t i, unsigned) {
            expand(tree_.leaves[i], &multipoles[tree_.leaves[i] * expansion_size]);
        });
        progress(0.1);
        evaluate_far(tree_, threads_, expansion_order, multipoles, locals);
        progress(0.5);
        parallel_for(tree_.leaves.size(), threads_, [&](std::size_t i, unsigned) {
            evaluate(tree_.leaves[i], &locals[tree_.leaves[i] * expansion_size]);
        });
        progress(1.0);
    }

private:
    static Eigen::Vector3d point(const std::array<std::vector<double>, 3>& from, std::size_t e) {
        return {from[0][e], from[1][e], from[2][e]};
    }

    void expand(uint32_t leaf, double* multipole) const {
        const Cluster& cluster = tree_.clusters[leaf];
        for (uint32_t i = cluster.begin; i < cluster.end; ++i) {
            const uint32_t e = tree_.order[i];
            const Harmonics r = regular_harmonics(point(arrays_.position, e) - cluster.centre);
            for (std::size_t l = 0; l <= expansion_order; ++l)
                for (std::size_t m = 0; m <= l; ++m) {
                    const double half = m == 0 ? 0.5 : 1.0;
                    double* const to = multipole + 2 * term(l, m) * mode_lanes;
                    for (std::size_t mode = 0; mode < 6; ++mode) {
                        to[mode] += half * r[term(l, m)].real() * arrays_.moment[mode][e];
                        to[mode_lanes + mode] += half * r[term(l, m)].imag() * arrays_.moment[mode][e];
                    }
                }
        }
    }

    void evaluate(uint32_t leaf, const double* local) const {
        const Cluster& cluster = tree_.clusters[leaf];
        for (uint32_t i = cluster.begin; i < cluster.end; ++i) {
            const uint32_t e = tree_.order[i];
            const Eigen::Vector3d place = point(arrays_.position, e), normal = point(arrays_.normal, e);
            std::array<double, mode_lanes> sum{};
            const Harmonics r = normal_derivatives(regular_harmonics(place - cluster.centre), normal);
            for (std::size_t l = 1; l <= expansion_order; ++l)
                for (std::size_t m = 0; m <= l; ++m) {
                    const double half = m == 0 ? 0.5 : 1.0;
                    const double* const from = local + 2 * term(l, m) * mode_lanes;
                    for (std::size_t mode = 0; mode < 6; ++mode)
                        sum[mode] +=
                            half * (r[term(l, m)].real() * from[mode] + r[term(l, m)].imag() * from[mode_lanes + mode]);
                }
            for (const uint32_t other : near_[leaf]) {
                const Cluster& source = tree_.clusters[other];
                add_normal_gradient(&charges_[source.begin * charge_fields], source.end - source.begin, place.data(),
                                    normal.data(), sum.data());
            }
            for (std::size_t mode = 0; mode < 6; ++mode) arrays_.sum[mode][e] = sum[mode];
        }
    }

    DoubletArrays& arrays_;
    unsigned threads_;
    ClusterTree tree_;
    std::vector<std::vector<uint32_t>> near_; // leaves near each leaf
    std::vector<double> charges_;             // in the order of the tree
};
} // namespace

void sum_doublets_fast(DoubletArrays& arrays, std::size_t count, unsigned threads,
                       const std::function<void(double)>& progress) {
    if (count > 0) DoubletSum(arrays, count, thread_count(threads)).run(progress);
}
} // namespace lr::baker
