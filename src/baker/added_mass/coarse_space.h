// The global part of the preconditioner.
#pragma once

#include "baker/added_mass/fast_hypersingular.h"

#include <Eigen/Core>

namespace lr::baker {

using ModeOperator = std::function<void(const ModeVectors&, ModeVectors&)>;

// A partition of unity over a few dozen clusters, with the inverse of the matrix between its functions.
class CoarseSpace {
public:
    CoarseSpace(const FastHypersingular& matrix, const ModeOperator& apply,
                const std::function<void(double)>& progress);

    // z += Z (Z^T W Z)^-1 Z^T r
    void add(const ModeVectors& r, ModeVectors& z) const;

private:
    struct Weight {
        uint32_t function;
        double value;
    };
    void choose_functions(const FastHypersingular& matrix);

    std::size_t size_ = 0;
    std::vector<std::size_t> start_; // of each unknown's weights
    std::vector<Weight> weights_;
    Eigen::MatrixXd inverse_;
};
} // namespace lr::baker
