// What bodies that touch each other do to each other: Gauss-Seidel over pairs, with the mass of both and that of the fluid that they
// move along. As kernel/contact_resolve-inl.h, which has the formulas, but for two bodies; docs/maintainers/contact.md.
#if defined(LR_KERNEL_CROWD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_CROWD_INL_H_
#undef LR_KERNEL_CROWD_INL_H_
#else
#define LR_KERNEL_CROWD_INL_H_
#endif

#include "kernel/crowd_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

void crowd_begin(const CrowdInput& in, uint32_t kind, uint32_t begin) {
    const DF d;
    GatheredBodies bodies(in, begin);
    auto& row = bodies.row;
    auto& twist = bodies.twist;
    const VF zero = hn::Zero(d), one = constant(1.0f);
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(d)) {
        const VF length = hn::Mul(hn::Load(d, row[at_scale] + at), constant(in.kinds[kind].body->length));
        const Quaternion q = load4(row + at_q, at), q0 = load4(row + at_q0, at);
        const Quaternion back{hn::Neg(q0.x), hn::Neg(q0.y), hn::Neg(q0.z), q0.w};
        const Quaternion turned = turn({zero, zero, zero, zero}, back, one, {q.x, q.y, q.z});
        // turn() gives back (q, 0); the part of q.w is added here.
        const VF w = hn::Add(turned.w, hn::Mul(back.w, q.w));
        Vec3 angle{mul_add(back.x, q.w, turned.x), mul_add(back.y, q.w, turned.y), mul_add(back.z, q.w, turned.z)};
        angle = scale(hn::IfThenElse(hn::Lt(w, zero), constant(-2.0f), constant(2.0f)), angle);
        const Vec3 moved = sub(load3(row + at_x, at), load3(row + at_x0, at));
        const Twist way{to_body(q, moved), scale(length, angle)};
        store6(row + at_way, at, way);
        store6(twist, at, way);
        for (size_t f = at_correction; f < fields_of_body; ++f) hn::Store(zero, d, row[f] + at);
        const Size size = size_of(in.kinds[kind], row, at);
        hn::Store(hn::Mul(constant(1e-4f), size.slop), d, row[at_dust] + at);
        for (size_t f = 6; f < twist_floats; ++f) hn::Store(zero, d, twist[f] + at);
    }
    bodies.put_back(in, begin);
}

// A pair's sides as its first projection sees them, and how its contacts have come about.
struct PairState {
    Side a, b;
    Size size_a, size_b;
    Quaternion began_a, began_b;
    Vec3 moved_a, moved_b;
    Twist way[2], met[2], before[2];
    decltype(hn::Gt(VF(), VF())) pair; // both are bodies
    VF slop, reach;                    // of the smaller
};
HWY_INLINE Twist twist_of(const LaneRow* row, size_t field, size_t at, VF length) {
    return {load3(row + field, at), scale(length, load3(row + field + 3, at))};
}
HWY_INLINE PairState state_of(const CrowdInput& in, const PairBlock& block, const Gathered& g, size_t at) {
    const DF d;
    const CrowdKind &kind_a = in.kinds[block.kind_a], &kind_b = in.kinds[block.kind_b];
    PairState s;
    s.size_a = size_of(kind_a, g.a, at), s.size_b = size_of(kind_b, g.b, at);
    const VF ratio = hn::Load(d, block.ratio + at);
    s.pair = hn::Gt(ratio, hn::Zero(d));
    s.slop = hn::Min(s.size_a.slop, hn::IfThenElse(s.pair, s.size_b.slop, s.size_a.slop));
    s.reach = hn::Min(s.size_a.reach, hn::IfThenElse(s.pair, s.size_b.reach, s.size_a.reach));
    s.a = {kind_a.body->full_inverse, matrix_of(load4(g.a + at_q, at)), constant(1.0f)};
    s.b = {kind_b.body->full_inverse, matrix_of(load4(g.b + at_q, at)), ratio};
    s.began_a = load4(g.a + at_q0, at), s.began_b = load4(g.b + at_q0, at);
    s.moved_a = sub(load3(g.a + at_x, at), load3(g.a + at_x0, at));
    s.moved_b = sub(load3(g.b + at_x, at), load3(g.b + at_x0, at));
    s.way[0] = load6(g.a + at_way, at), s.way[1] = load6(g.b + at_way, at);
    s.met[0] = twist_of(g.a, at_v, at, s.size_a.length), s.met[1] = twist_of(g.b, at_v, at, s.size_b.length);
    s.before[0] = twist_of(g.a, at_v0, at, s.size_a.length), s.before[1] = twist_of(g.b, at_v0, at, s.size_b.length);
    return s;
}

// The gap at the end of the substep and as it began, and how fast it came when it closed.
HWY_INLINE void set_gaps(const PairState& s, VF h, PairContacts& c, size_t at, Vec3 arm_a, Vec3 arm_b) {
    const DF d;
    const VF zero = hn::Zero(d);
    const Vec3 normal = load3(c.normal, at), surface = load3(c.surface, at);
    const Vec3 path = add(load3(c.lag, at), scale(h, surface));
    const Vec3 over_a = load3(c.arm_a, at), over_b = load3(c.arm_b, at);
    const VF given = hn::Load(d, c.gap + at);
    const auto empty = hn::Ge(given, constant(0.5f * no_contact));
    const Vec3 went_a = sub(add(s.moved_a, to_world(s.a.turn, arm_a)), to_world(s.began_a, arm_a));
    const Vec3 went_b = sub(add(s.moved_b, to_world(s.b.turn, arm_b)), to_world(s.began_b, arm_b));
    const VF closed = dot(normal, sub(select(s.pair, went_b, path), went_a));
    const VF gap = hn::IfThenElse(empty, given, hn::IfThenElse(s.pair, hn::Sub(given, closed), given));
    const VF before = hn::IfThenElse(empty, given, hn::IfThenElse(s.pair, given, hn::Add(given, closed)));
    hn::Store(gap, d, c.gap + at);
    hn::Store(before, d, c.before + at);
    const Vec3 first = select(s.pair, to_world(s.began_b, velocity_at(s.before[1], over_b)), surface);
    const Vec3 last = select(s.pair, velocity_of(s.b.turn, s.met[1], over_b), surface);
    const VF from = dot(normal, sub(to_world(s.began_a, velocity_at(s.before[0], over_a)), first));
    const VF to = dot(normal, sub(velocity_of(s.a.turn, s.met[0], over_a), last));
    const auto closes = hn::And(hn::Gt(before, s.slop), hn::Gt(closed, zero));
    const VF time = hn::Div(before, hn::Max(closed, constant(1e-30f)));
    const VF part = hn::IfThenElseZero(closes, hn::Min(time, constant(1.0f)));
    hn::Store(mul_add(part, hn::Sub(to, from), from), d, c.bounce + at);
}

// Of overlap that a substep began with no more than this part of the reach is undone in it: bodies that have come to lie in each other
// must not be thrown apart.
constexpr float pair_push = 0.02f, collider_push = 0.5f;
// Of overlap between bodies beyond the slop so much is undone in a substep: pairs of a heap that contradict each other would
// throw each other to and fro.
constexpr float undone = 0.3f;

HWY_INLINE void set_way(const PairState& s, VF h, PairContacts& c, size_t at) {
    const DF d;
    const VF zero = hn::Zero(d);
    const Vec3 arm_a = load3(c.arm_a, at), arm_b = load3(c.arm_b, at);
    store3(c.arm_a, at, scale(s.size_a.inverse, arm_a));
    store3(c.arm_b, at, scale(s.size_b.inverse, arm_b));
    set_gaps(s, h, c, at, arm_a, arm_b);
    set_gains(s.a, s.b, c, at);
    const Vec3 normal = load3(c.normal, at), tangent = load3(c.tangent, at);
    const auto solid = hn::Gt(hn::Load(d, c.solid + at), zero);
    const VF gap = hn::Load(d, c.gap + at);
    const VF before = hn::Load(d, c.before + at), overlap = hn::Min(hn::Add(before, s.slop), zero);
    const VF most = hn::Mul(constant(pair_push), s.reach);
    const VF stays = hn::Min(hn::Mul(constant(1.0f - undone), overlap), hn::Add(overlap, most));
    // Against what is solid as for a body alone.
    const VF gained = hn::Sub(gap, hn::Min(before, zero));
    const VF out = hn::Max(gap, hn::Min(mul_add(constant(-collider_push), s.reach, gained), zero));
    const VF push = hn::IfThenElse(solid, out, hn::Sub(gap, stays));
    const Vec3 relative =
        sub(velocity_of(s.a.turn, s.way[0], load3(c.arm_a, at)), velocity_of(s.b.turn, s.way[1], load3(c.arm_b, at)));
    hn::Store(hn::Sub(dot(normal, relative), push), d, c.target + at);
    const Vec3 path = add(load3(c.lag, at), scale(h, load3(c.surface, at)));
    hn::Store(dot(tangent, path), d, c.drift[0] + at);
    hn::Store(dot(cross(normal, tangent), path), d, c.drift[1] + at);
    for (float* to : {c.pressed, c.dragged[0], c.dragged[1]}) hn::Store(zero, d, to + at);
    store3(c.search, at, {zero, zero, zero});
}

void crowd_way(const CrowdInput& in, PairBlock& block) {
    const DF d;
    const Gathered g(in, block);
    alignas(64) LaneRow depth;
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(d)) {
        const PairState s = state_of(in, block, g, at);
        hn::Store(hn::Mul(constant(1e-3f), s.slop), d, block.dust + at);
        store_matrix(block.turn_a, at, s.a.turn);
        store_matrix(block.turn_b, at, s.b.turn);
        VF deepest = hn::Zero(d);
        for (uint32_t k = 0; k < block.used; ++k) {
            PairContacts& c = block.contact[k];
            set_way(s, constant(in.h), c, at);
            deepest = hn::Max(deepest, hn::Neg(hn::Load(d, c.gap + at)));
        }
        hn::Store(deepest, d, depth + at);
    }
    for (size_t lane = 0; lane < block.lanes; ++lane)
        for (uint32_t body : {block.a[lane], block.b[lane]}) {
            if (body == block.b[lane] && block.ratio[lane] == 0.0f) continue;
            in.bodies[body].depth = HWY_MAX(in.bodies[body].depth, depth[lane]);
        }
}

// Squares of impulses over a mass, m^2/s^2 and m^2: beyond it, or without being a number, nothing is handed on. A pair that came to that
// does not meet again in the substep.
constexpr float most_change = 1e30f;

HWY_INLINE void let_go(PairBlock& block, size_t at, hn::Mask<DF> fine) {
    const DF d;
    for (uint32_t k = 0; k < block.used; ++k) {
        PairContacts& c = block.contact[k];
        for (float* row : {c.inverse, c.pressed, c.dragged[0], c.dragged[1], c.change[0], c.change[1], c.change[2],
                           c.search[0], c.search[1], c.search[2]})
            hn::Store(hn::IfThenElseZero(fine, hn::Load(d, row + at)), d, row + at);
    }
}

bool crowd_sweep(const CrowdInput& in, PairBlock& block) {
    const DF d;
    const VF zero = hn::Zero(d);
    GatheredTwists twists(in, block);
    const float* const mass_a = in.kinds[block.kind_a].body->full_inverse;
    const float* const mass_b = in.kinds[block.kind_b].body->full_inverse;
    bool changed = false;
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(d)) {
        const Side a{mass_a, load_matrix(block.turn_a, at), constant(1.0f)};
        const Side b{mass_b, load_matrix(block.turn_b, at), hn::Load(d, block.ratio + at)};
        const VF dust = hn::Load(d, block.dust + at);
        Twist ta = load6(twists.a, at), tb = load6(twists.b, at);
        VF change = zero, load = zero, squares = zero;
        for (uint32_t k = 0; k < block.used; ++k) {
            PairContacts& c = block.contact[k];
            const Vec3 arm_a = load3(c.arm_a, at), arm_b = load3(c.arm_b, at);
            const Vec3 normal = load3(c.normal, at), first = load3(c.tangent, at), second = cross(normal, first);
            const Vec3 relative = sub(velocity_of(a.turn, ta, arm_a), velocity_of(b.turn, tb, arm_b));
            Row r;
            r.inverse = hn::Load(d, c.inverse + at);
            r.target = hn::Load(d, c.target + at);
            r.pressed = hn::Load(d, c.pressed + at);
            for (int i = 0; i < 2; ++i) r.dragged[i] = hn::Load(d, c.dragged[i] + at);
            for (int i = 0; i < 3; ++i) r.hold[i] = hn::Load(d, c.hold[i] + at);
            r.least = hn::Load(d, c.least + at);
            r.friction = hn::Load(d, c.friction + at);
            const VF more = press(r, dot(normal, relative), dust);
            const auto slip = [&](Vec3 along, const float* gained, const float* drift) LR_LAMBDA {
                const VF now = mul_add(more, hn::Load(d, gained + at), dot(along, relative));
                return hn::Sub(now, hn::Load(d, drift + at));
            };
            VF step_x, step_y;
            drag(r, slip(first, c.to_first, c.drift[0]), slip(second, c.to_second, c.drift[1]), dust, step_x, step_y);
            const Vec3 impulse = add_scaled(add_scaled(scale(more, normal), step_x, first), step_y, second);
            ta = add(ta, answer(a, impulse_at(a.turn, impulse, arm_a)));
            const Twist back = answer(b, impulse_at(b.turn, impulse, arm_b));
            tb = {sub(tb.v, back.v), sub(tb.u, back.u)};
            hn::Store(r.pressed, d, c.pressed + at);
            for (int i = 0; i < 2; ++i) hn::Store(r.dragged[i], d, c.dragged[i] + at);
            store3(c.change, at, {more, step_x, step_y});
            squares = hn::Add(squares, dot(Vec3{more, step_x, step_y}, Vec3{more, step_x, step_y}));
            load = hn::Add(load, hn::IfThenElse(hn::Gt(hn::Load(d, c.solid + at), zero), more, zero));
            change = hn::Max(hn::Max(change, hn::Abs(more)), hn::Max(hn::Abs(step_x), hn::Abs(step_y)));
        }
        const auto fine = hn::Le(squares, constant(most_change));
        if (HWY_UNLIKELY(!hn::AllTrue(d, fine))) {
            let_go(block, at, fine);
            ta = {select(fine, ta.v, load6(twists.a, at).v), select(fine, ta.u, load6(twists.a, at).u)};
            tb = {select(fine, tb.v, load6(twists.b, at).v), select(fine, tb.u, load6(twists.b, at).u)};
            squares = hn::IfThenElseZero(fine, squares);
            load = hn::IfThenElseZero(fine, load);
            change = hn::IfThenElseZero(fine, change);
        }
        store6(twists.a, at, ta);
        store6(twists.b, at, tb);
        hn::Store(squares, d, block.changed + at);
        hn::Store(hn::Add(hn::Load(d, twists.a[6] + at), load), d, twists.a[6] + at);
        changed = changed || !hn::AllTrue(d, hn::Eq(change, zero));
    }
    if (changed) twists.put_back(in, block);
    return changed;
}

// part 0: it only remembers the direction.
void crowd_follow(const CrowdInput& in, PairBlock& block, float part) {
    const DF d;
    if (part == 0.0f) {
        for (uint32_t k = 0; k < block.used; ++k)
            for (size_t at = 0; at < contact_lanes; at += hn::Lanes(d))
                store3(block.contact[k].search, at, load3(block.contact[k].change, at));
        return;
    }
    GatheredTwists twists(in, block);
    const float* const mass_a = in.kinds[block.kind_a].body->full_inverse;
    const float* const mass_b = in.kinds[block.kind_b].body->full_inverse;
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(d)) {
        const Side a{mass_a, load_matrix(block.turn_a, at), constant(1.0f)};
        const Side b{mass_b, load_matrix(block.turn_b, at), hn::Load(d, block.ratio + at)};
        Twist ta = load6(twists.a, at), tb = load6(twists.b, at);
        VF load = hn::Zero(d);
        for (uint32_t k = 0; k < block.used; ++k) {
            PairContacts& c = block.contact[k];
            const Vec3 more = scale(constant(part), load3(c.search, at));
            store3(c.search, at, add(more, load3(c.change, at)));
            const Vec3 normal = load3(c.normal, at), first = load3(c.tangent, at), second = cross(normal, first);
            const Vec3 impulse = add_scaled(add_scaled(scale(more.x, normal), more.y, first), more.z, second);
            ta = add(ta, answer(a, impulse_at(a.turn, impulse, load3(c.arm_a, at))));
            const Twist back = answer(b, impulse_at(b.turn, impulse, load3(c.arm_b, at)));
            tb = {sub(tb.v, back.v), sub(tb.u, back.u)};
            const auto put = [&](float* to, VF by)
                                 LR_LAMBDA { hn::Store(hn::Add(hn::Load(d, to + at), by), d, to + at); };
            put(c.pressed, more.x);
            put(c.dragged[0], more.y);
            put(c.dragged[1], more.z);
            load = hn::Add(load, hn::IfThenElseZero(hn::Gt(hn::Load(d, c.solid + at), hn::Zero(d)), more.x));
        }
        store6(twists.a, at, ta);
        store6(twists.b, at, tb);
        hn::Store(hn::Add(hn::Load(d, twists.a[6] + at), load), d, twists.a[6] + at);
    }
    twists.put_back(in, block);
}

// The couple against rolling and spinning, from the loads on colliders.
bool crowd_roll(const CrowdInput& in, uint32_t kind, uint32_t begin) {
    const DF d;
    const CrowdKind& k = in.kinds[kind];
    if (k.rolling == 0.0f) return false;
    bool loaded = false;
    for (size_t lane = 0; lane < contact_lanes; ++lane) loaded = loaded || in.twists[begin + lane].load > 0.0f;
    if (!loaded) return false;
    GatheredBodies bodies(in, begin);
    auto& row = bodies.row;
    auto& twist = bodies.twist;
    const VF zero = hn::Zero(d), spin_hold = constant(1.0f / most_turned<true>(*k.body));
    bool changed = false;
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(d)) {
        const VF load = hn::Max(hn::Load(d, twist[6] + at), zero);
        const Size size = size_of(k, row, at);
        const VF most = hn::Mul(hn::Mul(constant(k.rolling), hn::Mul(size.reach, size.inverse)), load);
        Twist t = load6(twist, at);
        const Vec3 rolled = load3(row + at_rolled, at);
        const auto turns = hn::Gt(greatest(t.u), hn::Load(d, row[at_dust] + at));
        Vec3 couple = select(turns, sub(rolled, scale(spin_hold, t.u)), rolled);
        const VF squared = dot(couple, couple);
        const auto outside = hn::Gt(squared, hn::Mul(constant(1.000001f), hn::Mul(most, most)));
        const VF less = hn::Mul(most, inverse_length(hn::Sqrt(squared)));
        couple = scale(hn::IfThenElse(outside, less, constant(1.0f)), couple);
        const Vec3 step = sub(couple, rolled);
        store3(row + at_rolled, at, couple);
        store6(twist, at, add(t, turned_by<true>(*k.body, step)));
        changed = changed || !hn::AllTrue(d, hn::Eq(greatest(step), zero));
    }
    if (!changed) return false;
    bodies.put_back(in, begin);
    return true;
}

void crowd_move(const CrowdInput& in, uint32_t kind, uint32_t begin) {
    const DF d;
    GatheredBodies bodies(in, begin);
    auto& row = bodies.row;
    auto& twist = bodies.twist;
    const VF zero = hn::Zero(d), half = constant(0.5f), one = constant(1.0f);
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(d)) {
        const Size size = size_of(in.kinds[kind], row, at);
        const Twist moved = load6(twist, at), way = load6(row + at_way, at);
        Twist correction{sub(moved.v, way.v), sub(moved.u, way.u)};
        // As for a body alone: the whole of it is made smaller.
        const VF large = hn::Mul(greatest(correction.u), size.inverse);
        const VF less = hn::Min(hn::Div(half, hn::Max(large, half)), one);
        correction = {scale(less, correction.v), scale(less, correction.u)};
        store6(row + at_correction, at, correction);
        Quaternion q = load4(row + at_q, at);
        store3(row + at_x, at, add(load3(row + at_x, at), to_world(q, correction.v)));
        const Twist met = twist_of(row, at_v, at, size.length);
        const Twist seen{to_world(q, met.v), to_world(q, met.u)};
        q = normalised(turn(q, q, hn::Mul(half, size.inverse), correction.u));
        store3(row + at_q, at, {q.x, q.y, q.z});
        hn::Store(q.w, d, row[at_q + 3] + at);
        // What the correction turns keeps its velocity in the world, and with it its momentum.
        const Twist goes{to_body(q, seen.v), to_body(q, seen.u)};
        store6(twist, at, goes);
        store6(row + at_way, at, goes);
        store3(row + at_rolled, at, {zero, zero, zero});
        hn::Store(constant(2e-5f * in.gravity * in.h), d, row[at_dust] + at);
        hn::Store(zero, d, twist[6] + at);
    }
    bodies.put_back(in, begin);
}

void crowd_touch(const CrowdInput& in, PairBlock& block) {
    const DF d;
    const Gathered g(in, block);
    const VF zero = hn::Zero(d), one = constant(1.0f), empty = constant(0.5f * no_contact);
    alignas(64) LaneRow carried, shallow, touching;
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(d)) {
        const Size size_a = size_of(in.kinds[block.kind_a], g.a, at), size_b = size_of(in.kinds[block.kind_b], g.b, at);
        const auto pair = hn::Gt(hn::Load(d, block.ratio + at), zero);
        const VF slop = hn::Min(size_a.slop, hn::IfThenElse(pair, size_b.slop, size_a.slop));
        const Matrix turn_a = load_matrix(block.turn_a, at), turn_b = load_matrix(block.turn_b, at);
        const Twist moved_a = load6(g.a + at_correction, at), moved_b = load6(g.b + at_correction, at);
        VF fast = zero, least = zero, any = zero;
        for (uint32_t k = 0; k < block.used; ++k) {
            PairContacts& c = block.contact[k];
            const VF given = hn::Load(d, c.gap + at);
            const auto there = hn::Lt(given, empty);
            const Vec3 relative =
                sub(velocity_of(turn_a, moved_a, load3(c.arm_a, at)), velocity_of(turn_b, moved_b, load3(c.arm_b, at)));
            const VF gap = hn::IfThenElse(there, hn::Add(given, dot(load3(c.normal, at), relative)), given);
            const auto pressed = hn::Gt(hn::Load(d, c.pressed + at), zero);
            const auto touches = hn::And(there, hn::Or(pressed, hn::Le(gap, slop)));
            hn::Store(gap, d, c.gap + at);
            hn::Store(hn::IfThenElseZero(touches, one), d, c.touching + at);
            any = hn::IfThenElse(touches, one, any);
            fast = hn::Max(fast, hn::IfThenElseZero(touches, greatest(load3(c.surface, at))));
            const auto counts = hn::And(touches, hn::Gt(hn::Load(d, c.solid + at), zero));
            least = hn::Min(least, hn::IfThenElseZero(counts, hn::Load(d, c.before + at)));
        }
        hn::Store(fast, d, carried + at);
        hn::Store(least, d, shallow + at);
        hn::Store(any, d, touching + at);
    }
    for (size_t lane = 0; lane < block.lanes; ++lane) {
        CrowdBody& a = in.bodies[block.a[lane]];
        a.carried = HWY_MAX(a.carried, carried[lane]);
        a.shallow = HWY_MIN(a.shallow, shallow[lane]);
        a.touches = HWY_MAX(a.touches, touching[lane]);
        if (block.ratio[lane] == 0.0f) continue;
        CrowdBody& b = in.bodies[block.b[lane]];
        b.touches = HWY_MAX(b.touches, touching[lane]);
    }
}

// Both points of a contact in the middle between them: impulses that act at two turn the pair. Not farther than where they still
// say how the surfaces go: a way that turns by much may end with them far from each other.
constexpr float most_joined = 0.2f; // of the smaller reach

HWY_INLINE void join_arms(const Side& a, const Side& b, const Size& size_a, const Size& size_b, Vec3 apart,
                          PairContacts& c, size_t at) {
    const Vec3 on_a = to_world(a.turn, scale(size_a.length, load3(c.arm_a, at)));
    const Vec3 on_b = to_world(b.turn, scale(size_b.length, load3(c.arm_b, at)));
    Vec3 half = scale(constant(0.5f), add(apart, sub(on_a, on_b)));
    const VF most = hn::Mul(constant(most_joined), hn::Min(size_a.reach, size_b.reach));
    half = scale(hn::Min(hn::Div(most, hn::Max(hn::Sqrt(dot(half, half)), constant(1e-30f))), constant(1.0f)), half);
    store3(c.arm_a, at, scale(size_a.inverse, to_body(a.turn, sub(on_a, half))));
    store3(c.arm_b, at, scale(size_b.inverse, to_body(b.turn, add(on_b, half))));
}

void crowd_velocity(const CrowdInput& in, PairBlock& block) {
    const DF d;
    const bool pairs = block.ratio[0] != 0.0f; // of all lanes or of none
    bool bouncing = false;
    const Gathered g(in, block);
    GatheredTwists twists(in, block);
    const CrowdKind &kind_a = in.kinds[block.kind_a], &kind_b = in.kinds[block.kind_b];
    // Of the shortest steps it would not be finite.
    const float frequency = 1.0f / HWY_MAX(in.h, 1e-30f);
    const VF zero = hn::Zero(d), slow = constant(2.0f * in.gravity * in.h), inverse_h = constant(frequency);
    const VF fall = constant(in.gravity * (in.h * in.h));
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(d)) {
        const Size size_a = size_of(kind_a, g.a, at), size_b = size_of(kind_b, g.b, at);
        const VF ratio = hn::Load(d, block.ratio + at);
        const Side a{kind_a.body->full_inverse, matrix_of(load4(g.a + at_q, at)), constant(1.0f)};
        const Side b{kind_b.body->full_inverse, matrix_of(load4(g.b + at_q, at)), ratio};
        store_matrix(block.turn_a, at, a.turn);
        store_matrix(block.turn_b, at, b.turn);
        hn::Store(hn::Mul(constant(1e-4f), slow), d, block.dust + at);
        const auto load = [&](const LaneRow* row, size_t field) LR_LAMBDA { return hn::Load(d, row[field] + at); };
        const auto rests_a = hn::Lt(load(g.a, at_depth), mul_add(constant(2.0f), size_a.slop, fall));
        const auto rests_b = hn::Lt(load(g.b, at_depth), mul_add(constant(2.0f), size_b.slop, fall));
        const VF guess = hn::IfThenElseZero(hn::And(rests_a, rests_b), constant(2.0f * frequency));
        const Vec3 apart = sub(load3(g.a + at_x, at), load3(g.b + at_x, at));
        const auto any = hn::Gt(hn::Max(load(g.a, at_touches), load(g.b, at_touches)), zero);
        Twist ta = load6(twists.a, at), tb = load6(twists.b, at);
        VF more = zero;
        const Twist met_a = load6(g.a + at_way, at), met_b = load6(g.b + at_way, at);
        for (uint32_t k = 0; k < block.used; ++k) {
            PairContacts& c = block.contact[k];
            if (pairs) join_arms(a, b, size_a, size_b, apart, c, at);
            set_gains(a, b, c, at);
            hn::Store(hn::IfThenElseZero(any, hn::Load(d, c.inverse + at)), d, c.inverse + at);
            const Vec3 normal = load3(c.normal, at), first = load3(c.tangent, at), second = cross(normal, first);
            const Vec3 surface = load3(c.surface, at);
            store3(c.search, at, {zero, zero, zero});
            const auto touches = hn::Gt(hn::Load(d, c.touching + at), zero);
            const VF bounce = hn::Load(d, c.bounce + at);
            const VF back = hn::Neg(hn::Mul(hn::Load(d, c.restitution + at), bounce));
            const VF away = hn::IfThenElseZero(hn::Lt(bounce, hn::Neg(slow)), back);
            // Of bodies that touch somewhere, what does not yet may come as fast as it takes to touch in a substep.
            const VF closing = hn::Neg(hn::Mul(hn::Max(hn::Load(d, c.gap + at), zero), inverse_h));
            const VF target = hn::Add(dot(normal, surface), hn::IfThenElse(touches, away, closing));
            hn::Store(target, d, c.target + at);
            hn::Store(dot(first, surface), d, c.drift[0] + at);
            hn::Store(dot(second, surface), d, c.drift[1] + at);
            const VF bounces = hn::IfThenElseZero(touches, away);
            hn::Store(bounces, d, c.bounce + at);
            bouncing = bouncing || !hn::AllTrue(d, hn::Eq(bounces, zero));
            const Vec3 met =
                sub(sub(velocity_of(a.turn, met_a, load3(c.arm_a, at)), velocity_of(b.turn, met_b, load3(c.arm_b, at))),
                    surface);
            store3(c.came, at, {dot(normal, met), dot(first, met), dot(second, met)});
            const VF kept = hn::IfThenElseZero(touches, guess);
            VF impulses[3];
            float* const kept_at[3] = {c.pressed, c.dragged[0], c.dragged[1]};
            for (int i = 0; i < 3; ++i) {
                impulses[i] = hn::Mul(kept, hn::Load(d, kept_at[i] + at));
                hn::Store(impulses[i], d, kept_at[i] + at);
            }
            const Vec3 impulse =
                add_scaled(add_scaled(scale(impulses[0], normal), impulses[1], first), impulses[2], second);
            ta = add(ta, answer(a, impulse_at(a.turn, impulse, load3(c.arm_a, at))));
            const Twist other = answer(b, impulse_at(b.turn, impulse, load3(c.arm_b, at)));
            tb = {sub(tb.v, other.v), sub(tb.u, other.u)};
            more = hn::Add(more, hn::IfThenElseZero(hn::Gt(hn::Load(d, c.solid + at), zero), impulses[0]));
        }
        store6(twists.a, at, ta);
        store6(twists.b, at, tb);
        hn::Store(hn::Add(hn::Load(d, twists.a[6] + at), more), d, twists.a[6] + at);
    }
    twists.put_back(in, block);
    block.bounces = bouncing ? 1 : 0;
}

// The work of a contact's impulse is half of it times the sum of the velocities before and after.
bool crowd_restrain(const CrowdInput& in, PairBlock& block) {
    if (block.bounces == 0) return false;
    const DF d;
    GatheredTwists twists(in, block);
    const VF zero = hn::Zero(d), most_gain = constant(1.01f);
    bool restrained = false;
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(d)) {
        const Matrix turn_a = load_matrix(block.turn_a, at), turn_b = load_matrix(block.turn_b, at);
        const Twist ta = load6(twists.a, at), tb = load6(twists.b, at);
        for (uint32_t k = 0; k < block.used; ++k) {
            PairContacts& c = block.contact[k];
            const auto load = [&](const float* row) LR_LAMBDA { return hn::Load(d, row + at); };
            const VF pressed = load(c.pressed), bounces = load(c.bounce);
            const auto counts = hn::And(hn::Gt(bounces, zero), hn::Gt(pressed, zero));
            if (hn::AllFalse(d, counts)) continue;
            const Vec3 normal = load3(c.normal, at), first = load3(c.tangent, at), second = cross(normal, first);
            const Vec3 relative =
                sub(velocity_of(turn_a, ta, load3(c.arm_a, at)), velocity_of(turn_b, tb, load3(c.arm_b, at)));
            const VF sum_x = hn::Add(load(c.came[1]), hn::Sub(dot(first, relative), load(c.drift[0])));
            const VF sum_y = hn::Add(load(c.came[2]), hn::Sub(dot(second, relative), load(c.drift[1])));
            const VF work = mul_add(load(c.dragged[0]), sum_x, hn::Mul(load(c.dragged[1]), sum_y));
            const VF over = hn::Div(work, hn::Max(pressed, constant(1e-30f)));
            const VF most = hn::Max(hn::Neg(hn::Add(load(c.came[0]), over)), zero);
            const auto less = hn::And(counts, hn::Gt(bounces, hn::Mul(most_gain, most)));
            if (hn::AllFalse(d, less)) continue;
            restrained = true;
            const VF by = hn::IfThenElseZero(less, hn::Sub(bounces, most));
            hn::Store(hn::Sub(bounces, by), d, c.bounce + at);
            hn::Store(hn::Sub(load(c.target), by), d, c.target + at);
        }
    }
    return restrained;
}

// Velocities, and the static lock: as for a body alone.
void crowd_finish(const CrowdInput& in, uint32_t kind, uint32_t begin) {
    const DF d;
    GatheredBodies bodies(in, begin);
    auto& row = bodies.row;
    auto& twist = bodies.twist;
    const VF zero = hn::Zero(d), creep = constant(0.01f * in.gravity * in.h);
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(d)) {
        const Size size = size_of(in.kinds[kind], row, at);
        Twist t = load6(twist, at);
        const auto speed = [&](const Twist& of) LR_LAMBDA {
            const VF spin = hn::Mul(hn::Mul(size.reach, size.inverse), hn::Sqrt(dot(of.u, of.u)));
            return hn::Add(hn::Sqrt(dot(of.v, of.v)), spin);
        };
        const auto load = [&](size_t field) LR_LAMBDA { return hn::Load(d, row[field] + at); };
        auto stays = hn::And(hn::Lt(speed(twist_of(row, at_v0, at, size.length)), creep), hn::Lt(speed(t), creep));
        stays = hn::And(
            hn::And(stays, hn::Gt(load(at_touches), zero)),
            hn::And(hn::Eq(load(at_carried), zero), hn::Gt(load(at_shallow), hn::Neg(hn::Add(size.slop, size.slop)))));
        const Vec3 none{zero, zero, zero};
        t = {select(stays, none, t.v), select(stays, none, t.u)};
        store3(row + at_x, at, select(stays, load3(row + at_x0, at), load3(row + at_x, at)));
        for (size_t k = 0; k < 4; ++k)
            hn::Store(hn::IfThenElse(stays, load(at_q0 + k), load(at_q + k)), d, row[at_q + k] + at);
        const auto dustless = [&](Vec3 v) LR_LAMBDA {
            return Vec3{without_dust(v.x), without_dust(v.y), without_dust(v.z)};
        };
        store3(row + at_v, at, dustless(t.v));
        store3(row + at_w, at, dustless(scale(size.inverse, t.u)));
    }
    bodies.put_back(in, begin);
}

} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
