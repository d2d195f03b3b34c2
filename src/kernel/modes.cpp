#include "kernel/modes.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

// c^-1 m, c lower triangular.
Matrix6 solve_lower(const Matrix6& c, Matrix6 m) {
    for (size_t j = 0; j < 6; ++j)
        for (size_t i = 0; i < 6; ++i) {
            for (size_t k = 0; k < i; ++k) m[i * 6 + j] -= c[i * 6 + k] * m[k * 6 + j];
            m[i * 6 + j] /= c[i * 7];
        }
    return m;
}

// c^-T m
Matrix6 solve_lower_transposed(const Matrix6& c, Matrix6 m) {
    for (size_t j = 0; j < 6; ++j)
        for (size_t i = 6; i-- > 0;) {
            for (size_t k = i + 1; k < 6; ++k) m[i * 6 + j] -= c[k * 6 + i] * m[k * 6 + j];
            m[i * 6 + j] /= c[i * 7];
        }
    return m;
}

Matrix6 transposed(const Matrix6& m) {
    Matrix6 t;
    for (size_t i = 0; i < 6; ++i)
        for (size_t j = 0; j < 6; ++j) t[i * 6 + j] = m[j * 6 + i];
    return t;
}

// Golub and Van Loan, Matrix Computations, section 8.5: rotations until the off-diagonal part is rounding.
void jacobi(Matrix6& a, Matrix6& vectors) {
    vectors = {};
    for (size_t i = 0; i < 6; ++i) vectors[i * 7] = 1.0;
    for (int sweep = 0; sweep < 40; ++sweep) {
        double off = 0.0, all = 0.0;
        for (size_t i = 0; i < 6; ++i)
            for (size_t j = 0; j < 6; ++j) (i == j ? all : off) += a[i * 6 + j] * a[i * 6 + j];
        if (off <= 1e-30 * (all + off)) return;
        for (size_t p = 0; p < 6; ++p)
            for (size_t q = p + 1; q < 6; ++q) {
                const double apq = a[p * 6 + q];
                if (apq == 0.0) continue;
                const double theta = (a[q * 7] - a[p * 7]) / (2.0 * apq);
                const double t = (theta >= 0.0 ? 1.0 : -1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
                const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
                for (size_t k = 0; k < 6; ++k) {
                    const double x = a[k * 6 + p], y = a[k * 6 + q];
                    a[k * 6 + p] = c * x - s * y;
                    a[k * 6 + q] = s * x + c * y;
                }
                for (size_t k = 0; k < 6; ++k) {
                    const double x = a[p * 6 + k], y = a[q * 6 + k];
                    a[p * 6 + k] = c * x - s * y;
                    a[q * 6 + k] = s * x + c * y;
                }
                for (size_t k = 0; k < 6; ++k) {
                    const double x = vectors[k * 6 + p], y = vectors[k * 6 + q];
                    vectors[k * 6 + p] = c * x - s * y;
                    vectors[k * 6 + q] = s * x + c * y;
                }
            }
    }
}

} // namespace

bool find_modes(const Matrix6& mass, const Matrix6& damping, Modes& out) {
    Matrix6 c;
    if (!cholesky(mass, 0.0, c)) return false;
    // c^-1 W c^-T
    Matrix6 reduced = solve_lower(c, transposed(solve_lower(c, damping)));
    for (size_t i = 0; i < 6; ++i)
        for (size_t j = 0; j < i; ++j)
            reduced[i * 6 + j] = reduced[j * 6 + i] = 0.5 * (reduced[i * 6 + j] + reduced[j * 6 + i]);
    Matrix6 vectors;
    jacobi(reduced, vectors);
    out.from = solve_lower_transposed(c, vectors);
    // from^-1 = vectors^T c^T
    out.to = {};
    for (size_t i = 0; i < 6; ++i) {
        out.rate[i] = std::max(0.0, reduced[i * 7]);
        for (size_t j = 0; j < 6; ++j)
            for (size_t k = 0; k < 6; ++k) out.to[i * 6 + j] += vectors[k * 6 + i] * c[j * 6 + k];
    }
    return true;
}

} // namespace lr
