#include "baker/added_mass/cluster_tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace lr::baker {
namespace {

class Builder {
public:
    Builder(const ClusterItems& items, std::size_t leaf_size, ClusterTree& out)
        : items_(items), leaf_size_(leaf_size), out_(out), reach_(items.position.size(), 0.0) {}

    void run() {
        const std::size_t n = items_.position.size();
        out_.order.resize(n);
        std::iota(out_.order.begin(), out_.order.end(), 0U);
        for (uint32_t i = 0; i < n; ++i)
            for_support(
                i, [&](const Eigen::Vector3d& p) { reach_[i] = std::max(reach_[i], (p - items_.position[i]).norm()); });
        if (n == 0) return;
        add(0, static_cast<uint32_t>(n), -1, 0);
        for (uint32_t at = 0; at < out_.clusters.size(); ++at) split(at);
        collect_leaves(0);
    }

private:
    template <class Work> void for_support(uint32_t item, const Work& work) const {
        if (items_.start.empty()) return;
        for (std::size_t k = items_.start[item]; k < items_.start[item + 1]; ++k) work(items_.support[k]);
    }

    uint32_t add(uint32_t begin, uint32_t end, int32_t parent, std::size_t level) {
        Cluster cluster;
        cluster.begin = begin;
        cluster.end = end;
        cluster.parent = parent;
        Eigen::AlignedBox3d box;
        for (uint32_t i = begin; i < end; ++i) {
            box.extend(items_.position[out_.order[i]]);
            for_support(out_.order[i], [&](const Eigen::Vector3d& p) { box.extend(p); });
        }
        cluster.centre = box.center();
        double square = 0.0;
        const auto include = [&](const Eigen::Vector3d& p) {
            square = std::max(square, (p - cluster.centre).squaredNorm());
        };
        for (uint32_t i = begin; i < end; ++i) {
            include(items_.position[out_.order[i]]);
            for_support(out_.order[i], include);
        }
        cluster.radius = std::sqrt(square);
        const auto index = static_cast<uint32_t>(out_.clusters.size());
        out_.clusters.push_back(cluster);
        level_.push_back(level);
        if (out_.levels.size() <= level) out_.levels.resize(level + 1);
        out_.levels[level].push_back(index);
        return index;
    }

    void split(uint32_t at) {
        const uint32_t begin = out_.clusters[at].begin, end = out_.clusters[at].end;
        if (end - begin <= leaf_size_) return;
        uint32_t middle = part_by_reach(begin, end);
        if (middle == begin || middle == end) middle = part_by_place(begin, end);
        const auto parent = static_cast<int32_t>(at);
        const uint32_t first = add(begin, middle, parent, level_[at] + 1),
                       second = add(middle, end, parent, level_[at] + 1);
        out_.clusters[at].first_child = static_cast<int32_t>(first);
        out_.clusters[at].second_child = static_cast<int32_t>(second);
    }

    // Splits off items that reach across half of the cluster, because each would enlarge a small cluster that contains it.
    uint32_t part_by_reach(uint32_t begin, uint32_t end) {
        Eigen::AlignedBox3d box;
        for (uint32_t i = begin; i < end; ++i) box.extend(items_.position[out_.order[i]]);
        const double limit = 0.5 * box.sizes().norm();
        const auto from = out_.order.begin() + begin, to = out_.order.begin() + end;
        const auto middle = std::stable_partition(from, to, [&](uint32_t i) { return reach_[i] <= limit; });
        return static_cast<uint32_t>(middle - out_.order.begin());
    }

    uint32_t part_by_place(uint32_t begin, uint32_t end) {
        Eigen::AlignedBox3d box;
        for (uint32_t i = begin; i < end; ++i) box.extend(items_.position[out_.order[i]]);
        Eigen::Index axis = 0;
        box.sizes().maxCoeff(&axis);
        std::sort(out_.order.begin() + begin, out_.order.begin() + end, [&](uint32_t a, uint32_t b) {
            const double x = items_.position[a][axis], y = items_.position[b][axis];
            return x != y ? x < y : a < b;
        });
        // Multiples of 8, so that leaves fill whole vectors.
        const uint32_t half = (end - begin) / 2;
        return begin + (half >= 16 ? (half + 4) / 8 * 8 : half);
    }

    void collect_leaves(uint32_t at) {
        const Cluster& cluster = out_.clusters[at];
        if (cluster.is_leaf()) {
            out_.leaves.push_back(at);
            return;
        }
        collect_leaves(static_cast<uint32_t>(cluster.first_child));
        collect_leaves(static_cast<uint32_t>(cluster.second_child));
    }

    const ClusterItems& items_;
    std::size_t leaf_size_;
    ClusterTree& out_;
    std::vector<double> reach_;
    std::vector<std::size_t> level_;
};
} // namespace

void find_cluster_pairs(ClusterTree& tree, double separation) {
    tree.near.clear();
    tree.far.clear();
    std::vector<ClusterPair> far, stack;
    if (!tree.clusters.empty()) stack.push_back({0, 0});
    const auto child = [](int32_t index) { return static_cast<uint32_t>(index); };
    while (!stack.empty()) {
        const auto [i, j] = stack.back();
        stack.pop_back();
        const Cluster &a = tree.clusters[i], &b = tree.clusters[j];
        if (i == j) {
            if (a.is_leaf()) {
                tree.near.push_back({i, i});
                continue;
            }
            stack.push_back({child(a.first_child), child(a.first_child)});
            stack.push_back({child(a.first_child), child(a.second_child)});
            stack.push_back({child(a.second_child), child(a.second_child)});
            continue;
        }
        if (a.radius + b.radius <= separation * (a.centre - b.centre).norm()) {
            far.push_back({i, j});
            far.push_back({j, i});
        } else if (a.is_leaf() && b.is_leaf()) {
            tree.near.push_back({std::min(i, j), std::max(i, j)});
        } else if (b.is_leaf() || (!a.is_leaf() && a.radius >= b.radius)) {
            stack.push_back({child(a.first_child), j});
            stack.push_back({child(a.second_child), j});
        } else {
            stack.push_back({i, child(b.first_child)});
            stack.push_back({i, child(b.second_child)});
        }
    }
    const auto before = [](const ClusterPair& p, const ClusterPair& q) {
        return p.first != q.first ? p.first < q.first : p.second < q.second;
    };
    std::sort(tree.near.begin(), tree.near.end(), before);
    std::sort(far.begin(), far.end(), before);
    tree.far_start.assign(tree.clusters.size() + 1, 0);
    for (const ClusterPair& pair : far) {
        ++tree.far_start[pair.first + 1];
        tree.far.push_back(pair.second);
    }
    std::partial_sum(tree.far_start.begin(), tree.far_start.end(), tree.far_start.begin());
}

ClusterTree build_cluster_tree(const ClusterItems& items, std::size_t leaf_size) {
    ClusterTree tree;
    Builder(items, std::max<std::size_t>(leaf_size, 1), tree).run();
    return tree;
}
} // namespace lr::baker
