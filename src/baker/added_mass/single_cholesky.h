// Cholesky factors in single precision: half the memory and twice the lanes; iterative refinement gives solutions in double
// precision. No multiply-add is fused, so that each instruction set gives the same bits.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace lr::baker {

class SingleCholesky {
public:
    // Reads the lower triangle. False if a pivot is not positive.
    bool factorise(const Eigen::MatrixXd& matrix) { return factorise(matrix, 0.0F, nullptr); }

    // Unknowns to leave out, one after the other, so that all pivots are above `least`.
    std::vector<Eigen::Index> weak_unknowns(const Eigen::MatrixXd& matrix, float least);

    // Replaces right sides by solutions, to single precision.
    void solve(Eigen::MatrixXd& right) const;

private:
    bool factorise(const Eigen::MatrixXd& matrix, float least, std::vector<std::size_t>* weak);

    Eigen::Index size_ = 0;
    std::size_t padded_ = 0;
    std::vector<float> factor_; // columns of length padded_; the padding is the unit matrix
};
} // namespace lr::baker
