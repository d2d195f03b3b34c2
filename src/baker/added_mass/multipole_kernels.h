// The inner loops of the fast multipole method, for every instruction set. As in panel_kernels.h, no multiply-add is fused and no
// sum crosses lanes, so that each set gives the same bits.
#pragma once

#include <cstddef>

namespace lr::baker {

// Vectors have one value for each of the six rigid modes, padded: value[i * mode_lanes + mode].
constexpr std::size_t mode_lanes = 8;

// Largest degree of solid harmonics in expansions. Two clusters at the smallest distance of ClusterTree then interact with an error of at most 1e-4;
// each degree less about doubles it.
constexpr std::size_t expansion_order = 8;
constexpr std::size_t expansion_terms = (expansion_order + 1) * (expansion_order + 2) / 2;
// Values of all modes, real and imaginary part of each term: value[(2 * term(l, m) + part) * mode_lanes + mode].
constexpr std::size_t expansion_size = 2 * expansion_terms * mode_lanes;

// Degree l, order 0 <= m <= l.
constexpr std::size_t term(std::size_t l, std::size_t m) {
    return l * (l + 1) / 2 + m;
}

// With R_l^m = r^l P_l^m e^(i m phi) / (l + m)! (no Condon-Shortley phase) a multipole expansion about a centre is the sum of charge R_l^m(position);
// a local expansion has the coefficients of Re R_l^m and Im R_l^m of the potential. At m = 0 multipoles are halved and locals doubled, which spares
// the formulas a special case.
// All functions add to their result and use degrees up to `order`. shift_multipole: from a child's centre to its parent's; offset: child - parent.
void shift_multipole(const double* child, const double* offset, std::size_t order, double* parent);
// The transpose of shift_multipole.
void shift_local(const double* parent, const double* offset, std::size_t order, double* child);
// The potential 1/r of a multipole, without the factor 2 (-1)^l of its degree; offset: local - multipole.
void add_multipole(const double* multipole, const double* offset, std::size_t order, double* local);

// y += B x and y += B^T x, with `rows` values of y (of x) and `columns` of x (of y). scratch: rows * columns.
void multiply_block(const float* block, std::size_t rows, std::size_t columns, const double* x, double* y,
                    double* scratch);
void multiply_transposed(const float* block, std::size_t rows, std::size_t columns, const double* x, double* y,
                         double* scratch);

// Point charges: x y z, then a charge for each mode.
constexpr std::size_t charge_fields = 3 + mode_lanes;
// The gradient of their potential 1/r at a point, along `normal`; a charge at the point adds nothing.
void add_normal_gradient(const double* charges, std::size_t count, const double* point, const double* normal,
                         double* sum);
} // namespace lr::baker
