// Preconditioned conjugate gradients for all rigid modes at once.
#pragma once

#include "baker/added_mass/coarse_space.h"

#include <array>

namespace lr::baker {

struct ModeSolution {
    ModeVectors value;
    std::size_t iterations = 0;
    double residual = 0.0;  // relative, of all modes together
    double condition = 0.0; // of the preconditioned matrix, from the iteration itself
};

// Modes share products with the matrix, each has its own search. Stops once the error of every mode in the norm of the
// preconditioner is `tolerance` times that of its right side - or of the millionth part of the largest, for a mode that
// is nothing but noise. False if it does not get there, or the matrix is not positive.
bool solve_modes(const ModeOperator& matrix, const ModeOperator& preconditioner, const ModeVectors& right,
                 double tolerance, std::size_t max_iterations, const std::function<void(double)>& progress,
                 ModeSolution& out);

} // namespace lr::baker
