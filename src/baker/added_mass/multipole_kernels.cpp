#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "baker/added_mass/multipole_kernels.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "baker/added_mass/multipole_kernels.h"

#include "hwy/highway.h"

#include <algorithm>
#include <cmath>

#ifndef LR_BAKER_HARMONIC_TABLE
#define LR_BAKER_HARMONIC_TABLE
namespace lr::baker {

// Solid harmonics of one point, orders -l to l, zero beyond; padded so that vectors can read past the end.
template <std::size_t Degree> struct HarmonicTable {
    static constexpr std::size_t middle = 2 * expansion_order, stride = 2 * middle + 8;
    double re[(Degree + 1) * stride] = {}, im[(Degree + 1) * stride] = {};

    void mirror() {
        for (std::size_t l = 1; l <= Degree; ++l)
            for (std::size_t m = 1; m <= l; ++m) {
                const std::size_t at = l * stride + middle;
                const double sign = m % 2 ? -1.0 : 1.0;
                re[at - m] = sign * re[at + m];
                im[at - m] = -sign * im[at + m];
            }
    }
};
using RegularTable = HarmonicTable<expansion_order>;
using IrregularTable = HarmonicTable<2 * expansion_order>;

inline void fill_regular(const double* v, RegularTable& table) {
    const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    constexpr std::size_t s = RegularTable::stride;
    double *re = table.re + RegularTable::middle, *im = table.im + RegularTable::middle;
    re[0] = 1.0;
    for (std::size_t m = 0; m <= expansion_order; ++m) {
        const std::size_t at = m * s + m;
        if (m > 0) {
            const std::size_t before = at - s - 1;
            const double f = 0.5 / static_cast<double>(m);
            re[at] = f * (v[0] * re[before] - v[1] * im[before]);
            im[at] = f * (v[0] * im[before] + v[1] * re[before]);
        }
        for (std::size_t l = m; l < expansion_order; ++l) {
            const auto n = static_cast<double>(l + 1);
            const double f = 1.0 / (n * n - static_cast<double>(m * m)), a = f * (2.0 * n - 1.0) * v[2];
            const double b = l > m ? f * square : 0.0;
            const std::size_t here = l * s + m, last = l > m ? here - s : here;
            re[here + s] = a * re[here] - b * re[last];
            im[here + s] = a * im[here] - b * im[last];
        }
    }
    table.mirror();
}
} // namespace lr::baker
#endif

HWY_BEFORE_NAMESPACE();
namespace lr::baker::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, mode_lanes>;
using V = hn::Vec<D>;

HWY_INLINE V mul_add(V a, V b, V c) {
    return hn::Add(hn::Mul(a, b), c);
}

// I_l^m = (l - m)! P_l^m e^(i m phi) / r^(l + 1), all orders of a degree at a time.
HWY_INLINE void fill_irregular(const double* v, size_t top, IrregularTable& table) {
    const D d;
    constexpr size_t s = IrregularTable::stride;
    double *re = table.re + IrregularTable::middle, *im = table.im + IrregularTable::middle;
    const double inverse2 = 1.0 / (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    const double x = v[0] * inverse2, y = v[1] * inverse2, z = v[2] * inverse2;
    re[0] = std::sqrt(inverse2);
    for (size_t l = 0; l < top; ++l) {
        const double f = static_cast<double>(2 * l + 1), *rl = re + l * s, *il = im + l * s;
        const V a = hn::Set(d, f * z), back = hn::Set(d, inverse2), l2 = hn::Set(d, static_cast<double>(l * l));
        double *rn = re + (l + 1) * s, *in = im + (l + 1) * s;
        for (size_t m = 0; m <= l; m += hn::Lanes(d)) { // orders above l are zero in rows l and l - 1
            const V order = hn::Iota(d, static_cast<double>(m));
            const V b = hn::Mul(hn::Sub(l2, hn::Mul(order, order)), back);
            V r = hn::Mul(a, hn::LoadU(d, rl + m)), i = hn::Mul(a, hn::LoadU(d, il + m));
            if (l > 0) {
                r = hn::Sub(r, hn::Mul(b, hn::LoadU(d, rl - s + m)));
                i = hn::Sub(i, hn::Mul(b, hn::LoadU(d, il - s + m)));
            }
            hn::StoreU(r, d, rn + m);
            hn::StoreU(i, d, in + m);
        }
        rn[l + 1] = f * (x * rl[l] - y * il[l]);
        in[l + 1] = f * (x * il[l] + y * rl[l]);
    }
    table.mirror();
}

// Contribution of one source degree to a target term (u, v): u += p a + w b, v += r a + q b for each order.
struct Factors {
    static constexpr size_t stride = 2 * expansion_order;
    HWY_ALIGN double p[stride], w[stride], r[stride], q[stride];
};

HWY_INLINE void accumulate(const Factors& f, const double* source, size_t degree, size_t at, V& u, V& v) {
    const D d;
    const double* from = source + 2 * term(degree, 0) * mode_lanes + at;
    for (size_t k = 0; k <= degree; ++k, from += 2 * mode_lanes) {
        const V a = hn::LoadU(d, from), b = hn::LoadU(d, from + mode_lanes);
        u = hn::Add(u, mul_add(hn::Set(d, f.p[k]), a, hn::Mul(hn::Set(d, f.w[k]), b)));
        v = hn::Add(v, mul_add(hn::Set(d, f.r[k]), a, hn::Mul(hn::Set(d, f.q[k]), b)));
    }
}

// Computes each term (j, i) of the target from the degrees first(j) to last(j) of the source.
template <class Range, class Fill>
HWY_INLINE void translate(const double* source, double* target, size_t order, const Range& range, const Fill& fill) {
    const D d;
    Factors factors[expansion_order + 1];
    for (size_t j = 0; j <= order; ++j) {
        const auto [first, last] = range(j);
        for (size_t i = 0; i <= j; ++i) {
            for (size_t l = first; l <= last; ++l) fill(j, i, l, factors[l]);
            double* const to = target + 2 * term(j, i) * mode_lanes;
            for (size_t at = 0; at < mode_lanes; at += hn::Lanes(d)) {
                V u = hn::LoadU(d, to + at), v = hn::LoadU(d, to + mode_lanes + at);
                for (size_t l = first; l <= last; ++l) accumulate(factors[l], source, l, at, u, v);
                hn::StoreU(u, d, to + at);
                hn::StoreU(v, d, to + mode_lanes + at);
            }
        }
    }
}

struct Degrees {
    size_t first, last;
};

// Greengard and Rokhlin 1997 (Acta Numerica 6) in real form: combines orders k and -k of the source, i and -i of the
// target, with I_l^-m = (-1)^m conj I_l^m.
HWY_NOINLINE void to_local(const double* multipole, const double* offset, size_t order, double* local) {
    IrregularTable table;
    fill_irregular(offset, 2 * order, table);
    constexpr size_t s = IrregularTable::stride, middle = IrregularTable::middle;
    translate(
        multipole, local, order,
        [&](size_t) HWY_ATTR {
            return Degrees{0, order};
        },
        [&](size_t j, size_t i, size_t l, Factors& f) HWY_ATTR {
            const D d;
            const size_t row = (j + l) * s + middle;
            const double *re = table.re + row, *im = table.im + row;
            const V sign = hn::Set(d, i % 2 ? -1.0 : 1.0);
            for (size_t k = 0; k <= l; k += hn::Lanes(d)) {
                const V plus_re = hn::LoadU(d, re + i + k), plus_im = hn::LoadU(d, im + i + k);
                const V minus_re = hn::Mul(sign, hn::LoadU(d, re + k - i)),
                        minus_im = hn::Mul(sign, hn::LoadU(d, im + k - i));
                hn::StoreU(hn::Add(plus_re, minus_re), d, f.p + k);
                hn::StoreU(hn::Add(plus_im, minus_im), d, f.w + k);
                hn::StoreU(hn::Sub(plus_im, minus_im), d, f.r + k);
                hn::StoreU(hn::Sub(minus_re, plus_re), d, f.q + k);
            }
        });
}

// R_n^m(x + offset) = sum R_l^k(x) R_(n-l)^(m-k)(offset), orders k and -k together.
HWY_NOINLINE void to_parent(const double* child, const double* offset, size_t order, double* parent) {
    RegularTable table;
    fill_regular(offset, table);
    constexpr size_t s = RegularTable::stride, middle = RegularTable::middle;
    translate(
        child, parent, order,
        [](size_t n) HWY_ATTR {
            return Degrees{0, n};
        },
        [&](size_t n, size_t m, size_t l, Factors& f) HWY_ATTR {
            const size_t row = (n - l) * s + middle + m;
            const double half = m == 0 ? 0.5 : 1.0;
            for (size_t k = 0; k <= l; ++k) {
                const double sign = k % 2 ? -half : half;
                const double g = half * table.re[row - k], h = half * table.im[row - k];
                const double a = sign * table.re[row + k], b = sign * table.im[row + k];
                f.p[k] = g + a, f.w[k] = b - h, f.r[k] = h + b, f.q[k] = g - a;
            }
        });
}

HWY_NOINLINE void to_child(const double* parent, const double* offset, size_t order, double* child) {
    RegularTable table;
    fill_regular(offset, table);
    constexpr size_t s = RegularTable::stride, middle = RegularTable::middle;
    translate(
        parent, child, order,
        [&](size_t l) HWY_ATTR {
            return Degrees{l, order};
        },
        [&](size_t l, size_t k, size_t n, Factors& f) HWY_ATTR {
            const size_t row = (n - l) * s + middle;
            for (size_t m = 0; m <= n; ++m) {
                const double half = m == 0 ? 0.5 : 1.0, sign = k % 2 ? -half : half;
                const double g = half * table.re[row + m - k], h = half * table.im[row + m - k];
                const double a = sign * table.re[row + m + k], b = sign * table.im[row + m + k];
                f.p[m] = g + a, f.r[m] = b - h, f.w[m] = h + b, f.q[m] = g - a;
            }
        });
}

HWY_INLINE void widen(const float* from, size_t count, double* to) {
    const D d;
    const hn::Rebind<float, D> single;
    size_t i = 0;
    for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d))
        hn::StoreU(hn::PromoteTo(d, hn::LoadU(single, from + i)), d, to + i);
    for (; i < count; ++i) to[i] = static_cast<double>(from[i]);
}

// Four values of y at a time; step_y and step_x are the strides of y and x in the block.
HWY_INLINE void multiply(const double* block, size_t size_y, size_t step_y, size_t size_x, size_t step_x,
                         const double* x, double* y) {
    const D d;
    for (size_t at = 0; at < mode_lanes; at += hn::Lanes(d)) {
        size_t i = 0;
        for (; i + 4 <= size_y; i += 4) {
            double* const to = y + i * mode_lanes + at;
            V y0 = hn::LoadU(d, to), y1 = hn::LoadU(d, to + mode_lanes), y2 = hn::LoadU(d, to + 2 * mode_lanes),
              y3 = hn::LoadU(d, to + 3 * mode_lanes);
            const double* w = block + i * step_y;
            for (size_t j = 0; j < size_x; ++j, w += step_x) {
                const V v = hn::LoadU(d, x + j * mode_lanes + at);
                y0 = mul_add(hn::Set(d, w[0]), v, y0);
                y1 = mul_add(hn::Set(d, w[step_y]), v, y1);
                y2 = mul_add(hn::Set(d, w[2 * step_y]), v, y2);
                y3 = mul_add(hn::Set(d, w[3 * step_y]), v, y3);
            }
            hn::StoreU(y0, d, to);
            hn::StoreU(y1, d, to + mode_lanes);
            hn::StoreU(y2, d, to + 2 * mode_lanes);
            hn::StoreU(y3, d, to + 3 * mode_lanes);
        }
        for (; i < size_y; ++i) {
            V sum = hn::LoadU(d, y + i * mode_lanes + at);
            for (size_t j = 0; j < size_x; ++j)
                sum = mul_add(hn::Set(d, block[i * step_y + j * step_x]), hn::LoadU(d, x + j * mode_lanes + at), sum);
            hn::StoreU(sum, d, y + i * mode_lanes + at);
        }
    }
}

HWY_NOINLINE void block_product(const float* block, size_t rows, size_t columns, const double* x, double* y,
                                double* scratch) {
    widen(block, rows * columns, scratch);
    multiply(scratch, rows, columns, columns, 1, x, y);
}

HWY_NOINLINE void transposed_product(const float* block, size_t rows, size_t columns, const double* x, double* y,
                                     double* scratch) {
    widen(block, rows * columns, scratch);
    multiply(scratch, columns, 1, rows, columns, x, y);
}

HWY_NOINLINE void normal_gradient(const double* charges, size_t count, const double* point, const double* normal,
                                  double* sum) {
    const D d;
    // First the kernels of a batch of charges, then all modes of each.
    constexpr size_t batch = 64;
    HWY_ALIGN double kernel[batch];
    const V px = hn::Set(d, point[0]), py = hn::Set(d, point[1]), pz = hn::Set(d, point[2]);
    const V nx = hn::Set(d, normal[0]), ny = hn::Set(d, normal[1]), nz = hn::Set(d, normal[2]);
    HWY_ALIGN double place[3 * batch];
    for (size_t first = 0; first < count; first += batch) {
        const size_t size = std::min(batch, count - first);
        for (size_t k = 0; k < 3; ++k)
            for (size_t i = 0; i < batch; ++i)
                place[k * batch + i] = charges[(first + std::min(i, size - 1)) * charge_fields + k];
        for (size_t i = 0; i < size; i += hn::Lanes(d)) {
            const V x = hn::Sub(hn::Load(d, place + i), px), y = hn::Sub(hn::Load(d, place + batch + i), py),
                    z = hn::Sub(hn::Load(d, place + 2 * batch + i), pz);
            const V square = mul_add(x, x, mul_add(y, y, hn::Mul(z, z)));
            const V cube = hn::Mul(square, hn::Sqrt(square));
            const V along = mul_add(x, nx, mul_add(y, ny, hn::Mul(z, nz)));
            hn::Store(hn::IfThenElseZero(hn::Gt(cube, hn::Zero(d)), hn::Div(along, cube)), d, kernel + i);
        }
        for (size_t at = 0; at < mode_lanes; at += hn::Lanes(d)) {
            V total = hn::LoadU(d, sum + at);
            for (size_t i = 0; i < size; ++i)
                total =
                    mul_add(hn::Set(d, kernel[i]), hn::LoadU(d, charges + (first + i) * charge_fields + 3 + at), total);
            hn::StoreU(total, d, sum + at);
        }
    }
}
} // namespace lr::baker::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lr::baker {

HWY_EXPORT(to_local);
HWY_EXPORT(to_parent);
HWY_EXPORT(to_child);
HWY_EXPORT(block_product);
HWY_EXPORT(transposed_product);
HWY_EXPORT(normal_gradient);

void shift_multipole(const double* child, const double* offset, std::size_t order, double* parent) {
    HWY_DYNAMIC_DISPATCH(to_parent)(child, offset, order, parent);
}
void shift_local(const double* parent, const double* offset, std::size_t order, double* child) {
    HWY_DYNAMIC_DISPATCH(to_child)(parent, offset, order, child);
}
void add_multipole(const double* multipole, const double* offset, std::size_t order, double* local) {
    HWY_DYNAMIC_DISPATCH(to_local)(multipole, offset, order, local);
}
void multiply_block(const float* block, std::size_t rows, std::size_t columns, const double* x, double* y,
                    double* scratch) {
    HWY_DYNAMIC_DISPATCH(block_product)(block, rows, columns, x, y, scratch);
}
void multiply_transposed(const float* block, std::size_t rows, std::size_t columns, const double* x, double* y,
                         double* scratch) {
    HWY_DYNAMIC_DISPATCH(transposed_product)(block, rows, columns, x, y, scratch);
}
void add_normal_gradient(const double* charges, std::size_t count, const double* point, const double* normal,
                         double* sum) {
    HWY_DYNAMIC_DISPATCH(normal_gradient)(charges, count, point, normal, sum);
}
} // namespace lr::baker
#endif // HWY_ONCE
