#include "baker/eigensystem.h"

#include <Eigen/Eigenvalues>

namespace lr::baker {

// One solver for all sizes: one for each takes the compiler three times as long.
template <class Matrix> Eigensystem<Matrix> eigensystem(const Matrix& symmetric) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{Eigen::MatrixXd(symmetric)};
    return {solver.eigenvalues(), solver.eigenvectors()};
}
template Eigensystem<Eigen::Matrix2d> eigensystem(const Eigen::Matrix2d&);
template Eigensystem<Eigen::Matrix3d> eigensystem(const Eigen::Matrix3d&);
template Eigensystem<Eigen::Matrix<double, 6, 6>> eigensystem(const Eigen::Matrix<double, 6, 6>&);
template Eigensystem<Eigen::MatrixXd> eigensystem(const Eigen::MatrixXd&);

Eigen::VectorXd tridiagonal_eigenvalues(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& beside) {
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
    return solver.eigenvalues();
}
} // namespace lr::baker
