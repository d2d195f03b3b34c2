// Bodies near colliders: which they are, what they touch after a substep, and what comes of it.
#pragma once

#include "contact/body_shape.h"
#include "contact/colliders.h"
#include "contact/pose_rows.h"
#include "contact/resting_bodies.h"
#include "kernel/contact.h"
#include "kernel/wind.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lr {

// How the bodies of a batch meet colliders.
struct ContactSettings {
    uint32_t layers = 0xffffffffu;
    float friction = 0.5f, restitution = 0.1f;
    float rolling = 0.05f; // of the geometric mean of reach and half thickness
    float ground_effect = 0.0f;
    bool may_rest = true;
    bool operator==(const ContactSettings&) const = default;
};
// Geometric mean and the larger: a pair slips as its materials do together, and bounces as the springier one. Of a batch and a
// collider, or of two batches.
template <class Other> float pair_friction(const ContactSettings& a, const Other& b) {
    return std::sqrt(a.friction * b.friction);
}
template <class Other> float pair_restitution(const ContactSettings& a, const Other& b) {
    return std::max(a.restitution, b.restitution);
}
// Null when fine, else what is wrong; NaN is.
const char* wrong_in(const ContactSettings& settings);

// The same as a part of the reach: ContactBodies::rolling.
float rolling_of(const ContactSettings& settings, const BodyShape& shape);

// Of a batch in a step.
struct ContactStep {
    const ContactTarget* target;
    const Colliders* colliders;
    const BodyShape* shape;
    const ContactSettings* settings;
    float gravity;                          // m/s^2, magnitude
    float fluid_density;                    // kg/m^3
    float dt;                               // s, of the step
    float gain;                             // m/s that bodies may gain in it beside what they have
    const RestingBodies* resting = nullptr; // that they meet; null: none
};

static_assert(most_shape_samples == most_ground_points);

// Where a collider is at a part of the step, 0 to 1.
Pose pose_at(const Collider& collider, float part);

// How a collider gets to where it is at the end of a substep of h.
struct SurfaceMotion {
    Vector middle;         // m, its frame's origin, at the end
    Vector velocity, spin; // m/s, mean of the origin; 2 sin(angle/2)/h about the axis
    float h;
    Vector velocity_at(Vector point) const; // of what is there at the end
    // Its way less h times that: along the chord and not along the end's tangent, by which all that it carries would go inwards.
    Vector lag_at(Vector point) const;
};
SurfaceMotion motion_of(const Collider& collider, float begin, float end, float h); // begin, end: parts of the step

// m, of a body at x: half a hundredth of it, what it falls in a substep, and what its position is rounded to. As in the kernel.
inline float contact_margin(float reach, Vector x, float gravity, float h) {
    const float far = std::max(std::abs(x.x), std::max(std::abs(x.y), std::abs(x.z)));
    return 0.005f * reach + 1e-6f * far + gravity * h * h;
}

// A contact of one body as its slot has it.
struct SlotContact {
    Vector arm, normal, surface, lag;
    float gap, friction, restitution;
    uint32_t collider;
};
inline SlotContact contact_in(const ContactSlots::Slot& s, uint32_t lane) {
    return {vector_in(s.arm, 0, lane),
            vector_in(s.normal, 0, lane),
            vector_in(s.surface, 0, lane),
            vector_in(s.lag, 0, lane),
            s.gap[lane],
            s.friction[lane],
            s.restitution[lane],
            s.collider[lane]};
}

// How a body met a collider.
struct Touch {
    uint32_t collider; // slot + 1; 0: none
    float position[3], normal[3];
    float speed, impulse; // m/s, N s
};

// Its contacts with a collider together: where the strongest is, and the impulse of all.
class TouchSum {
public:
    // The body at the end of a substep; then, v, w: its rotation and velocities as that began.
    TouchSum(uint32_t collider, const Pose& now, Rotation then, Vector v, Vector w)
        : now_(now), then_(then), v_(v), w_(w), touch_{collider + 1, {}, {}, 0.0f, 0.0f} {}
    void take(float impulse, Vector arm, Vector normal, Vector surface);
    Touch touch(float unit_mass) const;

private:
    Pose now_;
    Rotation then_;
    Vector v_, w_;
    float strongest_ = -1.0f;
    Touch touch_;
};

// What a body touches, the strongest first as far as there is room: colliders by slot + 1, bodies at rest by a_body + 1.
struct TouchList {
    uint32_t id[4] = {};
    float strength[4] = {-1.0f, -1.0f, -1.0f, -1.0f};
    void take(uint32_t one, float impulse);
};

// Up to contact_lanes bodies that may touch something, through a step.
class ContactGroup {
public:
    // bodies: in arrays of contact_lanes, of which the first `count` are bodies and the rest copies of the last.
    ContactGroup(const ContactStep& step, const BodyConstants& body, const BatchArrays& arrays, uint32_t count);

    // After a substep from `begin` to `end`, parts of the step, 0 to 1; h: s, its length. before: fields of the bodies from
    // field_x on, as they were before it.
    void resolve(const LaneRow (&before)[pose_fields], float begin, float end, float h);

    // The same in two parts. Between them contacts of single bodies can be taken out, to be solved with others'.
    void collect(const LaneRow (&before)[pose_fields], float begin, float end, float h);
    void solve(const LaneRow (&before)[pose_fields], float h);
    uint32_t contacts(uint32_t lane) const { return filled_[lane]; }
    SlotContact contact(uint32_t lane, uint32_t k) const { return contact_in(slots_.slot[k], lane); }
    void take_out(uint32_t lane);

    // The body at rest that a contact is with, whose collider is then `a_body`.
    struct AtRest {
        uint32_t batch, index;
    };
    static constexpr uint32_t a_body = UINT32_MAX - 1;
    AtRest at_rest(uint32_t lane, uint32_t k) const { return at_rest_[k][lane]; }
    // Of those that the body touched in the last substep.
    template <class Function> void visit_at_rest(uint32_t lane, Function&& function) const {
        for (uint32_t k = 0; k < filled_[lane] && touches_[lane]; ++k)
            if (slots_.slot[k].collider[lane] == a_body && slots_.slot[k].impulse[lane] >= 0.0f)
                function(at_rest_[k][lane]);
    }

    // Of the last substep: the strongest contacts' colliders of a body, slot + 1 each, 0 behind the last; strongest first.
    void touched(uint32_t lane, uint32_t (&out)[4]) const;
    // With one of them, in the last substep: at its strongest contact, and the impulse of all. before: as for resolve().
    Touch meeting(uint32_t lane, uint32_t collider, const LaneRow (&before)[pose_fields]) const;
    bool touches(uint32_t lane) const { return touches_[lane]; }

private:
    // Of more than there is room for, grounds alone: the others are asked for again and again, a list at a time.
    struct Near {
        uint32_t count;
        bool crowded;
        Candidate candidate[most_candidates];
    };
    template <class Found> void each_candidate(uint32_t lane, const Box& around, Found&& found) const;
    template <class Found> void any_order(uint32_t lane, const Box& around, Found&& found) const;
    ContactBodies bodies(const LaneRow (&before)[pose_fields], float h) const;
    void press_air(const LaneRow (&before)[pose_fields], float begin, float end);
    void clip(const LaneRow (&before)[pose_fields], float begin, float end, float h);
    void touch_grounds(const ContactBodies& bodies, float begin, float end, float h);
    void touch_others(uint32_t lane, float begin, float end, float h);
    void touch_resting(uint32_t lane, const LaneRow (&before)[pose_fields], float h);
    uint32_t put(uint32_t lane, const SlotContact& contact);
    void add(uint32_t lane, uint32_t collider, const Contact& contact, const Pose& pose, const SurfaceMotion& motion);
    uint32_t place(uint32_t lane, float gap);
    Pose pose_of(uint32_t lane) const { return pose_in(arrays_.field, lane); }
    float margin_of(uint32_t lane, float h) const;

    const ContactStep* step_;
    const BodyConstants* body_;
    BatchArrays arrays_;
    uint32_t count_;
    uint32_t ground_count_ = 0;
    uint32_t grounds_[contact_lanes * most_candidates]; // room for all: none may be left out for the company's sake
    uint8_t filled_[contact_lanes];
    bool touches_[contact_lanes];
    Near near_[contact_lanes];
    AtRest at_rest_[contact_slots][contact_lanes];
    ContactSlots slots_;
};

// Those whose boxes, over all of the step, reach into the box, in order of slots and parts; of a body that is not crowded all that
// are near it in the step.
template <class Found> void ContactGroup::each_candidate(uint32_t i, const Box& around, Found&& found) const {
    const Near& near = near_[i];
    if (!near.crowded) {
        for (uint32_t k = 0; k < near.count; ++k) found(near.candidate[k]);
        return;
    }
    Candidate list[most_candidates], last{};
    bool more = true;
    for (const Candidate* after = nullptr; more; after = &last) {
        const uint32_t count = step_->colliders->candidates(around, step_->settings->layers, after, list, more);
        for (uint32_t k = 0; k < count; ++k) found(list[k]);
        if (more) last = list[count - 1];
    }
}

// The same in any order: of a long way among very many they are not sorted.
template <class Found> void ContactGroup::any_order(uint32_t i, const Box& around, Found&& found) const {
    if (near_[i].crowded)
        step_->colliders->visit(around, step_->settings->layers, found);
    else
        each_candidate(i, around, found);
}

// Of [begin, end), up to near_range and as far as there is room for field_block of them, which field_block bodies always have:
// the bodies that may touch something within `dt`. Over a longer range few of them fill more of a group's lanes.
class NearContacts {
public:
    static constexpr uint32_t near_range = 16 * field_block;
    NearContacts(const ContactStep& step, const BatchArrays& arrays, uint32_t live, uint32_t begin, uint32_t end,
                 float dt);
    uint32_t end() const { return end_; } // of the bodies that were looked at
    uint32_t count() const { return count_; }
    uint32_t index(uint32_t i) const { return index_[i]; }
    bool holds(uint32_t body) const { return near_[body - begin_] != 0; }
    // By the class of each, less than `classes`, and then by index: alike ones share vectors, which are done with the last of their lanes.
    template <class Class> void arrange(uint32_t classes, Class&& class_of) {
        uint32_t sorted[field_block], at = 0;
        for (uint32_t c = 0; c < classes; ++c)
            for (uint32_t i = 0; i < count_; ++i)
                if (class_of(index_[i]) == c) sorted[at++] = index_[i];
        std::copy_n(sorted, count_, index_);
    }
    // Is there a body in this lane block that is not among them?
    bool others(uint32_t begin) const;

private:
    uint32_t begin_, end_, live_, count_ = 0;
    alignas(64) uint32_t near_[near_range];
    uint32_t index_[field_block];
};

} // namespace lr
