// Solves contacts: each body that touches no other awake one by itself, the rest together.
#include "body_contact/body_contact_step.h"

#include "base/scratch.h"
#include "kernel/divergence.h"
#include "world/world.h"

#include <algorithm>
#include <limits>
#include <span>

namespace lr {
namespace {

constexpr auto lanes = static_cast<uint32_t>(contact_lanes);

// In heaps the sweeps leave more motion than a single still body has: the speed limit for sleep is higher by this factor.
constexpr float heap_still = 3.0f;
// The place in which a body must stay for a second is larger by this factor, a tenth of the reach: sweeps end early and keep heaps of more
// than ten layers trembling by some millimetres.
constexpr float heap_place = 5.0f;
float place_in_heap(const BodyAfter& body, float least_gap, const BodyShape& shape, float scale, float fall) {
    return lies_deep(least_gap, shape, scale, fall) ? body.place : heap_place * body.place;
}

// A body that others push out has no velocity. A solid is not still if this would take it out of its place before it falls asleep. Sheets in high
// heaps are pushed to and fro for ever.
float speed_pushed(const Batch& batch, const BodyAfter& body, float least_gap, float h) {
    const bool pushed = least_gap < -stay_way * body.reach && length(body.way) * time_to_sleep > body.place * h;
    return pushed && !batch.pair_hull().flat ? std::numeric_limits<float>::infinity() : body.speed;
}

// How a body moves away from sleeping ones, which may lie on it; world frame.
struct Leaving {
    // m/s, the velocity of a body that falls as soon as it has woken, else 0. It has lost its support. So has a sleeping one that it falls away
    // from, and a substep later that is out of reach.
    Vector falls;
    float fast; // m/s, half of the fall in a substep
    // m/s, at both ends of the substep. A body that sinks on a lift moves the same way at both, one that trembles in a heap does not.
    Vector before, after;
    bool moves;  // it wakes what it touches
    bool gone;   // it has left the place where it stayed, or is carried
    float clear; // m: half of the margin of contact
    Vector down; // of length 2

    // Wakes a sleeping body, or asks for a trial if it may have lost its support. normal: from the sleeping body to this one.
    void tell(const lr_world& world, const ContactGroup::Asleep& other, bool touched, Vector normal, float gap) const {
        Batch& batch = *world.batches[other.batch].batch;
        const bool leaves = gone || (gap > clear && dot(normal, before) > 0.0f && dot(normal, after) > 0.0f);
        if ((touched && moves) || dot(normal, falls) > fast)
            batch.note_sleep(other.index);
        else if (dot(normal, down) > 1.0f && leaves)
            batch.doubt(other.index);
    }
};

// v0, w0, v: before and after the substep, body frame. carried: a slow collider takes it along.
Leaving leaving(const ContactStep& step, Vector gravity, const ContactCache& book, const BodyAfter& body,
                const Pose& now, Vector v0, Vector w0, Vector v, float h, bool carried) {
    Leaving out{};
    if (book.stay[0][body.index] == 0.0f && dot(v0, v0) + dot(w0, w0) == 0.0f) out.falls = rotate(now.rotation, v);
    out.fast = 0.5f * step.gravity * h;
    out.before = rotate(now.rotation, v0);
    out.after = rotate(now.rotation, v);
    out.moves = body.speed > body.moving;
    out.gone = carried || !(way_in_place(book, body) < body.place);
    out.clear = 0.5f * contact_margin(body.reach, now.position, step.gravity, h);
    if (step.gravity > 0.0f) out.down = 2.0f / step.gravity * gravity;
    return out;
}

Pose began(const SolverBody& b) {
    return {vector_of(b.x0), {b.q0[0], b.q0[1], b.q0[2], b.q0[3]}};
}
Pose now(const SolverBody& b) {
    return {vector_of(b.x), {b.q[0], b.q[1], b.q[2], b.q[3]}};
}
// Whether two contacts with fixed things can be in one unit. Compared to the bit, so that every machine finds the same.
bool one_frame(const BodyContactFrame& a, const BodyContactFrame& b) {
    const auto same = [](Vector u, Vector v) { return u.x == v.x && u.y == v.y && u.z == v.z; };
    return same(a.normal, b.normal) && same(a.surface, b.surface) && same(a.lag, b.lag) && a.friction == b.friction &&
           a.restitution == b.restitution && a.solid == b.solid;
}
} // namespace

void BodyContactStep::hold(uint32_t substep, Held which) {
    each_piece(lanes, 4, [&](const BodyContactBatch& member, uint32_t first, uint32_t) {
        hold_group(member, first, substep, which);
    });
}

void BodyContactStep::hold_group(const BodyContactBatch& member, uint32_t first, uint32_t substep, Held which) {
    const BatchArrays& from = member.item.batch->arrays();
    const uint32_t count = std::min(lanes, member.count - first);
    // Copies: in the batch's arrays the last awake body can be followed by sleeping ones, or by none.
    BodyCopies<contact_lanes> copies;
    copies.take(from, count, [first](uint32_t i) { return first + i; });
    const BatchArrays arrays = copies.arrays();
    const auto& field = copies.field;
    alignas(64) LaneRow began_rows[pose_fields];
    for (size_t f = 0; f < pose_fields; ++f)
        copies.gather(
            before(member.first + first, f), [](uint32_t i) { return i; }, began_rows[f]);

    const ContactSubstep taken = contact_substep(time_, substep, began_rows);
    const InScratch<ContactGroup> in_scratch(member.run.step, member.item.batch->step, arrays, count);
    ContactGroup& group = *in_scratch;
    group.collect(taken);
    if (copies.has_floor) std::copy_n(copies.floor, count, from.floor + first);
    const uint32_t* const place = buffers_->place.data() + member.first + first;
    const auto touches = [&](uint32_t i) { return place_count_ != 0 && place[i] != none; };
    for (uint32_t i = 0; i < count && which == Held::apart; ++i)
        if (touches(i)) take_out(group, i, place[i]);
    group.solve(taken, wet_ ? buffers_->submerged.data() + member.first + first : nullptr);
    for (uint32_t i = 0; i < count; ++i) {
        if (which != Held::apart && !touches(i)) continue;
        hold_if_insane(arrays, i, member.item.batch->step.faults, [&](size_t f) { return began_rows[f][i]; });
        for (size_t f = 0; f < field_count && from.field[f]; ++f) from.field[f][first + i] = field[f][i];
    }
    for (uint32_t i = 0; i < count; ++i) {
        if (touches(i) != (which == Held::touching) || is_held(field[field_age_remainder][i])) continue;
        BodyAfter body = body_after(member.run, group, i, first + i, field, i, began_rows);
        const float fall = member.run.step.gravity * taken.h;
        const Vector v0 = vector_in(began_rows, field_vx, i), w0 = vector_in(began_rows, field_wx, i);
        const Vector v = vector_in(field, field_vx, i), w = vector_in(field, field_wx, i);
        float least = 0.0f;
        if (std::count(body.now, body.now + most_touches, touching_body) != 0) {
            for (uint32_t k = 0; k < group.contacts(i); ++k)
                if (const SlotContact s = group.contact(i, k); s.collider == sleeping_body)
                    least = std::min(least, s.gap);
            body.place = place_in_heap(body, least, *member.run.step.shape, field[field_scale][i], fall * taken.h);
            body.speed = lasting_speed(body, v0, w0, v, w, fall);
        }
        const bool carried = group.carried(i, body.moving);
        const Leaving leaves = leaving(member.run.step, vector_of(world_->gravity), member.run.book, body,
                                       pose_in(field, i), v0, w0, v, taken.h, carried);
        body.speed = speed_pushed(*member.item.batch, body, least, taken.h);
        enter_body(member.run.book, body, !carried && may_sleep(*member.run.step.settings), taken.h, last(substep),
                   [&](uint32_t collider) { return group.touch_with(i, collider, taken); });
        group.visit_asleep(i, [&](const ContactGroup::Asleep& other, const SlotContact& s, bool touched) {
            leaves.tell(*world_, other, touched, s.normal, s.gap);
        });
    }
}

// Extracts a body's contacts with fixed things, to be solved with the others.
void BodyContactStep::take_out(ContactGroup& group, uint32_t lane, uint32_t place) {
    BodyContactBuffers& c = *buffers_;
    const uint32_t count = group.contacts(lane), first = held_used_.fetch_add(count, std::memory_order_relaxed);
    c.first_held[place] = first;
    c.held_count[place] = count;
    for (uint32_t k = 0; k < count; ++k) {
        const SlotContact s = group.contact(lane, k);
        const bool solid = s.collider != sleeping_body;
        c.held[first + k] = {s.collider, solid ? ContactGroup::Asleep{} : group.at_rest(lane, k)};
        c.held_frames[first + k] = {s.normal, s.surface, s.lag, s.friction, s.restitution, solid};
        c.held_contacts[first + k] = {s.arm, {}, s.gap};
    }
    group.take_out(lane);
}

void BodyContactStep::fill_body(uint32_t place) {
    SolverBody& to = buffers_->solver.bodies()[place];
    const uint32_t body = buffers_->body_at[place];
    to = SolverBody{};
    to.scale = to.q[3] = to.q0[3] = 1.0f;
    if (body == none) return;
    const BodyContactBatch& member = member_of(body);
    const BatchArrays& a = member.item.batch->arrays();
    const uint32_t index = body - member.first;
    const auto take = [&](size_t field, float* now, float* then, size_t count) {
        for (size_t k = 0; k < count; ++k) {
            now[k] = a.field[field + k][index];
            then[k] = *before(body, field + k);
        }
    };
    take(field_x, to.x, to.x0, 3);
    take(field_qx, to.q, to.q0, 4);
    take(field_vx, to.v, to.v0, 3);
    take(field_wx, to.w, to.w0, 3);
    to.scale = a.field[field_scale][index];
}

// For each place in order: the body's contacts with fixed things, then the pairs that it has found, by the other body's place.
uint32_t BodyContactStep::list_units() {
    BodyContactBuffers& c = *buffers_;
    uint32_t used = 0;
    for (uint32_t place = 0; place < place_count_; ++place) {
        const uint32_t body = c.body_at[place];
        c.first_unit[place] = used;
        c.deepest[place] = no_contact;
        if (body == none) continue;
        const BodyContactFrame* const frames = c.held_frames.data() + c.first_held[place];
        const BodyContactPoint* const held = c.held_contacts.data() + c.first_held[place];
        for (uint32_t k = 0, count; k < c.held_count[place]; k += count) {
            count = 1;
            while (count < block_contacts && k + count < c.held_count[place] && one_frame(frames[k], frames[k + count]))
                ++count;
            c.units[used++] = {place, BodyContactPair::nobody, frames + k, held + k, count};
        }
        const uint32_t first = used;
        for (uint32_t i = c.first_pair[body]; i < c.first_pair[body + 1]; ++i) {
            const BodyContactBuffers::Pair& pair = c.pairs[i];
            if (pair.count == 0) continue;
            const uint32_t other = c.place[pair.b];
            uint32_t at = used++;
            for (; at > first && c.units[at - 1].b > other; --at) c.units[at] = c.units[at - 1];
            const BodyContactBuffers::PairContacts& contacts = c.pair_contacts[i];
            c.units[at] = {place, other, &contacts.frame, contacts.contact, pair.count, i};
        }
    }
    return used;
}

bool BodyContactStep::solve() {
    BodyContactBuffers& c = *buffers_;
    workers_.run(place_count_, 256, [&](uint32_t begin, uint32_t end) {
        for (uint32_t place = begin; place < end; ++place) fill_body(place);
    });
    if (!grow(world_->allocator, c.units, size_t{held_used_} + c.first_pair[body_count_]) ||
        !grow(world_->allocator, c.kinds, 2 * size_t{member_count_}) ||
        !grow(world_->allocator, c.ranges, 2 * size_t{member_count_}))
        return false;
    const uint32_t unit_count = unit_count_ = list_units();
    uint32_t ranges = 0;
    const auto first_place = [&](uint32_t kind) {
        return kind < 2 * member_count_ ? c.members[kind / 2].first_place[kind % 2] : place_count_;
    };
    for (uint32_t kind = 0; kind < 2 * member_count_; ++kind) {
        c.kinds[kind] = c.members[kind / 2].kind[kind % 2];
        const uint32_t begin = first_place(kind), end = first_place(kind + 1);
        if (begin < end) c.ranges[ranges++] = {kind, begin, end - begin};
    }
    const auto h = static_cast<float>(time_.h);
    const BodyContactScene scene{c.kinds.data(), c.ranges.data(), ranges,      c.units.data(),
                                 unit_count,     c.tile.data(),   tile_levels_};
    if (!c.solver.solve(*world_->target->body_contact, h, c.members[0].run.step.gravity, scene, workers_)) return false;
    for (const BodyContactPair& unit : std::span(scene.units, unit_count)) {
        if (unit.b == BodyContactPair::nobody) continue;
        for (uint32_t k = 0; k < unit.count; ++k)
            if (c.solver.pressed(unit, k) >= 0.0f)
                for (const uint32_t place : {unit.a, unit.b})
                    c.deepest[place] = std::min(c.deepest[place], unit.contact[k].gap);
    }
    return true;
}

// Marks bodies that a slow collider carries, if only through others. They must stay awake: one that falls asleep stays behind, however
// slowly the collider moves, and is a fixed thing that holds the others back.
void BodyContactStep::find_carried() {
    BodyContactBuffers& c = *buffers_;
    std::fill_n(c.tile.data(), place_count_, 0u);
    bool more = false;
    const auto carry = [&](const BodyContactPair& unit, uint32_t other) {
        for (uint32_t k = 0; k < unit.count; ++k)
            if (c.solver.pressed(unit, k) >= 0.0f) c.tile[unit.a] = c.tile[other] = 1, more = true;
    };
    const auto fast = [&](uint32_t place) {
        const ContactRun& run = member_of(c.body_at[place]).run;
        return trembling * run.still * std::sqrt(run.step.shape->reach * c.solver.bodies()[place].scale);
    };
    const std::span<const BodyContactPair> units(c.units.data(), unit_count_);
    for (const BodyContactPair& unit : units)
        if (unit.b == BodyContactPair::nobody && is_slow(unit.frame->surface, fast(unit.a))) carry(unit, unit.a);
    while (std::exchange(more, false))
        for (const BodyContactPair& unit : units)
            if (unit.b != BodyContactPair::nobody && c.tile[unit.a] != c.tile[unit.b]) carry(unit, unit.b);
}

template <class Function> void BodyContactStep::each_held(uint32_t place, const Function& function) const {
    const BodyContactBuffers& c = *buffers_;
    uint32_t k = 0;
    for (uint32_t u = c.first_unit[place]; k < c.held_count[place]; ++u)
        for (uint32_t i = 0; i < c.units[u].count; ++i) function(k++, c.solver.pressed(c.units[u], i));
}

Touch BodyContactStep::touch_with(uint32_t place, uint32_t collider) const {
    const BodyContactBuffers& c = *buffers_;
    const SolverBody& body = buffers_->solver.bodies()[place];
    TouchSum sum(collider, now(body), lr::began(body).rotation, vector_of(body.v0), vector_of(body.w0));
    each_held(place, [&](uint32_t k, float impulse) {
        const uint32_t at = c.first_held[place] + k;
        if (c.held[at].collider == collider)
            sum.take(impulse, c.held_contacts[at].arm_a, c.held_frames[at].normal, c.held_frames[at].surface);
    });
    const BodyContactBatch& member = member_of(c.body_at[place]);
    const float unit_mass = member.kind[wet(member, c.body_at[place])].body->unit_mass;
    return sum.touch(unit_mass * body.scale * body.scale * body.scale);
}

void BodyContactStep::put_back(uint32_t place, uint32_t substep) {
    const BodyContactBuffers& c = *buffers_;
    const uint32_t index_in_step = c.body_at[place];
    if (index_in_step == none) return;
    const BodyContactBatch& member = member_of(index_in_step);
    const uint32_t index = index_in_step - member.first;
    const BatchArrays& a = member.item.batch->arrays();
    SolverBody& from = buffers_->solver.bodies()[place];
    const auto give = [&](size_t field, const float* values, size_t count) {
        for (size_t k = 0; k < count; ++k) a.field[field + k][index] = values[k];
    };
    give(field_x, from.x, 3);
    give(field_qx, from.q, 4);
    give(field_vx, from.v, 3);
    give(field_wx, from.w, 3);
    if (hold_if_insane(a, index, member.item.batch->step.faults, [&](size_t f) { return *before(index_in_step, f); }))
        return;
    // Other bodies can press this one into or through thin things. Beyond a surface its centre of mass would count as on the other side.
    const Vector x = vector_of(from.x);
    const Vector back = way_back(member.run.step, from.scale, a.floor[index], nullptr, vector_of(from.x0), x,
                                 contact_substep(time_, substep, nullptr));
    lr::put(x + back, from.x);
    give(field_x, from.x, 3);
    BodyAfter body = body_moved(index, *member.run.step.shape, from.scale, member.run.still, vector_of(from.v),
                                vector_of(from.w), lr::began(from), now(from));
    const auto h = static_cast<float>(time_.h);
    const float fall = member.run.step.gravity * h;
    const Vector v0 = vector_of(from.v0), w0 = vector_of(from.w0), v = vector_of(from.v);
    body.speed = lasting_speed(body, v0, w0, v, vector_of(from.w), fall);
    body.still *= heap_still;
    TouchList touched;
    float least = c.deepest[place];
    bool bears = false; // a sleeping body may lie on it
    each_held(place, [&](uint32_t k, float impulse) {
        const uint32_t at = c.first_held[place] + k;
        const bool asleep = c.held[at].collider == sleeping_body;
        bears |= asleep;
        if (!(impulse >= 0.0f)) return;
        touched.take(c.held[at].collider + 1, impulse);
        if (!asleep) return;
        least = std::min(least, c.held_contacts[at].gap);
    });
    if (least < no_contact) body.place = place_in_heap(body, least, *member.run.step.shape, from.scale, fall * h);
    const bool carried = last(substep) && c.tile[place] != 0;
    if (bears) {
        const Leaving leaves = leaving(member.run.step, vector_of(world_->gravity), member.run.book, body, now(from),
                                       v0, w0, v, h, carried);
        each_held(place, [&](uint32_t k, float impulse) {
            const uint32_t at = c.first_held[place] + k;
            if (c.held[at].collider == sleeping_body)
                leaves.tell(*world_, c.held[at].at_rest, impulse >= 0.0f, c.held_frames[at].normal,
                            c.held_contacts[at].gap);
        });
    }
    if (c.deepest[place] < no_contact) touched.take(touching_body, 0.0f);
    std::copy_n(touched.id, most_touches, body.now);
    body.speed = speed_pushed(*member.item.batch, body, least, h);
    enter_body(member.run.book, body, !carried && may_sleep(*member.run.step.settings), h, last(substep),
               [&](uint32_t collider) { return touch_with(place, collider); });
}
} // namespace lr
