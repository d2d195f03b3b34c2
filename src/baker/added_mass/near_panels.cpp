#include "baker/added_mass/near_panels.h"

#include "baker/added_mass/cluster_tree.h"

#include <algorithm>

namespace lr::baker {
namespace {

// Panels closer than this times the sum of their radii get a closed-form inner integral.
constexpr double near_ratio = 1.5;

struct Found {
    uint32_t first, second;
    bool touching;
};

class Search {
public:
    Search(const std::vector<Panel>& panels, std::size_t most) : panels_(panels), most_(most) {
        ClusterItems items;
        items.position.reserve(panels.size());
        for (const Panel& panel : panels) items.position.push_back(panel.centroid);
        tree_ = build_cluster_tree(items, 16);
        largest_.assign(tree_.clusters.size(), 0.0);
        for (std::size_t at = tree_.clusters.size(); at-- > 0;) {
            const Cluster& cluster = tree_.clusters[at];
            if (cluster.is_leaf())
                for (uint32_t i = cluster.begin; i < cluster.end; ++i)
                    largest_[at] = std::max(largest_[at], panels[tree_.order[i]].radius);
            if (cluster.parent >= 0) {
                double& parent = largest_[static_cast<std::size_t>(cluster.parent)];
                parent = std::max(parent, largest_[at]);
            }
        }
    }

    std::vector<Found> run() {
        if (!tree_.clusters.empty()) visit(0, 0);
        return std::move(found_);
    }

private:
    void visit(uint32_t i, uint32_t j) {
        if (found_.size() > most_) return;
        const Cluster &a = tree_.clusters[i], &b = tree_.clusters[j];
        const double reach = a.radius + b.radius + near_ratio * (largest_[i] + largest_[j]);
        // Margin for the rounding of radii and distance.
        if (i != j && (a.centre - b.centre).squaredNorm() > (1.0 + 1e-9) * reach * reach) return;
        if (a.is_leaf() && b.is_leaf()) {
            compare(i, j);
        } else if (i == j) {
            const auto first = static_cast<uint32_t>(a.first_child), second = static_cast<uint32_t>(a.second_child);
            visit(first, first);
            visit(first, second);
            visit(second, second);
        } else if (b.is_leaf() || (!a.is_leaf() && a.radius >= b.radius)) {
            visit(static_cast<uint32_t>(a.first_child), j);
            visit(static_cast<uint32_t>(a.second_child), j);
        } else {
            visit(i, static_cast<uint32_t>(b.first_child));
            visit(i, static_cast<uint32_t>(b.second_child));
        }
    }

    void compare(uint32_t i, uint32_t j) {
        const Cluster &a = tree_.clusters[i], &b = tree_.clusters[j];
        for (uint32_t m = a.begin; m < a.end; ++m) {
            const Panel& self = panels_[tree_.order[m]];
            for (uint32_t n = i == j ? m + 1 : b.begin; n < b.end; ++n) {
                const Panel& other = panels_[tree_.order[n]];
                const double reach = self.radius + other.radius;
                const double square = (self.centroid - other.centroid).squaredNorm();
                if (square > near_ratio * near_ratio * reach * reach) continue;
                found_.push_back({tree_.order[m], tree_.order[n], square < reach * reach});
            }
        }
    }

    const std::vector<Panel>& panels_;
    std::size_t most_;
    ClusterTree tree_;
    std::vector<double> largest_; // largest panel radius of each cluster
    std::vector<Found> found_;
};
} // namespace

bool find_near_panels(const std::vector<Panel>& panels, std::size_t most, std::vector<std::vector<NearPair>>& pairs,
                      std::vector<std::size_t>& level) {
    const std::size_t n = panels.size();
    const std::vector<Found> found = Search(panels, most).run();
    if (found.size() > most) return false;
    std::vector<std::size_t> count(n, 0);
    std::vector<double> smallest(n);
    for (std::size_t t = 0; t < n; ++t) smallest[t] = panels[t].radius;
    for (const Found& pair : found) {
        ++count[pair.first];
        ++count[pair.second];
        if (!pair.touching) continue;
        smallest[pair.first] = std::min(smallest[pair.first], panels[pair.second].radius);
        smallest[pair.second] = std::min(smallest[pair.second], panels[pair.first].radius);
    }
    pairs.assign(n, {});
    for (std::size_t t = 0; t < n; ++t) pairs[t].reserve(count[t]);
    for (const Found& pair : found) {
        pairs[pair.first].push_back({pair.second, pair.touching, 0.0});
        pairs[pair.second].push_back({pair.first, pair.touching, 0.0});
    }
    level.resize(n);
    for (std::size_t t = 0; t < n; ++t) {
        std::sort(pairs[t].begin(), pairs[t].end(),
                  [](const NearPair& a, const NearPair& b) { return a.panel < b.panel; });
        const double ratio = panels[t].radius / smallest[t];
        level[t] = ratio > 3.0 ? 2 : (ratio > 1.5 ? 1 : 0);
    }
    return true;
}
} // namespace lr::baker
