// Solver for contact with colliders: Gauss-Seidel over each body's contacts, first for positions, then for velocities. contact.md, section 4.
#if defined(LR_KERNEL_CONTACT_COLLIDER_SOLVER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_CONTACT_COLLIDER_SOLVER_INL_H_
#undef LR_KERNEL_CONTACT_COLLIDER_SOLVER_INL_H_
#else
#define LR_KERNEL_CONTACT_COLLIDER_SOLVER_INL_H_
#endif

#include "kernel/contact/collider_contact.h"
#include "kernel/integrator/equations_of_motion-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::LR_KERNEL_NAMESPACE {

// Sweeps, for all bodies and for resting ones: near the angle of friction convergence is slow, and with fewer these would creep.
constexpr uint32_t contact_sweeps = 16, resting_sweeps = 28;

// A contact in the body frame, in kernel units. An impulse p at the arm r is the twist impulse (p, r x p/(d s)). Directions: normal and two tangents.
struct Row {
    Twist along[3];         // unit impulse along each direction; times a twist: the point's velocity along it
    Twist response[3];      // the body's response to it
    VF inverse;             // 1 over the normal response to a unit normal impulse; 0 for an empty slot
    VF to_first, to_second; // tangential responses to a unit normal impulse
    VF hold[3];             // inverse of the 2x2 tangential response, upper triangle
    VF least;               // 1 over the larger tangential response
    VF target;              // least normal velocity, or displacement
    VF push;                // part of the target that undoes an older overlap with a sleeping body
    VF surface[2];          // of the surface along the tangents: velocity, or displacement
    VF friction;
    VF pressed, dragged[2]; // normal and friction impulses so far
};

HWY_INLINE Vec3 velocity_at(Twist t, Vec3 arm) {
    return t.v + cross(t.u, arm);
}
HWY_INLINE VF product(const Twist& a, const Twist& b) {
    return dot(a.v, b.v) + dot(a.u, b.u);
}

// The body's response to a couple.
template <bool kFull, class C> HWY_INLINE Twist turned_by(const C& c, Vec3 couple) {
    const Vec3 none = zero3();
    if constexpr (!kFull) return {none, scaled_by(c.inverse_spin_mass, couple)};
    const float* const m = c.full_inverse;
    const auto row = [&](int x, int y, int z) LR_LAMBDA {
        return constant(m[x]) * couple.x + (constant(m[y]) * couple.y + constant(m[z]) * couple.z);
    };
    return {{row(3, 4, 5), row(8, 9, 10), row(12, 13, 14)}, {row(15, 16, 17), row(16, 18, 19), row(17, 19, 20)}};
}

// Upper bound of the spin by a unit couple.
template <bool kFull, class C> HWY_INLINE float most_turned(const C& c) {
    const auto size = [](float x) { return x < 0.0f ? -x : x; };
    if constexpr (!kFull)
        return HWY_MAX(c.inverse_spin_mass[0], HWY_MAX(c.inverse_spin_mass[1], c.inverse_spin_mass[2]));
    const float* const m = c.full_inverse; // from here the block of spins
    return HWY_MAX(m[15] + size(m[16]) + size(m[17]),
                   HWY_MAX(size(m[16]) + m[18] + size(m[19]), size(m[17]) + size(m[19]) + m[20]));
}

// Times the impulse that undoes an overlap of one body alone: more does not push it out of a sleeping body, though it still keeps it from going deeper.
// Without this limit a body between sleeping ones that leave it no room is pushed out of one into the next, to and fro.
constexpr float most_push = 4.0f;

// Updates the normal impulse of a slot; returns its change. kPushes: some row may have a `push`.
template <bool kPushes = true> HWY_INLINE VF press(Row& r, VF normal, VF dust, VF relaxed = constant(1.3f)) {
    const VF wanted = (r.target - normal) * r.inverse;
    const auto change = [&](VF part) {
        VF to = r.pressed + part * wanted;
        if constexpr (kPushes) {
            const VF push = r.push * r.inverse;
            to = hn::Max(r.pressed + part * (wanted - push), hn::Min(to, constant(most_push) * push));
        }
        return hn::Max(to, hn::Zero(DF())) - r.pressed;
    };
    // Decided for each lane, and before relaxation: a change below the dust is then dropped in all later sweeps too.
    const auto counts = hn::Abs(change(constant(1.0f))) > dust * r.inverse;
    const VF counted = hn::IfThenElseZero(counts, change(relaxed));
    r.pressed += counted;
    return counted;
}

// Friction against the slip (x, y). Inside the cone the point sticks, else the impulse on the cone opposes the slip.
HWY_INLINE void drag(Row& r, VF x, VF y, VF dust, VF& step_x, VF& step_y) {
    const VF slip = hn::Abs(x) + hn::Abs(y);
    const auto slides = slip > dust;
    const VF most = r.friction * r.pressed, most_squared = most * most;
    VF to_x = r.dragged[0] - (r.hold[0] * x + r.hold[1] * y);
    VF to_y = r.dragged[1] - (r.hold[1] * x + r.hold[2] * y);
    to_x = hn::IfThenElse(slides, to_x, r.dragged[0]);
    to_y = hn::IfThenElse(slides, to_y, r.dragged[1]);
    // For a tiny excess the root is not worth its time, and sweeps would never end.
    const VF beyond = constant(1.000001f) * most_squared;
    const auto outside = to_x * to_x + to_y * to_y > beyond;
    if (!hn::AllFalse(DF(), outside)) {
        const VF less_x = hn::IfThenElseZero(slides, r.least * x);
        const VF less_y = hn::IfThenElseZero(slides, r.least * y);
        VF back_x = r.dragged[0] - less_x, back_y = r.dragged[1] - less_y;
        const VF size = hn::Sqrt(back_x * back_x + back_y * back_y);
        const VF factor = hn::Min(most * inverse_length(size), constant(1.0f));
        back_x = factor * back_x;
        back_y = factor * back_y;
        to_x = hn::IfThenElse(outside, back_x, to_x);
        to_y = hn::IfThenElse(outside, back_y, to_y);
    }
    step_x = to_x - r.dragged[0];
    step_y = to_y - r.dragged[1];
    r.dragged[0] = to_x;
    r.dragged[1] = to_y;
}

// Updates the couple against rolling and spinning, at most `most`; returns its change.
HWY_INLINE Vec3 hold_spin(Vec3& rolled, Vec3 spin, VF spin_hold, VF most, VF dust) {
    const Vec3 wanted = rolled - spin_hold * spin;
    Vec3 couple = select(greatest(spin) > dust, wanted, rolled);
    const VF squared = dot(couple, couple);
    const auto outside = squared > constant(1.000001f) * (most * most);
    const VF less = most * inverse_length(hn::Sqrt(squared));
    couple = hn::IfThenElse(outside, less, constant(1.0f)) * couple;
    const Vec3 step = couple - rolled;
    rolled = couple;
    return step;
}

// Bound of the speed of a point at the reach. reach: over d s.
HWY_INLINE VF speed_of(const Twist& t, VF reach) {
    return hn::Sqrt(dot(t.v, t.v)) + reach * hn::Sqrt(dot(t.u, t.u));
}

// Bodies that are swept beyond contact_sweeps: still ones that would now exceed `creep` against the floor. The residual of the sweeps would open
// their static lock.
struct Patience {
    hn::Mask<DF> still;
    Vec3 floor; // velocity, or displacement, of the surface
    VF lever, creep;
};

// Two unit vectors across a normal (Duff et al. 2017).
HWY_INLINE void tangents(Vec3 n, Vec3& first, Vec3& second) {
    const VF one = constant(1.0f), zero = hn::Zero(DF());
    const VF sign = hn::IfThenElse(n.z < zero, -one, one);
    const VF a = -one / (sign + n.z), b = n.x * n.y * a;
    first = {sign * n.x * (n.x * a) + one, sign * b, -(sign * n.x)};
    second = {b, n.y * n.y * a + sign, -n.y};
}

// Inverse of a contact's 2x2 tangential response: a and e on the diagonal, b off it.
HWY_INLINE void set_hold(VF a, VF b, VF e, VF (&hold)[3], VF& least) {
    const VF one = constant(1.0f), over = one / (a * e - b * b); // positive definite
    hold[0] = e * over;
    hold[1] = -(b * over);
    hold[2] = a * over;
    const VF half_gap = constant(0.5f) * (a - e);
    const VF spread = hn::Sqrt(half_gap * half_gap + b * b);
    least = one / (constant(0.5f) * (a + e) + spread);
}

template <bool kFull, class C> HWY_INLINE void set_row(const C& c, Vec3 normal, Vec3 arm, Row& r) {
    Vec3 direction[3] = {normal, {}, {}};
    tangents(normal, direction[1], direction[2]);
    for (int k = 0; k < 3; ++k) {
        r.along[k] = {direction[k], cross(arm, direction[k])};
        r.response[k] = acceleration<kFull>(c, r.along[k]);
    }
    r.inverse = inverse_length(product(r.along[0], r.response[0]));
    r.to_first = product(r.along[1], r.response[0]);
    r.to_second = product(r.along[2], r.response[0]);
    set_hold(product(r.along[1], r.response[1]), product(r.along[1], r.response[2]), product(r.along[2], r.response[2]),
             r.hold, r.least);
}

HWY_INLINE void set_surface(Row& r, Vec3 velocity) {
    r.surface[0] = dot(r.along[1].v, velocity);
    r.surface[1] = dot(r.along[2].v, velocity);
}

// Displacement in a substep as a twist in the body axes at its end; the rotation as a chord.
HWY_INLINE Twist way_of(Quaternion q0, Quaternion q, Vec3 moved, VF length) {
    const VF zero = hn::Zero(DF());
    const Quaternion back{-q0.x, -q0.y, -q0.z, q0.w};
    const Quaternion turned = turn({zero, zero, zero, zero}, back, constant(1.0f), {q.x, q.y, q.z});
    // turn() gives back * (q.xyz, 0); the part of q.w follows.
    const VF w = turned.w + back.w * q.w;
    const Vec3 angle{back.x * q.w + turned.x, back.y * q.w + turned.y, back.z * q.w + turned.z};
    const VF twice = hn::IfThenElse(w < zero, constant(-2.0f), constant(2.0f));
    return {to_body(q, moved), length * (twice * angle)};
}

// A twist stands for a small rotation, so a larger one is scaled down as a whole: contacts that do not oppose it do not oppose a part of it.
HWY_INLINE VF small_part(Vec3 u, VF inverse) {
    const VF half = constant(0.5f), large = greatest(u) * inverse;
    return hn::Min(half / hn::Max(large, half), constant(1.0f));
}

// Of an overlap at its beginning a substep undoes at most this share of the reach. Bodies that lie in each other, asleep or awake, must not be thrown
// apart.
constexpr float pair_push = 0.02f, collider_push = 0.5f;
// Of an overlap between awake bodies, beyond the slop, a substep undoes this share. With more, pairs of a heap that contradict each other would
// oscillate. Few lie deeper than `deep` slops beyond it: they get out sooner, and the heap still rests. A body alone among sleeping ones gets out at
// once, or it would fall asleep before.
constexpr float undone = 0.3f, deep = 3.0f, undone_deep = 0.6f, undone_alone = 1.0f;

// How far the path projection may let a contact's gap close, m; negative: how far it must open. gap, before: at the end of the substep and at its
// beginning. share: of older overlap between bodies.
HWY_INLINE VF push_out(VF gap, VF before, VF slop, VF reach, hn::Mask<DF> solid, float share = undone) {
    const VF zero = hn::Zero(DF());
    const VF overlap = hn::Min(before + slop, zero), most = constant(pair_push) * reach;
    const VF deep_stays = constant(1.0f - undone_deep) * overlap - constant((undone_deep - undone) * deep) * slop;
    const VF stays = hn::Min(hn::Max(constant(1.0f - share) * overlap, deep_stays), overlap + most);
    // Deep overlap with a collider, as when it was placed on a body, is undone over several substeps.
    const VF gained = gap - hn::Min(before, zero);
    const VF out = hn::Max(gap, hn::Min(constant(-collider_push) * reach + gained, zero));
    return hn::IfThenElse(solid, out, gap - stays);
}

// The part of push_out() that undoes older overlap, 0 for colliders.
HWY_INLINE VF pushed(VF gap, VF before, VF out, hn::Mask<DF> solid) {
    return hn::IfThenElseZero(hn::AndNot(solid, before < hn::Zero(DF())), gap - before - out);
}

HWY_INLINE hn::Mask<DF> solid_lanes(const ContactSlots::Slot& s, size_t at) {
    const DU lanes;
    return hn::RebindMask(DF(), hn::Ne(hn::LoadU(lanes, s.collider + at), hn::Set(lanes, sleeping_body)));
}

// A vector of bodies from `at` on, between the stages of the solver.
struct Solved {
    Row rows[contact_slots];
    uint32_t count, used[contact_slots]; // rows, and their slots
    // Of the sweeps.
    Patience patience;
    VF rolling, spin_hold, dust;
    Twist t;
    Vec3 rolled; // couple against rolling and spinning
    VF change;   // in this sweep
    bool done;

    size_t at;
    VF length, inverse, reach, rounding, slop, depth;
    Vec3 x, x0, floor; // floor: velocity of the first surface
    Quaternion q, q0;
    Twist began, way;
    Vec3 core[contact_slots]; // from the centre of mass to the core at a contact, over d s
    VF gap[contact_slots], before[contact_slots], bounce[contact_slots], touching[contact_slots];
    VF left[contact_slots]; // overlap that later substeps undo
    VF struck;              // share of the substep before the first contact that bounces
    VF shallow;             // least gap at the beginning
    VF apart;               // m/s, difference of the surfaces' velocities
    Vec3 carried;           // velocity of the first touching surface
    hn::Mask<DF> any_touch;
    Twist met;

    // The arm of a contact over d s; normal: in the body frame.
    HWY_INLINE Vec3 surface_at(uint32_t k, Vec3 normal) const { return core[k] - (inverse * rounding) * normal; }

    // Prepares the path projection. False if the bodies have no contact.
    template <bool kFull> HWY_NOINLINE bool begin(const ContactBodies& b, ContactSlots& slots, size_t from) {
        const BodyConstants& c = *b.body;
        const VF zero = hn::Zero(DF()), one = constant(1.0f), h = constant(b.h), empty = constant(0.5f * no_contact);
        at = from;
        count = 0;
        for (uint32_t k = 0; k < slots.used; ++k) {
            store1(slots.slot[k].impulse, at, -one);
            if (!hn::AllFalse(DF(), load1(slots.slot[k].gap, at) < empty)) used[count++] = k;
        }
        if (count == 0) return false;
        const VF body_scale = load1(b.arrays, field_scale, at);
        length = body_scale * constant(c.length), inverse = one / length;
        reach = body_scale * constant(b.shape.reach);
        rounding = body_scale * constant(b.shape.rounding);
        x = load3(b.arrays, field_x, at);
        q = load4(b.arrays, at);
        x0 = load3(b.before, at);
        q0 = load4(b.before + 3, at);
        began = {load3(b.before + 7, at), length * load3(b.before + 10, at)};
        slop = constant(1e-3f) * reach + constant(1e-6f) * greatest(x);
        t = way = way_of(q0, q, x - x0, length);

        depth = zero;
        struck = one;
        floor = zero3();
        auto above_any = reach < zero;
        for (uint32_t k = 0; k < count; ++k) {
            const ContactSlots::Slot& s = slots.slot[used[k]];
            const Vec3 normal = load3(s.normal, at), arm = load3(s.arm, at), surface = load3(s.surface, at);
            Row& r = rows[k];
            // A rounding does not turn with its body: the point of a ball that is nearest to the ground stays below the middle.
            const Vec3 axis = to_body(q, normal), axis0 = to_body(q0, normal), end = inverse * arm,
                       of_core = arm + rounding * axis;
            core[k] = inverse * of_core;
            set_row<kFull>(c, axis, end, r);
            r.pressed = r.dragged[0] = r.dragged[1] = zero;
            gap[k] = load1(s.gap, at);
            const auto empty_slot = gap[k] >= empty;
            depth = hn::Max(depth, hn::IfThenElse(empty_slot, zero, -gap[k]));
            floor = select(hn::Or(above_any, empty_slot), floor, surface);
            above_any = hn::Or(above_any, hn::Not(empty_slot));
            r.inverse = hn::IfThenElse(empty_slot, zero, r.inverse);
            const Vec3 path = load3(s.lag, at) + h * surface;
            set_surface(r, to_body(q, path));
            r.friction = hn::IfThenElse(empty_slot, zero, load1(s.friction, at));
            // Gap at the beginning, and the approach speed when it closed, interpolated between both ends.
            const Vec3 moved = x - x0 + to_world(q, of_core) - to_world(q0, of_core);
            before[k] = gap[k] + dot(normal, path - moved);
            const auto solid = solid_lanes(s, at);
            const VF push = push_out(gap[k], before[k], slop, reach, solid, undone_alone);
            r.target = product(r.along[0], way) - push;
            r.push = pushed(gap[k], before[k], push, solid);
            left[k] = gap[k] - push;
            const Twist after{load3(b.arrays, field_vx, at), length * load3(b.arrays, field_wx, at)};
            const VF carried = dot(normal, surface);
            const VF first = dot(normal, to_world(q0, velocity_at(began, surface_at(k, axis0)))) - carried;
            const VF last = dot(normal, to_world(q, velocity_at(after, end))) - carried;
            const VF closed = before[k] - gap[k];
            const auto closes = hn::And(before[k] > slop, closed > zero);
            // The swept test ends the path at the touch: there the mean velocity tells how far the gap would have closed. What gravity adds after the
            // touch does not bounce; without this a ball of restitution 0.95 bounced on a box for ever.
            const VF free = hn::Max(closed, -(constant(0.5f) * h * (first + last)));
            const VF part = hn::IfThenElseZero(closes, hn::Min(before[k] / hn::Max(free, constant(1e-30f)), one));
            const VF fell = hn::IfThenElseZero(closes, hn::Min(before[k] / hn::Max(closed, constant(1e-30f)), one));
            const VF late = hn::Max((fell - part) * (last - first), constant(-b.gravity * b.h));
            bounce[k] = fell * (last - first) + first - hn::Min(late, zero);
            const auto blow = hn::And(closes, bounce[k] < constant(-2.0f * b.gravity * b.h));
            struck = hn::IfThenElse(blow, hn::Min(struck, part), struck);
        }
        rolling = constant(b.rolling) * (reach * inverse);
        spin_hold = constant(1.0f / most_turned<kFull>(c));
        dust = constant(1e-2f) * slop;
        const VF lever = reach * inverse, creep = constant(0.01f * b.gravity * b.h);
        const auto still = speed_of({began.v - to_body(q0, floor), began.u}, lever) < constant(5.0f) * creep;
        patience = {still, h * to_body(q, floor), lever, h * creep};
        return true;
    }

    // Moves the bodies.
    HWY_NOINLINE void move(const ContactBodies& b, const ContactSlots& slots) {
        const VF zero = hn::Zero(DF()), one = constant(1.0f), half = constant(0.5f),
                 empty = constant(0.5f * no_contact);
        patience.floor = to_body(q, floor);
        patience.creep = constant(0.01f * b.gravity * b.h);
        Twist correction = t - way;
        const VF less = small_part(correction.u, inverse);
        correction = less * correction;
        for (uint32_t k = 0; k < count; ++k) {
            gap[k] += product(rows[k].along[0], correction);
            const auto touches = hn::Or(rows[k].pressed > zero, gap[k] <= slop);
            touching[k] = hn::IfThenElseZero(touches, one);
        }
        if (!hn::AllTrue(DF(), hn::Eq(less, one))) {
            // If the correction was scaled down, undoes the deepest remaining overlap along its normal, provided that this closes no other contact.
            VF deepest = zero;
            Vec3 up = zero3();
            for (uint32_t k = 0; k < count; ++k) {
                const auto deeper = left[k] - gap[k] > deepest;
                deepest = hn::IfThenElse(deeper, left[k] - gap[k], deepest);
                up = select(deeper, load3(slots.slot[used[k]].normal, at), up);
            }
            auto opens = hn::And(less<one, deepest> zero);
            for (uint32_t k = 0; k < count; ++k)
                opens = hn::And(opens, hn::Or(gap[k] >= empty, dot(up, load3(slots.slot[used[k]].normal, at)) >= zero));
            correction.v = select(opens, correction.v + deepest * to_body(q, up), correction.v);
            for (uint32_t k = 0; k < count; ++k) {
                const VF risen = deepest * dot(up, load3(slots.slot[used[k]].normal, at)) + gap[k];
                gap[k] = hn::IfThenElse(opens, risen, gap[k]);
            }
        }
        x += to_world(q, correction.v);
        const Vec3 v = load3(b.arrays, field_vx, at), seen = to_world(q, v);
        q = normalised(turn(q, q, half * inverse, correction.u));

        // In an impact the correction turns the body but not its velocity in the world, or a vertical blow would throw a tilted body sideways. Nor that of a
        // ball, whose contacts do not turn with it.
        const VF slow = constant(2.0f * b.gravity * b.h);
        auto hits = rounding > half * reach;
        for (uint32_t k = 0; k < count; ++k) hits = hn::Or(hits, hn::And(touching[k] > zero, bounce[k] < -slow));
        t = {select(hits, to_body(q, seen), v), length * load3(b.arrays, field_wx, at)};
        // The energy guard counts what the body had then: after the touch it falls no farther.
        const Vec3 was = to_world(q0, began.v);
        met = {select(hits, to_body(q, was + struck * (seen - was)), v), t.u};
        shallow = apart = zero;
        carried = zero3();
        any_touch = reach < zero;
        for (uint32_t k = 0; k < count; ++k) {
            const auto there = load1(slots.slot[used[k]].gap, at) < empty;
            const auto touches = hn::And(touching[k] > zero, there);
            const Vec3 surface = load3(slots.slot[used[k]].surface, at);
            carried = select(hn::AndNot(any_touch, touches), surface, carried);
            any_touch = hn::Or(any_touch, touches);
            apart = hn::Max(apart, hn::IfThenElseZero(touches, greatest(surface - carried)));
        }
    }

    // Prepares the velocity projection.
    template <bool kFull> HWY_NOINLINE void stop(const ContactBodies& b, const ContactSlots& slots) {
        const BodyConstants& c = *b.body;
        const VF zero = hn::Zero(DF()), empty = constant(0.5f * no_contact);
        const VF inverse_h = constant(1.0f / b.h), slow = constant(2.0f * b.gravity * b.h);
        // A resting body falls by g h^2/2 in a substep and gains g h. So the impulses of positions times 2/h are a good start.
        const auto rests = depth < constant(2.0f) * slop + constant(b.gravity * (b.h * b.h));
        const VF guess = hn::IfThenElseZero(rests, constant(2.0f / b.h));
        for (uint32_t k = 0; k < count; ++k) {
            const ContactSlots::Slot& s = slots.slot[used[k]];
            const Vec3 surface = to_body(q, load3(s.surface, at));
            Row& r = rows[k];
            const Vec3 normal = to_body(q, load3(s.normal, at));
            set_row<kFull>(c, normal, surface_at(k, normal), r);
            const auto touches = hn::And(touching[k] > zero, load1(s.gap, at) < empty);
            const auto present = load1(s.gap, at) < empty;
            r.inverse = hn::IfThenElseZero(hn::And(present, any_touch), r.inverse);
            const VF back_off = hn::IfThenElseZero(bounce[k] < -slow, -(load1(s.restitution, at) * bounce[k]));
            // While some point touches, an open contact may close within the substep but no faster, or the body would rock from side to side.
            const VF closing = -(hn::Max(gap[k], zero) * inverse_h);
            r.target = dot(r.along[0].v, surface) + hn::IfThenElse(touches, back_off, closing);
            r.push = zero;
            set_surface(r, surface);
            const VF kept = hn::IfThenElseZero(touches, guess);
            r.pressed = kept * r.pressed;
            for (VF& dragged : r.dragged) dragged = kept * dragged;
            t = t + r.pressed * r.response[0] + r.dragged[0] * r.response[1] + r.dragged[1] * r.response[2];
            shallow = hn::Min(shallow, hn::IfThenElse(touches, before[k], zero));
        }
        dust = constant(1e-3f) * slow;
    }

    // Stores the bodies' state and their impulses.
    template <bool kFull> HWY_NOINLINE void finish(const ContactBodies& b, ContactSlots& slots) {
        const BodyConstants& c = *b.body;
        const VF zero = hn::Zero(DF()), one = constant(1.0f), h = constant(b.h), empty = constant(0.5f * no_contact);
        // Energy guard in the frame of the surface, which does no work there: restitution with friction can add energy (Kane 1984).
        const Vec3 base = to_body(q, carried);
        const Twist came{met.v - base, met.u};
        Twist goes{t.v - base, t.u};
        const auto energy = [&](const Twist& of) LR_LAMBDA {
            const Twist p = momentum<kFull>(c, of);
            return dot(p.v, of.v) + dot(p.u, of.u);
        };
        const auto one_surface = apart <= patience.creep;
        const VF had = energy(came), has = energy(goes);
        const auto gained = hn::And(has > had, one_surface);
        const VF factor = hn::IfThenElse(gained, hn::Sqrt(had / hn::Max(has, constant(1e-30f))), one);
        goes = factor * goes;

        // Static lock: a body that was still and is still keeps its pose to the bit, since the sweeps' residual would make it creep. Less than 1/100
        // of gravity, half a degree of slope, does not move it.
        const Twist first{began.v - to_body(q0, carried), began.u};
        auto stays =
            hn::And(speed_of(first, patience.lever) < patience.creep, speed_of(goes, patience.lever) < patience.creep);
        stays = hn::And(hn::And(stays, any_touch), hn::And(one_surface, shallow > -(slop + slop)));
        // A contact must press the body: thin leaves under water rise with a few thousandths of gravity. And it must have begun within the slop: a
        // body that its fall has just brought to the ground would hang there.
        auto held = reach < zero;
        for (uint32_t k = 0; k < count; ++k) held = hn::Or(held, hn::And(rows[k].pressed > zero, before[k] <= slop));
        stays = hn::And(stays, held);
        x = select(stays, x0 + h * carried, x);
        q = select(stays, q0, q);
        goes = select(stays, Twist{zero3(), zero3()}, goes);
        t = {select(stays, to_body(q, carried), base) + goes.v, goes.u};

        auto any_contact = reach < zero;
        for (uint32_t k = 0; k < count; ++k) {
            ContactSlots::Slot& s = slots.slot[used[k]];
            const auto present = load1(s.gap, at) < empty;
            any_contact = hn::Or(any_contact, present);
            const auto touches = hn::And(touching[k] > zero, present);
            store1(s.impulse, at, hn::IfThenElse(touches, rows[k].pressed, -one));
        }
        // Bodies without contacts keep their bits, whatever the other lanes touch.
        const auto put = [&](VF value, size_t field) LR_LAMBDA {
            store1(b.arrays, field, at, hn::IfThenElse(any_contact, value, load1(b.arrays, field, at)));
        };
        const auto put3 = [&](Vec3 v, size_t field)
                              LR_LAMBDA { put(v.x, field), put(v.y, field + 1), put(v.z, field + 2); };
        put3(x, field_x);
        put3({q.x, q.y, q.z}, field_qx);
        put(q.w, field_qw);
        put3(without_dust(t.v), field_vx);
        put3(without_dust(inverse * t.u), field_wx);
    }
};

// Vectors that are swept together. A row's operations wait for each other, so the rows of two vectors, in turn, take little longer than those of one.
constexpr uint32_t swept_together = 2;

// Sweeps over the contacts in alternating directions until none changes its point's velocity by more than `dust`.
template <bool kFull, class C> static HWY_NOINLINE void project(const C& c, Solved* all, uint32_t vectors, bool rolls) {
    const VF zero = hn::Zero(DF());
    for (uint32_t v = 0; v < vectors; ++v) all[v].rolled = zero3(), all[v].done = false;
    for (uint32_t sweep = 0; sweep < resting_sweeps; ++sweep) {
        uint32_t most = 0;
        for (uint32_t v = 0; v < vectors; ++v) {
            Solved& s = all[v];
            if (sweep == contact_sweeps && !s.done) {
                const Patience& p = s.patience;
                const auto creeps = hn::And(p.still, speed_of({s.t.v - p.floor, s.t.u}, p.lever) > p.creep);
                s.done = hn::AllFalse(DF(), creeps);
                s.dust = hn::IfThenElse(creeps, s.dust, constant(1e30f)); // stops the others
            }
            s.change = zero;
            if (!s.done) most = HWY_MAX(most, s.count);
        }
        if (most == 0) break;
        // Over-relaxed after the first sweep, which solves a single contact exactly.
        const VF relaxed = constant(sweep == 0 ? 1.0f : 1.3f);
        for (uint32_t i = 0; i < most; ++i)
            for (uint32_t v = 0; v < vectors; ++v) {
                Solved& s = all[v];
                if (s.done || i >= s.count) continue;
                Row& r = s.rows[(sweep & 1) == 0 ? i : s.count - 1 - i];
                const VF more = press(r, product(r.along[0], s.t), s.dust, relaxed);
                if (hn::AllTrue(DF(), hn::Eq(hn::Max(r.pressed, hn::Abs(more)), zero)))
                    continue; // open, without friction
                const VF x = more * r.to_first + product(r.along[1], s.t) - r.surface[0];
                const VF y = more * r.to_second + product(r.along[2], s.t) - r.surface[1];
                VF step_x, step_y;
                drag(r, x, y, s.dust, step_x, step_y);
                s.t = s.t + more * r.response[0] + step_x * r.response[1] + step_y * r.response[2];
                s.change = hn::Max(hn::Max(s.change, hn::Abs(more)), hn::Max(hn::Abs(step_x), hn::Abs(step_y)));
            }
        for (uint32_t v = 0; v < vectors; ++v) {
            Solved& s = all[v];
            if (rolls && !s.done) {
                // The same order in each sweep, since rounding of the sum would move bodies that are done.
                VF load = zero;
                for (uint32_t i = 0; i < s.count; ++i) load += s.rows[i].pressed;
                const Vec3 step = hold_spin(s.rolled, s.t.u, s.spin_hold, s.rolling * load, s.dust);
                s.t += turned_by<kFull>(c, step);
                s.change = hn::Max(s.change, greatest(step));
            }
            s.done = s.done || hn::AllTrue(DF(), hn::Eq(s.change, zero));
        }
    }
}

template <bool kFull>
static HWY_NOINLINE void resolve(const ContactBodies& b, ContactSlots& slots, SolverMemory& memory) {
    static_assert(swept_together * sizeof(Solved) <= sizeof memory.bytes);
    auto* const all = new (memory.bytes) Solved[swept_together];
    for (size_t at = 0; at < b.count;) {
        uint32_t vectors = 0;
        for (; at < b.count && vectors < swept_together; at += hn::Lanes(DF()))
            vectors += all[vectors].begin<kFull>(b, slots, at) ? 1 : 0;
        project<kFull>(*b.body, all, vectors, b.rolling != 0.0f);
        for (uint32_t v = 0; v < vectors; ++v) {
            all[v].move(b, slots);
            all[v].stop<kFull>(b, slots);
        }
        project<kFull>(*b.body, all, vectors, b.rolling != 0.0f);
        for (uint32_t v = 0; v < vectors; ++v) all[v].finish<kFull>(b, slots);
    }
}

void resolve_contacts(const ContactBodies& b, ContactSlots& slots, SolverMemory& memory) {
    if (b.body->diagonal)
        resolve<false>(b, slots, memory);
    else
        resolve<true>(b, slots, memory);
}
} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
