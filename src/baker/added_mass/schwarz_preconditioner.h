// Preconditioner for FastHypersingular: exact inverses on overlapping patches, plus a global coarse space.
#pragma once

#include "baker/added_mass/fast_hypersingular.h"

namespace lr::baker {

// Constant potentials c have no energy in W. These rank-one terms give each the energy of a single unknown: D c c^T D / c^T D c, with D the diagonal
// of W.
class ConstantTerms {
public:
    ConstantTerms(const SurfaceBasis& basis, const FastHypersingular& matrix);
    void add(const ModeVectors& x, ModeVectors& y) const;
    // Adds to the matrix between the given unknowns, in the order of the tree.
    void add(std::span<const uint32_t> unknowns, Eigen::MatrixXd& block) const;

private:
    struct Entry {
        uint32_t other; // unknown of a constant, or constant of an unknown
        double value;   // of D c / sqrt(c^T D c)
    };
    std::vector<std::vector<Entry>> constants_;
    std::vector<std::size_t> start_; // of each unknown's entries
    std::vector<Entry> entries_;
};

class Schwarz {
public:
    Schwarz(const FastHypersingular& matrix, const HypersingularBlocks& blocks, const ConstantTerms& constants,
            unsigned threads, const std::function<void(double)>& progress);
    // z = M r. The same bits for any number of threads.
    void apply(const ModeVectors& r, ModeVectors& z);

private:
    struct Patch {
        std::vector<uint32_t> members; // in the order of the tree
        std::vector<float> inverse;
        std::size_t start; // offset in results_
    };
    void choose_members(const FastHypersingular& matrix);
    void invert(const HypersingularBlocks& blocks, const FastHypersingular& matrix, const ConstantTerms& constants,
                Patch& patch, HypersingularBlocks::Workspace& work) const;

    unsigned threads_;
    std::vector<Patch> patches_;
    std::vector<std::size_t> use_start_; // of each unknown, places in results_
    std::vector<std::size_t> uses_;
    std::vector<double> share_; // 1/sqrt(number of patches that contain the unknown)
    std::vector<double> results_;
};
} // namespace lr::baker
