// Six Gaussians a body and substep from a counter: no state, no order, no communication.
// Philox4x32-7: Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC 2011; seven rounds are
// the fewest that pass BigCrush there.
#if defined(LR_KERNEL_NOISE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_NOISE_INL_H_
#undef LR_KERNEL_NOISE_INL_H_
#else
#define LR_KERNEL_NOISE_INL_H_
#endif

#include "kernel/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

struct Counter {
    VU word[4];
};

// High and low halves of 32 x 32 bit products.
HWY_INLINE void multiply_wide(VU a, uint32_t factor, VU& high, VU& low) {
    const DU du;
#if HWY_TARGET == HWY_SCALAR
    const uint64_t product = static_cast<uint64_t>(hn::GetLane(a)) * factor;
    high = hn::Set(du, static_cast<uint32_t>(product >> 32));
    low = hn::Set(du, static_cast<uint32_t>(product));
#else
    const VU f = hn::Set(du, factor);
    const VU even = hn::BitCast(du, hn::MulEven(a, f));
    const VU odd = hn::BitCast(du, hn::MulEven(hn::ShiftRightLanes<1>(du, a), f));
    low = hn::Mul(a, f);
    high = hn::OddEven(odd, hn::DupOdd(even));
#endif
}

HWY_INLINE void philox(Counter& c, uint64_t key) {
    const DU du;
    uint32_t k0 = static_cast<uint32_t>(key), k1 = static_cast<uint32_t>(key >> 32);
    for (int round = 0; round < 7; ++round) {
        VU high0, low0, high2, low2;
        multiply_wide(c.word[0], 0xD2511F53u, high0, low0);
        multiply_wide(c.word[2], 0xCD9E8D57u, high2, low2);
        c.word[0] = hn::Xor(hn::Xor(high2, c.word[1]), hn::Set(du, k0));
        c.word[2] = hn::Xor(hn::Xor(high0, c.word[3]), hn::Set(du, k1));
        c.word[1] = low2;
        c.word[3] = low0;
        k0 += 0x9E3779B9u;
        k1 += 0xBB67AE85u;
    }
}

// Two Gaussians from two words, by Box and Muller (1958). 24 bits of the first give tails to 5.9 sigma.
HWY_INLINE void gaussian_pair(VU a, VU b, VF& g0, VF& g1) {
    const DI di;
    const VF ulp = constant(5.9604645e-8f); // 2^-24
    const VF u = mul_add(hn::ConvertTo(DF(), hn::BitCast(di, hn::ShiftRight<8>(a))), ulp, constant(2.9802322e-8f));
    const VF turn = hn::Mul(hn::ConvertTo(DF(), hn::BitCast(di, hn::ShiftRight<8>(b))), ulp);
    const VF radius = hn::Sqrt(hn::Mul(constant(-2.0f), hn::Min(log_unit(u), constant(0.0f))));
    VF s, c;
    sin_cos_turn(turn, s, c);
    g0 = hn::Mul(radius, c);
    g1 = hn::Mul(radius, s);
}

HWY_INLINE void six_gaussians(VU key, uint64_t substep, uint64_t seed, VF out[6]) {
    const DU du;
    const VU low = hn::Set(du, static_cast<uint32_t>(substep));
    const VU high = hn::Set(du, static_cast<uint32_t>(substep >> 32));
    Counter a{{key, low, high, hn::Set(du, 0)}};
    Counter b{{key, low, high, hn::Set(du, 1)}};
    philox(a, seed);
    philox(b, seed);
    gaussian_pair(a.word[0], a.word[1], out[0], out[1]);
    gaussian_pair(a.word[2], a.word[3], out[2], out[3]);
    gaussian_pair(b.word[0], b.word[1], out[4], out[5]);
}

// The first three of them.
HWY_INLINE void three_gaussians(VU key, uint64_t substep, uint64_t seed, VF out[3]) {
    const DU du;
    Counter a{{key, hn::Set(du, static_cast<uint32_t>(substep)), hn::Set(du, static_cast<uint32_t>(substep >> 32)),
               hn::Set(du, 0)}};
    philox(a, seed);
    VF unused;
    gaussian_pair(a.word[0], a.word[1], out[0], out[1]);
    gaussian_pair(a.word[2], a.word[3], out[2], unused);
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
