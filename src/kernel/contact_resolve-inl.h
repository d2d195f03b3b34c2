// What contacts do to bodies: Gauss-Seidel over the contacts of each body by itself, with its own mass and that of the fluid that it
// moves along, first for the way of the substep and then for the velocity at its end (docs/contact.md).
#if defined(LR_KERNEL_CONTACT_RESOLVE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_CONTACT_RESOLVE_INL_H_
#undef LR_KERNEL_CONTACT_RESOLVE_INL_H_
#else
#define LR_KERNEL_CONTACT_RESOLVE_INL_H_
#endif

#include "kernel/contact.h"
#include "kernel/contact_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

constexpr uint32_t contact_sweeps = 16;

// A contact in the body frame, in kernel units: an impulse p at the arm r is the twist impulse (p, r x p/(d s)).
struct Row {
    Vec3 normal, arm; // arm over d s
    Twist response;   // of the body to a unit impulse along the normal
    VF inverse;       // 1 over what the point's normal velocity gains by it; 0 for an empty slot
    VF target;        // normal velocity (or way) that it must have at least
    Vec3 surface;     // velocity (or way) of the surface
    VF friction;
    VF pressed;   // impulse along the normal
    Vec3 dragged; // by friction
};

HWY_INLINE VF greatest(Vec3 v) {
    return hn::Max(hn::Abs(v.x), hn::Max(hn::Abs(v.y), hn::Abs(v.z)));
}
HWY_INLINE Vec3 velocity_at(Twist t, Vec3 arm) {
    return add(t.v, cross(t.u, arm));
}
HWY_INLINE Twist impulse_at(Vec3 p, Vec3 arm) {
    return {p, cross(arm, p)};
}

// What `size` is multiplied with to be no more than `most`; exactly 1 where it is at its limit but for rounding, so that
// sweeps come to an end.
HWY_INLINE VF within_cone(VF most, VF size) {
    const VF factor = hn::Mul(most, inverse_length(size));
    return hn::IfThenElse(hn::Ge(factor, constant(0.999999f)), constant(1.0f), factor);
}

// Sweeps over the contacts until none changes the twist by more than `dust`.
template <bool kFull, class C>
HWY_INLINE void project(const C& c, Row* rows, uint32_t count, VF rolling, VF dust, Twist& t) {
    const DF d;
    const VF zero = hn::Zero(d);
    Vec3 rolled{zero, zero, zero}; // impulse couple against rolling and spinning
    for (uint32_t sweep = 0; sweep < contact_sweeps; ++sweep) {
        VF change = zero, load = zero;
        for (uint32_t i = 0; i < count; ++i) {
            Row& r = rows[(sweep & 1) == 0 ? i : count - 1 - i];
            Vec3 at = velocity_at(t, r.arm);
            const VF wanted = hn::Mul(hn::Sub(r.target, dot(r.normal, at)), hn::Mul(constant(1.3f), r.inverse));
            VF pressed = hn::Max(hn::Add(r.pressed, wanted), zero);
            VF more = hn::Sub(pressed, r.pressed);
            // Each lane by itself: what is under the dust stays as it is, in every later sweep too.
            const auto counts = hn::Gt(hn::Abs(more), hn::Mul(dust, hn::Min(r.inverse, constant(1e6f))));
            more = hn::IfThenElseZero(counts, more);
            pressed = hn::Add(r.pressed, more);
            r.pressed = pressed;
            load = hn::Add(load, pressed);
            t = add_scaled(t, more, r.response);
            change = hn::Max(change, hn::Abs(more));

            at = sub(velocity_at(t, r.arm), r.surface);
            const Vec3 slip = add_scaled(at, hn::Neg(dot(r.normal, at)), r.normal);
            const VF speed = hn::Sqrt(dot(slip, slip));
            const auto slides = hn::And(hn::Gt(speed, dust), hn::Gt(pressed, zero));
            const auto held = hn::Gt(dot(r.dragged, r.dragged), zero);
            if (hn::AllFalse(d, hn::Or(slides, held))) continue;
            const VF inverse_speed = inverse_length(speed);
            const Vec3 along = scale(inverse_speed, slip);
            const Twist answer = acceleration<kFull>(c, impulse_at(along, r.arm));
            const VF gain = dot(along, velocity_at(answer, r.arm));
            const VF needed = hn::IfThenElseZero(slides, hn::Mul(speed, inverse_length(gain)));
            Vec3 dragged = add_scaled(r.dragged, hn::Neg(needed), along);
            const VF size = hn::Sqrt(dot(dragged, dragged)), most = hn::Mul(r.friction, pressed);
            dragged = scale(within_cone(most, size), dragged);
            const Vec3 step = sub(dragged, r.dragged);
            r.dragged = dragged;
            t = add(t, acceleration<kFull>(c, impulse_at(step, r.arm)));
            change = hn::Max(change, greatest(step));
        }
        if (!hn::AllTrue(d, hn::Eq(rolling, zero))) {
            const VF speed = hn::Sqrt(dot(t.u, t.u));
            const Vec3 along = scale(inverse_length(speed), t.u);
            const Twist answer = acceleration<kFull>(c, {{zero, zero, zero}, along});
            const VF needed =
                hn::IfThenElseZero(hn::Gt(speed, dust), hn::Mul(speed, inverse_length(dot(along, answer.u))));
            Vec3 couple = add_scaled(rolled, hn::Neg(needed), along);
            const VF size = hn::Sqrt(dot(couple, couple)), most = hn::Mul(rolling, load);
            couple = scale(within_cone(most, size), couple);
            const Vec3 step = sub(couple, rolled);
            rolled = couple;
            t = add(t, acceleration<kFull>(c, {{zero, zero, zero}, step}));
            change = hn::Max(change, greatest(step));
        }
        if (hn::AllTrue(d, hn::Eq(change, zero))) break;
    }
}

template <class M> HWY_INLINE Twist select(M mask, const Twist& yes, const Twist& no) {
    return {select(mask, yes.v, no.v), select(mask, yes.u, no.u)};
}

template <bool kFull, class C> HWY_INLINE void set_row(const C& c, Vec3 normal, Vec3 arm, Row& r) {
    r.normal = normal;
    r.arm = arm;
    r.response = acceleration<kFull>(c, impulse_at(normal, arm));
    r.inverse = inverse_length(dot(normal, velocity_at(r.response, arm)));
}

template <bool kFull> HWY_NOINLINE void resolve(const ContactBodies& b, ContactSlots& slots) {
    const DF d;
    const BodyConstants& c = *b.body;
    const VF zero = hn::Zero(d), one = constant(1.0f), half = constant(0.5f), h = constant(b.h);
    const VF empty = constant(0.5f * no_contact);
    Row rows[contact_slots];
    uint32_t used[contact_slots];
    for (size_t at = 0; at < b.count; at += hn::Lanes(d)) {
        uint32_t count = 0;
        for (uint32_t k = 0; k < slots.used; ++k) {
            hn::Store(hn::Neg(one), d, slots.slot[k].impulse + at);
            if (!hn::AllFalse(d, hn::Lt(hn::Load(d, slots.slot[k].gap + at), empty))) used[count++] = k;
        }
        if (count == 0) continue;
        const VF body_scale = hn::Load(d, b.arrays.field[field_scale] + at);
        const VF length = hn::Mul(body_scale, constant(c.length)), inverse = hn::Div(one, length);
        const VF reach = hn::Mul(body_scale, constant(b.shape.reach));
        Vec3 x = load3(b.arrays, field_x, at);
        Quaternion q = load4(b.arrays, at);
        const Vec3 x0 = load3(b.before, at);
        const Quaternion q0 = load4(b.before + 3, at);
        const Twist began{load3(b.before + 7, at), scale(length, load3(b.before + 10, at))};
        const VF round = hn::Mul(constant(1e-6f), greatest(x));
        const VF slop = mul_add(constant(1e-3f), reach, round);

        // The way of the substep as a twist: along the body's axes as they are at its end, rotation by its chord.
        const Quaternion back{hn::Neg(q0.x), hn::Neg(q0.y), hn::Neg(q0.z), q0.w};
        const Quaternion turned = turn({zero, zero, zero, zero}, back, one, {q.x, q.y, q.z});
        // turn() gives back (q, 0); the part of q.w is added here.
        const VF w = hn::Add(turned.w, hn::Mul(back.w, q.w));
        Vec3 angle{mul_add(back.x, q.w, turned.x), mul_add(back.y, q.w, turned.y), mul_add(back.z, q.w, turned.z)};
        angle = scale(hn::IfThenElse(hn::Lt(w, zero), constant(-2.0f), constant(2.0f)), angle);
        const Twist way{to_body(q, sub(x, x0)), scale(length, angle)};

        VF gap[contact_slots], before[contact_slots], bounce[contact_slots], depth = zero;
        for (uint32_t k = 0; k < count; ++k) {
            const ContactSlots::Slot& s = slots.slot[used[k]];
            const Vec3 normal = load3(s.normal, at), arm = load3(s.arm, at), surface = load3(s.surface, at);
            Row& r = rows[k];
            set_row<kFull>(c, to_body(q, normal), scale(inverse, arm), r);
            r.pressed = zero;
            r.dragged = {zero, zero, zero};
            gap[k] = hn::Load(d, s.gap + at);
            const auto empty_slot = hn::Ge(gap[k], empty);
            // Deep overlap, as of a body that a collider was put on, is undone over a few substeps.
            const VF push = hn::Max(gap[k], hn::Mul(constant(-0.5f), reach));
            depth = hn::Max(depth, hn::IfThenElse(empty_slot, zero, hn::Neg(gap[k])));
            r.inverse = hn::IfThenElse(empty_slot, zero, r.inverse);
            r.target = hn::Sub(dot(r.normal, velocity_at(way, r.arm)), push);
            r.surface = scale(h, to_body(q, surface));
            r.friction = hn::IfThenElse(empty_slot, zero, hn::Load(d, s.friction + at));
            // Of the point that touches: where it was, and how fast it came when the gap closed, between its speeds at the ends.
            const Vec3 moved = sub(add(sub(x, x0), to_world(q, arm)), to_world(q0, arm));
            before[k] = hn::Add(gap[k], mul_sub(h, dot(normal, surface), dot(normal, moved)));
            const Twist end{load3(b.arrays, field_vx, at), scale(length, load3(b.arrays, field_wx, at))};
            const VF carried = dot(normal, surface);
            const VF first = hn::Sub(dot(normal, to_world(q0, velocity_at(began, r.arm))), carried);
            const VF last = hn::Sub(dot(normal, to_world(q, velocity_at(end, r.arm))), carried);
            const VF closed = hn::Sub(before[k], gap[k]);
            const auto closes = hn::And(hn::Gt(before[k], slop), hn::Gt(closed, zero));
            const VF part =
                hn::IfThenElseZero(closes, hn::Min(hn::Div(before[k], hn::Max(closed, constant(1e-30f))), one));
            bounce[k] = mul_add(part, hn::Sub(last, first), first);
        }
        const VF rolling = hn::Mul(constant(b.rolling), hn::Mul(reach, inverse));
        Twist moved = way;
        project<kFull>(c, rows, count, rolling, hn::Mul(constant(1e-4f), slop), moved);
        Twist correction{sub(moved.v, way.v), sub(moved.u, way.u)};
        // A twist is a small rotation.
        const VF large = hn::Mul(greatest(correction.u), inverse);
        const VF less = hn::Min(hn::Div(half, hn::Max(large, half)), one);
        correction.u = scale(less, correction.u);
        VF touching[contact_slots];
        for (uint32_t k = 0; k < count; ++k) {
            gap[k] = hn::Add(gap[k], dot(rows[k].normal, velocity_at(correction, rows[k].arm)));
            const auto touches = hn::Or(hn::Gt(rows[k].pressed, zero), hn::Le(gap[k], slop));
            touching[k] = hn::IfThenElseZero(touches, one);
        }
        x = add(x, to_world(q, correction.v));
        q = normalised(turn(q, q, hn::Mul(half, inverse), correction.u));

        const Twist met{load3(b.arrays, field_vx, at), scale(length, load3(b.arrays, field_wx, at))};
        Twist t = met;
        const VF slow = constant(2.0f * b.gravity * b.h);
        VF carried = zero, shallow = zero; // shallow: the least gap that the substep began with
        auto any_touch = hn::Lt(reach, zero);
        // A body that rests falls half of g h^2 in a substep and gains g h: the impulses that undo the one are a good guess of those
        // that undo the other.
        const auto rests = hn::Lt(depth, mul_add(constant(2.0f), slop, constant(b.gravity * (b.h * b.h))));
        const VF guess = hn::IfThenElseZero(rests, constant(2.0f / b.h));
        for (uint32_t k = 0; k < count; ++k) {
            const ContactSlots::Slot& s = slots.slot[used[k]];
            const Vec3 surface = to_body(q, load3(s.surface, at));
            Row& r = rows[k];
            set_row<kFull>(c, to_body(q, load3(s.normal, at)), r.arm, r);
            const auto touches = hn::And(hn::Gt(touching[k], zero), hn::Lt(hn::Load(d, s.gap + at), empty));
            r.inverse = hn::IfThenElseZero(touches, r.inverse);
            const VF back_off = hn::IfThenElseZero(hn::Lt(bounce[k], hn::Neg(slow)),
                                                   hn::Neg(hn::Mul(hn::Load(d, s.restitution + at), bounce[k])));
            r.target = hn::Add(dot(r.normal, surface), back_off);
            r.surface = surface;
            const VF kept = hn::IfThenElseZero(touches, guess);
            r.pressed = hn::Mul(kept, r.pressed);
            r.dragged = scale(kept, r.dragged);
            t = add(t, acceleration<kFull>(c, impulse_at(add_scaled(r.dragged, r.pressed, r.normal), r.arm)));
            carried = hn::Max(carried, hn::IfThenElseZero(touches, greatest(surface)));
            any_touch = hn::Or(any_touch, touches);
            shallow = hn::Min(shallow, hn::IfThenElse(touches, before[k], zero));
        }
        project<kFull>(c, rows, count, rolling, hn::Mul(constant(1e-5f), slow), t);
        // Restitution and friction of several contacts together could give energy (Kane 1984): still surfaces have none to give.
        const auto energy = [&](const Twist& of) LR_LAMBDA {
            const Twist p = momentum<kFull>(c, of);
            return hn::Add(dot(p.v, of.v), dot(p.u, of.u));
        };
        const VF had = energy(met), has = energy(t);
        const auto gained = hn::And(hn::Gt(has, had), hn::Eq(carried, zero));
        const VF factor = hn::IfThenElse(gained, hn::Sqrt(hn::Div(had, hn::Max(has, constant(1e-30f)))), one);
        t = {scale(factor, t.v), scale(factor, t.u)};

        // What is left of the sweeps would make bodies at rest creep. One that neither moved before nor does now stays where it
        // was, to the bit: less than 1/500 of gravity does not get it going.
        const auto size = [&](const Twist& of) LR_LAMBDA {
            const VF spin = hn::Mul(hn::Mul(reach, inverse), hn::Sqrt(dot(of.u, of.u)));
            return hn::Add(hn::Sqrt(dot(of.v, of.v)), spin);
        };
        const VF creep = constant(0.002f * b.gravity * b.h);
        auto stays = hn::And(hn::Lt(size(began), creep), hn::Lt(size(t), creep));
        stays = hn::And(hn::And(stays, any_touch),
                        hn::And(hn::Eq(carried, zero), hn::Gt(shallow, hn::Neg(hn::Add(slop, slop)))));
        x = select(stays, x0, x);
        q = {hn::IfThenElse(stays, q0.x, q.x), hn::IfThenElse(stays, q0.y, q.y), hn::IfThenElse(stays, q0.z, q.z),
             hn::IfThenElse(stays, q0.w, q.w)};
        t = select(stays, Twist{{zero, zero, zero}, {zero, zero, zero}}, t);

        for (uint32_t k = 0; k < count; ++k) {
            ContactSlots::Slot& s = slots.slot[used[k]];
            const auto touches = hn::And(hn::Gt(touching[k], zero), hn::Lt(hn::Load(d, s.gap + at), empty));
            hn::Store(hn::IfThenElse(touches, rows[k].pressed, hn::Neg(one)), d, s.impulse + at);
        }
        store3(b.arrays, field_x, at, x);
        hn::Store(q.x, d, b.arrays.field[field_qx] + at);
        hn::Store(q.y, d, b.arrays.field[field_qy] + at);
        hn::Store(q.z, d, b.arrays.field[field_qz] + at);
        hn::Store(q.w, d, b.arrays.field[field_qw] + at);
        const auto dustless = [&](Vec3 v) LR_LAMBDA {
            return Vec3{without_dust(v.x), without_dust(v.y), without_dust(v.z)};
        };
        store3(b.arrays, field_vx, at, dustless(t.v));
        store3(b.arrays, field_wx, at, dustless(scale(inverse, t.u)));
    }
}

void resolve_contacts(const ContactBodies& b, ContactSlots& slots) {
    if (b.body->diagonal)
        resolve<false>(b, slots);
    else
        resolve<true>(b, slots);
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
