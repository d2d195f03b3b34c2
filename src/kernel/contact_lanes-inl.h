// What contact needs of vectors beside the kernel's.
#if defined(LR_KERNEL_CONTACT_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_CONTACT_LANES_INL_H_
#undef LR_KERNEL_CONTACT_LANES_INL_H_
#else
#define LR_KERNEL_CONTACT_LANES_INL_H_
#endif

#include "kernel/batch_arrays.h"
#include "kernel/contact.h"
#include "kernel/motion-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

#if LR_KERNEL_PAIRS
namespace pairs {
template <class V> HWY_INLINE Pair<V> Shr(Pair<V> v, Pair<V> bits) {
    return {one::Shr(v.a, bits.a), one::Shr(v.b, bits.b)};
}
} // namespace pairs
#endif

HWY_INLINE Vec3 load3(const BatchArrays& a, size_t field, size_t at) {
    const DF d;
    return {hn::Load(d, a.field[field] + at), hn::Load(d, a.field[field + 1] + at),
            hn::Load(d, a.field[field + 2] + at)};
}
HWY_INLINE void store3(const BatchArrays& a, size_t field, size_t at, Vec3 v) {
    const DF d;
    hn::Store(v.x, d, a.field[field] + at);
    hn::Store(v.y, d, a.field[field + 1] + at);
    hn::Store(v.z, d, a.field[field + 2] + at);
}
HWY_INLINE Vec3 load3(const LaneRow* rows, size_t at) {
    const DF d;
    return {hn::Load(d, rows[0] + at), hn::Load(d, rows[1] + at), hn::Load(d, rows[2] + at)};
}
HWY_INLINE void store3(LaneRow* rows, size_t at, Vec3 v) {
    const DF d;
    hn::Store(v.x, d, rows[0] + at);
    hn::Store(v.y, d, rows[1] + at);
    hn::Store(v.z, d, rows[2] + at);
}
HWY_INLINE Quaternion load4(const BatchArrays& a, size_t at) {
    const DF d;
    return {hn::Load(d, a.field[field_qx] + at), hn::Load(d, a.field[field_qy] + at),
            hn::Load(d, a.field[field_qz] + at), hn::Load(d, a.field[field_qw] + at)};
}
HWY_INLINE Quaternion load4(const LaneRow* rows, size_t at) {
    const DF d;
    return {hn::Load(d, rows[0] + at), hn::Load(d, rows[1] + at), hn::Load(d, rows[2] + at), hn::Load(d, rows[3] + at)};
}
template <class M> HWY_INLINE Vec3 select(M mask, Vec3 yes, Vec3 no) {
    return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z)};
}
// The height of a heightfield below points in its frame, that at its outline where they are beyond.
HWY_INLINE VF height_within(const float* heights, const uint32_t (&counts)[2], const float (&inverse_spacing)[2],
                            Vec3 p) {
    const DI di;
    const VF zero = hn::Zero(DF());
    const auto within = [&](VF at, int k) LR_LAMBDA {
        const VF last = constant(static_cast<float>(counts[k] - 1));
        return hn::Max(hn::Min(hn::Mul(at, constant(inverse_spacing[k])), last), zero);
    };
    const auto below = [&](VF at, int k)
                           LR_LAMBDA { return hn::Min(hn::Floor(at), constant(static_cast<float>(counts[k] - 2))); };
    const VF u = within(p.x, 0), w = within(p.z, 1), i = below(u, 0), k = below(w, 1);
    const VI row = hn::Set(di, static_cast<int32_t>(counts[0])), next = hn::Set(di, 1);
    const VI at = hn::Add(hn::ConvertTo(di, i), hn::Mul(hn::ConvertTo(di, k), row));
    const VF fu = hn::Sub(u, i), fw = hn::Sub(w, k);
    const auto upper = hn::Ge(fw, fu);
    const auto height = [&](VI index) LR_LAMBDA { return hn::GatherIndex(DF(), heights, index); };
    const VF h00 = height(at), h11 = height(hn::Add(hn::Add(at, row), next));
    const VF corner = height(hn::Add(at, hn::IfThenElse(hn::RebindMask(di, upper), row, next)));
    const VF along_w = hn::IfThenElse(upper, hn::Sub(corner, h00), hn::Sub(h11, corner));
    const VF along_u = hn::IfThenElse(upper, hn::Sub(h11, corner), hn::Sub(corner, h00));
    return mul_add(fu, along_u, mul_add(fw, along_w, h00));
}
// How far above such a height what reaches so far may be and touch something; heights are rounded.
HWY_INLINE VF most_above(VF reach, float secant, VF height) {
    return mul_add(reach, constant(secant), hn::Mul(constant(1e-6f), hn::Abs(height)));
}
// A vector's length, and its inverse that is 0 for no vector at all.
HWY_INLINE VF inverse_length(VF length) {
    const VF least = constant(1e-30f);
    return hn::IfThenElseZero(hn::Gt(length, least), hn::Div(constant(1.0f), hn::Max(length, least)));
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
