// The kernel's lane functions, on every instruction set of this processor.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/math/test_lanes.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "base/lane_arrays.h"
#include "hwy/highway.h"
#include "kernel/math/gaussian_noise-inl.h"

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// Counts are multiples of lane_block, arrays aligned.
void test_log(const float* x, float* out, size_t n) {
    const DF d;
    for (size_t i = 0; i < n; i += hn::Lanes(d)) hn::Store(log_unit(hn::Load(d, x + i)), d, out + i);
}
void test_sin_cos(const float* turn, float* sine, float* cosine, size_t n) {
    const DF d;
    for (size_t i = 0; i < n; i += hn::Lanes(d)) {
        VF s, c;
        sin_cos_turn(hn::Load(d, turn + i), s, c);
        hn::Store(s, d, sine + i);
        hn::Store(c, d, cosine + i);
    }
}
void test_philox(const uint32_t* counter, uint64_t key, uint32_t* out) {
    const DU d;
    VU word[4];
    philox(hn::Set(d, counter[0]), counter[1], counter[2], counter[3], key, word);
    // All lanes are equal: the last represents them.
    HWY_ALIGN uint32_t lanes[lane_block];
    for (size_t i = 0; i < 4; ++i) {
        hn::Store(word[i], d, lanes);
        out[i] = lanes[hn::Lanes(d) - 1];
    }
}
// out: four arrays of n.
void test_words(const uint32_t* keys, uint64_t substep, uint64_t seed, uint32_t* out, size_t n) {
    const DU du;
    for (size_t i = 0; i < n; i += hn::Lanes(du)) {
        VU word[4];
        noise_words(hn::Load(du, keys + i), substep, seed, word);
        for (size_t k = 0; k < 4; ++k) hn::Store(word[k], du, out + k * n + i);
    }
}
void test_angles(const uint32_t* words, uint32_t* out, size_t n) {
    const DU du;
    for (size_t i = 0; i < n; i += hn::Lanes(du)) {
        VU word[4];
        for (size_t k = 0; k < 4; ++k) word[k] = hn::Load(du, words + k * n + i);
        hn::Store(pair_angle<0>(word), du, out + i);
        hn::Store(pair_angle<1>(word), du, out + n + i);
        hn::Store(pair_angle<2>(word), du, out + 2 * n + i);
    }
}
void test_squared_radius(const uint32_t* word, float* out, size_t n) {
    const DF d;
    for (size_t i = 0; i < n; i += hn::Lanes(d)) hn::Store(squared_radius(hn::Load(DU(), word + i)), d, out + i);
}
void test_pair(const uint32_t* word, const uint32_t* angle, float* first, float* second, size_t n) {
    const DF d;
    const DU du;
    for (size_t i = 0; i < n; i += hn::Lanes(d)) {
        VF g0, g1;
        gaussian_pair(hn::Load(du, word + i), hn::Load(du, angle + i), g0, g1);
        hn::Store(g0, d, first + i);
        hn::Store(g1, d, second + i);
    }
}
// out: six arrays of n.
void test_gaussians(const uint32_t* keys, uint64_t substep, uint64_t seed, float* out, size_t n) {
    const DF d;
    const DU du;
    for (size_t i = 0; i < n; i += hn::Lanes(d)) {
        VF g[6];
        six_gaussians(hn::Load(du, keys + i), substep, seed, g);
        for (size_t k = 0; k < 6; ++k) hn::Store(g[k], d, out + k * n + i);
    }
}
// out: three arrays of n.
void test_three_gaussians(const uint32_t* keys, uint64_t substep, uint64_t seed, float* out, size_t n) {
    const DF d;
    for (size_t i = 0; i < n; i += hn::Lanes(d)) {
        VF g[3], uniform[2];
        three_gaussians(hn::Load(DU(), keys + i), substep, seed, g, uniform);
        for (size_t k = 0; k < 3; ++k) hn::Store(g[k], d, out + k * n + i);
    }
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "kernel/math/lanes.h"

#include "hwy/targets.h"

namespace test {

std::vector<Lanes> lanes() {
    const int64_t supported = hwy::SupportedTargets();
    std::vector<Lanes> out;
    const auto add = [&](const char* name, int64_t target, Lanes functions) {
        functions.name = name;
        if ((target & supported) != 0 || target == HWY_EMU128 || target == HWY_SCALAR) out.push_back(functions);
    };
#define LR_ADD(target)                                                                                                 \
    add(#target, HWY_##target,                                                                                         \
        {nullptr, &lr::N_##target::test_log, &lr::N_##target::test_sin_cos, &lr::N_##target::test_philox,              \
         &lr::N_##target::test_words, &lr::N_##target::test_angles, &lr::N_##target::test_squared_radius,              \
         &lr::N_##target::test_pair, &lr::N_##target::test_gaussians, &lr::N_##target::test_three_gaussians})
#if HWY_TARGETS & HWY_AVX3
    LR_ADD(AVX3);
#endif
#if HWY_TARGETS & HWY_AVX2
    LR_ADD(AVX2);
#endif
#if HWY_TARGETS & HWY_SSE4
    LR_ADD(SSE4);
#endif
#if HWY_TARGETS & HWY_NEON
    LR_ADD(NEON);
#endif
#if HWY_TARGETS & HWY_EMU128
    LR_ADD(EMU128);
#endif
#if HWY_TARGETS & HWY_SCALAR
    LR_ADD(SCALAR);
#endif
#undef LR_ADD
    return out;
}

} // namespace test
#endif
