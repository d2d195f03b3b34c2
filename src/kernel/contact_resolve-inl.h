// What contacts do to bodies: Gauss-Seidel over the contacts of each body by itself, with its own mass and that of the fluid that it
// moves along, first for the way of the substep and then for the velocity at its end (docs/maintainers/contact.md).
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

// A contact in the body frame, in kernel units: an impulse p at the arm r is the twist impulse (p, r x p/(d s)). Directions: the
// normal and two tangents.
struct Row {
    Twist along[3];         // the impulse along a direction; with a twist, what the point has of it
    Twist response[3];      // of the body to it
    VF inverse;             // 1 over what the normal velocity gains by a unit along the normal; 0 for an empty slot
    VF to_first, to_second; // what the tangential ones gain by it
    VF hold[3];             // inverse of what the tangential ones gain by each other, upper triangle
    VF least;               // 1 over the most that a tangential one gains
    VF target;              // normal velocity (or way) that it must have at least
    VF surface[2];          // tangential velocity (or way) of the surface
    VF friction;
    VF pressed, dragged[2]; // impulses
};

HWY_INLINE VF greatest(Vec3 v) {
    return hn::Max(hn::Abs(v.x), hn::Max(hn::Abs(v.y), hn::Abs(v.z)));
}
HWY_INLINE Vec3 velocity_at(Twist t, Vec3 arm) {
    return add(t.v, cross(t.u, arm));
}
HWY_INLINE VF product(const Twist& a, const Twist& b) {
    return hn::Add(dot(a.v, b.v), dot(a.u, b.u));
}

// The twist that a couple alone gives.
template <bool kFull, class C> HWY_INLINE Twist turned_by(const C& c, Vec3 couple) {
    const Vec3 none{hn::Zero(DF()), hn::Zero(DF()), hn::Zero(DF())};
    if constexpr (!kFull) return {none, scaled_by(c.inverse_spin_mass, couple)};
    const float* const m = c.full_inverse;
    const auto row = [&](int x, int y, int z) LR_LAMBDA {
        return mul_add(constant(m[x]), couple.x, mul_add(constant(m[y]), couple.y, hn::Mul(constant(m[z]), couple.z)));
    };
    return {{row(3, 4, 5), row(8, 9, 10), row(12, 13, 14)}, {row(15, 16, 17), row(16, 18, 19), row(17, 19, 20)}};
}

// No unit couple gives more spin.
template <bool kFull, class C> HWY_INLINE float most_turned(const C& c) {
    const auto size = [](float x) { return x < 0.0f ? -x : x; };
    if constexpr (!kFull)
        return HWY_MAX(c.inverse_spin_mass[0], HWY_MAX(c.inverse_spin_mass[1], c.inverse_spin_mass[2]));
    const float* const m = c.full_inverse; // rows of its block of spins
    return HWY_MAX(m[15] + size(m[16]) + size(m[17]),
                   HWY_MAX(size(m[16]) + m[18] + size(m[19]), size(m[17]) + size(m[19]) + m[20]));
}

// Of a slot's normal impulse: what the contact must be held with at once, and the new one.
HWY_INLINE VF press(Row& r, VF normal, VF dust, VF relaxed = constant(1.3f)) {
    const VF wanted = hn::Mul(hn::Sub(r.target, normal), r.inverse);
    const auto change = [&](VF by) { return hn::Sub(hn::Max(hn::Add(r.pressed, by), hn::Zero(DF())), r.pressed); };
    // Each lane by itself: what is under the dust stays as it is, in every later sweep too, however relaxed that is.
    const auto counts = hn::Gt(hn::Abs(change(wanted)), hn::Mul(dust, r.inverse));
    const VF counted = hn::IfThenElseZero(counts, change(hn::Mul(relaxed, wanted)));
    r.pressed = hn::Add(r.pressed, counted);
    return counted;
}

// Friction against the slip (x, y). Within the cone the point is held; else the impulse goes straight against the slip.
HWY_INLINE void drag(Row& r, VF x, VF y, VF dust, VF& step_x, VF& step_y) {
    const DF d;
    const VF slip = hn::Add(hn::Abs(x), hn::Abs(y));
    const auto slides = hn::Gt(slip, dust);
    const VF most = hn::Mul(r.friction, r.pressed), most_squared = hn::Mul(most, most);
    VF to_x = hn::Sub(r.dragged[0], mul_add(r.hold[0], x, hn::Mul(r.hold[1], y)));
    VF to_y = hn::Sub(r.dragged[1], mul_add(r.hold[1], x, hn::Mul(r.hold[2], y)));
    to_x = hn::IfThenElse(slides, to_x, r.dragged[0]);
    to_y = hn::IfThenElse(slides, to_y, r.dragged[1]);
    // A little beyond is not worth a root, and would never end.
    const VF beyond = hn::Mul(constant(1.000001f), most_squared);
    const auto outside = hn::Gt(mul_add(to_x, to_x, hn::Mul(to_y, to_y)), beyond);
    if (!hn::AllFalse(d, outside)) {
        const VF less_x = hn::IfThenElseZero(slides, hn::Mul(r.least, x));
        const VF less_y = hn::IfThenElseZero(slides, hn::Mul(r.least, y));
        VF back_x = hn::Sub(r.dragged[0], less_x), back_y = hn::Sub(r.dragged[1], less_y);
        const VF size = hn::Sqrt(mul_add(back_x, back_x, hn::Mul(back_y, back_y)));
        const VF factor = hn::Min(hn::Mul(most, inverse_length(size)), constant(1.0f));
        back_x = hn::Mul(factor, back_x);
        back_y = hn::Mul(factor, back_y);
        to_x = hn::IfThenElse(outside, back_x, to_x);
        to_y = hn::IfThenElse(outside, back_y, to_y);
    }
    step_x = hn::Sub(to_x, r.dragged[0]);
    step_y = hn::Sub(to_y, r.dragged[1]);
    r.dragged[0] = to_x;
    r.dragged[1] = to_y;
}

// Sweeps over the contacts, to and fro, until none changes the twist by more than `dust`.
template <bool kFull, class C>
HWY_INLINE void project(const C& c, Row* rows, uint32_t count, VF rolling, VF spin_hold, VF dust, Twist& t) {
    const DF d;
    const VF zero = hn::Zero(d);
    const bool rolls = !hn::AllTrue(d, hn::Eq(rolling, zero));
    Vec3 rolled{zero, zero, zero}; // impulse couple against rolling and spinning
    for (uint32_t sweep = 0; sweep < contact_sweeps; ++sweep) {
        VF change = zero, load = zero;
        // Over-relaxed, but for the first: a body's only contact is done then, and exactly.
        const VF relaxed = constant(sweep == 0 ? 1.0f : 1.3f);
        for (uint32_t i = 0; i < count; ++i) {
            Row& r = rows[(sweep & 1) == 0 ? i : count - 1 - i];
            const VF more = press(r, product(r.along[0], t), dust, relaxed);
            const VF x = hn::Sub(mul_add(more, r.to_first, product(r.along[1], t)), r.surface[0]);
            const VF y = hn::Sub(mul_add(more, r.to_second, product(r.along[2], t)), r.surface[1]);
            VF step_x, step_y;
            drag(r, x, y, dust, step_x, step_y);
            t = add_scaled(add_scaled(add_scaled(t, more, r.response[0]), step_x, r.response[1]), step_y,
                           r.response[2]);
            load = hn::Add(load, r.pressed);
            change = hn::Max(hn::Max(change, hn::Abs(more)), hn::Max(hn::Abs(step_x), hn::Abs(step_y)));
        }
        if (rolls) {
            const Vec3 wanted = sub(rolled, scale(spin_hold, t.u));
            const auto turns = hn::Gt(greatest(t.u), dust);
            Vec3 couple = select(turns, wanted, rolled);
            const VF squared = dot(couple, couple), most = hn::Mul(rolling, load);
            const auto outside = hn::Gt(squared, hn::Mul(constant(1.000001f), hn::Mul(most, most)));
            const VF factor = hn::IfThenElse(outside, hn::Mul(most, inverse_length(hn::Sqrt(squared))), constant(1.0f));
            couple = scale(factor, couple);
            const Vec3 step = sub(couple, rolled);
            rolled = couple;
            t = add(t, turned_by<kFull>(c, step));
            change = hn::Max(change, greatest(step));
        }
        if (hn::AllTrue(d, hn::Eq(change, zero))) break;
    }
}

template <class M> HWY_INLINE Twist select(M mask, const Twist& yes, const Twist& no) {
    return {select(mask, yes.v, no.v), select(mask, yes.u, no.u)};
}

// Two unit vectors across a normal (Duff et al. 2017).
HWY_INLINE void tangents(Vec3 n, Vec3& first, Vec3& second) {
    const VF one = constant(1.0f), zero = hn::Zero(DF());
    const VF sign = hn::IfThenElse(hn::Lt(n.z, zero), hn::Neg(one), one);
    const VF a = hn::Div(hn::Neg(one), hn::Add(sign, n.z)), b = hn::Mul(hn::Mul(n.x, n.y), a);
    first = {mul_add(hn::Mul(sign, n.x), hn::Mul(n.x, a), one), hn::Mul(sign, b), hn::Neg(hn::Mul(sign, n.x))};
    second = {b, mul_add(hn::Mul(n.y, n.y), a, sign), hn::Neg(n.y)};
}

template <bool kFull, class C> HWY_INLINE void set_row(const C& c, Vec3 normal, Vec3 arm, Row& r) {
    const VF one = constant(1.0f);
    Vec3 direction[3] = {normal, {}, {}};
    tangents(normal, direction[1], direction[2]);
    for (int k = 0; k < 3; ++k) {
        r.along[k] = {direction[k], cross(arm, direction[k])};
        r.response[k] = acceleration<kFull>(c, r.along[k]);
    }
    r.inverse = inverse_length(product(r.along[0], r.response[0]));
    r.to_first = product(r.along[1], r.response[0]);
    r.to_second = product(r.along[2], r.response[0]);
    const VF a = product(r.along[1], r.response[1]), b = product(r.along[1], r.response[2]),
             e = product(r.along[2], r.response[2]);
    const VF over = hn::Div(one, neg_mul_add(b, b, hn::Mul(a, e))); // positive definite
    r.hold[0] = hn::Mul(e, over);
    r.hold[1] = hn::Neg(hn::Mul(b, over));
    r.hold[2] = hn::Mul(a, over);
    const VF half_gap = hn::Mul(constant(0.5f), hn::Sub(a, e));
    const VF spread = hn::Sqrt(mul_add(half_gap, half_gap, hn::Mul(b, b)));
    r.least = hn::Div(one, mul_add(constant(0.5f), hn::Add(a, e), spread));
}

HWY_INLINE void set_surface(Row& r, Vec3 velocity) {
    r.surface[0] = dot(r.along[1].v, velocity);
    r.surface[1] = dot(r.along[2].v, velocity);
}

template <bool kFull> static HWY_NOINLINE void resolve(const ContactBodies& b, ContactSlots& slots) {
    const DF d;
    const BodyConstants& c = *b.body;
    const VF zero = hn::Zero(d), one = constant(1.0f), half = constant(0.5f), h = constant(b.h);
    const VF empty = constant(0.5f * no_contact), inverse_h = constant(1.0f / b.h);
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

        Vec3 over[contact_slots]; // arms over d s
        VF gap[contact_slots], before[contact_slots], bounce[contact_slots], depth = zero;
        VF left[contact_slots]; // of the gap, of what is to be undone later
        for (uint32_t k = 0; k < count; ++k) {
            const ContactSlots::Slot& s = slots.slot[used[k]];
            const Vec3 normal = load3(s.normal, at), arm = load3(s.arm, at), surface = load3(s.surface, at);
            Row& r = rows[k];
            over[k] = scale(inverse, arm);
            set_row<kFull>(c, to_body(q, normal), over[k], r);
            r.pressed = r.dragged[0] = r.dragged[1] = zero;
            gap[k] = hn::Load(d, s.gap + at);
            const auto empty_slot = hn::Ge(gap[k], empty);
            depth = hn::Max(depth, hn::IfThenElse(empty_slot, zero, hn::Neg(gap[k])));
            r.inverse = hn::IfThenElse(empty_slot, zero, r.inverse);
            const Vec3 path = add(load3(s.lag, at), scale(h, surface));
            set_surface(r, to_body(q, path));
            r.friction = hn::IfThenElse(empty_slot, zero, hn::Load(d, s.friction + at));
            // Of the point that touches: where it was, and how fast it came when the gap closed, between its speeds at the ends.
            const Vec3 moved = sub(add(sub(x, x0), to_world(q, arm)), to_world(q0, arm));
            before[k] = hn::Add(gap[k], dot(normal, sub(path, moved)));
            // Deep overlap that it had already, as of a body that a collider was put on, is undone over a few substeps.
            const VF gained = hn::Sub(gap[k], hn::Min(before[k], zero));
            const VF push = hn::Max(gap[k], hn::Min(mul_add(constant(-0.5f), reach, gained), zero));
            r.target = hn::Sub(product(r.along[0], way), push);
            left[k] = hn::Sub(gap[k], push);
            const Twist end{load3(b.arrays, field_vx, at), scale(length, load3(b.arrays, field_wx, at))};
            const VF carried = dot(normal, surface);
            const VF first = hn::Sub(dot(normal, to_world(q0, velocity_at(began, over[k]))), carried);
            const VF last = hn::Sub(dot(normal, to_world(q, velocity_at(end, over[k]))), carried);
            const VF closed = hn::Sub(before[k], gap[k]);
            const auto closes = hn::And(hn::Gt(before[k], slop), hn::Gt(closed, zero));
            const VF part =
                hn::IfThenElseZero(closes, hn::Min(hn::Div(before[k], hn::Max(closed, constant(1e-30f))), one));
            bounce[k] = mul_add(part, hn::Sub(last, first), first);
        }
        const VF rolling = hn::Mul(constant(b.rolling), hn::Mul(reach, inverse));
        const VF spin_hold = constant(1.0f / most_turned<kFull>(c));
        Twist moved = way;
        project<kFull>(c, rows, count, rolling, spin_hold, hn::Mul(constant(1e-2f), slop), moved);
        Twist correction{sub(moved.v, way.v), sub(moved.u, way.u)};
        // A twist is a small rotation. The whole of it is made smaller: what no contact is against, no part of it is against.
        const VF large = hn::Mul(greatest(correction.u), inverse);
        const VF less = hn::Min(hn::Div(half, hn::Max(large, half)), one);
        correction = {scale(less, correction.v), scale(less, correction.u)};
        VF touching[contact_slots];
        for (uint32_t k = 0; k < count; ++k) {
            gap[k] = hn::Add(gap[k], product(rows[k].along[0], correction));
            const auto touches = hn::Or(hn::Gt(rows[k].pressed, zero), hn::Le(gap[k], slop));
            touching[k] = hn::IfThenElseZero(touches, one);
        }
        if (!hn::AllTrue(d, hn::Eq(less, one))) {
            // Of what is left where the turn was too large the deepest is undone along its normal, if that opens all others.
            VF deepest = zero;
            Vec3 up{zero, zero, zero};
            for (uint32_t k = 0; k < count; ++k) {
                const auto deeper = hn::Gt(hn::Sub(left[k], gap[k]), deepest);
                deepest = hn::IfThenElse(deeper, hn::Sub(left[k], gap[k]), deepest);
                up = select(deeper, load3(slots.slot[used[k]].normal, at), up);
            }
            auto opens = hn::And(hn::Lt(less, one), hn::Gt(deepest, zero));
            for (uint32_t k = 0; k < count; ++k)
                opens = hn::And(
                    opens, hn::Or(hn::Ge(gap[k], empty), hn::Ge(dot(up, load3(slots.slot[used[k]].normal, at)), zero)));
            correction.v = select(opens, add(correction.v, scale(deepest, to_body(q, up))), correction.v);
            for (uint32_t k = 0; k < count; ++k) {
                const VF risen = mul_add(deepest, dot(up, load3(slots.slot[used[k]].normal, at)), gap[k]);
                gap[k] = hn::IfThenElse(opens, risen, gap[k]);
            }
        }
        x = add(x, to_world(q, correction.v));
        q = normalised(turn(q, q, hn::Mul(half, inverse), correction.u));

        const Twist met{load3(b.arrays, field_vx, at), scale(length, load3(b.arrays, field_wx, at))};
        Twist t = met;
        const VF slow = constant(2.0f * b.gravity * b.h);
        VF shallow = zero,
           apart = zero; // the least gap that the substep began with; m/s, between the surfaces' velocities
        Vec3 carried{zero, zero, zero}; // velocity of the surface that it touches, if it is one
        auto any_touch = hn::Lt(reach, zero);
        // A body that rests falls half of g h^2 in a substep and gains g h: the impulses that undo the one are a good guess of those
        // that undo the other.
        const auto rests = hn::Lt(depth, mul_add(constant(2.0f), slop, constant(b.gravity * (b.h * b.h))));
        const VF guess = hn::IfThenElseZero(rests, constant(2.0f / b.h));
        for (uint32_t k = 0; k < count; ++k) {
            const auto there = hn::Lt(hn::Load(d, slots.slot[used[k]].gap + at), empty);
            const auto touches = hn::And(hn::Gt(touching[k], zero), there);
            const Vec3 surface = load3(slots.slot[used[k]].surface, at);
            carried = select(hn::AndNot(any_touch, touches), surface, carried);
            any_touch = hn::Or(any_touch, touches);
            apart = hn::Max(apart, hn::IfThenElseZero(touches, greatest(sub(surface, carried))));
        }
        for (uint32_t k = 0; k < count; ++k) {
            const ContactSlots::Slot& s = slots.slot[used[k]];
            const Vec3 surface = to_body(q, load3(s.surface, at));
            Row& r = rows[k];
            set_row<kFull>(c, to_body(q, load3(s.normal, at)), over[k], r);
            const auto touches = hn::And(hn::Gt(touching[k], zero), hn::Lt(hn::Load(d, s.gap + at), empty));
            const auto present = hn::Lt(hn::Load(d, s.gap + at), empty);
            r.inverse = hn::IfThenElseZero(hn::And(present, any_touch), r.inverse);
            const VF back_off = hn::IfThenElseZero(hn::Lt(bounce[k], hn::Neg(slow)),
                                                   hn::Neg(hn::Mul(hn::Load(d, s.restitution + at), bounce[k])));
            // Of a body that touches with another point, what does not yet may come as fast as it takes to touch in a substep: a
            // body does not rock from one side to the other with what it falls in each.
            const VF closing = hn::Neg(hn::Mul(hn::Max(gap[k], zero), inverse_h));
            r.target = hn::Add(dot(r.along[0].v, surface), hn::IfThenElse(touches, back_off, closing));
            set_surface(r, surface);
            const VF kept = hn::IfThenElseZero(touches, guess);
            r.pressed = hn::Mul(kept, r.pressed);
            for (VF& dragged : r.dragged) dragged = hn::Mul(kept, dragged);
            t = add_scaled(add_scaled(add_scaled(t, r.pressed, r.response[0]), r.dragged[0], r.response[1]),
                           r.dragged[1], r.response[2]);
            shallow = hn::Min(shallow, hn::IfThenElse(touches, before[k], zero));
        }
        project<kFull>(c, rows, count, rolling, spin_hold, hn::Mul(constant(1e-3f), slow), t);
        // Seen from what it touches. Restitution and friction of several contacts together could give energy (Kane 1984), and still
        // surfaces have none to give.
        const Vec3 base = to_body(q, carried);
        const Twist came{sub(met.v, base), met.u};
        Twist goes{sub(t.v, base), t.u};
        const auto energy = [&](const Twist& of) LR_LAMBDA {
            const Twist p = momentum<kFull>(c, of);
            return hn::Add(dot(p.v, of.v), dot(p.u, of.u));
        };
        const VF creep = constant(0.01f * b.gravity * b.h);
        const auto one_surface = hn::Le(apart, creep);
        const VF had = energy(came), has = energy(goes);
        const auto gained = hn::And(hn::Gt(has, had), one_surface);
        const VF factor = hn::IfThenElse(gained, hn::Sqrt(hn::Div(had, hn::Max(has, constant(1e-30f)))), one);
        goes = {scale(factor, goes.v), scale(factor, goes.u)};

        // What is left of the sweeps would make bodies at rest creep. One that neither moved before nor does now stays where it
        // was, to the bit: less than 1/100 of gravity, half a degree of slope, does not get it going.
        const auto size = [&](const Twist& of) LR_LAMBDA {
            const VF spin = hn::Mul(hn::Mul(reach, inverse), hn::Sqrt(dot(of.u, of.u)));
            return hn::Add(hn::Sqrt(dot(of.v, of.v)), spin);
        };
        const Twist first{sub(began.v, to_body(q0, carried)), began.u};
        auto stays = hn::And(hn::Lt(size(first), creep), hn::Lt(size(goes), creep));
        stays = hn::And(hn::And(stays, any_touch), hn::And(one_surface, hn::Gt(shallow, hn::Neg(hn::Add(slop, slop)))));
        x = select(stays, add(x0, scale(h, carried)), x);
        q = {hn::IfThenElse(stays, q0.x, q.x), hn::IfThenElse(stays, q0.y, q.y), hn::IfThenElse(stays, q0.z, q.z),
             hn::IfThenElse(stays, q0.w, q.w)};
        goes = select(stays, Twist{{zero, zero, zero}, {zero, zero, zero}}, goes);
        t = {add(select(stays, to_body(q, carried), base), goes.v), goes.u};

        auto any_contact = hn::Lt(reach, zero);
        for (uint32_t k = 0; k < count; ++k) {
            ContactSlots::Slot& s = slots.slot[used[k]];
            const auto present = hn::Lt(hn::Load(d, s.gap + at), empty);
            any_contact = hn::Or(any_contact, present);
            const auto touches = hn::And(hn::Gt(touching[k], zero), present);
            hn::Store(hn::IfThenElse(touches, rows[k].pressed, hn::Neg(one)), d, s.impulse + at);
        }
        // A body without contacts must not see that another in its vector has some: not even by rounding.
        const auto put = [&](VF value, size_t field) LR_LAMBDA {
            float* const to = b.arrays.field[field] + at;
            hn::Store(hn::IfThenElse(any_contact, value, hn::Load(d, to)), d, to);
        };
        const auto put3 = [&](Vec3 v, size_t field)
                              LR_LAMBDA { put(v.x, field), put(v.y, field + 1), put(v.z, field + 2); };
        const auto dustless = [&](Vec3 v) LR_LAMBDA {
            return Vec3{without_dust(v.x), without_dust(v.y), without_dust(v.z)};
        };
        put3(x, field_x);
        put3({q.x, q.y, q.z}, field_qx);
        put(q.w, field_qw);
        put3(dustless(t.v), field_vx);
        put3(dustless(scale(inverse, t.u)), field_wx);
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
