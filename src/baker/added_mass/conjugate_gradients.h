// Preconditioned conjugate gradients for all rigid modes at once.
#pragma once

#include "baker/added_mass/coarse_space.h"

#include <array>

namespace lr::baker {

struct ModeSolution {
    ModeVectors value;
    std::size_t iterations = 0;
    double residual = 0.0;  // relative, of all modes together
    double condition = 0.0; // of the preconditioned matrix, estimated from the iteration
};

// All modes share the products with the matrix; each has its own search direction. Stops when the error of every mode, in the norm of the
// preconditioner, is at most `tolerance` times the norm of its right side. For modes of mere rounding that norm is a thousandth of the largest one
// instead. False without convergence, or if the matrix is not positive.
bool solve_modes(const ModeOperator& matrix, const ModeOperator& preconditioner, const ModeVectors& right,
                 double tolerance, std::size_t max_iterations, const std::function<void(double)>& progress,
                 ModeSolution& out);
} // namespace lr::baker
