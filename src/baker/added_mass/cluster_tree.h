// A binary tree of clusters of points, with the pairs of clusters far enough apart for expansions.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lr::baker {

// Items are clustered by position; item i extends to the points support[start[i]] to support[start[i + 1]].
struct ClusterItems {
    std::vector<Eigen::Vector3d> position;
    std::vector<std::size_t> start; // empty: items are points
    std::vector<Eigen::Vector3d> support;
};

struct Cluster {
    uint32_t begin, end; // in ClusterTree::order
    int32_t parent = -1, first_child = -1, second_child = -1;
    Eigen::Vector3d centre;
    double radius; // around the centre, contains the supports of all items
    bool is_leaf() const { return first_child < 0; }
};

struct ClusterPair {
    uint32_t first, second;
};

struct ClusterTree {
    std::vector<uint32_t> order;   // items
    std::vector<Cluster> clusters; // parents before children
    std::vector<uint32_t> leaves;  // in the order of their items
    std::vector<std::vector<uint32_t>> levels;
    // Every pair of items is in exactly one pair of clusters. near: pairs of leaves, first <= second. far: for each cluster,
    // its far clusters, in both directions.
    std::vector<ClusterPair> near;
    std::vector<std::size_t> far_start;
    std::vector<uint32_t> far;
};

// Clusters are split at the middle item along their longest side until they hold at most leaf_size.
ClusterTree build_cluster_tree(const ClusterItems& items, std::size_t leaf_size);

// Fills near and far: a pair is far if the sum of its radii is at most `separation` times its distance.
void find_cluster_pairs(ClusterTree& tree, double separation);
} // namespace lr::baker
