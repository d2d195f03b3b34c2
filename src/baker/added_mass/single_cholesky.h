// Cholesky factors in single precision: half the memory and twice the lanes. Good for solutions in double by iterative
// refinement. Products and sums are never fused: each instruction set gives the same bits.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace lr::baker {

class SingleCholesky {
public:
    // Of the lower triangle. False where a pivot is not positive.
    bool factorise(const Eigen::MatrixXd& matrix);

    // Replaces right sides by solutions, to single precision.
    void solve(Eigen::MatrixXd& right) const;

private:
    Eigen::Index size_ = 0;
    std::size_t padded_ = 0;
    std::vector<float> factor_; // columns of padded_, the padding is the unit matrix
};

} // namespace lr::baker
