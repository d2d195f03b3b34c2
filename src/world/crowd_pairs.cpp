// Which bodies of a crowd touch each other in a substep.
#include "world/crowd_step.h"

#include "contact/pair_batch.h"
#include "kernel/faults.h"
#include "world/world.h"

#include <algorithm>
#include <cmath>

namespace lr {
namespace {

constexpr uint32_t grain = 128; // bodies: some ten microseconds

} // namespace

float CrowdStep::margin_of(const CrowdMember& member, uint32_t index) const {
    const BatchArrays& a = member.item.batch->arrays();
    return contact_margin(member.run.step.shape->reach * a.field[field_scale][index], pose_of(a, index).position,
                          member.run.step.gravity, static_cast<float>(time_.h));
}

void CrowdStep::set_box(const CrowdMember& member, uint32_t index) {
    const Batch& batch = *member.item.batch;
    const uint32_t body = member.first + index;
    const float scale = batch.arrays().field[field_scale][index], margin = margin_of(member, index);
    const Pose began_at = began(body), now = pose_of(batch.arrays(), index);
    crowd_->moved[body] = {pair_body(batch.meeting, scale, began_at, now), margin,
                           static_cast<uint32_t>(&member - crowd_->members.data())};
    const Box way = around(bounds(batch.meeting, scale, began_at), bounds(batch.meeting, scale, now));
    crowd_->grid.boxes()[body] = {grown(way, margin), body, 0, 0};
}

// Of a pair that both find it counts for the first by batch and key. Where callers give keys twice, it is the place that tells.
bool CrowdStep::finds(const MeetingBox& one, const MeetingBox& other, bool mutual) const {
    if (one.body == other.body) return false;
    const CrowdMember* const members = crowd_->members.data();
    const CrowdMember &a = members[crowd_->moved[one.body].member], &b = members[crowd_->moved[other.body].member];
    if (&a == &b ? !a.own : !world_->pairs.has(a.slot, b.slot)) return false;
    if (!mutual) return true;
    if (&a != &b) return a.slot < b.slot;
    const BatchArrays& arrays = a.item.batch->arrays();
    const uint32_t i = one.body - a.first, j = other.body - b.first;
    if (arrays.key[i] != arrays.key[j]) return arrays.key[i] < arrays.key[j];
    for (size_t f = field_x; f <= field_z; ++f)
        if (arrays.field[f][i] != arrays.field[f][j]) return arrays.field[f][i] < arrays.field[f][j];
    return i < j;
}

// In place of the last of a full list, if it comes before that by batch and key.
void CrowdStep::keep_first(uint32_t* seen, uint32_t body) const {
    const auto order = [&](uint32_t of) {
        const CrowdMember& member = member_of(of);
        return uint64_t{member.slot} << 32 | member.item.batch->arrays().key[of - member.first];
    };
    uint32_t* last = seen;
    for (uint32_t k = 1; k < Crowd::most_seen; ++k)
        if (order(seen[k]) > order(*last)) last = seen + k;
    if (order(body) < order(*last)) *last = body;
}

// The contacts of the pairs that bodies [begin, end), in the order of the grid, have found. Gaps are those that the substep begins
// with, so that what goes through each other within it is known by the side on which it began; those that stay open need not be held.
void CrowdStep::meet(uint32_t begin, uint32_t end) {
    Crowd& c = *crowd_;
    PairBatch batch(pair_search(world_->target->simd));
    const auto found = [&](uint32_t at, const WayContact* contacts, uint32_t count) {
        c.pairs[at].count = count;
        if (count != 0) enter_contacts(at, contacts);
    };
    // Bodies that are near each other lie far apart in memory.
    const auto fetch = [&c](uint32_t body) {
        const uint32_t count = c.first_pair[body + 1] - c.first_pair[body];
        const uint32_t* const seen = c.seen.data() + size_t{Crowd::most_seen} * body;
        for (uint32_t k = 0; k < count; ++k) {
            const Crowd::Moved* const other = c.moved.data() + seen[k];
            __builtin_prefetch(other);
            __builtin_prefetch(&other->margin);
        }
    };
    for (uint32_t i = begin; i < end; ++i) {
        const uint32_t body = c.grid.placed(i), first = c.first_pair[body], past = c.first_pair[body + 1];
        const Crowd::Moved& one = c.moved[body];
        const uint32_t* const seen = c.seen.data() + size_t{Crowd::most_seen} * body;
        if (i + 2 < end) fetch(c.grid.placed(i + 2));
        for (uint32_t at = first; at < past; ++at) {
            const Crowd::Moved& other = c.moved[seen[at - first]];
            c.pairs[at] = {body, seen[at - first], 0};
            batch.find(one.body, other.body, std::min(one.margin, other.margin), at, found);
        }
    }
    batch.finish(found);
}

void CrowdStep::enter_contacts(uint32_t at, const WayContact* found) {
    Crowd& c = *crowd_;
    const Crowd::Pair& pair = c.pairs[at];
    const ContactSettings& of_a = c.members[c.moved[pair.a].member].item.batch->contact;
    const ContactSettings& of_b = c.members[c.moved[pair.b].member].item.batch->contact;
    const float friction = pair_friction(of_a, of_b), restitution = pair_restitution(of_a, of_b);
    CrowdContact* const contacts = c.pair_contacts.data() + size_t{block_contacts} * at;
    for (uint32_t k = 0; k < pair.count; ++k) {
        const PairContact& contact = found[k].begin;
        contacts[k] = {contact.arm_a, contact.arm_b, contact.normal, contact.gap, {}, {}, friction, restitution, false};
    }
}

bool CrowdStep::find_pairs() {
    Crowd& c = *crowd_;
    Allocator& allocator = world_->allocator;
    if (!c.grid.reserve(allocator, body_count_) || !grow(allocator, c.moved, body_count_) ||
        !grow(allocator, c.first_pair, size_t{body_count_} + 1) ||
        !grow(allocator, c.seen, size_t{Crowd::most_seen} * body_count_))
        return false;
    workers_.run(body_count_, grain, [&](uint32_t begin, uint32_t end) {
        for (uint32_t body = begin; body < end; ++body) {
            const CrowdMember& member = member_of(body);
            const uint32_t index = body - member.first;
            if (index < member.count && !is_held(member.item.batch->arrays().field[field_age_rest][index])) {
                set_box(member, index);
            } else {
                // Padding and what is held meet nothing.
                c.grid.boxes()[body] = {{{1.0f, 1.0f, 1.0f}, {-1.0f, -1.0f, -1.0f}}, body, 0, 0};
            }
        }
    });
    c.grid.build(body_count_);
    std::fill_n(c.first_pair.data(), body_count_, 0u);
    workers_.run(c.grid.placed(), grain, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i) {
            const uint32_t body = c.grid.placed(i);
            const MeetingBox& one = c.grid.box(body);
            uint32_t count = 0;
            uint32_t* const seen = c.seen.data() + size_t{Crowd::most_seen} * body;
            c.grid.visit(one, [&](const MeetingBox& other, bool mutual) {
                if (!finds(one, other, mutual)) return;
                if (count < Crowd::most_seen)
                    seen[count++] = other.body;
                else
                    keep_first(seen, other.body);
            });
            c.first_pair[body] = count;
        }
    });
    uint32_t sum = 0;
    for (uint32_t body = 0; body < body_count_; ++body) {
        const uint32_t count = c.first_pair[body];
        c.first_pair[body] = sum;
        sum += count;
    }
    c.first_pair[body_count_] = sum;
    if (!grow(allocator, c.pairs, sum) || !grow(allocator, c.pair_contacts, size_t{block_contacts} * sum)) return false;
    workers_.run(c.grid.placed(), grain, [&](uint32_t begin, uint32_t end) { meet(begin, end); });
    return true;
}

// Those that touch another get places: batches one after the other, each in the order of keys and from a whole group of
// lanes on.
bool CrowdStep::number_touching() {
    constexpr auto lanes = static_cast<uint32_t>(contact_lanes);
    Crowd& c = *crowd_;
    Allocator& allocator = world_->allocator;
    if (!grow(allocator, c.place, body_count_) || !grow(allocator, c.order, body_count_)) return false;
    std::fill_n(c.place.data(), body_count_, none);
    const uint32_t pair_count = c.first_pair[body_count_];
    for (uint32_t i = 0; i < pair_count; ++i)
        if (c.pairs[i].count != 0) c.place[c.pairs[i].a] = c.place[c.pairs[i].b] = 0;
    uint32_t count = 0;
    for (uint32_t m = 0; m < member_count_; ++m) {
        CrowdMember& member = c.members[m];
        count = (count + lanes - 1) / lanes * lanes;
        member.first_place = count;
        for (uint32_t i = 0; i < member.count; ++i)
            if (c.place[member.first + i] == 0) ++count;
    }
    const uint32_t padded = (count + lanes - 1) / lanes * lanes;
    if (padded == 0) return true;
    if (!grow(allocator, c.body_at, padded) || !grow(allocator, c.first_held, padded) ||
        !grow(allocator, c.held_count, padded) || !grow(allocator, c.first_unit, padded) ||
        !grow(allocator, c.touches_body, padded) || !grow(allocator, c.held, size_t{contact_slots} * padded) ||
        !grow(allocator, c.held_contacts, size_t{contact_slots} * padded) ||
        !grow(allocator, c.units, size_t{contact_slots / block_contacts} * padded + pair_count) ||
        !c.solver.reserve_bodies(padded)) {
        std::fill_n(c.place.data(), body_count_, none);
        return false;
    }
    std::fill_n(c.body_at.data(), padded, none);
    for (uint32_t m = 0; m < member_count_; ++m) {
        const CrowdMember& member = c.members[m];
        const uint32_t* const key = member.item.batch->arrays().key;
        uint32_t found = 0;
        for (uint32_t i = 0; i < member.count; ++i)
            if (c.place[member.first + i] == 0) c.order[found++] = uint64_t{key[i]} << 32 | (member.first + i);
        std::sort(c.order.data(), c.order.data() + found);
        for (uint32_t i = 0; i < found; ++i) {
            const auto body = static_cast<uint32_t>(c.order[i]);
            c.place[body] = member.first_place + i;
            c.body_at[member.first_place + i] = body;
        }
    }
    place_count_ = padded;
    held_used_ = 0;
    return true;
}

} // namespace lr
