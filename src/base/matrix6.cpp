#include "base/matrix6.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

Matrix6 unit_matrix() {
    Matrix6 m{};
    for (size_t i = 0; i < 6; ++i) m[i * 7] = 1.0;
    return m;
}
void make_symmetric(Matrix6& m) {
    for (size_t i = 0; i < 6; ++i)
        for (size_t j = 0; j < i; ++j) m[i * 6 + j] = m[j * 6 + i] = 0.5 * (m[i * 6 + j] + m[j * 6 + i]);
}

// m = l l^T with l lower triangular; false when a pivot is not above `floor`.
bool cholesky(const Matrix6& m, double floor, Matrix6& l) {
    l = {};
    for (size_t j = 0; j < 6; ++j) {
        double pivot = m[j * 6 + j];
        for (size_t k = 0; k < j; ++k) pivot -= l[j * 6 + k] * l[j * 6 + k];
        if (!(pivot > floor)) return false;
        l[j * 6 + j] = std::sqrt(pivot);
        for (size_t i = j + 1; i < 6; ++i) {
            double v = m[i * 6 + j];
            for (size_t k = 0; k < j; ++k) v -= l[i * 6 + k] * l[j * 6 + k];
            l[i * 6 + j] = v / l[j * 6 + j];
        }
    }
    return true;
}

// Cyclic Jacobi (Golub and Van Loan, section 8.5): `a` becomes diagonal; columns of the result are its eigenvectors. Takes some six sweeps; the bound
// is for NaN.
Matrix6 diagonalise(Matrix6& a) {
    Matrix6 v = unit_matrix();
    for (int sweep = 0; sweep < 30; ++sweep) {
        bool rotated = false;
        for (size_t p = 0; p < 6; ++p)
            for (size_t q = p + 1; q < 6; ++q) {
                const double off = a[p * 6 + q];
                if (std::abs(off) <= 1e-18 * (std::abs(a[p * 7]) + std::abs(a[q * 7]))) continue;
                rotated = true;
                const double theta = 0.5 * (a[q * 7] - a[p * 7]) / off;
                const double t = (theta < 0.0 ? -1.0 : 1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
                const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
                const auto turn = [&](double& x, double& y) {
                    const double before = x;
                    x = c * before - s * y;
                    y = s * before + c * y;
                };
                for (size_t k = 0; k < 6; ++k) turn(a[k * 6 + p], a[k * 6 + q]);
                for (size_t k = 0; k < 6; ++k) turn(a[p * 6 + k], a[q * 6 + k]);
                for (size_t k = 0; k < 6; ++k) turn(v[k * 6 + p], v[k * 6 + q]);
                a[p * 6 + q] = a[q * 6 + p] = 0.0;
            }
        if (!rotated) break;
    }
    return v;
}

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
} // namespace

Matrix6 rigid_mass_matrix(double mass, const std::array<double, 9>& inertia) {
    Matrix6 m{};
    for (size_t i = 0; i < 3; ++i) {
        m[i * 6 + i] = mass;
        for (size_t j = 0; j < 3; ++j) m[(i + 3) * 6 + j + 3] = inertia[i * 3 + j];
    }
    return m;
}

Matrix6 product(const Matrix6& a, const Matrix6& b) {
    Matrix6 c{};
    for (size_t i = 0; i < 36; ++i)
        for (size_t k = 0; k < 6; ++k) c[i] += a[i / 6 * 6 + k] * b[k * 6 + i % 6];
    return c;
}

void scale_to_unit(Matrix6& m, double mass, double length) {
    for (size_t i = 0; i < 6; ++i)
        for (size_t j = 0; j < 6; ++j) m[i * 6 + j] /= mass * (i < 3 ? 1.0 : length) * (j < 3 ? 1.0 : length);
}

void make_semi_definite(Matrix6& m) {
    Matrix6 a = m;
    const Matrix6 v = diagonalise(a);
    for (size_t e = 0; e < 6; ++e)
        if (a[e * 7] < 0.0)
            for (size_t i = 0; i < 6; ++i)
                for (size_t j = 0; j < 6; ++j) m[i * 6 + j] -= a[e * 7] * (v[i * 6 + e] * v[j * 6 + e]);
}

bool find_modes(const Matrix6& mass, const Matrix6& damping, Modes& out) {
    Matrix6 c;
    if (!cholesky(mass, 0.0, c)) return false;
    // c^-1 W c^-T
    Matrix6 reduced = solve_lower(c, transposed(solve_lower(c, damping)));
    make_symmetric(reduced);
    const Matrix6 vectors = diagonalise(reduced);
    out.from = solve_lower_transposed(c, vectors);
    // from^-1 = vectors^T c^T
    out.to = product(transposed(vectors), transposed(c));
    for (size_t i = 0; i < 6; ++i) out.rate[i] = std::max(0.0, reduced[i * 7]);
    return true;
}

bool is_positive_definite(const Matrix6& m, double floor) {
    Matrix6 l;
    return cholesky(m, floor, l);
}

void shift_added_mass(Matrix6& m, const std::array<double, 3>& to) {
    // v_old = v_new + w x (old - new) = v_new + to x w: the old twist is T times the new one, so m becomes T^T m T.
    Matrix6 t = unit_matrix();
    t[0 * 6 + 4] = -to[2], t[0 * 6 + 5] = to[1];
    t[1 * 6 + 3] = to[2], t[1 * 6 + 5] = -to[0];
    t[2 * 6 + 3] = -to[1], t[2 * 6 + 4] = to[0];
    m = product(transposed(t), product(m, t));
    make_symmetric(m);
}

bool invert_spd(const Matrix6& m, Matrix6& inverse) {
    Matrix6 l;
    if (!cholesky(m, 0.0, l)) return false;
    inverse = solve_lower_transposed(l, solve_lower(l, unit_matrix()));
    make_symmetric(inverse);
    return true;
}

void eigen3(double (&m)[3][3], double (&vectors)[3][3]) {
    Matrix6 padded{}; // the padding stays separate
    for (size_t i = 0; i < 9; ++i) padded[i / 3 * 6 + i % 3] = m[i / 3][i % 3];
    make_symmetric(padded);
    const Matrix6 v = diagonalise(padded);
    for (size_t i = 0; i < 9; ++i) vectors[i / 3][i % 3] = v[i / 3 * 6 + i % 3];
    for (size_t i = 0; i < 3; ++i) m[i][i] = std::max(0.0, padded[i * 7]);
}

bool is_rotation(const std::array<double, 9>& rows, double tolerance) {
    const auto& q = rows;
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j <= i; ++j) {
            const double dot = q[i * 3] * q[j * 3] + q[i * 3 + 1] * q[j * 3 + 1] + q[i * 3 + 2] * q[j * 3 + 2];
            if (!(std::abs(dot - (i == j ? 1.0 : 0.0)) < tolerance)) return false;
        }
    return q[0] * (q[4] * q[8] - q[5] * q[7]) + q[1] * (q[5] * q[6] - q[3] * q[8]) +
               q[2] * (q[3] * q[7] - q[4] * q[6]) >
           0.0;
}
} // namespace lr
