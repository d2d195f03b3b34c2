#include "world/sleep/sleeping_bodies.h"

#include "collision/pair_contacts.h"
#include "kernel/limits.h"
#include "world/world.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace lr {
namespace {

// From this age on rounding is carried along, as the kernel does for awake bodies.
constexpr float plain_age = 2.0f; // s
constexpr double never = std::numeric_limits<double>::infinity();
constexpr double slack = 200.0; // s: bound of an age's rounding error

struct Neighbour {
    uint32_t batch, noise_seed, index;
    bool operator<(const Neighbour& other) const {
        return std::tie(batch, noise_seed, index) < std::tie(other.batch, other.noise_seed, other.index);
    }
};

bool equal(Vector a, Vector b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

// The first most_sleeping by batch and noise seed, each once, whatever the order of insertion.
struct Neighbours {
    Neighbour found[most_sleeping];
    uint32_t count = 0;

    void take(const Neighbour& one) {
        uint32_t at = count;
        while (at > 0 && one < found[at - 1]) --at;
        if (at > 0 && !(found[at - 1] < one)) return;
        if (at == most_sleeping) return;
        count = std::min(count + 1, most_sleeping);
        for (uint32_t i = count - 1; i > at; --i) found[i] = found[i - 1];
        found[at] = one;
    }
};
} // namespace

bool withstands(Vector held, Vector wind) {
    const float squared = dot(held, held), along = dot(held, wind);
    if (!(squared > 0.0f)) return dot(wind, wind) == 0.0f;
    if (along < 0.0f || along > 1.1f * squared) return false;
    const Vector across = wind - along / squared * held;
    return dot(across, across) <= 0.02f * squared;
}

bool SleepingBodies::allocate(Allocator& allocator, uint32_t capacity, double reach, uint32_t phase, double* births) {
    if (!boxes_.allocate(allocator, capacity) || !grid.create(allocator, capacity, reach)) return false;
    phase_ = phase % rule_steps;
    births_ = births;
    for (uint32_t slot = 0; slot < capacity; ++slot) forget_box(slot);
    begin();
    return true;
}

void SleepingBodies::begin() {
    state_ = {};
    state_.steps = phase_;
    sheltered_ = 0;
    earliest_ = never;
}

void SleepingBodies::forget_box(uint32_t slot) {
    boxes_[slot].low.x = std::numeric_limits<float>::quiet_NaN();
}

void SleepingBodies::enter(uint32_t index, uint32_t slot, Vector position, float scale) {
    state_.tried = 0;
    earliest_ = std::min(earliest_, births_[index]);
    grid.insert(slot, position, scale);
}

void SleepingBodies::age_of(uint32_t index, float& age, float& age_remainder) const {
    const double exact = std::clamp(state_.clock - births_[index], 0.0, wide(most_age));
    age = static_cast<float>(exact);
    age_remainder = age >= plain_age ? static_cast<float>(wide(age) - exact) : 0.0f;
}

bool SleepingBodies::pass(double seconds, uint32_t steps) {
    state_.clock += seconds;
    state_.steps += steps;
    if (state_.steps < rule_steps) return false;
    state_.steps %= rule_steps;
    return true;
}

bool SleepingBodies::withstood(const float (&wind)[3]) {
    const float(&held)[3] = state_.wind;
    if (!withstands({held[0], held[1], held[2]}, {wind[0], wind[1], wind[2]})) {
        state_.tried = 0;
        std::copy(wind, wind + 3, state_.wind);
    }
    if (state_.tried == rule_steps) return true;
    ++state_.tried;
    return false;
}

// The oldest body decides; its age is rounded as the rules will see it. A needless yes only costs time.
bool SleepingBodies::in_question(float max_age) const {
    return state_.unjudged != 0 || (max_age > 0.0f && static_cast<float>(state_.clock - earliest_) >= max_age);
}

void SleepingBodies::answered(uint32_t begin, uint32_t end, float max_age) {
    state_.unjudged = 0;
    earliest_ = never;
    for (uint32_t i = begin; i < end; ++i) {
        const bool stays = max_age <= 0.0f || static_cast<float>(state_.clock - births_[i]) < max_age;
        if (stays) earliest_ = std::min(earliest_, births_[i]);
    }
}

bool SleepingBodies::consistent(const State& s) {
    return s.steps < rule_steps && s.unjudged <= 1 && s.tried <= rule_steps && in_range(s.clock, 0.0, most_time) &&
           !wrong_wind(s.wind);
}

bool SleepingBodies::consistent(const State& s, double birth) {
    return in_range(birth, -(wide(most_age) + slack), s.clock + slack);
}

SleepingNeighbours::SleepingNeighbours(const lr_world& world, uint32_t slot, float nearer)
    : world_(&world), slot_(slot), nearer_(nearer) {
    world.pairs.visit_partners(slot, [&](uint32_t other) {
        const Batch& batch = *world.batches[other].batch;
        any_ = any_ || batch.awake() < batch.count();
    });
}

uint32_t SleepingNeighbours::touched_by(uint32_t noise_seed, float scale, const Pose& from, const Pose& to,
                                        float margin, SleepingTouch (&out)[most_sleeping]) const {
    const Batch& own = *world_->batches[slot_].batch;
    const PairBody moving = pair_body(own.pair_hull(), scale, from, to);
    // Between its ends a turning body reaches out of their boxes by at most r (1 - cos(a/2)) <= (2 r sin(a/2))^2/(4 r).
    const float bulge = 0.25f * moving.turns * moving.turns / moving.reach();
    const Box box =
        grown(around(bounds(own.pair_hull(), scale, from), bounds(own.pair_hull(), scale, to)), margin + bulge);
    // In a heap the boxes of dozens of bodies overlap the path's. Only those that can touch are counted.
    Neighbours near;
    Neighbour waiting[search_lanes];
    PlacedBox boxes[search_lanes + 1]; // the body's own is the last
    boxes[search_lanes] = placed_box(moving, margin);
    uint32_t waiting_count = 0;
    const auto body_of = [&](const Neighbour& one) {
        const Batch& batch = *world_->batches[one.batch].batch;
        const Pose pose = pose_of(batch.arrays(), one.index);
        return PairBody{&batch.pair_hull(), batch.arrays().field[field_scale][one.index], pose, pose, {}, 0.0f};
    };
    const auto take_near = [&] {
        uint32_t met[search_lanes];
        std::iota(met, met + waiting_count, 0u);
        const uint32_t met_count = world_->target->near_boxes(boxes, search_lanes, met, waiting_count);
        for (uint32_t k = 0; k < met_count; ++k) near.take(waiting[met[k]]);
        waiting_count = 0;
    };
    world_->pairs.visit_partners(slot_, [&](uint32_t other) {
        const Batch& batch = *world_->batches[other].batch;
        batch.visit_sleeping(box, [&](uint32_t index) {
            const uint32_t its = batch.arrays().noise_seed[index];
            // The copy in a trial must not touch its original.
            if (other == slot_ && its == noise_seed && equal(pose_of(batch.arrays(), index).position, from.position))
                return;
            waiting[waiting_count] = {other, its, index};
            boxes[waiting_count] = placed_box(body_of(waiting[waiting_count]), margin);
            if (++waiting_count == search_lanes) take_near();
        });
    });
    take_near();
    PairBody others[most_sleeping];
    PairBatch pairs(world_->target->search_pairs);
    const auto found = [&](uint32_t n, const WayContact* contacts, uint32_t count, const Manifold&) {
        out[n].count = count;
        for (uint32_t k = 0; k < count; ++k) {
            out[n].contact[k] = contacts[k].begin;
            out[n].contact[k].arm_a = contacts[k].end_a;
            out[n].contact[k].gap = contacts[k].end - nearer_ * moving.reach();
        }
    };
    for (uint32_t n = 0; n < near.count; ++n) {
        others[n] = body_of(near.found[n]);
        pairs.find(moving, others[n], margin, 0.0f, n, found);
    }
    pairs.finish(found);
    uint32_t count = 0;
    for (uint32_t n = 0; n < near.count; ++n) {
        if (out[n].count == 0) continue;
        if (n != count) out[count] = out[n];
        SleepingTouch& touch = out[count++];
        const Batch& batch = *world_->batches[near.found[n].batch].batch;
        touch.batch = near.found[n].batch;
        touch.index = near.found[n].index;
        touch.friction = pair_friction(own.contact(), batch.contact());
        touch.restitution = pair_restitution(own.contact(), batch.contact());
    }
    return count;
}
} // namespace lr
