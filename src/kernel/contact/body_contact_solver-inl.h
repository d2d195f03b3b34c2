// Body contact around its sweeps: short steps of the path, start of the velocities, static lock, with mass and added mass of both bodies; formulas as
// in collider_solver-inl.h (docs/maintainers/contact.md).
#if defined(LR_KERNEL_CONTACT_BODY_CONTACT_SOLVER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_CONTACT_BODY_CONTACT_SOLVER_INL_H_
#undef LR_KERNEL_CONTACT_BODY_CONTACT_SOLVER_INL_H_
#else
#define LR_KERNEL_CONTACT_BODY_CONTACT_SOLVER_INL_H_
#endif

#include "kernel/contact/body_contact_sweeps-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lr::LR_KERNEL_NAMESPACE {

void body_contact_begin(const BodyContactInput& in, uint32_t kind, uint32_t begin) {
    GatheredBodies bodies(in, begin);
    auto& row = bodies.row;
    auto& twist = bodies.twist;
    constexpr float part = 1.0f / short_steps;
    const VF zero = hn::Zero(DF());
    alignas(64) LaneRow steps[steps_floats];
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(DF())) {
        const VF length = load1(row[at_scale], at) * constant(in.kinds[kind].body->length);
        const Quaternion q = load4(row + at_q, at), q0 = load4(row + at_q0, at);
        const Twist way = way_of(q0, q, load3(row + at_x, at) - load3(row + at_x0, at), length);
        store6(row + at_way, at, way);
        // Without contacts the short steps make up the way, and their speed goes evenly from that before the substep to that after it.
        const Twist before{to_body(q, to_world(q0, load3(row + at_v0, at))),
                           length * to_body(q, to_world(q0, load3(row + at_w0, at)))};
        const Twist after{load3(row + at_v, at), length * load3(row + at_w, at)};
        const Twist growth = constant(part * part * in.h) * (after - before);
        store6(steps + at_step, at, constant(part) * way - constant(0.5f * (short_steps + 1.0f)) * growth);
        store6(steps + at_growth, at, growth);
        for (size_t f = at_correction; f < fields_of_body; ++f) store1(row[f], at, zero);
        const Size size = size_of(in.kinds[kind], row, at);
        store1(row[at_dust], at, constant(1e-4f * part * part) * size.slop);
        for (LaneRow& of : twist) store1(of, at, zero);
        for (size_t f = at_end; f < steps_floats; ++f) store1(steps[f], at, zero);
    }
    put_lanes(steps, in.steps + begin);
    bodies.put_back(in, begin);
}

// Bodies go on at the speed at which the last short step left them, and contacts act on them with `short_kept` of its impulses.
void body_contact_short_step(const BodyContactInput& in, uint32_t kind, uint32_t begin, bool first) {
    alignas(64) LaneRow twist[twist_floats], steps[steps_floats];
    take_lanes(in.twists + begin, twist);
    take_lanes(in.steps + begin, steps);
    const VF gone = constant(first ? 0.0f : 1.0f), kept = constant(first ? 1.0f : short_kept);
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(DF())) {
        const Twist now = load6(twist, at), by_contacts = now - load6(steps + at_end, at);
        const Twist step = load6(steps + at_step, at) + load6(steps + at_growth, at) + gone * by_contacts;
        const Twist end = gone * now + step;
        store6(steps + at_step, at, step);
        store6(steps + at_end, at, end);
        store6(steps + at_steps_acted, at, load6(steps + at_steps_acted, at) + gone * by_contacts);
        store6(twist, at, end + kept * by_contacts);
        store1(twist[6], at, kept * load1(twist[6], at));
    }
    put_lanes(twist, in.twists + begin);
    put_lanes(steps, in.steps + begin);
    if (!first && in.kinds[kind].rolling != 0.0f)
        for (size_t lane = 0; lane < contact_lanes; ++lane)
            for (float& rolled : in.bodies[begin + lane].rolled) rolled *= short_kept;
}

// The two bodies of a unit after the substep's motion.
struct PairState {
    Matrix turn_a, turn_b;
    Quaternion began_a, began_b;
    Size size_a, size_b;
    Vec3 moved_a, moved_b;
    Vec3 round_a, round_b; // world: from the core to the surface, at a contact
    Twist way[2], met[2], before[2];
    decltype(VF() > VF()) pair; // both are bodies
    VF slop, reach;             // of the smaller body
};
HWY_INLINE Twist twist_of(const LaneRow* row, size_t field, size_t at, VF length) {
    return {load3(row + field, at), length * load3(row + field + 3, at)};
}
// From a body's core to its surface where it touches the other body, or a collider. A rounding does not turn with its body: the point of a ball that is
// nearest to the ground stays below the middle. With points that turn along, balls sank into each other, and the velocities of those that had rolled in
// a correction were not stopped.
HWY_INLINE Vec3 rounding_at(const SolverBodyKind& kind, const LaneRow* row, size_t at, const PairBlock& block,
                            Vec3 normal) {
    const auto solid = load1(block.solid, at) > hn::Zero(DF());
    const VF radius = hn::IfThenElse(solid, constant(kind.own_rounding), constant(kind.rounding));
    return -(load1(row[at_scale], at) * radius) * normal;
}
HWY_INLINE PairState state_of(const BodyContactInput& in, const PairBlock& block, const Gathered& g, size_t at) {
    const SolverBodyKind &kind_a = in.kinds[block.kind_a], &kind_b = in.kinds[block.kind_b];
    PairState s;
    s.size_a = size_of(kind_a, g.a, at), s.size_b = size_of(kind_b, g.b, at);
    s.pair = load1(block.ratio, at) > hn::Zero(DF());
    s.slop = hn::Min(s.size_a.slop, hn::IfThenElse(s.pair, s.size_b.slop, s.size_a.slop));
    s.reach = hn::Min(s.size_a.reach, hn::IfThenElse(s.pair, s.size_b.reach, s.size_a.reach));
    s.turn_a = matrix_of(load4(g.a + at_q, at)), s.turn_b = matrix_of(load4(g.b + at_q, at));
    s.began_a = load4(g.a + at_q0, at), s.began_b = load4(g.b + at_q0, at);
    s.moved_a = load3(g.a + at_x, at) - load3(g.a + at_x0, at);
    s.moved_b = load3(g.b + at_x, at) - load3(g.b + at_x0, at);
    const Vec3 normal = load3(block.normal, at);
    s.round_a = rounding_at(kind_a, g.a, at, block, normal);
    s.round_b = rounding_at(kind_b, g.b, at, block, constant(-1.0f) * normal);
    s.way[0] = load6(g.a + at_way, at), s.way[1] = load6(g.b + at_way, at);
    s.met[0] = twist_of(g.a, at_v, at, s.size_a.length), s.met[1] = twist_of(g.b, at_v, at, s.size_b.length);
    s.before[0] = twist_of(g.a, at_v0, at, s.size_a.length), s.before[1] = twist_of(g.b, at_v0, at, s.size_b.length);
    return s;
}

// Contacts act at the middle between the points on both surfaces: impulses at two points would turn the pair. Each point is
// drawn there by at most this: after a large rotation the two no longer say how the surfaces move. Not so far on a rounding: no impulse along
// its normal turns a ball.
constexpr float most_joined = 0.2f; // of the smaller reach without the rounding
HWY_INLINE Vec3 joined(const SolverBodyKind& kind, const LaneRow* row, size_t at, VF smaller, Vec3 half) {
    const VF core = load1(row[at_scale], at) * constant(kind.reach - kind.rounding);
    const VF part =
        constant(most_joined) * hn::Min(smaller, core) / hn::Max(hn::Sqrt(dot(half, half)), constant(1e-30f));
    return hn::Min(part, constant(1.0f)) * half;
}

// Sets the contact frame, its axes and middle on both bodies, and all gains.
HWY_NOINLINE void set_frame(const BodyContactInput& in, const Gathered& g, PairBlock& block, size_t at,
                            const Size& size_a, const Size& size_b, Side& a, Side& b) {
    const VF zero = hn::Zero(DF()), one = constant(1.0f);
    const bool pairs = between_bodies(block);
    const Matrix turn_a = matrix_of(load4(g.a + at_q, at)), turn_b = matrix_of(load4(g.b + at_q, at));
    const Vec3 normal = load3(block.normal, at);
    Vec3 first, second;
    tangents(normal, first, second);
    const Matrix frame{{normal, first, cross(normal, first)}};
    const auto seen_from = [&](const Matrix& turn) LR_LAMBDA {
        return Matrix{{transposed_times(turn, frame.row[0]), transposed_times(turn, frame.row[1]),
                       transposed_times(turn, frame.row[2])}};
    };
    store_matrix(block.axes_a, at, seen_from(turn_a));
    store_matrix(block.axes_b, at, seen_from(turn_b));
    store1(block.lengths, at, size_a.length * size_b.inverse);
    const Vec3 apart = load3(g.a + at_x, at) - load3(g.b + at_x, at);
    const VF smaller = hn::Min(size_a.reach, size_b.reach);
    const Vec3 round_a = rounding_at(in.kinds[block.kind_a], g.a, at, block, normal);
    const Vec3 round_b = rounding_at(in.kinds[block.kind_b], g.b, at, block, constant(-1.0f) * normal);
    Vec3 on_a[block_contacts], sum_a = zero3(), sum_b = zero3();
    VF there[block_contacts], count = zero;
    for (uint32_t k = 0; k < block.used; ++k) {
        const PairBlock::Place& c = block.place[k];
        there[k] = hn::IfThenElseZero(load1(c.gap, at) < constant(0.5f * no_contact), one);
        on_a[k] = turn_a * load3(c.arm_a, at) + round_a;
        if (pairs) {
            const Vec3 on_b = turn_b * load3(c.arm_b, at) + round_b;
            const Vec3 half = constant(0.5f) * (apart + (on_a[k] - on_b));
            on_a[k] = on_a[k] - joined(in.kinds[block.kind_a], g.a, at, smaller, half);
            sum_b += there[k] * (on_b + joined(in.kinds[block.kind_b], g.b, at, smaller, half));
        }
        sum_a += there[k] * on_a[k];
        count += there[k];
    }
    const VF part = one / hn::Max(count, one);
    const Vec3 middle_a = part * sum_a, middle_b = part * sum_b;
    VF radius = zero;
    for (uint32_t k = 0; k < block.used; ++k) {
        const Vec3 from_middle = size_a.inverse * (on_a[k] - middle_a);
        const VF x = dot(first, from_middle), y = dot(frame.row[2], from_middle);
        store1(block.row[k].along[0], at, x);
        store1(block.row[k].along[1], at, y);
        radius += there[k] * hn::Sqrt(x * x + y * y);
    }
    store1(block.friction.radius, at, part * radius);
    store3(block.middle_a, at, size_a.inverse * (frame * middle_a));
    store3(block.middle_b, at, size_b.inverse * (frame * middle_b));
    a = side_a(in, block, at), b = side_b(in, block, at);
    if (full_mass(in, block))
        set_gains<true>(a, b, block, at);
    else
        set_gains<false>(a, b, block, at);
}
// Applies a unit's impulses to its bodies.
HWY_INLINE void push_pair(const BodyContactInput& in, const PairBlock& block, const Side& a, const Side& b,
                          const Reduced& impulse, GatheredTwists& twists, size_t at) {
    Twist ta = load6(twists.a, at), tb = load6(twists.b, at);
    if (full_mass(in, block))
        push<true, true>(a, b, impulse, ta, tb);
    else
        push<false, true>(a, b, impulse, ta, tb);
    store6(twists.a, at, ta);
    store6(twists.b, at, tb);
    store1(twists.a[6], at, load1(twists.a[6], at) + load1(block.solid, at) * impulse.press.x);
}

// The gap at the end of the substep and at its beginning, and the approach velocity when it closed.
HWY_INLINE void set_gaps(const PairState& s, VF h, const PairBlock& block, PairBlock::Place& c, size_t at) {
    const VF zero = hn::Zero(DF());
    const Vec3 normal = load3(block.normal, at), surface = load3(block.surface, at);
    const Vec3 path = load3(block.lag, at) + h * surface;
    const auto in_a = [&](Vec3 v) LR_LAMBDA { return transposed_times(s.turn_a, v); };
    const auto in_b = [&](Vec3 v) LR_LAMBDA { return transposed_times(s.turn_b, v); };
    // Given are arms to the surfaces: of pairs as the substep begins, else at its end.
    const Vec3 began_round_a = to_body(s.began_a, s.round_a), began_round_b = to_body(s.began_b, s.round_b);
    const Vec3 arm_a = load3(c.arm_a, at) - select(s.pair, began_round_a, in_a(s.round_a));
    const Vec3 arm_b = load3(c.arm_b, at) - select(s.pair, began_round_b, in_b(s.round_b));
    store3(c.arm_a, at, arm_a);
    store3(c.arm_b, at, arm_b);
    const VF given = load1(c.gap, at);
    const auto empty = given >= constant(0.5f * no_contact);
    const Vec3 went_a = s.moved_a + s.turn_a * arm_a - to_world(s.began_a, arm_a);
    const Vec3 went_b = s.moved_b + s.turn_b * arm_b - to_world(s.began_b, arm_b);
    const VF closed = dot(normal, select(s.pair, went_b, path) - went_a);
    const VF gap = hn::IfThenElse(empty, given, hn::IfThenElse(s.pair, given - closed, given));
    const VF before = hn::IfThenElse(empty, given, hn::IfThenElse(s.pair, given, given + closed));
    store1(c.gap, at, gap);
    store1(c.before, at, before);
    const Vec3 over_a = s.size_a.inverse * (arm_a + began_round_a), over_b = s.size_b.inverse * (arm_b + began_round_b);
    const Vec3 end_a = s.size_a.inverse * (arm_a + in_a(s.round_a)),
               end_b = s.size_b.inverse * (arm_b + in_b(s.round_b));
    const Vec3 first = select(s.pair, to_world(s.began_b, velocity_at(s.before[1], over_b)), surface);
    const Vec3 last = select(s.pair, s.turn_b * velocity_at(s.met[1], end_b), surface);
    const VF from = dot(normal, to_world(s.began_a, velocity_at(s.before[0], over_a)) - first);
    const VF to = dot(normal, s.turn_a * velocity_at(s.met[0], end_a) - last);
    const auto closes = hn::And(before > s.slop, closed > zero);
    const VF time = before / hn::Max(closed, constant(1e-30f));
    const VF part = hn::IfThenElseZero(closes, hn::Min(time, constant(1.0f)));
    store1(c.bounce, at, part * (to - from) + from);
}

// Starts a unit from normal impulses and from friction `drag`, which it reduces to the friction limits. Returns the unit's impulses.
HWY_INLINE Reduced started(PairBlock& block, size_t at, const VF* pressed, Vec3 drag) {
    const VF zero = hn::Zero(DF()), one = constant(1.0f);
    Vec3 press = zero3();
    PairBlock::Friction& f = block.friction;
    for (uint32_t k = 0; k < block.used; ++k) {
        PairBlock::Row& row = block.row[k];
        const VF had = hn::IfThenElseZero(load1(row.inverse, at) > zero, hn::Max(pressed[k], zero));
        store1(row.pressed, at, had);
        store1(row.search, at, zero);
        store1(row.change, at, zero);
        press += had * press_direction(row, at);
    }
    const VF most = load1(f.most, at) * press.x, most_spin = load1(f.radius, at) * most;
    const VF size = hn::Sqrt(drag.x * drag.x + drag.y * drag.y);
    const VF part = hn::Min(most / hn::Max(size, constant(1e-30f)), one);
    drag = {part * drag.x, part * drag.y, hn::Max(hn::Min(drag.z, most_spin), -most_spin)};
    store3(f.dragged, at, drag);
    store3(f.search, at, zero3());
    store3(f.change, at, zero3());
    return {press, drag};
}
HWY_NOINLINE Matrix frame_of(const PairBlock& block, size_t at) {
    const Vec3 normal = load3(block.normal, at);
    Vec3 first, second;
    tangents(normal, first, second);
    return {{normal, first, cross(normal, first)}};
}

void body_contact_way(const BodyContactInput& in, PairBlock& block) {
    constexpr float part = 1.0f / short_steps;
    const VF zero = hn::Zero(DF());
    const Gathered g(in, block);
    GatheredTwists twists(in, block);
    for (size_t at = 0; at < block.lanes; at += hn::Lanes(DF())) {
        const PairState s = state_of(in, block, g, at);
        store1(block.dust, at, constant(1e-3f * part * part) * s.slop);
        for (uint32_t k = 0; k < block.used; ++k) set_gaps(s, constant(in.h), block, block.place[k], at);
        Side a, b;
        set_frame(in, g, block, at, s.size_a, s.size_b, a, b);
        const Matrix frame = frame_of(block, at);
        const Vec3 path = constant(part) * (frame * (load3(block.lag, at) + constant(in.h) * load3(block.surface, at)));
        store1(block.friction.path[0], at, path.y);
        store1(block.friction.path[1], at, path.z);
        store3(block.friction.drift, at, {path.y, path.z, zero});
        store3(block.friction.sum, at, zero3());
        const Reduced way = relative_motion(a, b, s.way[0], s.way[1]);
        VF guess[block_contacts];
        for (uint32_t k = 0; k < block.used; ++k) {
            const PairBlock::Place& c = block.place[k];
            const VF gap = load1(c.gap, at), began = load1(c.before, at);
            const auto solid = load1(block.solid, at) > zero;
            const VF out = push_out(gap, began, s.slop, s.reach, solid);
            // A gap may close at once; older overlap is undone evenly.
            const VF target = dot(press_direction(block.row[k], at), way.press) - out;
            store1(block.row[k].target, at, hn::Min(target, constant(part) * target));
            store1(block.row[k].push, at, constant(part) * pushed(gap, began, out, solid));
            store1(block.place[k].sum, at, zero);
            guess[k] = load1(c.start, at);
        }
        const Vec3 drag = frame * load3(block.start_drag, at);
        const Reduced impulse = started(block, at, guess, {drag.y, drag.z, load1(block.start_spin, at)});
        push_pair(in, block, a, b, impulse, twists, at);
    }
    twists.put_back(in, block);
}

void body_contact_end_short_step(const BodyContactInput& in, PairBlock& block, uint32_t ended) {
    const bool last = ended == short_steps;
    const VF more = constant((static_cast<float>(ended) + 1.0f) / static_cast<float>(ended)),
             kept = constant(short_kept);
    const GatheredTwists twists(in, block);
    for (size_t at = 0; at < block.lanes; at += hn::Lanes(DF())) {
        PairBlock::Friction& f = block.friction;
        const Vec3 dragged = load3(f.dragged, at);
        store3(f.sum, at, load3(f.sum, at) + dragged);
        for (uint32_t k = 0; k < block.used; ++k) {
            PairBlock::Row& row = block.row[k];
            LaneRow& sum = block.place[k].sum;
            const VF pressed = load1(row.pressed, at), target = load1(row.target, at);
            store1(sum, at, load1(sum, at) + pressed);
            if (last) continue;
            store1(row.pressed, at, kept * pressed);
            store1(row.target, at, hn::Max(target, more * target));
            store1(row.push, at, more * load1(row.push, at));
        }
        if (last) continue;
        store3(f.dragged, at, kept * dragged);
        // Friction undoes half of the slip since the substep began. If it undid none, stacks would creep; if all, heaps would rest later.
        const Reduced went =
            relative_motion(side_a(in, block, at), side_b(in, block, at), load6(twists.a, at), load6(twists.b, at));
        const Vec3 path{load1(f.path[0], at), load1(f.path[1], at), hn::Zero(DF())};
        store3(f.drift, at, constant(0.5f) * went.drag + constant(0.5f * static_cast<float>(ended) + 1.0f) * path);
    }
}

void body_contact_move(const BodyContactInput& in, uint32_t kind, uint32_t begin) {
    GatheredBodies bodies(in, begin);
    auto& row = bodies.row;
    auto& twist = bodies.twist;
    const float h = in.h / short_steps;
    alignas(64) LaneRow steps[steps_floats];
    take_lanes(in.steps + begin, steps);
    const VF zero = hn::Zero(DF()), half = constant(0.5f);
    for (size_t at = 0; at < contact_lanes; at += hn::Lanes(DF())) {
        const Size size = size_of(in.kinds[kind], row, at);
        const Twist moved = load6(twist, at), way = load6(row + at_way, at);
        store6(row + at_acted, at, load6(steps + at_steps_acted, at) + (moved - load6(steps + at_end, at)));
        Twist correction = moved - way;
        correction = small_part(correction.u, size.inverse) * correction;
        store6(row + at_correction, at, correction);
        Quaternion q = load4(row + at_q, at);
        store3(row + at_x, at, load3(row + at_x, at) + to_world(q, correction.v));
        const Twist met = twist_of(row, at_v, at, size.length);
        // A warm start that the sweeps correct only in part integrates the overlap: impulses overshoot, and a high heap swings. A share below 1 damps
        // this. If a body falls by less than the slop in a short step, most of the path undoes older overlap, which does not come again: the share then
        // leaves about the weight.
        const VF falls = constant(in.gravity * (h * h)) / size.slop, grown = falls * falls + falls;
        const VF share = grown / (grown + constant(2.0f));
        store1(row[at_share], at, share);
        const Twist seen{to_world(q, met.v), to_world(q, met.u)};
        q = normalised(turn(q, q, half * size.inverse, correction.u));
        store4(row + at_q, at, q);
        // The correction turns the body but not its velocity in the world, so that momentum is kept.
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
    const VF presses = constant(0.5f * in.gravity * (in.h * in.h)); // weight presses bodies in by this
    alignas(64) LaneRow carried, shallow, touching;
    for (size_t at = 0; at < block.lanes; at += hn::Lanes(DF())) {
        const Size size_a = size_of(in.kinds[block.kind_a], g.a, at), size_b = size_of(in.kinds[block.kind_b], g.b, at);
        const auto pair = load1(block.ratio, at) > zero, solid = load1(block.solid, at) > zero;
        const VF slop = hn::Min(size_a.slop, hn::IfThenElse(pair, size_b.slop, size_a.slop));
        // Limited, or small solids at 30 Hz would rest half in each other.
        const VF reach = hn::Min(size_a.reach, hn::IfThenElse(pair, size_b.reach, size_a.reach));
        const VF within = hn::IfThenElseZero(hn::Not(solid), hn::Min(presses, constant(0.1f) * reach));
        const Side a = side_a(in, block, at), b = side_b(in, block, at);
        const Reduced moved = relative_motion(a, b, load6(g.a + at_correction, at), load6(g.b + at_correction, at));
        const Reduced acted = relative_motion(a, b, load6(g.a + at_acted, at), load6(g.b + at_acted, at));
        const Reduced came = relative_motion(a, b, load6(g.a + at_way, at), load6(g.b + at_way, at));
        const Vec3 drift = frame_of(block, at) * load3(block.surface, at), dragged = load3(block.friction.sum, at);
        VF least = zero, any = zero;
        VF stopping = dot(dragged, Vec3{drift.y, drift.z, zero} - came.drag), moving = dot(dragged, acted.drag);
        for (uint32_t k = 0; k < block.used; ++k) {
            PairBlock::Place& c = block.place[k];
            const Vec3 direction = press_direction(block.row[k], at);
            const VF given = load1(c.gap, at), pressed = load1(c.sum, at);
            const auto there = given < empty;
            const VF opened = dot(direction, moved.press);
            stopping += pressed * (drift.x - dot(direction, came.press));
            moving += pressed * dot(direction, acted.press);
            const VF gap = hn::IfThenElse(there, given + opened, given);
            const auto touches = hn::And(there, hn::Or(pressed > zero, gap <= slop));
            store1(c.gap, at, gap);
            store1(c.touching, at, hn::IfThenElseZero(touches, one));
            any = hn::IfThenElse(touches, one, any);
            const VF began = load1(c.before, at) + within;
            least = hn::Min(least, hn::IfThenElseZero(touches, began));
        }
        store1(carried, at, any * greatest(load3(block.surface, at)));
        store1(shallow, at, least);
        store1(touching, at, any);
        store1(block.start, at, stopping);
        store1(block.moving, at, moving);
    }
    for (size_t lane = 0; lane < block.lanes; ++lane) {
        SolverBody& a = in.bodies[block.a[lane]];
        a.carried = HWY_MAX(a.carried, carried[lane]);
        a.shallow = HWY_MIN(a.shallow, shallow[lane]);
        a.touches = HWY_MAX(a.touches, touching[lane]);
        if (block.ratio[lane] == 0.0f) continue;
        SolverBody& b = in.bodies[block.b[lane]];
        b.shallow = HWY_MIN(b.shallow, shallow[lane]);
        b.touches = HWY_MAX(b.touches, touching[lane]);
    }
}

void body_contact_velocity(const BodyContactInput& in, PairBlock& block) {
    bool bouncing = false;
    const Gathered g(in, block);
    GatheredTwists twists(in, block);
    // The inverse of the shortest steps would overflow.
    const float frequency = 1.0f / HWY_MAX(in.h, 1e-30f);
    const VF zero = hn::Zero(DF()), slow = constant(2.0f * in.gravity * in.h), inverse_h = constant(frequency);
    for (size_t at = 0; at < block.lanes; at += hn::Lanes(DF())) {
        const Size size_a = size_of(in.kinds[block.kind_a], g.a, at), size_b = size_of(in.kinds[block.kind_b], g.b, at);
        PairBlock::Friction& f = block.friction;
        const Matrix frame = frame_of(block, at);
        const Vec3 path{load1(f.dragged[0], at), load1(f.dragged[1], at), load1(f.dragged[2], at)};
        store3(block.start_drag, at, path.x * frame.row[1] + path.y * frame.row[2]);
        store1(block.start_spin, at, path.z);
        Side a, b;
        set_frame(in, g, block, at, size_a, size_b, a, b);
        store1(block.dust, at, constant(1e-4f) * slow);
        const auto load = [&](const LaneRow* row, size_t field) LR_LAMBDA { return load1(row[field], at); };
        const VF guess = load1(block.start, at);
        const auto any = hn::Max(load(g.a, at_touches), load(g.b, at_touches)) > zero;
        const Vec3 drift = frame * load3(block.surface, at);
        store3(f.drift, at, {drift.y, drift.z, zero});
        const Reduced came = relative_motion(a, b, load6(g.a + at_way, at), load6(g.b + at_way, at));
        store3(block.came, at, came.drag - Vec3{drift.y, drift.z, zero});
        VF had[block_contacts];
        for (uint32_t k = 0; k < block.used; ++k) {
            PairBlock::Place& c = block.place[k];
            PairBlock::Row& row = block.row[k];
            store1(row.inverse, at, hn::IfThenElseZero(any, load1(row.inverse, at)));
            const auto touches = load1(c.touching, at) > zero;
            const VF bounce = load1(c.bounce, at);
            const VF back = -(load1(block.restitution, at) * bounce);
            const VF away = hn::IfThenElseZero(bounce < -slow, back);
            // If one of the bodies touches anything, open contacts can close within a substep, but not faster.
            const VF closing = -(hn::Max(load1(c.gap, at), zero) * inverse_h);
            store1(row.target, at, drift.x + hn::IfThenElse(touches, away, closing));
            store1(row.push, at, hn::Zero(DF()));
            const VF bounces = hn::IfThenElseZero(touches, away);
            store1(c.bounce, at, bounces);
            bouncing = bouncing || !hn::AllTrue(DF(), hn::Eq(bounces, zero));
            store1(c.came, at, dot(press_direction(row, at), came.press) - drift.x);
            store1(c.start, at, load1(row.pressed, at));
            had[k] = hn::IfThenElseZero(touches, guess * load1(c.sum, at));
        }
        const Reduced impulse = started(block, at, had, guess * load3(f.sum, at));
        push_pair(in, block, a, b, impulse, twists, at);
    }
    twists.put_back(in, block);
    block.bounces = bouncing ? 1 : 0;
}

// Cuts the bounce of contacts whose impulses, with the unit's friction, would gain energy. The work of an impulse is half of it times the
// sum of the velocities before and after.
bool body_contact_restrain(const BodyContactInput& in, PairBlock& block) {
    if (block.bounces == 0) return false;
    GatheredTwists twists(in, block);
    const VF zero = hn::Zero(DF()), most_gain = constant(1.01f);
    bool restrained = false;
    for (size_t at = 0; at < block.lanes; at += hn::Lanes(DF())) {
        const Reduced now =
            relative_motion(side_a(in, block, at), side_b(in, block, at), load6(twists.a, at), load6(twists.b, at));
        const PairBlock::Friction& f = block.friction;
        const Vec3 drift{load1(f.drift[0], at), load1(f.drift[1], at), zero};
        const VF work = dot(load3(f.dragged, at), load3(block.came, at) + (now.drag - drift));
        VF load = zero;
        for (uint32_t k = 0; k < block.used; ++k) load += load1(block.row[k].pressed, at);
        const VF over = work / hn::Max(load, constant(1e-30f));
        for (uint32_t k = 0; k < block.used; ++k) {
            PairBlock::Place& c = block.place[k];
            PairBlock::Row& row = block.row[k];
            const VF bounces = load1(c.bounce, at);
            const auto counts = hn::And(bounces > zero, load1(row.pressed, at) > zero);
            const VF most = hn::Max(-(load1(c.came, at) + over), zero);
            const auto less = hn::And(counts, bounces > most_gain * most);
            if (hn::AllFalse(DF(), less)) continue;
            restrained = true;
            const VF by = hn::IfThenElseZero(less, bounces - most);
            store1(c.bounce, at, bounces - by);
            store1(row.target, at, load1(row.target, at) - by);
        }
    }
    return restrained;
}

// Stores velocities, after a static lock like that of single bodies.
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
        // Contacts hold the body only if they have changed its velocity.
        const Twist came = load6(row + at_way, at);
        stays = hn::And(stays, speed_of({t.v - came.v, t.u - came.u}, lever) > load(at_dust));
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
