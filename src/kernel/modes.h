// Simultaneous diagonalisation of mass and damping: M z' = -alpha W z falls apart into six decays.
#pragma once

#include "format/matrix6.h"

#include <array>

namespace lr {

struct Modes {
    std::array<double, 6> rate; // lambda >= 0 of W x = lambda M x
    Matrix6 from;               // columns: modes, with from^T M from = 1
    Matrix6 to;                 // from^-1 = from^T M
};

// By Cholesky and cyclic Jacobi rotations. mass: symmetric positive definite; damping: positive semi-definite. False
// when mass is not positive definite.
bool find_modes(const Matrix6& mass, const Matrix6& damping, Modes& out);

} // namespace lr
