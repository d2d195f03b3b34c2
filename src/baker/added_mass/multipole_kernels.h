// The inner loops of the fast multipole method, for every instruction set. As in panel_kernels.h nothing is fused and no
// sum runs across lanes, so that each set gives the same bits.
#pragma once

#include <cstddef>

namespace lr::baker {

// Vectors hold a value for each of the six rigid modes, padded: value[i * mode_lanes + mode].
constexpr std::size_t mode_lanes = 8;

// Expansions keep solid harmonics up to this degree. Of two clusters as close as ClusterTree allows, the interaction is
// then right to 1e-4 in the worst case; each degree less loses a factor of about 2.
constexpr std::size_t expansion_order = 8;
constexpr std::size_t expansion_terms = (expansion_order + 1) * (expansion_order + 2) / 2;
// Values of all modes, real and imaginary part for each term: value[(2 * term(l, m) + part) * mode_lanes + mode].
constexpr std::size_t expansion_size = 2 * expansion_terms * mode_lanes;

// Degree l, order 0 <= m <= l.
constexpr std::size_t term(std::size_t l, std::size_t m) {
    return l * (l + 1) / 2 + m;
}

// With R_l^m = r^l P_l^m e^(i m phi) / (l + m)! (no Condon-Shortley phase) a multipole expansion about a centre holds
// sum of charge R_l^m(place), and a local expansion the coefficients of Re R_l^m and Im R_l^m of the potential. Where
// m = 0 multipoles hold half of that and locals twice: the formulas need no exceptions then.
//
// All add to their result, and take degrees up to `order` only. Multipoles about a parent's centre from those about a child's; offset: child less parent.
void shift_multipole(const double* child, const double* offset, std::size_t order, double* parent);
// The transpose of shift_multipole.
void shift_local(const double* parent, const double* offset, std::size_t order, double* child);
// The potential 1/r of a multipole, without the factor 2 (-1)^l of its degree; offset: local less multipole.
void add_multipole(const double* multipole, const double* offset, std::size_t order, double* local);

// y += B x and y += B^T x, with `rows` values of y (of x) and `columns` of x (of y). scratch: rows * columns.
void multiply_block(const float* block, std::size_t rows, std::size_t columns, const double* x, double* y,
                    double* scratch);
void multiply_transposed(const float* block, std::size_t rows, std::size_t columns, const double* x, double* y,
                         double* scratch);

// Point charges: x y z, then a charge for each mode.
constexpr std::size_t charge_fields = 3 + mode_lanes;
// The gradient of their potential 1/r at a point, along `normal`; a charge at the point itself adds nothing.
void add_normal_gradient(const double* charges, std::size_t count, const double* point, const double* normal,
                         double* sum);

} // namespace lr::baker
