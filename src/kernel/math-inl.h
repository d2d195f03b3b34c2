// Elementary functions from + - x / sqrt only, so that every target gives the same bits. Polynomials are minimax fits
// made for these ranges; their errors are below half an ulp of a float result (docs/maintainers/determinism.md).
#if defined(LR_KERNEL_MATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_MATH_INL_H_
#undef LR_KERNEL_MATH_INL_H_
#else
#define LR_KERNEL_MATH_INL_H_
#endif

#include "kernel/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {
HWY_INLINE VF constant(float x) {
    return hn::Set(DF(), x);
}
// Constants that differ from body to body are vectors already.
HWY_INLINE VF constant(VF x) {
    return x;
}

// Never fused: a fused product differs in the last bit, and not every target has one.
HWY_INLINE VF mul_add(VF a, VF b, VF c) {
    return hn::Add(hn::Mul(a, b), c);
}
HWY_INLINE VF mul_sub(VF a, VF b, VF c) {
    return hn::Sub(hn::Mul(a, b), c);
}
HWY_INLINE VF neg_mul_add(VF a, VF b, VF c) {
    return hn::Sub(c, hn::Mul(a, b));
}

// Natural logarithm for x in (0, 1], normal.
HWY_INLINE VF log_unit(VF x) {
    const DU du;
    const DI di;
    const VU bits = hn::BitCast(du, x);
    VF exponent = hn::ConvertTo(DF(), hn::Sub(hn::BitCast(di, hn::ShiftRight<23>(bits)), hn::Set(di, 127)));
    VF m = hn::BitCast(DF(), hn::Or(hn::And(bits, hn::Set(du, 0x007fffffu)), hn::Set(du, 0x3f800000u)));
    const auto upper = hn::Gt(m, constant(1.41421356f));
    m = hn::IfThenElse(upper, hn::Mul(m, constant(0.5f)), m);
    exponent = hn::IfThenElse(upper, hn::Add(exponent, constant(1.0f)), exponent);
    // log(1 + f) = f - f^2/2 + f^3 P(f) for f in [sqrt(1/2) - 1, sqrt(2) - 1]
    const VF f = hn::Sub(m, constant(1.0f));
    const VF f2 = hn::Mul(f, f);
    VF p = constant(-0.07865377515554428f);
    p = mul_add(p, f, constant(0.12879173457622528f));
    p = mul_add(p, f, constant(-0.13125309348106384f));
    p = mul_add(p, f, constant(0.1418142467737198f));
    p = mul_add(p, f, constant(-0.16624969244003296f));
    p = mul_add(p, f, constant(0.20002281665802002f));
    p = mul_add(p, f, constant(-0.2500079572200775f));
    p = mul_add(p, f, constant(0.33333316445350647f));
    const VF y = neg_mul_add(constant(0.5f), f2, hn::Mul(hn::Mul(f, f2), p));
    return mul_add(exponent, constant(0.69314718f), hn::Add(f, y));
}

// Sine and cosine of a turn's fraction, 0 <= turn < 1.
HWY_INLINE void sin_cos_turn(VF turn, VF& sine, VF& cosine) {
    const DU du;
    const DI di;
    const VF quarter = hn::Mul(turn, constant(4.0f));
    // Truncation of a non-negative number is its floor: exact on every target, whatever the rounding mode.
    const VI quadrant = hn::ConvertTo(di, hn::Add(quarter, constant(0.5f)));
    const VF t = hn::Sub(quarter, hn::ConvertTo(DF(), quadrant)); // [-1/2, 1/2] quarter turns
    const VF z = hn::Mul(t, t);
    VF s = mul_add(constant(-0.004602177f), z, constant(0.07968023f));
    s = mul_add(s, z, constant(-0.6459635f));
    s = hn::Mul(t, mul_add(s, z, constant(1.5707964f)));
    VF c = mul_add(constant(0.00090402167f), z, constant(-0.020860288f));
    c = mul_add(c, z, constant(0.25366923f));
    c = mul_add(c, z, constant(-1.2337005f));
    c = mul_add(c, z, constant(1.0f));
    const VU q = hn::BitCast(du, quadrant);
    const auto odd = hn::RebindMask(DF(), hn::Ne(hn::And(quadrant, hn::Set(di, 1)), hn::Zero(di)));
    const VF a = hn::IfThenElse(odd, c, s), b = hn::IfThenElse(odd, s, c);
    const VU sine_sign = hn::ShiftLeft<30>(hn::And(q, hn::Set(du, 2)));
    const VU cosine_sign = hn::ShiftLeft<30>(hn::And(hn::Add(q, hn::Set(du, 1)), hn::Set(du, 2)));
    sine = hn::BitCast(DF(), hn::Xor(hn::BitCast(du, a), sine_sign));
    cosine = hn::BitCast(DF(), hn::Xor(hn::BitCast(du, b), cosine_sign));
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
