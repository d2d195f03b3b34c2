// Numbers and vectors of many pairs of bodies side by side, for their search.
#if defined(LR_KERNEL_CONTACT_SEARCH_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_CONTACT_SEARCH_LANES_INL_H_
#undef LR_KERNEL_CONTACT_SEARCH_LANES_INL_H_
#else
#define LR_KERNEL_CONTACT_SEARCH_LANES_INL_H_
#endif

#include "kernel/contact/gjk_pairs.h"

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {
namespace search {

namespace hw = hwy::HWY_NAMESPACE;
using Tag = hw::CappedTag<float, search_lanes>;
using Number = hw::Vec<Tag>;

struct Vec {
    Number x, y, z;
};
HWY_INLINE Vec operator+(const Vec& a, const Vec& b) {
    return {hw::Add(a.x, b.x), hw::Add(a.y, b.y), hw::Add(a.z, b.z)};
}
HWY_INLINE Vec operator-(const Vec& a, const Vec& b) {
    return {hw::Sub(a.x, b.x), hw::Sub(a.y, b.y), hw::Sub(a.z, b.z)};
}
HWY_INLINE Vec operator*(Number s, const Vec& a) {
    return {hw::Mul(s, a.x), hw::Mul(s, a.y), hw::Mul(s, a.z)};
}
HWY_INLINE Number dot(const Vec& a, const Vec& b) {
    return hw::Add(hw::Add(hw::Mul(a.x, b.x), hw::Mul(a.y, b.y)), hw::Mul(a.z, b.z));
}
HWY_INLINE Vec cross(const Vec& a, const Vec& b) {
    return {hw::Sub(hw::Mul(a.y, b.z), hw::Mul(a.z, b.y)), hw::Sub(hw::Mul(a.z, b.x), hw::Mul(a.x, b.z)),
            hw::Sub(hw::Mul(a.x, b.y), hw::Mul(a.y, b.x))};
}

struct Lanes {
    using V = Number;
    using Vec = search::Vec;
    using M = hw::Mask<Tag>;
    static constexpr bool relative = false;
    static constexpr uint32_t most_rounds = 24;
    static HWY_INLINE V number(float a) { return hw::Set(Tag(), a); }
    static HWY_INLINE V root(V a) { return hw::Sqrt(a); }
    static HWY_INLINE M none() { return hw::FirstN(Tag(), 0); }
    static HWY_INLINE bool any(M a) { return !hw::AllFalse(Tag(), a); }
    static HWY_INLINE M both(M a, M b) { return hw::And(a, b); }
    static HWY_INLINE M either(M a, M b) { return hw::Or(a, b); }
    static HWY_INLINE M without(M a, M b) { return hw::AndNot(b, a); }
    static HWY_INLINE M inverse(M a) { return hw::Not(a); }
    static HWY_INLINE V choose(M m, V yes, V no) { return hw::IfThenElse(m, yes, no); }
    static HWY_INLINE Vec choose(M m, const Vec& yes, const Vec& no) {
        return {choose(m, yes.x, no.x), choose(m, yes.y, no.y), choose(m, yes.z, no.z)};
    }
};

HWY_INLINE Vec load(const SearchBlock::Row* rows, size_t at) {
    return {hw::Load(Tag(), rows[0] + at), hw::Load(Tag(), rows[1] + at), hw::Load(Tag(), rows[2] + at)};
}
HWY_INLINE void store(const Vec& a, SearchBlock::Row* rows, size_t at) {
    hw::Store(a.x, Tag(), rows[0] + at);
    hw::Store(a.y, Tag(), rows[1] + at);
    hw::Store(a.z, Tag(), rows[2] + at);
}
} // namespace search
} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
