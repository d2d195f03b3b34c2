// Vectors of bodies. A substep is one chain of dependent operations, longer than a processor looks ahead: two hardware vectors side by side fill the
// gaps (docs/maintainers/performance.md). The rest of the kernel is written for one vector, with Highway's names.
#if defined(LR_KERNEL_MATH_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_MATH_LANES_INL_H_
#undef LR_KERNEL_MATH_LANES_INL_H_
#else
#define LR_KERNEL_MATH_LANES_INL_H_
#endif

#include "hwy/highway.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

// Lambdas in kernels: compiled for the target, and inlined, because a call would pass vectors through memory.
#undef LR_LAMBDA
#if HWY_COMPILER_MSVC
#define LR_LAMBDA
#else
#define LR_LAMBDA HWY_ATTR __attribute__((always_inline))
#endif

// Files with and without pairs have functions of the same names: separate namespaces keep the linker from mixing those that are not inlined.
#undef LR_KERNEL_PAIRS
#undef LR_KERNEL_NAMESPACE
#if !defined(LR_NO_PAIRS) && (HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_NEON)
#define LR_KERNEL_PAIRS 1
#define LR_KERNEL_NAMESPACE HWY_NAMESPACE::inline paired
#else
#define LR_KERNEL_PAIRS 0
#define LR_KERNEL_NAMESPACE HWY_NAMESPACE
#endif

// Min is a < b ? a : b, Max a > b ? a : b; of a number and NaN the second, as on x86. Others differ, but a body must diverge alike on all targets.
#undef LR_LESSER_BY_COMPARISON
#if HWY_ARCH_X86 && HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_SCALAR
#define LR_LESSER_BY_COMPARISON 0
#else
#define LR_LESSER_BY_COMPARISON 1
#endif

HWY_BEFORE_NAMESPACE();
namespace lr::LR_KERNEL_NAMESPACE {

#if LR_KERNEL_PAIRS

namespace pairs {

namespace one = hwy::HWY_NAMESPACE;

template <class T> struct Tag {
    using Lane = T;
    using One = one::CappedTag<T, 16>;
};
template <class V> struct Pair { V a, b; };
template <class V> HWY_INLINE Pair<V> pair(V a, V b) {
    return {a, b};
}
template <class D> using Vec = Pair<one::Vec<typename D::One>>;
template <class D> using Mask = Pair<one::Mask<typename D::One>>;

template <class T> HWY_INLINE constexpr size_t Lanes(Tag<T>) {
    return 2 * one::Lanes(typename Tag<T>::One());
}
template <class T> HWY_INLINE Vec<Tag<T>> Set(Tag<T>, std::type_identity_t<T> x) {
    const auto v = one::Set(typename Tag<T>::One(), x);
    return {v, v};
}
template <class T> HWY_INLINE Vec<Tag<T>> Load(Tag<T>, const T* p) {
    const typename Tag<T>::One d;
    return {one::Load(d, p), one::Load(d, p + one::Lanes(d))};
}
template <class T> HWY_INLINE void Store(Vec<Tag<T>> v, Tag<T>, T* p) {
    const typename Tag<T>::One d;
    one::Store(v.a, d, p);
    one::Store(v.b, d, p + one::Lanes(d));
}
template <class T, class V> HWY_INLINE Vec<Tag<T>> GatherIndex(Tag<T>, const T* p, Pair<V> index) {
    const typename Tag<T>::One d;
    return {one::GatherIndex(d, p, index.a), one::GatherIndex(d, p, index.b)};
}

// Functions of vectors and masks, and functions with a tag before them.
#define LR_PAIR(name)                                                                                                  \
    template <class... V> HWY_INLINE auto name(Pair<V>... x) {                                                         \
        return pair(one::name(x.a...), one::name(x.b...));                                                             \
    }
#define LR_TAGGED_PAIR(name)                                                                                           \
    template <class T, class... V> HWY_INLINE auto name(Tag<T>, Pair<V>... x) {                                        \
        const typename Tag<T>::One d;                                                                                  \
        return pair(one::name(d, x.a...), one::name(d, x.b...));                                                       \
    }
#define LR_OPERATOR(symbol)                                                                                            \
    template <class V> HWY_INLINE auto operator symbol(Pair<V> x, Pair<V> y) {                                         \
        return pair(x.a symbol y.a, x.b symbol y.b);                                                                   \
    }
// clang-format off
LR_PAIR(Neg) LR_PAIR(Abs) LR_PAIR(Sqrt) LR_PAIR(Floor) LR_PAIR(Not) LR_PAIR(DupEven) LR_PAIR(DupOdd)
LR_PAIR(And) LR_PAIR(Or) LR_PAIR(Xor) LR_PAIR(MulEven) LR_PAIR(OddEven)
LR_PAIR(Eq) LR_PAIR(Ne) LR_PAIR(IfThenElse) LR_PAIR(IfThenElseZero)
LR_TAGGED_PAIR(Zero) LR_TAGGED_PAIR(ConvertTo) LR_TAGGED_PAIR(BitCast) LR_TAGGED_PAIR(RebindMask)
LR_OPERATOR(+) LR_OPERATOR(-) LR_OPERATOR(*) LR_OPERATOR(/) LR_OPERATOR(<) LR_OPERATOR(<=) LR_OPERATOR(>) LR_OPERATOR(>=)
// clang-format on
#if !LR_LESSER_BY_COMPARISON
                LR_PAIR(Min) LR_PAIR(Max)
#endif
#undef LR_PAIR
#undef LR_TAGGED_PAIR
#undef LR_OPERATOR
                    template <class V>
                    HWY_INLINE Pair<V>& operator+=(Pair<V>& x, Pair<V> y) {
    return x = x + y;
}
template <class V> HWY_INLINE Pair<V>& operator-=(Pair<V>& x, Pair<V> y) {
    return x = x - y;
}
template <class V> HWY_INLINE Pair<V>& operator*=(Pair<V>& x, Pair<V> y) {
    return x = x * y;
}

template <int kBits, class V> HWY_INLINE Pair<V> ShiftLeft(Pair<V> v) {
    return {one::ShiftLeft<kBits>(v.a), one::ShiftLeft<kBits>(v.b)};
}
template <int kBits, class V> HWY_INLINE Pair<V> ShiftRight(Pair<V> v) {
    return {one::ShiftRight<kBits>(v.a), one::ShiftRight<kBits>(v.b)};
}
#if LR_LESSER_BY_COMPARISON
template <class V> HWY_INLINE Pair<V> Min(Pair<V> x, Pair<V> y) {
    return IfThenElse(x < y, x, y);
}
template <class V> HWY_INLINE Pair<V> Max(Pair<V> x, Pair<V> y) {
    return IfThenElse(x > y, x, y);
}
#endif
template <class T, class M> HWY_INLINE bool AllFalse(Tag<T>, Pair<M> m) {
    return one::AllFalse(typename Tag<T>::One(), one::Or(m.a, m.b));
}
template <class T, class M> HWY_INLINE bool AllTrue(Tag<T>, Pair<M> m) {
    return one::AllTrue(typename Tag<T>::One(), one::And(m.a, m.b));
}
} // namespace pairs

namespace hn = pairs;
using DF = pairs::Tag<float>;
using DU = pairs::Tag<uint32_t>;
using DI = pairs::Tag<int32_t>;

#else

#if LR_LESSER_BY_COMPARISON
namespace alike {
using namespace hwy::HWY_NAMESPACE;
template <class V> HWY_INLINE V Min(V a, V b) {
    return IfThenElse(Lt(a, b), a, b);
}
template <class V> HWY_INLINE V Max(V a, V b) {
    return IfThenElse(Gt(a, b), a, b);
}
} // namespace alike
namespace hn = alike;
#else
namespace hn = hwy::HWY_NAMESPACE;
#endif
using DF = hn::CappedTag<float, 16>;
using DU = hn::RebindToUnsigned<DF>;
using DI = hn::RebindToSigned<DF>;

#endif

using VF = hn::Vec<DF>;
using VU = hn::Vec<DU>;
using VI = hn::Vec<DI>;

HWY_INLINE float least_lane(VF v) {
#if LR_KERNEL_PAIRS
    namespace one = hwy::HWY_NAMESPACE;
    return one::GetLane(one::MinOfLanes(DF::One(), one::Min(v.a, v.b)));
#else
    return hn::GetLane(hn::MinOfLanes(DF(), v));
#endif
}

// Elementary functions from + - x / sqrt only, so that every target gives the same bits. Polynomials are minimax fits for these ranges, with errors
// below half an ulp of a float result (docs/maintainers/numerics.md).

HWY_INLINE VF constant(float x) {
    return hn::Set(DF(), x);
}
// Constants that differ from body to body are vectors already.
HWY_INLINE VF constant(VF x) {
    return x;
}

// Products and sums are never fused (cmake/compile_flags.cmake): fusing changes the last bit, and not every target has it.
HWY_INLINE VF operator-(VF a) {
    return hn::Neg(a);
}

// Coefficients from the highest power on.
template <size_t N> HWY_INLINE VF polynomial(const float (&c)[N], VF x) {
    VF sum = constant(c[0]);
    for (size_t i = 1; i < N; ++i) sum = sum * x + constant(c[i]);
    return sum;
}

// Natural logarithm for x in (0, 1], normal.
HWY_INLINE VF log_unit(VF x) {
    const DU du;
    const DI di;
    const VU bits = hn::BitCast(du, x);
    VF exponent = hn::ConvertTo(DF(), hn::BitCast(di, hn::ShiftRight<23>(bits)) - hn::Set(di, 127));
    VF m = hn::BitCast(DF(), hn::Or(hn::And(bits, hn::Set(du, 0x007fffffu)), hn::Set(du, 0x3f800000u)));
    const auto upper = m > constant(1.41421356f);
    m = hn::IfThenElse(upper, m * constant(0.5f), m);
    exponent = hn::IfThenElse(upper, exponent + constant(1.0f), exponent);
    // log(1 + f) = f - f^2/2 + f^3 P(f) for f in [sqrt(1/2) - 1, sqrt(2) - 1]
    const VF f = m - constant(1.0f);
    const VF f2 = f * f;
    const VF p = polynomial({-0.07865377515554428f, 0.12879173457622528f, -0.13125309348106384f, 0.1418142467737198f,
                             -0.16624969244003296f, 0.20002281665802002f, -0.2500079572200775f, 0.33333316445350647f},
                            f);
    const VF y = f * f2 * p - constant(0.5f) * f2;
    return exponent * constant(0.69314718f) + (f + y);
}

// Sine and cosine of a turn's fraction, 0 <= turn < 1.
HWY_INLINE void sin_cos_turn(VF turn, VF& sine, VF& cosine) {
    const DU du;
    const DI di;
    const VF quarter = turn * constant(4.0f);
    // Truncation of a non-negative number is its floor: exact on every target, whatever the rounding mode.
    const VI quadrant = hn::ConvertTo(di, quarter + constant(0.5f));
    const VF t = quarter - hn::ConvertTo(DF(), quadrant); // [-1/2, 1/2] quarter turns
    const VF z = t * t;
    const VF s = t * polynomial({-0.004602177f, 0.07968023f, -0.6459635f, 1.5707964f}, z);
    const VF c = polynomial({0.00090402167f, -0.020860288f, 0.25366923f, -1.2337005f, 1.0f}, z);
    const VU q = hn::BitCast(du, quadrant);
    const auto odd = hn::RebindMask(DF(), hn::Ne(hn::And(quadrant, hn::Set(di, 1)), hn::Zero(di)));
    const VF a = hn::IfThenElse(odd, c, s), b = hn::IfThenElse(odd, s, c);
    const VU sine_sign = hn::ShiftLeft<30>(hn::And(q, hn::Set(du, 2)));
    const VU cosine_sign = hn::ShiftLeft<30>(hn::And(q + hn::Set(du, 1), hn::Set(du, 2)));
    sine = hn::BitCast(DF(), hn::Xor(hn::BitCast(du, a), sine_sign));
    cosine = hn::BitCast(DF(), hn::Xor(hn::BitCast(du, b), cosine_sign));
}
} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
