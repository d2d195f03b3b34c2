// Vectors of a block's bodies in rows of x, y and z.
#if defined(LR_KERNEL_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_ROWS_INL_H_
#undef LR_KERNEL_ROWS_INL_H_
#else
#define LR_KERNEL_ROWS_INL_H_
#endif

#include "kernel/motion-inl.h"
#include "kernel/wind.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

using Row = float[field_block];

HWY_INLINE Vec3 load3(const Row* rows, size_t at) {
    const DF d;
    return {hn::Load(d, rows[0] + at), hn::Load(d, rows[1] + at), hn::Load(d, rows[2] + at)};
}
HWY_INLINE void store3(Row* rows, size_t at, Vec3 v) {
    const DF d;
    hn::Store(v.x, d, rows[0] + at);
    hn::Store(v.y, d, rows[1] + at);
    hn::Store(v.z, d, rows[2] + at);
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
