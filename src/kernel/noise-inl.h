// Six Gaussians a body and substep from a counter: no state, no order, no communication (docs/maintainers/numerics.md).
#if defined(LR_KERNEL_NOISE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_NOISE_INL_H_
#undef LR_KERNEL_NOISE_INL_H_
#else
#define LR_KERNEL_NOISE_INL_H_
#endif

#include "kernel/math-inl.h"
#include "kernel/philox-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

HWY_INLINE VF from_signed(VU x) {
    return hn::ConvertTo(DF(), hn::BitCast(DI(), x));
}

// -2 log(x/2^31) for the odd number x made of a word's low 31 bits: exponential, with mean 2, up to 43 (6.5 sigma).
HWY_INLINE VF squared_radius(VU word) {
    const DU du;
    const VF x = from_signed(hn::Or(hn::And(word, hn::Set(du, 0x7fffffffu)), hn::Set(du, 1)));
    const VU bits = hn::BitCast(du, x);
    // As an integer, the bits are a logarithm by linear interpolation; what it lacks is a function of the mantissa. The factor
    // f keeps the error in proportion as x comes near 2^31 from below. The largest words round to 2^31 itself, where f = -1:
    // there the fit was held just below zero, so that the result is never negative.
    const VF line =
        hn::Mul(from_signed(hn::Sub(hn::Set(du, 0x4f000000u), bits)), constant(1.65259166e-7f)); // 2^-22 log 2
    const VU mantissa = hn::Or(hn::And(bits, hn::Set(du, 0x007fffffu)), hn::Set(du, 0x3f800000u));
    const VF f = hn::Sub(hn::BitCast(DF(), mantissa), constant(2.0f)); // [-1, 0)
    const VF f2 = hn::Mul(f, f);
    const VF low = mul_add(constant(0.249895617f), f, constant(0.386293232f));
    const VF middle = mul_add(constant(0.0226345584f), f, constant(-0.08489687f));
    const VF high =
        mul_add(constant(-0.0160808917f), f2, mul_add(constant(-0.0216045007f), f, constant(-0.0343900733f)));
    return mul_add(f, mul_add(mul_add(high, f2, middle), f2, low), line);
}

// Two Gaussians by Box and Muller (1958). The radius is that of `word`. The angle, in quarter turns over 2^31, gives a
// direction (a, b) within half a turn; the highest bit of `word` turns it by the other half. The direction's length is divided
// out, so that its polynomials need to be right in their ratio only.
HWY_INLINE void gaussian_pair(VU word, VU angle, VF& g0, VF& g1) {
    const DU du;
    const VF t = from_signed(angle);
    const VF z = hn::Mul(t, t);
    // 2^30 times cosine and sine, about: large enough for the coefficients, and small enough for the square.
    const VF a = mul_add(mul_add(constant(3.23106421e-30f), z, constant(-2.47731502e-10f)), z, constant(1073741824.0f));
    const VF b = hn::Mul(t, mul_add(constant(-4.10875894e-20f), z, constant(0.785377026f)));
    const VF radius = hn::Sqrt(hn::Div(squared_radius(word), mul_add(a, a, hn::Mul(b, b))));
    const VU sign = hn::And(word, hn::Set(du, 0x80000000u));
    const VF turned = hn::BitCast(DF(), hn::Xor(hn::BitCast(du, radius), sign));
    g0 = hn::Mul(turned, a);
    g1 = hn::Mul(turned, b);
}

// Ten bits of each pair's angle come from the fourth word. Ten more are the low ones of the radius's word, where they stand for
// less than 2^-20 of the radius's uniform number. Signs, radii to 21 bits and angles to 20 are independent and uniform: every
// bit of an angle is one that they have not yet used, changed or not by bits that they have.
template <int kPair> HWY_INLINE VU pair_angle(const VU word[4]) {
    return hn::Xor(hn::ShiftLeft<12>(word[kPair]), hn::ShiftLeft<10 * kPair>(word[3]));
}

HWY_INLINE void noise_words(VU key, uint64_t substep, uint64_t seed, VU word[4]) {
    philox(key, static_cast<uint32_t>(substep), static_cast<uint32_t>(substep >> 32), 0, seed, word);
}

HWY_INLINE void six_gaussians(VU key, uint64_t substep, uint64_t seed, VF out[6]) {
    VU word[4];
    noise_words(key, substep, seed, word);
    gaussian_pair(word[0], pair_angle<0>(word), out[0], out[1]);
    gaussian_pair(word[1], pair_angle<1>(word), out[2], out[3]);
    gaussian_pair(word[2], pair_angle<2>(word), out[4], out[5]);
}

// The first three of them.
HWY_INLINE void three_gaussians(VU key, uint64_t substep, uint64_t seed, VF out[3]) {
    VU word[4];
    noise_words(key, substep, seed, word);
    VF unused;
    gaussian_pair(word[0], pair_angle<0>(word), out[0], out[1]);
    gaussian_pair(word[1], pair_angle<1>(word), out[2], unused);
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
