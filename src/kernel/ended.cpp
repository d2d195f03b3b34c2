// Which bodies have come to their end by a batch's rules, compiled once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/ended.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

#include "kernel/ended.h"

#include "hwy/highway.h"
#include "kernel/motion-inl.h"
#include "langevin_rigid.h"

namespace lr {
static_assert(most_kill_volumes == LR_MAX_KILL_VOLUMES);
} // namespace lr

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

HWY_INLINE hn::Mask<DF> inside(const lr_kill_volume& volume, Vec3 x) {
    const Vec3 r = sub(x, broadcast(volume.center));
    const auto within = [&](VF at, size_t axis) LR_LAMBDA { return hn::Le(hn::Abs(at), constant(volume.size[axis])); };
    switch (volume.shape) {
    case LR_VOLUME_PLANE:
        return hn::Lt(dot(broadcast(volume.size), r), hn::Zero(DF()));
    case LR_VOLUME_BOX:
        return hn::And(within(r.x, 0), hn::And(within(r.y, 1), within(r.z, 2)));
    default:
        return hn::Le(dot(r, r), constant(volume.size[0] * volume.size[0]));
    }
}

bool ended_range(const lr_batch_rules& rules, const BatchArrays& a, size_t begin, size_t end, uint32_t* cause) {
    const DF d;
    const DU du;
    const VF zero = hn::Zero(d);
    VU any = hn::Zero(du);
    for (size_t at = begin; at < end; at += hn::Lanes(d)) {
        const Vec3 x{hn::Load(d, a.field[field_x] + at), hn::Load(d, a.field[field_y] + at),
                     hn::Load(d, a.field[field_z] + at)};
        // The first of the causes counts: they are written over each other in reverse.
        VU out = hn::Zero(du);
        const auto put = [&](hn::Mask<DF> where, uint32_t code)
                             LR_LAMBDA { out = hn::IfThenElse(hn::RebindMask(du, where), hn::Set(du, code), out); };
        for (uint32_t k = rules.volume_count; k-- > 0;) {
            const auto in = inside(rules.volumes[k], x);
            put(rules.volumes[k].side == LR_KILL_OUTSIDE ? hn::Not(in) : in, cause_volume + k);
        }
        if (rules.max_age > 0.0f) put(hn::Ge(hn::Load(d, a.field[field_age] + at), constant(rules.max_age)), cause_age);
        // 0 for finite x only.
        const Vec3 nothing = sub(x, x);
        const VF sum = hn::Add(nothing.x, hn::Add(nothing.y, nothing.z));
        put(hn::Not(hn::Eq(sum, zero)), cause_not_finite);
        hn::Store(out, du, cause + at);
        any = hn::Or(any, out);
    }
    return !hn::AllTrue(du, hn::Eq(any, hn::Zero(du)));
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
