#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "baker/added_mass/single_cholesky.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "baker/added_mass/single_cholesky.h"

#include "hwy/highway.h"

#ifndef LR_BAKER_SINGLE_CHOLESKY_TILES
#define LR_BAKER_SINGLE_CHOLESKY_TILES
namespace lr::baker {
constexpr std::size_t tile = 32;    // every size and offset is a multiple
constexpr std::size_t depth = 256;  // of a packed block
constexpr std::size_t height = 128; // of a packed block
constexpr std::size_t right_sides = 8;

struct Packed {
    std::vector<float> left, right;
};
} // namespace lr::baker
#endif

HWY_BEFORE_NAMESPACE();
namespace lr::baker::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;

HWY_INLINE V mul_add(V a, V b, V c) {
    return hn::Add(hn::Mul(a, b), c);
}

// c -= a b^T for one tile of 2 vectors by 4 columns; a and b packed, k deep.
HWY_INLINE void multiply_tile(float* c, size_t stride, const float* a, const float* b, size_t k) {
    const D d;
    const size_t lanes = hn::Lanes(d);
    const V zero = hn::Zero(d);
    V c00 = zero, c01 = zero, c02 = zero, c03 = zero, c10 = zero, c11 = zero, c12 = zero, c13 = zero;
    for (size_t p = 0; p < k; ++p, a += tile, b += 4) {
        const V a0 = hn::LoadU(d, a), a1 = hn::LoadU(d, a + lanes);
        const V b0 = hn::Set(d, b[0]), b1 = hn::Set(d, b[1]), b2 = hn::Set(d, b[2]), b3 = hn::Set(d, b[3]);
        c00 = mul_add(a0, b0, c00), c10 = mul_add(a1, b0, c10);
        c01 = mul_add(a0, b1, c01), c11 = mul_add(a1, b1, c11);
        c02 = mul_add(a0, b2, c02), c12 = mul_add(a1, b2, c12);
        c03 = mul_add(a0, b3, c03), c13 = mul_add(a1, b3, c13);
    }
    const V all[8] = {c00, c10, c01, c11, c02, c12, c03, c13};
    for (size_t j = 0; j < 4; ++j)
        for (size_t i = 0; i < 2; ++i) {
            float* const at = c + j * stride + i * lanes;
            hn::StoreU(hn::Sub(hn::LoadU(d, at), all[2 * j + i]), d, at);
        }
}

// C (m x n) -= A (m x k) B^T (n x k), columns `stride` apart; if `lower`, only tiles of C on or below the diagonal.
HWY_NOINLINE void multiply(float* c, const float* a, const float* b, size_t m, size_t n, size_t k, size_t stride,
                           bool lower, Packed& packed) {
    const size_t step = 2 * hn::Lanes(D());
    packed.left.resize(height * depth);
    packed.right.resize(n * depth);
    for (size_t k0 = 0; k0 < k; k0 += depth) {
        const size_t deep = HWY_MIN(depth, k - k0);
        float* to = packed.right.data();
        for (size_t j = 0; j < n; j += 4)
            for (size_t p = 0; p < deep; ++p, to += 4)
                for (size_t q = 0; q < 4; ++q) to[q] = b[(k0 + p) * stride + j + q];
        for (size_t i0 = 0; i0 < m; i0 += height) {
            const size_t high = HWY_MIN(height, m - i0);
            to = packed.left.data();
            for (size_t i = 0; i < high; i += tile)
                for (size_t p = 0; p < deep; ++p, to += tile)
                    for (size_t q = 0; q < tile; ++q) to[q] = a[(k0 + p) * stride + i0 + i + q];
            const size_t columns = lower ? HWY_MIN(n, i0 + high) : n;
            for (size_t j = 0; j < columns; j += 4)
                for (size_t i = 0; i < high; i += tile) {
                    if (lower && i0 + i + tile <= j) continue;
                    for (size_t q = 0; q < tile; q += step)
                        multiply_tile(c + j * stride + i0 + i + q, stride, packed.left.data() + i * deep + q,
                                      packed.right.data() + j * deep, deep);
                }
        }
    }
}

// A (m x n) becomes A L^-T.
HWY_NOINLINE void solve_rows(float* a, const float* l, size_t m, size_t n, size_t stride, Packed& packed) {
    const D d;
    if (n == tile) {
        for (size_t j = 0; j < n; ++j) {
            const V inverse = hn::Set(d, 1.0f / l[j * stride + j]);
            for (size_t i = 0; i < m; i += hn::Lanes(d)) {
                V sum = hn::LoadU(d, a + j * stride + i);
                for (size_t p = 0; p < j; ++p)
                    sum = hn::Sub(sum, hn::Mul(hn::LoadU(d, a + p * stride + i), hn::Set(d, l[p * stride + j])));
                hn::StoreU(hn::Mul(sum, inverse), d, a + j * stride + i);
            }
        }
        return;
    }
    const size_t half = n / 2 / tile * tile;
    solve_rows(a, l, m, half, stride, packed);
    multiply(a + half * stride, a, l + half, m, n - half, half, stride, false, packed);
    solve_rows(a + half * stride, l + half * stride + half, m, n - half, stride, packed);
}

// An unknown whose pivot is at most `least` is left out, and its number appended to `weak`; without that list the result is false. first: number of
// the first unknown.
HWY_NOINLINE bool factorise(float* a, size_t n, size_t stride, Packed& packed, float least, size_t first,
                            std::vector<size_t>* weak) {
    if (n == tile) {
        const D d;
        for (size_t j = 0; j < n; ++j) {
            float* const column = a + j * stride;
            for (size_t p = 0; p < j; ++p) {
                const float factor = a[p * stride + j];
                // From the start of a vector: entries above the diagonal are never read.
                for (size_t i = j / hn::Lanes(d) * hn::Lanes(d); i < n; i += hn::Lanes(d))
                    hn::StoreU(hn::Sub(hn::LoadU(d, column + i),
                                       hn::Mul(hn::LoadU(d, a + p * stride + i), hn::Set(d, factor))),
                               d, column + i);
            }
            float pivot = column[j];
            if (!(pivot > least)) {
                if (!weak) return false;
                weak->push_back(first + j);
                pivot = 1e36f; // leaves next to nothing of its column
            }
            const float root = __builtin_sqrtf(pivot), inverse = 1.0f / root;
            for (size_t i = j + 1; i < n; ++i) column[i] *= inverse;
            column[j] = root;
        }
        return true;
    }
    const size_t half = n / 2 / tile * tile;
    if (!factorise(a, half, stride, packed, least, first, weak)) return false;
    solve_rows(a + half, a, n - half, half, stride, packed);
    multiply(a + half * stride + half, a + half, a + half, n - half, n - half, half, stride, true, packed);
    return factorise(a + half * stride + half, n - half, stride, packed, least, first + half, weak);
}

// x has right_sides values per row. Lanes are right sides; both sweeps read the factor along its columns.
HWY_NOINLINE void substitute(const float* l, float* x, size_t n) {
    const hn::CappedTag<float, right_sides> d;
    for (size_t lane = 0; lane < right_sides; lane += hn::Lanes(d)) {
        float* const y = x + lane;
        // Four columns at a time: n is a multiple of four.
        for (size_t j = 0; j < n; j += 4) {
            const float* const column = l + j * n;
            hn::Vec<decltype(d)> value[4];
            for (size_t q = 0; q < 4; ++q) {
                value[q] = hn::LoadU(d, y + (j + q) * right_sides);
                for (size_t p = 0; p < q; ++p)
                    value[q] = hn::Sub(value[q], hn::Mul(value[p], hn::Set(d, column[p * n + j + q])));
                value[q] = hn::Mul(value[q], hn::Set(d, 1.0f / column[q * n + j + q]));
                hn::StoreU(value[q], d, y + (j + q) * right_sides);
            }
            for (size_t i = j + 4; i < n; ++i) {
                float* const at = y + i * right_sides;
                auto sum = hn::LoadU(d, at);
                for (size_t q = 0; q < 4; ++q) sum = hn::Sub(sum, hn::Mul(value[q], hn::Set(d, column[q * n + i])));
                hn::StoreU(sum, d, at);
            }
        }
        for (size_t j = n; j-- > 0;) {
            const float* const column = l + j * n;
            // Four sums, because each addition waits for the previous one.
            auto s0 = hn::LoadU(d, y + j * right_sides), s1 = hn::Zero(d), s2 = s1, s3 = s1;
            size_t i = j + 1;
            const auto term = [&](size_t at) HWY_ATTR {
                return hn::Mul(hn::LoadU(d, y + at * right_sides), hn::Set(d, column[at]));
            };
            for (; i + 4 <= n; i += 4) {
                s0 = hn::Sub(s0, term(i)), s1 = hn::Sub(s1, term(i + 1));
                s2 = hn::Sub(s2, term(i + 2)), s3 = hn::Sub(s3, term(i + 3));
            }
            for (; i < n; ++i) s0 = hn::Sub(s0, term(i));
            const auto sum = hn::Add(hn::Add(s0, s1), hn::Add(s2, s3));
            hn::StoreU(hn::Mul(sum, hn::Set(d, 1.0f / column[j])), d, y + j * right_sides);
        }
    }
}
} // namespace lr::baker::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lr::baker {

HWY_EXPORT(factorise);
HWY_EXPORT(substitute);

bool SingleCholesky::factorise(const Eigen::MatrixXd& matrix, float least, std::vector<std::size_t>* weak) {
    size_ = matrix.rows();
    const auto n = static_cast<std::size_t>(size_);
    padded_ = (n + tile - 1) / tile * tile;
    factor_.assign(padded_ * padded_, 0.0f);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = j; i < n; ++i)
            factor_[j * padded_ + i] =
                static_cast<float>(matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
    for (std::size_t j = n; j < padded_; ++j) factor_[j * padded_ + j] = 1.0f;
    Packed packed;
    return HWY_DYNAMIC_DISPATCH(factorise)(factor_.data(), padded_, padded_, packed, least, 0, weak);
}

std::vector<Eigen::Index> SingleCholesky::weak_unknowns(const Eigen::MatrixXd& matrix, float least) {
    std::vector<std::size_t> weak;
    factorise(matrix, least, &weak);
    return {weak.begin(), weak.end()};
}

void SingleCholesky::solve(Eigen::MatrixXd& right) const {
    for (Eigen::Index first = 0; first < right.cols(); first += right_sides) {
        const Eigen::Index count = std::min(static_cast<Eigen::Index>(right_sides), right.cols() - first);
        std::vector<float> x(padded_ * right_sides, 0.0f);
        for (Eigen::Index i = 0; i < size_; ++i)
            for (Eigen::Index k = 0; k < count; ++k)
                x[static_cast<std::size_t>(i) * right_sides + static_cast<std::size_t>(k)] =
                    static_cast<float>(right(i, first + k));
        HWY_DYNAMIC_DISPATCH(substitute)(factor_.data(), x.data(), padded_);
        for (Eigen::Index i = 0; i < size_; ++i)
            for (Eigen::Index k = 0; k < count; ++k)
                right(i, first + k) =
                    static_cast<double>(x[static_cast<std::size_t>(i) * right_sides + static_cast<std::size_t>(k)]);
    }
}
} // namespace lr::baker
#endif // HWY_ONCE
