// Which bodies may touch something solid within a step.
#if defined(LR_KERNEL_CONTACT_NEAR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_CONTACT_NEAR_INL_H_
#undef LR_KERNEL_CONTACT_NEAR_INL_H_
#else
#define LR_KERNEL_CONTACT_NEAR_INL_H_
#endif

#include "kernel/contact.h"
#include "kernel/contact_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

HWY_INLINE hn::Mask<DF> marked(const OccupancyLevel& level, Vec3 x) {
    const DU du;
    const DI di;
    const VF inverse = constant(level.inverse_cell), most = constant(most_cells);
    const auto cell = [&](VF at) LR_LAMBDA {
        const VF floored = hn::Floor(hn::Mul(at, inverse));
        return hn::BitCast(du, hn::ConvertTo(di, hn::Max(hn::Min(floored, most), hn::Neg(most))));
    };
    VU h = hn::Xor(hn::Mul(cell(x.x), hn::Set(du, 0x9e3779b1u)), hn::Mul(cell(x.y), hn::Set(du, 0x85ebca77u)));
    h = hn::Xor(h, hn::Mul(cell(x.z), hn::Set(du, 0xc2b2ae3du)));
    h = hn::Mul(hn::Xor(h, hn::ShiftRight<15>(h)), hn::Set(du, 0x2c1b3c6du));
    h = hn::Xor(h, hn::ShiftRight<13>(h));
    const VU word = hn::And(hn::ShiftRight<5>(h), hn::Set(du, level.mask));
    const VU bits = hn::GatherIndex(du, level.bits, hn::BitCast(di, word));
    const VU one = hn::Set(du, 1), bit = hn::And(hn::Shr(bits, hn::And(h, hn::Set(du, 31))), one);
    return hn::RebindMask(DF(), hn::Eq(bit, one));
}

HWY_INLINE hn::Mask<DF> over(const NearHeightfield& f, Vec3 x, VF reach) {
    const DI di;
    const Vec3 r = rows(f.axes, sub(x, broadcast(f.position)));
    const VF zero = hn::Zero(DF());
    const auto square = [&](VF at, int k) LR_LAMBDA {
        const VF floored = hn::Floor(hn::Mul(at, constant(f.inverse_coarse[k])));
        const VF last = constant(static_cast<float>(f.counts[k] - 1));
        return hn::ConvertTo(di, hn::Max(hn::Min(floored, last), zero));
    };
    const VI at = hn::Add(square(r.x, 0), hn::Mul(square(r.z, 1), hn::Set(di, static_cast<int32_t>(f.counts[0]))));
    VF top = hn::GatherIndex(DF(), f.coarse, at);
    top = hn::IfThenElse(hn::Le(reach, constant(f.coarse_size)), top, constant(f.highest));
    const auto within = [&](VF at_axis, int k) LR_LAMBDA {
        return hn::And(hn::Ge(hn::Add(at_axis, reach), zero), hn::Le(hn::Sub(at_axis, reach), constant(f.extent[k])));
    };
    const auto low = hn::And(hn::Le(hn::Sub(r.y, reach), top), hn::And(within(r.x, 0), within(r.z, 1)));
    if (hn::AllFalse(DF(), low)) return low;
    const VF height = height_within(f.heights, f.samples, f.inverse_spacing, r);
    return hn::And(low, hn::Le(hn::Sub(r.y, height), most_above(reach, f.secant, height)));
}

void near_colliders(const NearColliders& c, float reach, float dt, float speed, const BatchArrays& a, size_t begin,
                    size_t end, uint32_t* near) {
    const DF d;
    const DU du;
    const VF travel = constant(1.5f * dt), gain = constant(speed * dt);
    for (size_t at = begin; at < end; at += hn::Lanes(d)) {
        const Vec3 x = load3(a, field_x, at), v = load3(a, field_vx, at), w = load3(a, field_wx, at);
        // Half of the reach again: contact begins before touching.
        const VF size = hn::Mul(constant(1.5f * reach), hn::Load(d, a.field[field_scale] + at));
        // What spins fast may go fast a moment later: added mass turns the energy of one into that of the other.
        const VF speed_now = mul_add(hn::Mul(constant(0.25f), size), hn::Sqrt(dot(w, w)), hn::Sqrt(dot(v, v)));
        const VF far = hn::Add(mul_add(travel, speed_now, size), gain);
        const auto nobody = hn::Lt(far, hn::Zero(d));
        auto over_ground = nobody;
        if (c.everywhere) over_ground = hn::Not(over_ground);
        for (uint32_t k = 0; k < c.plane_count; ++k) {
            const NearPlane& p = c.planes[k];
            const VF above = dot(broadcast(p.normal), sub(x, broadcast(p.point)));
            over_ground = hn::Or(over_ground, hn::Le(above, hn::Add(far, constant(p.travel))));
        }
        for (uint32_t k = 0; k < c.heightfield_count; ++k) {
            const NearHeightfield& f = c.heightfields[k];
            over_ground = hn::Or(over_ground, over(f, x, hn::Add(far, constant(f.travel))));
        }
        auto is_near = nobody;
        for (uint32_t k = 0; k < c.level_count; ++k) {
            const OccupancyLevel& l = c.levels[k];
            is_near = hn::Or(is_near, hn::Or(hn::Gt(far, constant(l.dilation)), marked(l, x)));
        }
        const VU bits = hn::IfThenElseZero(hn::RebindMask(du, is_near), hn::Set(du, near_bits));
        const VU ground = hn::IfThenElseZero(hn::RebindMask(du, over_ground), hn::Set(du, near_ground));
        hn::Store(hn::Or(bits, ground), du, near + (at - begin));
    }
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
