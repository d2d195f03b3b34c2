// Body contact: Gauss-Seidel over pairs with mass and added mass of both; formulas as in collider_solver-inl.h (docs/maintainers/contact.md).
#if defined(LR_KERNEL_CONTACT_BODY_CONTACT_SOLVER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_CONTACT_BODY_CONTACT_SOLVER_INL_H_
#undef LR_KERNEL_CONTACT_BODY_CONTACT_SOLVER_INL_H_
#else
#define LR_KERNEL_CONTACT_BODY_CONTACT_SOLVER_INL_H_
#endif

#include "kernel/contact/body_contact_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::LR_KERNEL_NAMESPACE {

void body_contact_begin(const BodyContactInput& in, uint32_t kind, uint32_t begin) {
    GatheredBodies bodies(in, begin);
    auto& row = bodies.row;
    auto& twist = bodies.twist;
    const VF zero = hn::Zero(DF());
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(DF())) {
        const VF length = load1(row[at_scale], at) * constant(in.kinds[kind].body->length);
        const Quaternion q = load4(row + at_q, at), q0 = load4(row + at_q0, at);
        const Twist way = way_of(q0, q, load3(row + at_x, at) - load3(row + at_x0, at), length);
        store6(row + at_way, at, way);
        store6(twist, at, way);
        for (size_t f = at_correction; f < fields_of_body; ++f) store1(row[f], at, zero);
        const Size size = size_of(in.kinds[kind], row, at);
        store1(row[at_dust], at, constant(1e-4f) * size.slop);
        for (size_t f = 6; f < twist_floats; ++f) store1(twist[f], at, zero);
    }
    bodies.put_back(in, begin);
}

// The two bodies of a pair in the first projection, and their motion in the substep so far.
struct PairState {
    Side a, b;
    Size size_a, size_b;
    Quaternion began_a, began_b;
    Vec3 moved_a, moved_b;
    Twist way[2], met[2], before[2];
    decltype(VF() > VF()) pair; // both are bodies
    VF slop, reach;             // of the smaller body
};
HWY_INLINE Twist twist_of(const LaneRow* row, size_t field, size_t at, VF length) {
    return {load3(row + field, at), length * load3(row + field + 3, at)};
}
HWY_INLINE PairState state_of(const BodyContactInput& in, const PairBlock& block, const Gathered& g, size_t at) {
    const SolverBodyKind &kind_a = in.kinds[block.kind_a], &kind_b = in.kinds[block.kind_b];
    PairState s;
    s.size_a = size_of(kind_a, g.a, at), s.size_b = size_of(kind_b, g.b, at);
    const VF ratio = load1(block.ratio, at);
    s.pair = ratio > hn::Zero(DF());
    s.slop = hn::Min(s.size_a.slop, hn::IfThenElse(s.pair, s.size_b.slop, s.size_a.slop));
    s.reach = hn::Min(s.size_a.reach, hn::IfThenElse(s.pair, s.size_b.reach, s.size_a.reach));
    s.a = {kind_a.body->full_inverse, matrix_of(load4(g.a + at_q, at)), constant(1.0f)};
    s.b = {kind_b.body->full_inverse, matrix_of(load4(g.b + at_q, at)), ratio};
    s.began_a = load4(g.a + at_q0, at), s.began_b = load4(g.b + at_q0, at);
    s.moved_a = load3(g.a + at_x, at) - load3(g.a + at_x0, at);
    s.moved_b = load3(g.b + at_x, at) - load3(g.b + at_x0, at);
    s.way[0] = load6(g.a + at_way, at), s.way[1] = load6(g.b + at_way, at);
    s.met[0] = twist_of(g.a, at_v, at, s.size_a.length), s.met[1] = twist_of(g.b, at_v, at, s.size_b.length);
    s.before[0] = twist_of(g.a, at_v0, at, s.size_a.length), s.before[1] = twist_of(g.b, at_v0, at, s.size_b.length);
    return s;
}

// The gap at the end of the substep and at its beginning, and the approach velocity when it closed.
HWY_INLINE void set_gaps(const PairState& s, VF h, PairContacts& c, size_t at, Vec3 arm_a, Vec3 arm_b) {
    const VF zero = hn::Zero(DF());
    const Vec3 normal = load3(c.normal, at), surface = load3(c.surface, at);
    const Vec3 path = load3(c.lag, at) + h * surface;
    const Vec3 over_a = load3(c.arm_a, at), over_b = load3(c.arm_b, at);
    const VF given = load1(c.gap, at);
    const auto empty = given >= constant(0.5f * no_contact);
    const Vec3 went_a = s.moved_a + s.a.turn * arm_a - to_world(s.began_a, arm_a);
    const Vec3 went_b = s.moved_b + s.b.turn * arm_b - to_world(s.began_b, arm_b);
    const VF closed = dot(normal, select(s.pair, went_b, path) - went_a);
    const VF gap = hn::IfThenElse(empty, given, hn::IfThenElse(s.pair, given - closed, given));
    const VF before = hn::IfThenElse(empty, given, hn::IfThenElse(s.pair, given, given + closed));
    store1(c.gap, at, gap);
    store1(c.before, at, before);
    const Vec3 first = select(s.pair, to_world(s.began_b, velocity_at(s.before[1], over_b)), surface);
    const Vec3 last = select(s.pair, velocity_of(s.b.turn, s.met[1], over_b), surface);
    const VF from = dot(normal, to_world(s.began_a, velocity_at(s.before[0], over_a)) - first);
    const VF to = dot(normal, velocity_of(s.a.turn, s.met[0], over_a) - last);
    const auto closes = hn::And(before > s.slop, closed > zero);
    const VF time = before / hn::Max(closed, constant(1e-30f));
    const VF part = hn::IfThenElseZero(closes, hn::Min(time, constant(1.0f)));
    store1(c.bounce, at, part * (to - from) + from);
}

// A substep undoes at most this part of the reach of an overlap that it began with: bodies that lie in each other must not be thrown apart.
constexpr float pair_push = 0.02f, collider_push = 0.5f;
// A substep undoes this part of an overlap between bodies beyond the slop: with more, pairs of a heap that contradict each other would oscillate.
constexpr float undone = 0.3f;

HWY_INLINE void set_way(const PairState& s, VF h, PairContacts& c, size_t at) {
    const VF zero = hn::Zero(DF());
    const Vec3 arm_a = load3(c.arm_a, at), arm_b = load3(c.arm_b, at);
    store3(c.arm_a, at, s.size_a.inverse * arm_a);
    store3(c.arm_b, at, s.size_b.inverse * arm_b);
    set_gaps(s, h, c, at, arm_a, arm_b);
    set_gains(s.a, s.b, c, at);
    const Vec3 normal = load3(c.normal, at), tangent = load3(c.tangent, at);
    const auto solid = load1(c.solid, at) > zero;
    const VF gap = load1(c.gap, at);
    const VF before = load1(c.before, at), overlap = hn::Min(before + s.slop, zero);
    const VF most = constant(pair_push) * s.reach;
    const VF stays = hn::Min(constant(1.0f - undone) * overlap, overlap + most);
    // Colliders: as in the solver of single bodies.
    const VF gained = gap - hn::Min(before, zero);
    const VF out = hn::Max(gap, hn::Min(constant(-collider_push) * s.reach + gained, zero));
    const VF push = hn::IfThenElse(solid, out, gap - stays);
    const Vec3 relative = relative_velocity(s.a.turn, s.b.turn, c, at, s.way[0], s.way[1]);
    store1(c.target, at, dot(normal, relative) - push);
    const Vec3 path = load3(c.lag, at) + h * load3(c.surface, at);
    store1(c.drift[0], at, dot(tangent, path));
    store1(c.drift[1], at, dot(cross(normal, tangent), path));
}

// Starts a contact from an impulse along its normal and tangents, as far as friction allows.
HWY_INLINE Vec3 started(PairContacts& c, size_t at, Vec3 had, hn::Mask<DF> counts) {
    const VF zero = hn::Zero(DF()), most = load1(c.friction, at) * hn::Max(had.x, zero);
    const VF size = hn::Sqrt(had.y * had.y + had.z * had.z);
    const VF part = hn::Min(most / hn::Max(size, constant(1e-30f)), constant(1.0f));
    const auto counted = [&](VF a) LR_LAMBDA { return hn::IfThenElseZero(counts, a); };
    const Vec3 impulse{counted(hn::Max(had.x, zero)), counted(part * had.y), counted(part * had.z)};
    store1(c.pressed, at, impulse.x);
    store1(c.dragged[0], at, impulse.y);
    store1(c.dragged[1], at, impulse.z);
    return impulse;
}

void body_contact_way(const BodyContactInput& in, PairBlock& block) {
    const Gathered g(in, block);
    GatheredTwists twists(in, block);
    alignas(64) LaneRow depth;
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(DF())) {
        const PairState s = state_of(in, block, g, at);
        store1(block.dust, at, constant(1e-3f) * s.slop);
        store_matrix(block.turn_a, at, s.a.turn);
        store_matrix(block.turn_b, at, s.b.turn);
        VF deepest = hn::Zero(DF());
        Twist ta = load6(twists.a, at), tb = load6(twists.b, at);
        for (uint32_t k = 0; k < block.used; ++k) {
            PairContacts& c = block.contact[k];
            set_way(s, constant(in.h), c, at);
            store3(c.search, at, zero3());
            const Matrix frame = frame_of(c, at);
            const Vec3 impulse = started(c, at, frame * load3(c.start, at), load1(c.inverse, at) > hn::Zero(DF()));
            push(s.a, s.b, c, at, transposed_times(frame, impulse), ta, tb);
            deepest = hn::Max(deepest, -load1(c.gap, at));
        }
        store1(depth, at, deepest);
        store6(twists.a, at, ta);
        store6(twists.b, at, tb);
    }
    twists.put_back(in, block);
    for (size_t lane = 0; lane < block.lanes; ++lane)
        for (uint32_t body : {block.a[lane], block.b[lane]}) {
            if (body == block.b[lane] && block.ratio[lane] == 0.0f) continue;
            in.bodies[body].depth = HWY_MAX(in.bodies[body].depth, depth[lane]);
        }
}

// Squares of impulses over a mass, m^2/s^2 and m^2. A pair with larger changes, or NaN, passes nothing on and is dropped for the substep.
constexpr float most_change = 1e30f;

HWY_INLINE void let_go(PairBlock& block, size_t at, hn::Mask<DF> fine) {
    for (uint32_t k = 0; k < block.used; ++k) {
        PairContacts& c = block.contact[k];
        for (float* row : {c.inverse, c.pressed, c.dragged[0], c.dragged[1], c.change[0], c.change[1], c.change[2],
                           c.search[0], c.search[1], c.search[2]})
            store1(row, at, hn::IfThenElseZero(fine, load1(row, at)));
    }
}

bool body_contact_sweep(const BodyContactInput& in, PairBlock& block) {
    const VF zero = hn::Zero(DF());
    GatheredTwists twists(in, block);
    bool changed = false;
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(DF())) {
        const Side a{in.kinds[block.kind_a].body->full_inverse, load_matrix(block.turn_a, at), constant(1.0f)};
        const Side b{in.kinds[block.kind_b].body->full_inverse, load_matrix(block.turn_b, at), load1(block.ratio, at)};
        const VF dust = load1(block.dust, at);
        Twist ta = load6(twists.a, at), tb = load6(twists.b, at);
        VF change = zero, load = zero, squares = zero;
        for (uint32_t k = 0; k < block.used; ++k) {
            PairContacts& c = block.contact[k];
            const Matrix frame = frame_of(c, at);
            const Vec3 relative = frame * relative_velocity(a.turn, b.turn, c, at, ta, tb);
            Row r;
            r.inverse = load1(c.inverse, at);
            r.target = load1(c.target, at);
            r.pressed = load1(c.pressed, at);
            for (int i = 0; i < 2; ++i) r.dragged[i] = load1(c.dragged[i], at);
            for (int i = 0; i < 3; ++i) r.hold[i] = load1(c.hold[i], at);
            r.least = load1(c.least, at);
            r.friction = load1(c.friction, at);
            const VF more = press(r, relative.x, dust);
            const auto slip = [&](VF seen, const float* gained, const float* drift)
                                  LR_LAMBDA { return more * load1(gained, at) + seen - load1(drift, at); };
            Vec3 step{more, more, more};
            drag(r, slip(relative.y, c.to_first, c.drift[0]), slip(relative.z, c.to_second, c.drift[1]), dust, step.y,
                 step.z);
            push(a, b, c, at, transposed_times(frame, step), ta, tb);
            store1(c.pressed, at, r.pressed);
            store3(c.change, at, step);
            for (int i = 0; i < 2; ++i) store1(c.dragged[i], at, r.dragged[i]);
            squares += dot(step, step);
            load += hn::IfThenElse(load1(c.solid, at) > zero, more, zero);
            change = hn::Max(hn::Max(change, hn::Abs(more)), hn::Max(hn::Abs(step.y), hn::Abs(step.z)));
        }
        const auto fine = squares <= constant(most_change);
        if (HWY_UNLIKELY(!hn::AllTrue(DF(), fine))) {
            let_go(block, at, fine);
            ta = select(fine, ta, load6(twists.a, at));
            tb = select(fine, tb, load6(twists.b, at));
            squares = hn::IfThenElseZero(fine, squares);
            load = hn::IfThenElseZero(fine, load);
            change = hn::IfThenElseZero(fine, change);
        }
        store6(twists.a, at, ta);
        store6(twists.b, at, tb);
        store1(block.changed, at, squares);
        store1(twists.a[6], at, load1(twists.a[6], at) + load);
        changed = changed || !hn::AllTrue(DF(), hn::Eq(change, zero));
    }
    if (changed) twists.put_back(in, block);
    return changed;
}

// part 0: only remembers the direction.
void body_contact_follow(const BodyContactInput& in, PairBlock& block, float part) {
    if (part == 0.0f) {
        for (uint32_t k = 0; k < block.used; ++k)
            for (size_t at = 0; at < contact_lanes; at += hn::Lanes(DF()))
                store3(block.contact[k].search, at, load3(block.contact[k].change, at));
        return;
    }
    GatheredTwists twists(in, block);
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(DF())) {
        const Side a{in.kinds[block.kind_a].body->full_inverse, load_matrix(block.turn_a, at), constant(1.0f)};
        const Side b{in.kinds[block.kind_b].body->full_inverse, load_matrix(block.turn_b, at), load1(block.ratio, at)};
        Twist ta = load6(twists.a, at), tb = load6(twists.b, at);
        VF load = hn::Zero(DF());
        for (uint32_t k = 0; k < block.used; ++k) {
            PairContacts& c = block.contact[k];
            const Vec3 more = constant(part) * load3(c.search, at);
            store3(c.search, at, more + load3(c.change, at));
            push(a, b, c, at, transposed_times(frame_of(c, at), more), ta, tb);
            const auto gain = [&](float* to, VF by) LR_LAMBDA { store1(to, at, load1(to, at) + by); };
            gain(c.pressed, more.x);
            gain(c.dragged[0], more.y);
            gain(c.dragged[1], more.z);
            load += hn::IfThenElseZero(load1(c.solid, at) > hn::Zero(DF()), more.x);
        }
        store6(twists.a, at, ta);
        store6(twists.b, at, tb);
        store1(twists.a[6], at, load1(twists.a[6], at) + load);
    }
    twists.put_back(in, block);
}

// The couple against rolling and spinning, bounded by the normal impulses.
bool body_contact_roll(const BodyContactInput& in, uint32_t kind, uint32_t begin) {
    const SolverBodyKind& k = in.kinds[kind];
    if (k.rolling == 0.0f) return false;
    bool loaded = false;
    for (size_t lane = 0; lane < contact_lanes; ++lane) loaded = loaded || in.twists[begin + lane].load > 0.0f;
    if (!loaded) return false;
    GatheredBodies bodies(in, begin);
    auto& row = bodies.row;
    auto& twist = bodies.twist;
    const VF zero = hn::Zero(DF()), spin_hold = constant(1.0f / most_turned<true>(*k.body));
    bool changed = false;
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(DF())) {
        const VF load = hn::Max(load1(twist[6], at), zero);
        const Size size = size_of(k, row, at);
        const VF most = constant(k.rolling) * (size.reach * size.inverse) * load;
        const Twist t = load6(twist, at);
        Vec3 rolled = load3(row + at_rolled, at);
        const Vec3 step = hold_spin(rolled, t.u, spin_hold, most, load1(row[at_dust], at));
        store3(row + at_rolled, at, rolled);
        store6(twist, at, t + turned_by<true>(*k.body, step));
        changed = changed || !hn::AllTrue(DF(), hn::Eq(greatest(step), zero));
    }
    if (!changed) return false;
    bodies.put_back(in, begin);
    return true;
}

void body_contact_move(const BodyContactInput& in, uint32_t kind, uint32_t begin) {
    GatheredBodies bodies(in, begin);
    auto& row = bodies.row;
    auto& twist = bodies.twist;
    const VF zero = hn::Zero(DF()), half = constant(0.5f);
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(DF())) {
        const Size size = size_of(in.kinds[kind], row, at);
        const Twist moved = load6(twist, at), way = load6(row + at_way, at);
        Twist correction = moved - way;
        correction = small_part(correction.u, size.inverse) * correction;
        store6(row + at_correction, at, correction);
        Quaternion q = load4(row + at_q, at);
        store3(row + at_x, at, load3(row + at_x, at) + to_world(q, correction.v));
        const Twist met = twist_of(row, at_v, at, size.length);
        const Twist seen{to_world(q, met.v), to_world(q, met.u)};
        q = normalised(turn(q, q, half * size.inverse, correction.u));
        store4(row + at_q, at, q);
        // The correction turns the body, not its velocity in the world: momentum is kept.
        const Twist goes{to_body(q, seen.v), to_body(q, seen.u)};
        store6(twist, at, goes);
        store6(row + at_way, at, goes);
        store3(row + at_rolled, at, zero3());
        store1(row[at_dust], at, constant(2e-5f * in.gravity * in.h));
        store1(twist[6], at, zero);
    }
    bodies.put_back(in, begin);
}

void body_contact_touch(const BodyContactInput& in, PairBlock& block) {
    const Gathered g(in, block);
    const VF zero = hn::Zero(DF()), one = constant(1.0f), empty = constant(0.5f * no_contact);
    alignas(64) LaneRow carried, shallow, touching;
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(DF())) {
        const Size size_a = size_of(in.kinds[block.kind_a], g.a, at), size_b = size_of(in.kinds[block.kind_b], g.b, at);
        const auto pair = load1(block.ratio, at) > zero;
        const VF slop = hn::Min(size_a.slop, hn::IfThenElse(pair, size_b.slop, size_a.slop));
        const Matrix turn_a = load_matrix(block.turn_a, at), turn_b = load_matrix(block.turn_b, at);
        const Twist moved_a = load6(g.a + at_correction, at), moved_b = load6(g.b + at_correction, at);
        VF fast = zero, least = zero, any = zero;
        for (uint32_t k = 0; k < block.used; ++k) {
            PairContacts& c = block.contact[k];
            const VF given = load1(c.gap, at);
            const auto there = given < empty;
            const Vec3 relative = relative_velocity(turn_a, turn_b, c, at, moved_a, moved_b);
            const VF gap = hn::IfThenElse(there, given + dot(load3(c.normal, at), relative), given);
            const auto pressed = load1(c.pressed, at) > zero;
            const auto touches = hn::And(there, hn::Or(pressed, gap <= slop));
            store1(c.gap, at, gap);
            store1(c.touching, at, hn::IfThenElseZero(touches, one));
            any = hn::IfThenElse(touches, one, any);
            fast = hn::Max(fast, hn::IfThenElseZero(touches, greatest(load3(c.surface, at))));
            const auto counts = hn::And(touches, load1(c.solid, at) > zero);
            least = hn::Min(least, hn::IfThenElseZero(counts, load1(c.before, at)));
        }
        store1(carried, at, fast);
        store1(shallow, at, least);
        store1(touching, at, any);
    }
    for (size_t lane = 0; lane < block.lanes; ++lane) {
        SolverBody& a = in.bodies[block.a[lane]];
        a.carried = HWY_MAX(a.carried, carried[lane]);
        a.shallow = HWY_MIN(a.shallow, shallow[lane]);
        a.touches = HWY_MAX(a.touches, touching[lane]);
        if (block.ratio[lane] == 0.0f) continue;
        SolverBody& b = in.bodies[block.b[lane]];
        b.touches = HWY_MAX(b.touches, touching[lane]);
    }
}

// Moves both points of a contact to the middle between them: impulses at two points would turn the pair. At most this far: after a
// large rotation they no longer say how the surfaces move.
constexpr float most_joined = 0.2f; // of the smaller reach

HWY_INLINE void join_arms(const Side& a, const Side& b, const Size& size_a, const Size& size_b, Vec3 apart,
                          PairContacts& c, size_t at) {
    const Vec3 on_a = a.turn * (size_a.length * load3(c.arm_a, at));
    const Vec3 on_b = b.turn * (size_b.length * load3(c.arm_b, at));
    Vec3 half = constant(0.5f) * (apart + (on_a - on_b));
    const VF most = constant(most_joined) * hn::Min(size_a.reach, size_b.reach);
    half = hn::Min(most / hn::Max(hn::Sqrt(dot(half, half)), constant(1e-30f)), constant(1.0f)) * half;
    store3(c.arm_a, at, size_a.inverse * transposed_times(a.turn, on_a - half));
    store3(c.arm_b, at, size_b.inverse * transposed_times(b.turn, on_b + half));
}

// The velocity's impulse starts from that of the path over h: of a body at rest it is twice that, after a blow just that.
constexpr float resting_guess = 2.0f, moving_guess = 1.0f;

void body_contact_velocity(const BodyContactInput& in, PairBlock& block) {
    const bool pairs = block.ratio[0] != 0.0f; // of all lanes or of none
    bool bouncing = false;
    const Gathered g(in, block);
    GatheredTwists twists(in, block);
    const SolverBodyKind &kind_a = in.kinds[block.kind_a], &kind_b = in.kinds[block.kind_b];
    // The inverse of the shortest steps would overflow.
    const float frequency = 1.0f / HWY_MAX(in.h, 1e-30f);
    const VF zero = hn::Zero(DF()), slow = constant(2.0f * in.gravity * in.h), inverse_h = constant(frequency);
    const VF fall = constant(in.gravity * (in.h * in.h));
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(DF())) {
        const Size size_a = size_of(kind_a, g.a, at), size_b = size_of(kind_b, g.b, at);
        const VF ratio = load1(block.ratio, at);
        const Side a{kind_a.body->full_inverse, matrix_of(load4(g.a + at_q, at)), constant(1.0f)};
        const Side b{kind_b.body->full_inverse, matrix_of(load4(g.b + at_q, at)), ratio};
        store_matrix(block.turn_a, at, a.turn);
        store_matrix(block.turn_b, at, b.turn);
        store1(block.dust, at, constant(1e-4f) * slow);
        const auto load = [&](const LaneRow* row, size_t field) LR_LAMBDA { return load1(row[field], at); };
        const auto asleep_a = load(g.a, at_depth) < constant(2.0f) * size_a.slop + fall;
        const auto asleep_b = load(g.b, at_depth) < constant(2.0f) * size_b.slop + fall;
        const VF guess = hn::IfThenElse(hn::And(asleep_a, asleep_b), constant(resting_guess * frequency),
                                        constant(moving_guess * frequency));
        const Vec3 apart = load3(g.a + at_x, at) - load3(g.b + at_x, at);
        const auto any = hn::Max(load(g.a, at_touches), load(g.b, at_touches)) > zero;
        Twist ta = load6(twists.a, at), tb = load6(twists.b, at);
        VF more = zero;
        const Twist met_a = load6(g.a + at_way, at), met_b = load6(g.b + at_way, at);
        for (uint32_t k = 0; k < block.used; ++k) {
            PairContacts& c = block.contact[k];
            if (pairs) join_arms(a, b, size_a, size_b, apart, c, at);
            set_gains(a, b, c, at);
            store3(c.search, at, zero3());
            store1(c.inverse, at, hn::IfThenElseZero(any, load1(c.inverse, at)));
            const Matrix frame = frame_of(c, at);
            const Vec3 surface = load3(c.surface, at), drift = frame * surface;
            const auto touches = load1(c.touching, at) > zero;
            const VF bounce = load1(c.bounce, at);
            const VF back = -(load1(c.restitution, at) * bounce);
            const VF away = hn::IfThenElseZero(bounce < -slow, back);
            // If a body touches somewhere, its open contacts can close within a substep, but not faster.
            const VF closing = -(hn::Max(load1(c.gap, at), zero) * inverse_h);
            store1(c.target, at, drift.x + hn::IfThenElse(touches, away, closing));
            store1(c.drift[0], at, drift.y);
            store1(c.drift[1], at, drift.z);
            const VF bounces = hn::IfThenElseZero(touches, away);
            store1(c.bounce, at, bounces);
            bouncing = bouncing || !hn::AllTrue(DF(), hn::Eq(bounces, zero));
            store3(c.came, at, frame * (relative_velocity(a.turn, b.turn, c, at, met_a, met_b) - surface));
            const Vec3 path{load1(c.pressed, at), load1(c.dragged[0], at), load1(c.dragged[1], at)};
            store3(c.start, at, transposed_times(frame, path));
            const Vec3 had = guess * path;
            const Vec3 impulse = started(c, at, had, touches);
            push(a, b, c, at, transposed_times(frame, impulse), ta, tb);
            more += hn::IfThenElseZero(load1(c.solid, at) > zero, impulse.x);
        }
        store6(twists.a, at, ta);
        store6(twists.b, at, tb);
        store1(twists.a[6], at, load1(twists.a[6], at) + more);
    }
    twists.put_back(in, block);
    block.bounces = bouncing ? 1 : 0;
}

// The work of a contact's impulse is half of it times the sum of the velocities before and after.
bool body_contact_restrain(const BodyContactInput& in, PairBlock& block) {
    if (block.bounces == 0) return false;
    GatheredTwists twists(in, block);
    const VF zero = hn::Zero(DF()), most_gain = constant(1.01f);
    bool restrained = false;
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(DF())) {
        const Matrix turn_a = load_matrix(block.turn_a, at), turn_b = load_matrix(block.turn_b, at);
        const Twist ta = load6(twists.a, at), tb = load6(twists.b, at);
        for (uint32_t k = 0; k < block.used; ++k) {
            PairContacts& c = block.contact[k];
            const auto load = [&](const float* row) LR_LAMBDA { return load1(row, at); };
            const VF pressed = load(c.pressed), bounces = load(c.bounce);
            const auto counts = hn::And(bounces > zero, pressed > zero);
            if (hn::AllFalse(DF(), counts)) continue;
            const Vec3 relative = frame_of(c, at) * relative_velocity(turn_a, turn_b, c, at, ta, tb);
            const VF sum_x = load(c.came[1]) + (relative.y - load(c.drift[0]));
            const VF sum_y = load(c.came[2]) + (relative.z - load(c.drift[1]));
            const VF work = load(c.dragged[0]) * sum_x + load(c.dragged[1]) * sum_y;
            const VF over = work / hn::Max(pressed, constant(1e-30f));
            const VF most = hn::Max(-(load(c.came[0]) + over), zero);
            const auto less = hn::And(counts, bounces > most_gain * most);
            if (hn::AllFalse(DF(), less)) continue;
            restrained = true;
            const VF by = hn::IfThenElseZero(less, bounces - most);
            store1(c.bounce, at, bounces - by);
            store1(c.target, at, load(c.target) - by);
        }
    }
    return restrained;
}

// Velocities and the static lock, as in the solver of single bodies.
void body_contact_finish(const BodyContactInput& in, uint32_t kind, uint32_t begin) {
    GatheredBodies bodies(in, begin);
    auto& row = bodies.row;
    auto& twist = bodies.twist;
    const VF zero = hn::Zero(DF()), creep = constant(0.01f * in.gravity * in.h);
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(DF())) {
        const Size size = size_of(in.kinds[kind], row, at);
        Twist t = load6(twist, at);
        const VF lever = size.reach * size.inverse;
        const auto load = [&](size_t field) LR_LAMBDA { return load1(row[field], at); };
        auto stays =
            hn::And(speed_of(twist_of(row, at_v0, at, size.length), lever) < creep, speed_of(t, lever) < creep);
        stays = hn::And(hn::And(stays, load(at_touches) > zero),
                        hn::And(hn::Eq(load(at_carried), zero), load(at_shallow) > -(size.slop + size.slop)));
        t = select(stays, Twist{zero3(), zero3()}, t);
        store3(row + at_x, at, select(stays, load3(row + at_x0, at), load3(row + at_x, at)));
        store4(row + at_q, at, select(stays, load4(row + at_q0, at), load4(row + at_q, at)));
        store3(row + at_v, at, without_dust(t.v));
        store3(row + at_w, at, without_dust(size.inverse * t.u));
    }
    bodies.put_back(in, begin);
}
} // namespace lr::LR_KERNEL_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
