// Whether all bodies of a vector are bodies still: kernel/faults.h.
#if defined(LR_KERNEL_FAULTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_FAULTS_INL_H_
#undef LR_KERNEL_FAULTS_INL_H_
#else
#define LR_KERNEL_FAULTS_INL_H_
#endif

#include "kernel/faults.h"
#include "kernel/motion-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

// Comparisons with NaN do not hold.
HWY_INLINE hn::Mask<DF> sane_pose(Vec3 x, Quaternion q) {
    const VF far = constant(farthest_place);
    const VF turn = mul_add(q.x, q.x, mul_add(q.y, q.y, mul_add(q.z, q.z, hn::Mul(q.w, q.w))));
    const auto near = hn::And(hn::Le(hn::Abs(x.x), far), hn::And(hn::Le(hn::Abs(x.y), far), hn::Le(hn::Abs(x.z), far)));
    return hn::And(near, hn::And(hn::Ge(turn, constant(shortest_turn)), hn::Le(turn, constant(longest_turn))));
}
HWY_INLINE hn::Mask<DF> sane_motion(Vec3 v, Vec3 w) {
    return hn::And(hn::Le(dot(v, v), constant(fastest_squared)), hn::Le(dot(w, w), constant(fastest_spin_squared)));
}
HWY_INLINE hn::Mask<DF> sane_gust(Vec3 gust) {
    return hn::Le(dot(gust, gust), constant(fastest_squared));
}
HWY_INLINE hn::Mask<DF> not_held(const BatchArrays& a, size_t at) {
    return hn::Gt(hn::Load(DF(), a.field[field_age_rest] + at), constant(least_age_rest));
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
