// Vectors of bodies. A substep is one long chain of dependent operations, longer than a processor looks ahead: two hardware
// vectors side by side fill the gaps (docs/maintainers/performance.md). Everything else in the kernel is written for one vector,
// with Highway's names, and does not know.
#if defined(LR_KERNEL_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_LANES_INL_H_
#undef LR_KERNEL_LANES_INL_H_
#else
#define LR_KERNEL_LANES_INL_H_
#endif

#include "hwy/highway.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

// Lambdas in kernels: of the target, and never calls with vectors passed through memory.
#undef LR_LAMBDA
#define LR_LAMBDA HWY_ATTR __attribute__((always_inline))

// Functions that are not inlined are static: files with and without pairs have others of the same names.
#undef LR_KERNEL_PAIRS
#if !defined(LR_NO_PAIRS) && (HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_NEON)
#define LR_KERNEL_PAIRS 1
#else
#define LR_KERNEL_PAIRS 0
#endif

// The lesser is a < b ? a : b and the greater a > b ? a : b, of a number and NaN the second: as x86 has it, where others differ. A body
// that leaves the numbers does so on all of them alike.
#undef LR_LESSER_BY_COMPARISON
#if HWY_ARCH_X86 && HWY_TARGET != HWY_EMU128 && HWY_TARGET != HWY_SCALAR
#define LR_LESSER_BY_COMPARISON 0
#else
#define LR_LESSER_BY_COMPARISON 1
#endif

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

#if LR_KERNEL_PAIRS

namespace pairs {

namespace one = hwy::HWY_NAMESPACE;

template <class T> struct Tag {
    using Lane = T;
    using One = one::CappedTag<T, 16>;
};
template <class V> struct Pair { V a, b; };
template <class D> using Vec = Pair<one::Vec<typename D::One>>;
template <class D> using Mask = Pair<one::Mask<typename D::One>>;

template <class T> HWY_INLINE constexpr size_t Lanes(Tag<T>) {
    return 2 * one::Lanes(typename Tag<T>::One());
}
template <class T> HWY_INLINE Vec<Tag<T>> Set(Tag<T>, std::type_identity_t<T> x) {
    const auto v = one::Set(typename Tag<T>::One(), x);
    return {v, v};
}
template <class T> HWY_INLINE Vec<Tag<T>> Zero(Tag<T>) {
    const auto v = one::Zero(typename Tag<T>::One());
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

#define LR_PAIR_1(name)                                                                                                \
    template <class V> HWY_INLINE auto name(Pair<V> x)->Pair<decltype(one::name(x.a))> {                               \
        return {one::name(x.a), one::name(x.b)};                                                                       \
    }
#define LR_PAIR_2(name)                                                                                                \
    template <class V> HWY_INLINE auto name(Pair<V> x, Pair<V> y)->Pair<decltype(one::name(x.a, y.a))> {               \
        return {one::name(x.a, y.a), one::name(x.b, y.b)};                                                             \
    }
LR_PAIR_1(Neg)
LR_PAIR_1(Abs)
LR_PAIR_1(Sqrt)
LR_PAIR_1(Floor)
LR_PAIR_1(Not)
LR_PAIR_1(DupEven)
LR_PAIR_1(DupOdd)
LR_PAIR_2(Add)
LR_PAIR_2(Sub)
LR_PAIR_2(Mul)
LR_PAIR_2(Div)
LR_PAIR_2(And)
LR_PAIR_2(AndNot)
LR_PAIR_2(Or)
LR_PAIR_2(Xor)
LR_PAIR_2(Eq)
LR_PAIR_2(Ne)
LR_PAIR_2(Lt)
LR_PAIR_2(Le)
LR_PAIR_2(Gt)
LR_PAIR_2(Ge)
LR_PAIR_2(MulEven)
LR_PAIR_2(OddEven)
#if !LR_LESSER_BY_COMPARISON
LR_PAIR_2(Min)
LR_PAIR_2(Max)
#endif
#undef LR_PAIR_1
#undef LR_PAIR_2

template <int kBits, class V> HWY_INLINE Pair<V> ShiftLeft(Pair<V> v) {
    return {one::ShiftLeft<kBits>(v.a), one::ShiftLeft<kBits>(v.b)};
}
template <int kBits, class V> HWY_INLINE Pair<V> ShiftRight(Pair<V> v) {
    return {one::ShiftRight<kBits>(v.a), one::ShiftRight<kBits>(v.b)};
}
template <int kLanes, class T, class V> HWY_INLINE Pair<V> ShiftRightLanes(Tag<T>, Pair<V> v) {
    const typename Tag<T>::One d;
    return {one::ShiftRightLanes<kLanes>(d, v.a), one::ShiftRightLanes<kLanes>(d, v.b)};
}
template <class T, class V> HWY_INLINE Vec<Tag<T>> ConvertTo(Tag<T>, Pair<V> v) {
    const typename Tag<T>::One d;
    return {one::ConvertTo(d, v.a), one::ConvertTo(d, v.b)};
}
template <class T, class V> HWY_INLINE Vec<Tag<T>> BitCast(Tag<T>, Pair<V> v) {
    const typename Tag<T>::One d;
    return {one::BitCast(d, v.a), one::BitCast(d, v.b)};
}
template <class T, class M> HWY_INLINE Mask<Tag<T>> RebindMask(Tag<T>, Pair<M> m) {
    const typename Tag<T>::One d;
    return {one::RebindMask(d, m.a), one::RebindMask(d, m.b)};
}
template <class M, class V> HWY_INLINE Pair<V> IfThenElse(Pair<M> m, Pair<V> x, Pair<V> y) {
    return {one::IfThenElse(m.a, x.a, y.a), one::IfThenElse(m.b, x.b, y.b)};
}
template <class M, class V> HWY_INLINE Pair<V> IfThenElseZero(Pair<M> m, Pair<V> x) {
    return {one::IfThenElseZero(m.a, x.a), one::IfThenElseZero(m.b, x.b)};
}
#if LR_LESSER_BY_COMPARISON
template <class V> HWY_INLINE Pair<V> Min(Pair<V> x, Pair<V> y) {
    return IfThenElse(Lt(x, y), x, y);
}
template <class V> HWY_INLINE Pair<V> Max(Pair<V> x, Pair<V> y) {
    return IfThenElse(Gt(x, y), x, y);
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
HWY_INLINE float greatest_lane(VF v) {
#if LR_KERNEL_PAIRS
    namespace one = hwy::HWY_NAMESPACE;
    return one::GetLane(one::MaxOfLanes(DF::One(), one::Max(v.a, v.b)));
#else
    return hn::GetLane(hn::MaxOfLanes(DF(), v));
#endif
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
