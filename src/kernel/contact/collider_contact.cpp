// Contact with colliders, compiled once for each instruction set. Method and formulas: docs/maintainers/contact.md.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/contact/collider_contact.cpp"
#include "hwy/foreach_target.h" // IWYU pragma: keep

// One vector at a time: two side by side spill so much here that they gain nothing, with twice the code.
#ifndef LR_NO_PAIRS
#define LR_NO_PAIRS
#endif

#include "kernel/contact/collider_contact.h"

#include "hwy/highway.h"
#include "kernel/contact/body_contact_solver-inl.h"
#include "kernel/contact/collider_solver-inl.h"
#include "kernel/contact/ground_contact-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

HWY_INLINE hn::Mask<DF> marked(const OccupancyLevel& level, Vec3 x) {
    const DU du;
    const DI di;
    const VF inverse = constant(level.inverse_cell), most = constant(most_cells);
    const auto cell = [&](VF at) LR_LAMBDA {
        const VF floored = hn::Floor(at * inverse);
        return hn::BitCast(du, hn::ConvertTo(di, hn::Max(hn::Min(floored, most), -most)));
    };
    VU h = hn::Xor(cell(x.x) * hn::Set(du, 0x9e3779b1u), cell(x.y) * hn::Set(du, 0x85ebca77u));
    h = hn::Xor(h, cell(x.z) * hn::Set(du, 0xc2b2ae3du));
    h = hn::Xor(h, hn::ShiftRight<15>(h)) * hn::Set(du, 0x2c1b3c6du);
    h = hn::Xor(h, hn::ShiftRight<13>(h));
    const VU word = hn::And(hn::ShiftRight<5>(h), hn::Set(du, level.mask));
    const VU bits = hn::GatherIndex(du, level.bits, hn::BitCast(di, word));
    const VU one = hn::Set(du, 1), bit = hn::And(hn::Shr(bits, hn::And(h, hn::Set(du, 31))), one);
    return hn::RebindMask(DF(), hn::Eq(bit, one));
}

HWY_INLINE hn::Mask<DF> over(const NearHeightfield& f, Vec3 x, VF reach) {
    const DI di;
    const Vec3 r = rows(f.axes, x - broadcast(f.position));
    const VF zero = hn::Zero(DF());
    const auto square = [&](VF at, int k) LR_LAMBDA {
        const VF floored = hn::Floor(at * constant(f.inverse_coarse[k]));
        const VF last = constant(static_cast<float>(f.counts[k] - 1));
        return hn::ConvertTo(di, hn::Max(hn::Min(floored, last), zero));
    };
    const VI at = square(r.x, 0) + square(r.z, 1) * hn::Set(di, static_cast<int32_t>(f.counts[0]));
    VF top = hn::GatherIndex(DF(), f.coarse, at);
    top = hn::IfThenElse(reach <= constant(f.coarse_size), top, constant(f.highest));
    const auto within = [&](VF at_axis, int k) LR_LAMBDA {
        return hn::And(at_axis + reach >= zero, at_axis - reach <= constant(f.extent[k]));
    };
    const auto low = hn::And(r.y - reach <= top, hn::And(within(r.x, 0), within(r.z, 1)));
    if (hn::AllFalse(DF(), low)) return low;
    const VF height = height_within(f.grid, r);
    return hn::And(low, r.y - height <= most_above(reach, f.grid.secant, height));
}

// Marks bodies that can touch a collider within a step.
void near_colliders(const NearColliders& c, float reach, float dt, float speed, const BatchArrays& a, size_t begin,
                    size_t end, uint32_t* near) {
    const DU du;
    const VF travel = constant(1.5f * dt), gain = constant(speed * dt);
    for (size_t at = begin; at < end; at += hn::Lanes(DF())) {
        const Vec3 x = load3(a, field_x, at), v = load3(a, field_vx, at), w = load3(a, field_wx, at);
        // Half of the reach more: contact begins before bodies touch.
        const VF size = constant(1.5f * reach) * load1(a, field_scale, at);
        // A fast spin can become a fast velocity a moment later: added mass exchanges energy between them.
        const VF speed_now = constant(0.25f) * size * hn::Sqrt(dot(w, w)) + hn::Sqrt(dot(v, v));
        const VF far = travel * speed_now + size + gain;
        const auto nobody = far < hn::Zero(DF());
        auto over_ground = nobody;
        if (c.everywhere) over_ground = hn::Not(over_ground);
        for (uint32_t k = 0; k < c.plane_count; ++k) {
            const NearPlane& p = c.planes[k];
            const VF above = dot(broadcast(p.normal), x - broadcast(p.point));
            over_ground = hn::Or(over_ground, above <= far + constant(p.travel));
        }
        for (uint32_t k = 0; k < c.heightfield_count; ++k) {
            const NearHeightfield& f = c.heightfields[k];
            over_ground = hn::Or(over_ground, over(f, x, far + constant(f.travel)));
        }
        auto is_near = nobody;
        for (uint32_t k = 0; k < c.level_count; ++k) {
            const OccupancyLevel& l = c.levels[k];
            is_near = hn::Or(is_near, hn::Or(far > constant(l.dilation), marked(l, x)));
        }
        const VU bits = hn::IfThenElseZero(hn::RebindMask(du, is_near), hn::Set(du, near_bits));
        const VU ground = hn::IfThenElseZero(hn::RebindMask(du, over_ground), hn::Set(du, near_ground));
        store1(near, (at - begin), hn::Or(bits, ground));
    }
}

// As declared in kernel/integrator/step.cpp.
extern const ContactTarget contact_functions;
extern const BodyContactTarget body_contact_functions;
const ContactTarget contact_functions{&near_colliders, &touch_ground, &resolve_contacts};
const BodyContactTarget body_contact_functions{
    &body_contact_begin, &body_contact_way,      &body_contact_short_step, &body_contact_end_short_step,
    &body_contact_sweep, &body_contact_follow,   &body_contact_roll,       &body_contact_move,
    &body_contact_touch, &body_contact_velocity, &body_contact_restrain,   &body_contact_finish};
} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
