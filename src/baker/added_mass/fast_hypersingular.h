// The matrix of W (boundary_operators.h) as an operator whose time and memory grow linearly with the panels.
#pragma once

#include "baker/added_mass/cluster_tree.h"
#include "baker/added_mass/hypersingular_blocks.h"
#include "baker/added_mass/multipole.h"

#include <functional>

namespace lr::baker {

// A value for each unknown (in the order of the tree) and rigid mode: value[i * mode_lanes + mode].
using ModeVectors = std::vector<double>;

class FastHypersingular {
public:
    // Unknowns in near clusters interact as in the dense matrix (blocks in single precision), far ones as layers of doublets, which requires basis
    // functions that are continuous or end in zero. Keeps references to panels and parts.
    FastHypersingular(const std::vector<Panel>& panels, const BasisParts& parts, unsigned threads);

    // Entries in memory after assembly: near blocks, and moments of all unknowns.
    std::size_t stored_entries() const;

    void assemble(const HypersingularBlocks& blocks, const std::function<void(double)>& progress);

    // y = W x, with expansions up to degree `order`. The same bits for any number of threads.
    void apply(const ModeVectors& x, ModeVectors& y, std::size_t order = expansion_order);

    const ClusterTree& tree() const { return tree_; }
    const std::vector<Eigen::Vector3d>& positions() const { return items_.position; } // of each unknown
    const std::vector<double>& diagonal() const { return diagonal_; }                 // in the order of the tree

private:
    void place_unknowns();
    void assemble_near(const HypersingularBlocks& blocks, const std::function<void(double)>& progress);
    void find_moments();
    void apply_near(uint32_t leaf, const ModeVectors& x, double* y, std::vector<double>& scratch) const;

    struct Near {
        std::size_t block; // in tree_.near
        uint32_t leaf;
        bool transposed; // the block's columns belong to this leaf
    };

    const std::vector<Panel>& panels_;
    const BasisParts& parts_;
    unsigned threads_;
    ClusterItems items_;
    ClusterTree tree_;
    std::vector<std::size_t> block_start_;
    std::vector<float> blocks_;             // for each near pair: rows of `second`, columns of `first`
    std::vector<std::vector<Near>> near_;   // for each leaf cluster
    std::vector<std::size_t> moment_start_; // for each leaf cluster
    // Moments of n . grad R over the basis functions, with lengths in radii of the leaf: one row for each part of a term,
    // one column for each unknown.
    std::vector<float> moments_;
    std::vector<double> diagonal_;
    Expansions multipoles_, locals_;
};
} // namespace lr::baker
