// Six Gaussians per body and substep from a counter: no state, no order, no communication (docs/maintainers/numerics.md).
#if defined(LR_KERNEL_MATH_GAUSSIAN_NOISE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_MATH_GAUSSIAN_NOISE_INL_H_
#undef LR_KERNEL_MATH_GAUSSIAN_NOISE_INL_H_
#else
#define LR_KERNEL_MATH_GAUSSIAN_NOISE_INL_H_
#endif

#include "kernel/math/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::LR_KERNEL_NAMESPACE {

// Philox4x32-7: Salmon et al., "Parallel random numbers: as easy as 1, 2, 3", SC 2011; seven rounds are the fewest that pass BigCrush there.

// One word per body, even and odd lanes apart, in the low half of 64 bits, which the wide product reads: a product serves as its own low word.
#if HWY_TARGET == HWY_SCALAR
struct Word {
    uint64_t even;
};
HWY_INLINE Word each(uint32_t x) {
    return {x};
}
HWY_INLINE Word split(VU x) {
    return {hn::GetLane(x)};
}
HWY_INLINE Word product(Word a, uint32_t factor) {
    return {(a.even & 0xffffffffu) * factor};
}
HWY_INLINE Word high(Word product) {
    return {product.even >> 32};
}
HWY_INLINE Word operator^(Word a, Word b) {
    return {a.even ^ b.even};
}
HWY_INLINE VU join(Word a) {
    return hn::Set(DU(), static_cast<uint32_t>(a.even));
}
HWY_INLINE VU join_high(Word product) {
    return join(high(product));
}
#else
struct Word {
    VU even, odd;
};
HWY_INLINE Word each(uint32_t x) {
    const VU all = hn::Set(DU(), x);
    return {all, all};
}
HWY_INLINE Word split(VU x) {
    return {x, hn::DupOdd(x)};
}
HWY_INLINE Word product(Word a, uint32_t factor) {
    const DU du;
    const VU f = hn::Set(du, factor);
    return {hn::BitCast(du, hn::MulEven(a.even, f)), hn::BitCast(du, hn::MulEven(a.odd, f))};
}
// By a shuffle: shifts compete for ports with the additions of neighbouring code.
HWY_INLINE Word high(Word product) {
    return {hn::DupOdd(product.even), hn::DupOdd(product.odd)};
}
HWY_INLINE Word operator^(Word a, Word b) {
    return {hn::Xor(a.even, b.even), hn::Xor(a.odd, b.odd)};
}
HWY_INLINE VU join(Word a) {
    return hn::OddEven(hn::DupEven(a.odd), a.even);
}
HWY_INLINE VU join_high(Word product) {
    return hn::OddEven(product.odd, hn::DupOdd(product.even));
}
#endif

// Counter (first, second, third, fourth). Only the first differs between bodies, so each of the first two rounds has one product that does.
HWY_INLINE void philox(VU first, uint32_t second, uint32_t third, uint32_t fourth, uint64_t key, VU out[4]) {
    const DU du;
    constexpr uint32_t m0 = 0xD2511F53u, m1 = 0xCD9E8D57u, w0 = 0x9E3779B9u, w1 = 0xBB67AE85u;
    uint32_t k0 = static_cast<uint32_t>(key), k1 = static_cast<uint32_t>(key >> 32);
    const auto next_key = [&]() LR_LAMBDA { k0 += w0, k1 += w1; };

    Word p0 = product(split(first), m0);
    const uint64_t same2 = uint64_t{third} * m1;
    const uint32_t c0 = static_cast<uint32_t>(same2 >> 32) ^ second ^ k0, c1 = static_cast<uint32_t>(same2);
    Word word2 = high(p0) ^ each(fourth ^ k1);
    next_key();

    const uint64_t same0 = uint64_t{c0} * m0;
    Word p2 = product(word2, m1);
    Word word0 = high(p2) ^ each(c1 ^ k0);
    word2 = p0 ^ each(static_cast<uint32_t>(same0 >> 32) ^ k1);
    Word word1 = p2, word3 = each(static_cast<uint32_t>(same0));
    next_key();

    for (int round = 2; round < 6; ++round) {
        p0 = product(word0, m0);
        p2 = product(word2, m1);
        word0 = high(p2) ^ word1 ^ each(k0);
        word2 = high(p0) ^ word3 ^ each(k1);
        word1 = p2;
        word3 = p0;
        next_key();
    }
    p0 = product(word0, m0);
    p2 = product(word2, m1);
    out[0] = hn::Xor(hn::Xor(join_high(p2), join(word1)), hn::Set(du, k0));
    out[1] = join(p2);
    out[2] = hn::Xor(hn::Xor(join_high(p0), join(word3)), hn::Set(du, k1));
    out[3] = join(p0);
}

HWY_INLINE VF from_signed(VU x) {
    return hn::ConvertTo(DF(), hn::BitCast(DI(), x));
}

// -2 log(x/2^31) for the odd number x made of a word's low 31 bits: exponential, with mean 2, up to 43 (6.5 sigma).
HWY_INLINE VF squared_radius(VU word) {
    const DU du;
    const VF x = from_signed(hn::Or(hn::And(word, hn::Set(du, 0x7fffffffu)), hn::Set(du, 1)));
    const VU bits = hn::BitCast(du, x);
    // As an integer, the bits are a linearly interpolated logarithm; the rest is a function of the mantissa. The factor f keeps the error
    // proportional as x approaches 2^31. The largest words round to 2^31, f = -1: there the fit stays just below zero, so no result is negative.
    const VF line = from_signed(hn::Set(du, 0x4f000000u) - bits) * constant(1.65259166e-7f); // 2^-22 log 2
    const VU mantissa = hn::Or(hn::And(bits, hn::Set(du, 0x007fffffu)), hn::Set(du, 0x3f800000u));
    const VF f = hn::BitCast(DF(), mantissa) - constant(2.0f); // [-1, 0)
    const VF f2 = f * f;
    const VF low = constant(0.249895617f) * f + constant(0.386293232f);
    const VF middle = constant(0.0226345584f) * f + constant(-0.08489687f);
    const VF high = constant(-0.0160808917f) * f2 + (constant(-0.0216045007f) * f + constant(-0.0343900733f));
    return f * ((high * f2 + middle) * f2 + low) + line;
}

// Two Gaussians by Box and Muller (1958), with the radius of `word`. The angle, in quarter turns over 2^31, gives a direction (a, b) within half a
// turn; the highest bit of `word` adds the other half. The direction's length is divided out: only the ratio of its polynomials must be right.
HWY_INLINE void gaussian_pair(VU word, VU angle, VF& g0, VF& g1) {
    const DU du;
    const VF t = from_signed(angle);
    const VF z = t * t;
    // 2^30 times cosine and sine, about: large enough for the coefficients, and small enough for the square.
    const VF a = (constant(3.23106421e-30f) * z + constant(-2.47731502e-10f)) * z + constant(1073741824.0f);
    const VF b = t * (constant(-4.10875894e-20f) * z + constant(0.785377026f));
    const VF radius = hn::Sqrt(squared_radius(word) / (a * a + b * b));
    const VU sign = hn::And(word, hn::Set(du, 0x80000000u));
    const VF turned = hn::BitCast(DF(), hn::Xor(hn::BitCast(du, radius), sign));
    g0 = turned * a;
    g1 = turned * b;
}

// Ten bits of each angle come from the fourth word, ten more are the low bits of the radius's word, less than 2^-20 of its uniform number. Signs,
// radii to 21 bits and angles to 20 are independent and uniform: each bit of an angle is unused by them, at most XORed with used bits.
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

// The first three of six_gaussians. uniform: two numbers of mean 0 and variance 1, independent of them and of each other.
HWY_INLINE void three_gaussians(VU key, uint64_t substep, uint64_t seed, VF out[3], VF uniform[2]) {
    VU word[4];
    noise_words(key, substep, seed, word);
    VF unused;
    gaussian_pair(word[0], pair_angle<0>(word), out[0], out[1]);
    gaussian_pair(word[1], pair_angle<1>(word), out[2], unused);
    const VF unit = constant(8.0654933e-10f); // sqrt(3)/2^31
    uniform[0] = unit * from_signed(word[2]);
    uniform[1] = unit * from_signed(hn::ShiftLeft<16>(word[2]));
}
} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
