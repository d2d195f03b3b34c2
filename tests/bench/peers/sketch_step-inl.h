// The sketch's step, included once for each instruction set; LR_SKETCH_STEP is the name of its function. Every operation is that
// of the first sketch: as the reference of speed it must not become faster or slower.
#include "peers/sketch.h"

// Independent of the library's targets: this has one target, that of its flags.
#undef HWY_DISABLED_TARGETS
#include <hwy/highway.h>

namespace lr_bench {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<float>;
using DU = hn::ScalableTag<uint32_t>;
using DI = hn::ScalableTag<int32_t>;
using F = hn::Vec<D>;
using U = hn::Vec<DU>;
constexpr D d;
constexpr DU du;
constexpr DI di;

HWY_INLINE F set(float x) {
    return hn::Set(d, x);
}
#ifdef LR_SKETCH_NO_FMA
HWY_INLINE F mul_add(F a, F b, F c) {
    return hn::Add(hn::Mul(a, b), c);
}
HWY_INLINE F neg_mul_add(F a, F b, F c) {
    return hn::Sub(c, hn::Mul(a, b));
}
HWY_INLINE F mul_sub(F a, F b, F c) {
    return hn::Sub(hn::Mul(a, b), c);
}
#else
HWY_INLINE F mul_add(F a, F b, F c) {
    return hn::MulAdd(a, b, c);
}
HWY_INLINE F neg_mul_add(F a, F b, F c) {
    return hn::NegMulAdd(a, b, c);
}
HWY_INLINE F mul_sub(F a, F b, F c) {
    return hn::MulSub(a, b, c);
}
#endif
HWY_INLINE F mul(F a, F b) {
    return hn::Mul(a, b);
}

HWY_INLINE void multiply_wide(U a, uint32_t factor, U& high, U& low) {
    const U f = hn::Set(du, factor);
    const U even = hn::BitCast(du, hn::MulEven(a, f));
    const U odd = hn::BitCast(du, hn::MulEven(hn::ShiftRightLanes<1>(du, a), f));
    low = hn::Mul(a, f);
    high = hn::OddEven(odd, hn::DupOdd(even));
}

HWY_INLINE void philox(U (&c)[4], uint32_t k0, uint32_t k1) {
    for (int round = 0; round < 7; ++round) {
        U high0, low0, high1, low1;
        multiply_wide(c[0], 0xD2511F53u, high0, low0);
        multiply_wide(c[2], 0xCD9E8D57u, high1, low1);
        const U next0 = hn::Xor(hn::Xor(high1, c[1]), hn::Set(du, k0));
        const U next2 = hn::Xor(hn::Xor(high0, c[3]), hn::Set(du, k1));
        c[0] = next0, c[1] = low1, c[2] = next2, c[3] = low0;
        k0 += 0x9E3779B9u;
        k1 += 0xBB67AE85u;
    }
}

// x in (0, 1]; coefficients of Cephes.
HWY_INLINE F log_unit(F x) {
    const U bits = hn::BitCast(du, x);
    F e = hn::ConvertTo(d, hn::Sub(hn::BitCast(di, hn::ShiftRight<23>(bits)), hn::Set(di, 127)));
    F m = hn::BitCast(d, hn::Or(hn::And(bits, hn::Set(du, 0x7fffffu)), hn::Set(du, 0x3f800000u)));
    const auto upper = hn::Gt(m, set(1.41421356f));
    m = hn::IfThenElse(upper, mul(m, set(0.5f)), m);
    e = hn::IfThenElse(upper, hn::Add(e, set(1.0f)), e);
    const F f = hn::Sub(m, set(1.0f)), z = mul(f, f);
    F p = set(7.0376836292E-2f);
    for (const float c : {-1.1514610310E-1f, 1.1676998740E-1f, -1.2420140846E-1f, 1.4249322787E-1f, -1.6668057665E-1f,
                          2.0000714765E-1f, -2.4999993993E-1f, 3.3333331174E-1f})
        p = mul_add(p, f, set(c));
    const F y = neg_mul_add(set(0.5f), z, mul(mul(f, z), p));
    return mul_add(e, set(0.693147181f), hn::Add(f, y));
}

HWY_INLINE void sin_cos_turn(F turn, F& sine, F& cosine) {
    const F t = mul(turn, set(4.0f)), q = hn::Round(t), r = mul(hn::Sub(t, q), set(1.57079633f)), z = mul(r, r);
    const F s = mul_add(mul_add(mul_add(set(-1.9515295891E-4f), z, set(8.3321608736E-3f)), z, set(-1.6666654611E-1f)),
                        mul(z, r), r);
    const F c = mul_add(
        mul_add(mul_add(set(2.443315711809948E-5f), z, set(-1.388731625493765E-3f)), z, set(4.166664568298827E-2f)),
        mul(z, z), neg_mul_add(set(0.5f), z, set(1.0f)));
    const auto quadrant = hn::ConvertTo(di, q);
    const auto odd = hn::RebindMask(d, hn::Ne(hn::And(quadrant, hn::Set(di, 1)), hn::Zero(di)));
    const F a = hn::IfThenElse(odd, c, s), b = hn::IfThenElse(odd, s, c);
    const U two = hn::Set(du, 2);
    const U sine_sign = hn::ShiftLeft<30>(hn::And(hn::BitCast(du, quadrant), two));
    const U cosine_sign = hn::ShiftLeft<30>(hn::And(hn::BitCast(du, hn::Add(quadrant, hn::Set(di, 1))), two));
    sine = hn::BitCast(d, hn::Xor(hn::BitCast(du, a), sine_sign));
    cosine = hn::BitCast(d, hn::Xor(hn::BitCast(du, b), cosine_sign));
}

HWY_INLINE void gaussian_pair(U a, U b, F& g0, F& g1) {
    const F ulp = set(5.9604645e-8f);
    const F u = mul_add(hn::ConvertTo(d, hn::BitCast(di, hn::ShiftRight<8>(a))), ulp, set(2.98e-8f));
    const F turn = mul(hn::ConvertTo(d, hn::BitCast(di, hn::ShiftRight<8>(b))), ulp);
    const F radius = hn::Sqrt(mul(set(-2.0f), log_unit(u)));
    F s, c;
    sin_cos_turn(turn, s, c);
    g0 = mul(radius, c);
    g1 = mul(radius, s);
}

// n: factor times the component i x j of a x b, added to c.
HWY_INLINE F add_cross(F ai, F bj, F aj, F bi, F c) {
    return mul_add(ai, bj, neg_mul_add(aj, bi, c));
}

struct Load {
    F damping;
    F force[3], couple[3];
};

HWY_INLINE void rates(const SketchConstants& p, const Load& load, const F* v, const F* w, const F* q, F* dv, F* dw) {
    const F two = set(2.0f * p.weight);
    const F gravity[3] = {
        mul(two, mul_sub(q[1], q[3], mul(q[0], q[2]))), mul(two, mul_add(q[2], q[3], mul(q[0], q[1]))),
        mul(set(p.weight), mul_add(q[0], q[0], mul_sub(q[3], q[3], mul_add(q[1], q[1], mul(q[2], q[2])))))};
    F momentum[3], spin[3];
    for (int k = 0; k < 3; ++k) {
        momentum[k] = mul(v[k], set(p.mass[k]));
        spin[k] = mul(w[k], set(p.inertia[k]));
    }
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        F f = add_cross(momentum[i], w[j], momentum[j], w[i], hn::Add(gravity[k], load.force[k]));
        F t = add_cross(spin[i], w[j], spin[j], w[i], add_cross(momentum[i], v[j], momentum[j], v[i], load.couple[k]));
        f = neg_mul_add(mul(load.damping, set(p.carried[k])), v[k], f);
        t = neg_mul_add(mul(load.damping, set(p.turned[k])), w[k], t);
        dv[k] = mul(f, set(p.inverse_mass[k]));
        dw[k] = mul(t, set(p.inverse_inertia[k]));
    }
}

// q + h/2 a w
HWY_INLINE void turned(const F* q, const F* a, const F* w, F h, F* out) {
    const F half = mul(h, set(0.5f));
    const F w0 = mul(w[0], half), w1 = mul(w[1], half), w2 = mul(w[2], half);
    const F r0 = neg_mul_add(a[1], w0, neg_mul_add(a[2], w1, neg_mul_add(a[3], w2, q[0])));
    const F r1 = mul_add(a[0], w0, mul_add(a[2], w2, neg_mul_add(a[3], w1, q[1])));
    const F r2 = mul_add(a[0], w1, mul_add(a[3], w0, neg_mul_add(a[1], w2, q[2])));
    const F r3 = mul_add(a[0], w2, mul_add(a[1], w1, neg_mul_add(a[2], w0, q[3])));
    out[0] = r0, out[1] = r1, out[2] = r2, out[3] = r3;
}

HWY_INLINE void advanced(const F* v, const F* w, const F* dv, const F* dw, F h, F* to_v, F* to_w) {
    for (int k = 0; k < 3; ++k) {
        to_v[k] = mul_add(dv[k], h, v[k]);
        to_w[k] = mul_add(dw[k], h, w[k]);
    }
}

HWY_INLINE Load draw(const SketchConstants& p, U id, uint32_t index, const F* v) {
    U a[4] = {id, hn::Set(du, index), hn::Zero(du), hn::Zero(du)};
    U b[4] = {id, hn::Set(du, index), hn::Set(du, 1), hn::Zero(du)};
    philox(a, 1, 2);
    philox(b, 1, 2);
    F g[6];
    gaussian_pair(a[0], a[1], g[0], g[1]);
    gaussian_pair(a[2], a[3], g[2], g[3]);
    gaussian_pair(b[0], b[1], g[4], g[5]);
    const F speed = hn::Sqrt(mul_add(v[0], v[0], mul_add(v[1], v[1], mul(v[2], v[2]))));
    const F noise = mul(speed, hn::Sqrt(mul(speed, set(p.noise))));
    Load load;
    load.damping = mul(speed, set(p.damping));
    for (int k = 0; k < 3; ++k) {
        load.force[k] = mul(mul(noise, g[k]), set(p.carried[k]));
        load.couple[k] = mul(mul(noise, g[3 + k]), set(p.turned[k]));
    }
    return load;
}

HWY_INLINE void substep(const SketchConstants& p, const Load& load, float h, F* x, F* q, F* v, F* w) {
    const F half = set(h * 0.5f), whole = set(h);
    F kv[4][3], kw[4][3], v1[3], w1[3], a[4], b[4];
    rates(p, load, v, w, q, kv[0], kw[0]);
    turned(q, q, w, half, a);
    advanced(v, w, kv[0], kw[0], half, v1, w1);
    rates(p, load, v1, w1, a, kv[1], kw[1]);
    turned(q, a, w1, half, b);
    advanced(v, w, kv[1], kw[1], half, v1, w1);
    rates(p, load, v1, w1, b, kv[2], kw[2]);
    turned(q, b, w1, whole, a);
    advanced(v, w, kv[2], kw[2], whole, v1, w1);
    rates(p, load, v1, w1, a, kv[3], kw[3]);

    F v_mean[3], w_mean[3];
    const auto finish = [&](const F* k0, const F* k1, const F* k2, const F* k3, int k, F* of, F* mean) HWY_ATTR {
        const F inner = hn::Add(k1[k], k2[k]);
        const F next = mul_add(set(h / 6.0f), hn::Add(hn::Add(k0[k], k3[k]), hn::Add(inner, inner)), of[k]);
        mean[k] = mul(set(0.5f), hn::Add(of[k], next));
        of[k] = next;
    };
    for (int k = 0; k < 3; ++k) {
        finish(kv[0], kv[1], kv[2], kv[3], k, v, v_mean);
        finish(kw[0], kw[1], kw[2], kw[3], k, w, w_mean);
    }
    // The mean velocity, rotated to the world by the orientation in the middle.
    F r[4], u[3];
    turned(q, q, w_mean, half, r);
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        u[k] = mul_sub(r[1 + i], v_mean[j], mul(r[1 + j], v_mean[i]));
        u[k] = hn::Add(u[k], u[k]);
    }
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const F across = mul_sub(r[1 + i], u[j], mul(r[1 + j], u[i]));
        x[k] = mul_add(whole, mul_add(r[0], u[k], hn::Add(v_mean[k], across)), x[k]);
    }
    turned(q, r, w_mean, whole, b);
    const F norm2 = mul_add(b[0], b[0], mul_add(b[1], b[1], mul_add(b[2], b[2], mul(b[3], b[3]))));
    const F inverse = hn::Div(set(1.0f), hn::Sqrt(norm2));
    for (int k = 0; k < 4; ++k) q[k] = mul(b[k], inverse);
}

} // namespace

void LR_SKETCH_STEP(const SketchConstants& p, float* const* state, size_t count, int substeps, uint32_t first,
                    float h) {
    for (size_t at = 0; at < count; at += hn::Lanes(d)) {
        F s[13];
        for (int k = 0; k < 13; ++k) s[k] = hn::Load(d, state[k] + at);
        const U id = hn::Iota(du, static_cast<uint32_t>(at));
        for (int i = 0; i < substeps; ++i)
            substep(p, draw(p, id, first + static_cast<uint32_t>(i), s + 7), h, s, s + 3, s + 7, s + 10);
        for (int k = 0; k < 13; ++k) hn::Store(s[k], d, state[k] + at);
    }
}

} // namespace lr_bench
