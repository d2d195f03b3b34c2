// Eigenvalues and eigenvectors of symmetric matrices. Eigen's solver takes seconds to compile, so one file instantiates it.
#pragma once

#include <Eigen/Core>

namespace lr::baker {

template <class Matrix> struct Eigensystem {
    Eigen::Matrix<double, Matrix::RowsAtCompileTime, 1> values; // rising
    Matrix vectors;                                             // unit columns
};
// Of 2x2, 3x3, 6x6 and dynamic matrices.
template <class Matrix> Eigensystem<Matrix> eigensystem(const Matrix& symmetric);

// Rising. `beside` is the diagonal next to the main one.
Eigen::VectorXd tridiagonal_eigenvalues(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& beside);
} // namespace lr::baker
