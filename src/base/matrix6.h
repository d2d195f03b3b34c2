// Small matrices, 6x6 in the order vx vy vz wx wy wz: the runtime has no Eigen.
#pragma once

#include <array>

namespace lr {

using Matrix6 = std::array<double, 36>; // row-major

// diag(m, m, m, J0)
Matrix6 rigid_mass_matrix(double mass, const std::array<double, 9>& inertia);

Matrix6 product(const Matrix6& a, const Matrix6& b);

// Makes a mass matrix dimensionless: blocks divided by mass, mass * length and mass * length^2.
void scale_to_unit(Matrix6& m, double mass, double length);

// By Cholesky; every pivot must exceed `floor`.
bool is_positive_definite(const Matrix6& m, double floor);

// The nearest positive semi-definite matrix to a symmetric one: negative eigenvalues become zero.
void make_semi_definite(Matrix6& m);

// Inverse of a symmetric positive definite matrix; false if it is not.
bool invert_spd(const Matrix6& m, Matrix6& inverse);

// Replaces the diagonal of a symmetric positive semi-definite matrix by its eigenvalues. vectors: orthonormal eigenvectors as columns.
void eigen3(double (&m)[3][3], double (&vectors)[3][3]);

// Simultaneous diagonalisation of mass and damping: M z' = -alpha W z becomes six independent decays.
struct Modes {
    std::array<double, 6> rate; // lambda >= 0 of W x = lambda M x
    Matrix6 from;               // columns: modes, with from^T M from = 1
    Matrix6 to;                 // from^-1 = from^T M
};

// mass: symmetric positive definite; damping: positive semi-definite. False if mass is not positive definite.
bool find_modes(const Matrix6& mass, const Matrix6& damping, Modes& out);

// Added mass about another point. to: that point, relative to the old one. Velocities at the new point give the same energy of the fluid.
void shift_added_mass(Matrix6& m, const std::array<double, 3>& to);

// Rows of unit length, right-handed, each dot product within `tolerance`. False if an entry is not finite.
bool is_rotation(const std::array<double, 9>& rows, double tolerance);
} // namespace lr
