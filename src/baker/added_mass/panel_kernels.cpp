#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "baker/added_mass/panel_kernels.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "baker/added_mass/panel_kernels.h"

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace lr::baker::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, near_batch>;
using DI = hn::RebindToSigned<D>;
using V = hn::Vec<D>;

struct Vec3 {
    V x, y, z;
};

HWY_INLINE V constant(double x) {
    return hn::Set(D(), x);
}
HWY_INLINE V mul_add(V a, V b, V c) {
    return hn::Add(hn::Mul(a, b), c);
}
HWY_INLINE V dot(const Vec3& a, const Vec3& b) {
    return mul_add(a.x, b.x, mul_add(a.y, b.y, hn::Mul(a.z, b.z)));
}
HWY_INLINE Vec3 broadcast(const double* v) {
    return {constant(v[0]), constant(v[1]), constant(v[2])};
}
HWY_INLINE Vec3 load(const double* fields, size_t first, size_t at) {
    const D d;
    const double* const from = fields + first * near_batch + at;
    return {hn::LoadU(d, from), hn::LoadU(d, from + near_batch), hn::LoadU(d, from + 2 * near_batch)};
}
HWY_INLINE Vec3 minus(const Vec3& a, const Vec3& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Vec3 mean(const Vec3& a, const Vec3& b) {
    const V half = constant(0.5);
    return {hn::Mul(half, hn::Add(a.x, b.x)), hn::Mul(half, hn::Add(a.y, b.y)), hn::Mul(half, hn::Add(a.z, b.z))};
}

// p / q = 2^exponent (1 + s) / (1 - s), with (1 + s) / (1 - s) within a factor sqrt(2) of one; s = over / under.
struct Ratio {
    V exponent, over, under;
};
HWY_INLINE Ratio reduce_ratio(V p, V q) {
    const D d;
    const DI di;
    const auto mantissa = hn::Set(di, 0x000fffffffffffffLL), one = hn::Set(di, 0x3ff0000000000000LL);
    const auto p_bits = hn::BitCast(di, p), q_bits = hn::BitCast(di, q);
    // 3 2^51 + k as a double ends in the bits of k: exact, and avoids 64-bit conversions, which few instruction sets have.
    const V magic = constant(6755399441055744.0);
    const auto difference = hn::Sub(hn::ShiftRight<52>(p_bits), hn::ShiftRight<52>(q_bits));
    V exponent = hn::Sub(hn::BitCast(d, hn::Add(difference, hn::BitCast(di, magic))), magic);
    V a = hn::BitCast(d, hn::Or(hn::And(p_bits, mantissa), one));
    V b = hn::BitCast(d, hn::Or(hn::And(q_bits, mantissa), one));
    const V root2 = constant(1.4142135623730951), unit = constant(1.0);
    const auto high = hn::Gt(a, hn::Mul(root2, b)), low = hn::Gt(b, hn::Mul(root2, a));
    exponent = hn::Add(exponent, hn::Sub(hn::IfThenElseZero(high, unit), hn::IfThenElseZero(low, unit)));
    b = hn::Add(b, hn::IfThenElseZero(high, b));
    a = hn::Add(a, hn::IfThenElseZero(low, a));
    return {exponent, hn::Sub(a, b), hn::Add(a, b)};
}

// The logarithm of the ratio from s, to 1e-15: the series of 2 atanh(s) / s in s^2, interpolated at Chebyshev nodes.
HWY_INLINE V log_ratio(V exponent, V s) {
    const V z = hn::Mul(s, s);
    V y = constant(0.1480971294959388);
    y = mul_add(y, z, constant(0.15312527900804804));
    y = mul_add(y, z, constant(0.1818363168947327));
    y = mul_add(y, z, constant(0.22222197056556095));
    y = mul_add(y, z, constant(0.2857142876064327));
    y = mul_add(y, z, constant(0.3999999999930233));
    y = mul_add(y, z, constant(0.6666666666666765));
    y = mul_add(y, z, constant(2.0));
    return mul_add(exponent, constant(0.69314718055994531), hn::Mul(s, y));
}

// Four-quadrant arc tangent, to 1e-15: the smaller over the larger argument, turned by 45 degrees if above tan(22.5 degrees).
HWY_INLINE V arc_tangent(V y, V x) {
    const V ay = hn::Abs(y), ax = hn::Abs(x);
    const V least = hn::Min(ax, ay), most = hn::Max(hn::Max(ax, ay), constant(1e-300));
    const auto turned = hn::Gt(least, hn::Mul(most, constant(0.41421356237309503)));
    const V numerator = hn::IfThenElse(turned, hn::Sub(least, most), least);
    const V denominator = hn::IfThenElse(turned, hn::Add(least, most), most);
    const V s = hn::Div(numerator, denominator), z = hn::Mul(s, s);
    V p = constant(0.021135361370409115);
    p = mul_add(p, z, constant(-0.043480512532460464));
    p = mul_add(p, z, constant(0.05688348893659236));
    p = mul_add(p, z, constant(-0.06640233866767065));
    p = mul_add(p, z, constant(0.07689953488978554));
    p = mul_add(p, z, constant(-0.0909077307428817));
    p = mul_add(p, z, constant(0.11111106180433551));
    p = mul_add(p, z, constant(-0.14285714180975917));
    p = mul_add(p, z, constant(0.19999999998855103));
    p = mul_add(p, z, constant(-0.3333333333332844));
    p = mul_add(p, z, constant(1.0));
    V angle = hn::Mul(p, s);
    angle = hn::IfThenElse(turned, hn::Add(angle, constant(0.78539816339744831)), angle);
    angle = hn::IfThenElse(hn::Gt(ay, ax), hn::Sub(constant(1.5707963267948966), angle), angle);
    angle = hn::IfThenElse(hn::Lt(x, hn::Zero(D())), hn::Sub(constant(3.1415926535897932), angle), angle);
    return hn::CopySign(angle, y);
}

// The closed forms of panel_potential; the slope of lambda along edge normal k needs the sum over e of m_k . m_e L_e.
HWY_NOINLINE void near_panels(const OuterRule& outer, const double* sources, double* results) {
    const D d;
    using F = NearFields;
    for (size_t at = 0; at < near_batch; at += hn::Lanes(d)) {
        const auto field = [&](size_t which) HWY_ATTR { return hn::LoadU(d, sources + which * near_batch + at); };
        const auto store = [&](V v, size_t which) HWY_ATTR { hn::StoreU(v, d, results + which * near_batch + at); };
        const Vec3 corner0 = load(sources, F::corner, at), corner1 = load(sources, F::corner + 3, at),
                   corner2 = load(sources, F::corner + 6, at);
        const Vec3 normal = load(sources, F::normal, at);
        V single = hn::Zero(d);
        V d00 = single, d01 = single, d02 = single, d10 = single, d11 = single, d12 = single, d20 = single,
          d21 = single, d22 = single;
        for (size_t g = 0; g < outer.size; ++g) {
            const Vec3 point = broadcast(outer.points + 3 * g);
            const Vec3 to0 = minus(corner0, point), to1 = minus(corner1, point), to2 = minus(corner2, point);
            const V r0 = hn::Sqrt(dot(to0, to0)), r1 = hn::Sqrt(dot(to1, to1)), r2 = hn::Sqrt(dot(to2, to2));
            const V height = hn::Neg(dot(normal, to0));
            const V numerator = hn::Neg(hn::Mul(field(F::twice_area), height));
            const V denominator =
                mul_add(hn::Mul(r0, r1), r2,
                        mul_add(dot(to0, to1), r2, mul_add(dot(to1, to2), r0, hn::Mul(dot(to2, to0), r1))));
            const auto out_of_plane = hn::Ge(hn::Abs(height), field(F::in_plane));
            const V angle =
                hn::IfThenElseZero(out_of_plane, hn::Mul(constant(-2.0), arc_tangent(numerator, denominator)));
            const auto ratio = [&](V from, V to, V length) HWY_ATTR {
                const V sum = hn::Add(from, to), excess = hn::Sub(sum, length);
                // On the edge the integral is infinite, but its factors e and height are zero.
                const auto off = hn::Gt(excess, hn::Mul(constant(1e-14), sum));
                const V above = hn::Add(sum, length);
                return reduce_ratio(above, hn::IfThenElse(off, excess, above));
            };
            const Ratio q0 = ratio(r0, r1, field(F::edge_length)), q1 = ratio(r1, r2, field(F::edge_length + 1)),
                        q2 = ratio(r2, r0, field(F::edge_length + 2));
            // One division for three.
            const V u01 = hn::Mul(q0.under, q1.under);
            const V inverse = hn::Div(constant(1.0), hn::Mul(u01, q2.under)), inverse2 = hn::Mul(inverse, q2.under);
            const V l0 = log_ratio(q0.exponent, hn::Mul(q0.over, hn::Mul(q1.under, inverse2))),
                    l1 = log_ratio(q1.exponent, hn::Mul(q1.over, hn::Mul(q0.under, inverse2))),
                    l2 = log_ratio(q2.exponent, hn::Mul(q2.over, hn::Mul(u01, inverse)));
            const V e0 = dot(load(sources, F::edge_normal, at), to0),
                    e1 = dot(load(sources, F::edge_normal + 3, at), to1),
                    e2 = dot(load(sources, F::edge_normal + 6, at), to2);
            const V potential = hn::Sub(mul_add(e0, l0, mul_add(e1, l1, hn::Mul(e2, l2))), hn::Mul(height, angle));
            const V c01 = field(F::edge_cosine), c12 = field(F::edge_cosine + 1), c20 = field(F::edge_cosine + 2);
            const V s0 = hn::Add(l0, mul_add(c01, l1, hn::Mul(c20, l2)));
            const V s1 = hn::Add(l1, mul_add(c01, l0, hn::Mul(c12, l2)));
            const V s2 = hn::Add(l2, mul_add(c20, l0, hn::Mul(c12, l1)));
            const V u0 = mul_add(e0, angle, hn::Mul(height, s0)), u1 = mul_add(e1, angle, hn::Mul(height, s1)),
                    u2 = mul_add(e2, angle, hn::Mul(height, s2));
            const double* const w = outer.weights + 3 * g;
            const V w0 = constant(w[0]), w1 = constant(w[1]), w2 = constant(w[2]);
            single = mul_add(constant(w[0] + w[1] + w[2]), potential, single);
            d00 = mul_add(w0, u0, d00), d01 = mul_add(w1, u0, d01), d02 = mul_add(w2, u0, d02);
            d10 = mul_add(w0, u1, d10), d11 = mul_add(w1, u1, d11), d12 = mul_add(w2, u1, d12);
            d20 = mul_add(w0, u2, d20), d21 = mul_add(w1, u2, d21), d22 = mul_add(w2, u2, d22);
        }
        store(single, NearResult::single_layer);
        const V all[9] = {d00, d01, d02, d10, d11, d12, d20, d21, d22};
        for (size_t k = 0; k < 9; ++k) store(all[k], NearResult::double_layer + k);

        const Vec3 source[3] = {mean(corner0, corner1), mean(corner1, corner2), mean(corner2, corner0)};
        for (size_t b = 0; b < 3; ++b) {
            V flux[3];
            for (size_t a = 0; a < 3; ++a) {
                const Vec3 to = minus(broadcast(outer.middles + 3 * a), source[b]);
                const V square = dot(to, to);
                const auto apart = hn::Gt(square, hn::Zero(d));
                const V cube = hn::Mul(square, hn::Sqrt(square));
                flux[a] = hn::IfThenElseZero(apart, hn::Div(hn::Mul(constant(0.5), dot(normal, to)),
                                                            hn::IfThenElse(apart, cube, constant(1.0))));
            }
            store(hn::Add(flux[0], flux[2]), NearResult::middles + 3 * b);
            store(hn::Add(flux[0], flux[1]), NearResult::middles + 3 * b + 1);
            store(hn::Add(flux[1], flux[2]), NearResult::middles + 3 * b + 2);
        }
    }
}

HWY_NOINLINE void doublets(DoubletArrays& arrays, size_t begin, size_t end) {
    const D d;
    const size_t n = arrays.position[0].size();
    const double *px = arrays.position[0].data(), *py = arrays.position[1].data(), *pz = arrays.position[2].data();
    const double* m[6];
    for (size_t c = 0; c < 6; ++c) m[c] = arrays.moment[c].data();
    for (size_t s = begin; s < end; s += hn::Lanes(d)) {
        const Vec3 from = {hn::LoadU(d, px + s), hn::LoadU(d, py + s), hn::LoadU(d, pz + s)};
        const Vec3 normal = {hn::LoadU(d, arrays.normal[0].data() + s), hn::LoadU(d, arrays.normal[1].data() + s),
                             hn::LoadU(d, arrays.normal[2].data() + s)};
        V s0 = hn::Zero(d), s1 = s0, s2 = s0, s3 = s0, s4 = s0, s5 = s0;
        for (size_t e = 0; e < n; ++e) {
            const Vec3 to = minus({constant(px[e]), constant(py[e]), constant(pz[e])}, from);
            const V square = dot(to, to);
            const V cube = hn::Mul(square, hn::Sqrt(square));
            const V kernel = hn::IfThenElseZero(hn::Gt(cube, hn::Zero(d)), hn::Div(dot(normal, to), cube));
            s0 = mul_add(constant(m[0][e]), kernel, s0), s1 = mul_add(constant(m[1][e]), kernel, s1);
            s2 = mul_add(constant(m[2][e]), kernel, s2), s3 = mul_add(constant(m[3][e]), kernel, s3);
            s4 = mul_add(constant(m[4][e]), kernel, s4), s5 = mul_add(constant(m[5][e]), kernel, s5);
        }
        const V all[6] = {s0, s1, s2, s3, s4, s5};
        for (size_t c = 0; c < 6; ++c) hn::StoreU(all[c], d, arrays.sum[c].data() + s);
    }
}

HWY_NOINLINE void far_panels(const double* panels, size_t count, const std::array<std::size_t, near_batch>& targets,
                             double* values) {
    const D d;
    HWY_ALIGN double target[far_fields * near_batch];
    for (size_t lane = 0; lane < near_batch; ++lane)
        for (size_t k = 0; k < far_fields; ++k) target[k * near_batch + lane] = panels[targets[lane] * far_fields + k];
    for (size_t at = 0; at < near_batch; at += hn::Lanes(d)) {
        V t[far_fields];
        for (size_t k = 0; k < far_fields; ++k) t[k] = hn::Load(d, target + k * near_batch + at);
        // 1/(4 pi) is in both areas.
        const V scale = hn::Mul(t[9], constant(12.566370614359172));
        for (size_t s = 0; s < count; ++s) {
            const double* const f = panels + s * far_fields;
            const V dx = hn::Sub(t[0], constant(f[0])), dy = hn::Sub(t[1], constant(f[1])),
                    dz = hn::Sub(t[2], constant(f[2]));
            const V dx2 = hn::Mul(dx, dx), dy2 = hn::Mul(dy, dy), dz2 = hn::Mul(dz, dz);
            const V square = hn::Add(dx2, hn::Add(dy2, dz2));
            const V inverse2 = hn::Div(constant(1.0), square); // infinite for s = t; the caller replaces this value
            const V inverse = hn::Mul(hn::Sqrt(square), inverse2);
            const V xx = hn::Add(t[3], constant(f[3])), yy = hn::Add(t[4], constant(f[4])),
                    zz = hn::Add(t[5], constant(f[5]));
            const V xy = hn::Add(t[6], constant(f[6])), yz = hn::Add(t[7], constant(f[7])),
                    zx = hn::Add(t[8], constant(f[8]));
            const V mixed = mul_add(hn::Mul(xy, dx), dy, mul_add(hn::Mul(yz, dy), dz, hn::Mul(hn::Mul(zx, dz), dx)));
            const V along =
                hn::Mul(inverse2, mul_add(xx, dx2, mul_add(yy, dy2, mul_add(zz, dz2, hn::Add(mixed, mixed)))));
            const V trace = hn::Add(xx, hn::Add(yy, zz));
            const V correction =
                hn::Mul(hn::Mul(constant(0.5), inverse2), hn::Sub(hn::Mul(constant(3.0), along), trace));
            const V product = hn::Mul(hn::Mul(scale, constant(f[9])), inverse);
            hn::StoreU(mul_add(product, correction, product), d, values + s * near_batch + at);
        }
    }
}

HWY_NOINLINE void currents(const PanelFans& fans, const double* values, const double* curls,
                           const std::array<double*, 3 * near_batch>& columns, size_t lanes) {
    const D d;
    const size_t vertices = fans.start.size() - 1;
    const auto entries = [&](size_t v, size_t at, V* out) HWY_ATTR {
        V x = hn::Zero(d), y = x, z = x;
        for (size_t i = fans.start[v]; i < fans.start[v + 1]; ++i) {
            const V value = hn::LoadU(d, values + fans.panel[i] * near_batch + at);
            x = mul_add(value, constant(fans.curl[3 * i]), x);
            y = mul_add(value, constant(fans.curl[3 * i + 1]), y);
            z = mul_add(value, constant(fans.curl[3 * i + 2]), z);
        }
        for (size_t k = 0; k < 3; ++k) out[k] = dot(load(curls, 3 * k, at), {x, y, z});
    };
    size_t v = 0;
    HWY_ALIGN double lower[3 * near_batch];
#if HWY_TARGET != HWY_SCALAR
    // two vertices at a time
    const hn::FixedTag<double, 2> pair;
    HWY_ALIGN double upper[3 * near_batch];
    for (; lanes == near_batch && v + 2 <= vertices; v += 2) {
        for (size_t at = 0; at < near_batch; at += hn::Lanes(d)) {
            V first[3], second[3];
            entries(v, at, first);
            entries(v + 1, at, second);
            for (size_t k = 0; k < 3; ++k) {
                hn::Store(hn::InterleaveLower(d, first[k], second[k]), d, lower + k * near_batch + at);
                hn::Store(hn::InterleaveUpper(d, first[k], second[k]), d, upper + k * near_batch + at);
            }
        }
        for (size_t j = 0; j < 3 * near_batch; j += 2) {
            double *const even = columns[j] + v, *const odd = columns[j + 1] + v;
            hn::StoreU(hn::Add(hn::LoadU(pair, even), hn::Load(pair, lower + j)), pair, even);
            hn::StoreU(hn::Add(hn::LoadU(pair, odd), hn::Load(pair, upper + j)), pair, odd);
        }
    }
#endif
    for (; v < vertices; ++v) {
        for (size_t at = 0; at < near_batch; at += hn::Lanes(d)) {
            V values_of[3];
            entries(v, at, values_of);
            for (size_t k = 0; k < 3; ++k) hn::Store(values_of[k], d, lower + k * near_batch + at);
        }
        for (size_t k = 0; k < 3; ++k)
            for (size_t lane = 0; lane < lanes; ++lane)
                columns[k * near_batch + lane][v] += lower[k * near_batch + lane];
    }
}
} // namespace lr::baker::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lr::baker {

HWY_EXPORT(near_panels);
HWY_EXPORT(doublets);
HWY_EXPORT(far_panels);
HWY_EXPORT(currents);

void integrate_near_panels(const OuterRule& outer, const double* sources, double* results) {
    HWY_DYNAMIC_DISPATCH(near_panels)(outer, sources, results);
}
void sum_doublets(DoubletArrays& arrays, std::size_t begin, std::size_t end) {
    HWY_DYNAMIC_DISPATCH(doublets)(arrays, begin, end);
}
void far_single_layer(const double* panels, std::size_t count, const std::array<std::size_t, near_batch>& targets,
                      double* values) {
    HWY_DYNAMIC_DISPATCH(far_panels)(panels, count, targets, values);
}
void add_currents(const PanelFans& fans, const double* values, const double* curls,
                  const std::array<double*, 3 * near_batch>& columns, std::size_t lanes) {
    HWY_DYNAMIC_DISPATCH(currents)(fans, values, curls, columns, lanes);
}

std::array<double, NearFields::count> near_fields(const Panel& panel) {
    std::array<double, NearFields::count> f{};
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
            f[NearFields::corner + 3 * k + c] = panel.corner[k][static_cast<Eigen::Index>(c)];
            f[NearFields::edge_normal + 3 * k + c] = panel.edge_normal[k][static_cast<Eigen::Index>(c)];
        }
        f[NearFields::normal + k] = panel.normal[static_cast<Eigen::Index>(k)];
        f[NearFields::edge_length + k] = panel.edge_length[k];
        f[NearFields::edge_cosine + k] = panel.edge_normal[k].dot(panel.edge_normal[(k + 1) % 3]);
    }
    f[NearFields::twice_area] = 2.0 * panel.area;
    f[NearFields::in_plane] = 1e-13 * panel.radius;
    return f;
}
} // namespace lr::baker
#endif // HWY_ONCE
