// Philox4x32-7: Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC 2011; seven rounds are
// the fewest that pass BigCrush there.
#if defined(LR_KERNEL_PHILOX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_PHILOX_INL_H_
#undef LR_KERNEL_PHILOX_INL_H_
#else
#define LR_KERNEL_PHILOX_INL_H_
#endif

#include "kernel/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// A word a body, bodies of even and of odd lanes apart: each word in the low half of 64 bits, which is all that the wide
// product reads. What is above does not matter, so that a product is its own low word.
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
// By a shuffle: shifts share their ports with the additions of whatever runs beside.
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

// Counter (first, second, third, fourth); all but the first are the same for all bodies. The first two rounds have then
// only one product of theirs each that differs from body to body.
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

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
