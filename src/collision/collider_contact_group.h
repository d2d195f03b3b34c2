// Bodies near colliders, in groups of lanes: finds their contacts after a substep and solves them.
#pragma once

#include "base/pose.h"
#include "collision/body_narrow_phase.h"
#include "collision/collider_narrow_phase.h"
#include "collision/colliders.h"
#include "collision/mesh_floor.h"
#include "kernel/contact/collider_contact.h"
#include "kernel/integrator/step.h"
#include "kernel/wind/sample_wind.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace lr {

// A batch's contact settings until its user sets others.
inline constexpr lr_batch_contact initial_contact = LR_BATCH_CONTACT_INIT;
inline bool may_sleep(const lr_batch_contact& settings) {
    return (settings.flags & LR_CONTACT_NEVER_SLEEP) == 0;
}
// Friction is the geometric mean of both materials, restitution the larger: the springier material decides a bounce.
template <class Other> float pair_friction(const lr_batch_contact& a, const Other& b) {
    return std::sqrt(a.friction * b.friction);
}
template <class Other> float pair_restitution(const lr_batch_contact& a, const Other& b) {
    return std::max(a.restitution, b.restitution);
}
// Null if the settings are valid, else the reason; NaN is invalid.
const char* wrong_in(const lr_batch_contact& settings);

// Rolling resistance times its lever, as a share of the reach: ContactBodies::rolling.
float rolling_of(const lr_batch_contact& settings, const BodyShape& shape);

// Awake bodies meet sleeping ones as fixed things.
inline constexpr uint32_t most_sleeping = 32; // that one body can touch, by batch and noise seed

struct SleepingTouch {
    uint32_t batch, index; // of the sleeping body: batch slot and dense index
    float friction, restitution;
    uint32_t count;
    PairContact contact[most_pair_contacts]; // a: the awake body; its arms and the gaps at the end of the substep
};

class SleepingContacts {
public:
    // Finds sleeping bodies that touch the body with this noise seed at `to`, or are within `margin` (m). Returns their number. Any thread.
    virtual uint32_t touched_by(uint32_t noise_seed, float scale, const Pose& from, const Pose& to, float margin,
                                SleepingTouch (&out)[most_sleeping]) const = 0;

protected:
    SleepingContacts() = default;
    SleepingContacts(const SleepingContacts&) = default;
    SleepingContacts& operator=(const SleepingContacts&) = default;
    ~SleepingContacts() = default;
};

struct ContactStep {
    const ContactTarget* target;
    const Colliders* colliders;
    const BodyShape* shape;
    const lr_batch_contact* settings;
    Vector weight;                              // m/s^2, gravity
    float gravity;                              // m/s^2, its magnitude
    float fluid_density;                        // kg/m^3
    float dt;                                   // s, length of the step
    float gain;                                 // m/s: allowance for speed gained in it
    const SleepingContacts* sleeping = nullptr; // sleeping bodies in reach; null: none
};

static_assert(most_shape_samples == most_ground_points);

// The pose of a collider at a fraction of the step, 0 to 1.
Pose pose_at(const Collider& collider, float part);

struct ContactSubstep {
    const LaneRow* before; // field_x and following, before the substep
    float begin, end;      // fractions of the step, 0 to 1
    float h;               // s, its length
};

// The motion of a collider over a substep of h.
struct SurfaceMotion {
    Vector middle;         // m: origin of its frame at the end
    Vector velocity, spin; // m/s, mean of the origin; 2 sin(angle/2)/h about the axis
    float h;
    Vector velocity_at(Vector point) const; // of the material point at this place at the end
    // Displacement less h times the end velocity: a point moves along the chord, and the tangent at the end would carry bodies inwards.
    Vector lag_at(Vector point) const;
};
SurfaceMotion motion_of(const Collider& collider, const ContactSubstep& substep);

// m, for a body at x: 0.005 of its reach, its fall in a substep, and the rounding of its position. As in the kernel.
inline float contact_margin(float reach, Vector x, float gravity, float h) {
    const float far = std::max(std::abs(x.x), std::max(std::abs(x.y), std::abs(x.z)));
    return 0.005f * reach + 1e-6f * far + gravity * h * h;
}

// A contact of one body, as stored in its slot.
struct SlotContact {
    Vector arm, normal, surface, lag;
    float gap, friction, restitution;
    uint32_t collider;
};
inline SlotContact contact_in(const ContactSlots::Slot& s, uint32_t lane) {
    SlotContact c{{}, {}, {}, {}, s.gap[lane], s.friction[lane], s.restitution[lane], s.collider[lane]};
    c.arm = vector_in(s.arm, 0, lane), c.normal = vector_in(s.normal, 0, lane);
    c.surface = vector_in(s.surface, 0, lane), c.lag = vector_in(s.lag, 0, lane);
    return c;
}

// Whether a support moves, but so slowly that its speed alone would not keep a body awake.
inline bool is_slow(Vector surface, float fast) {
    const float square = dot(surface, surface);
    return square > 0.0f && square <= fast * fast;
}

// The touch of a body and a collider, for events.
struct Touch {
    uint32_t collider; // slot + 1; 0: none
    float position[3], normal[3];
    float speed, impulse; // m/s, N s
};

// Sums a body's contacts with one collider: the place of the strongest, the impulse of all.
class TouchSum {
public:
    // now: pose at the end of the substep; then, v, w: rotation and velocities at its beginning.
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

// Things that a body touches, strongest first: colliders by slot + 1, sleeping bodies by sleeping_body + 1. The weakest are dropped.
struct TouchList {
    uint32_t id[4] = {};
    float strength[4] = {-1.0f, -1.0f, -1.0f, -1.0f};
    void take(uint32_t one, float impulse);
};

// The side of a mesh that the body is on, world frame; zero: unknown. packed: of column_floor.
Vector floor_side(uint32_t packed, uint32_t slot);

// Height above a plane or heightfield in its own frame; negative where there is no ground.
float height_over(const Geometry& ground, Vector at);

// The displacement that puts a centre of mass back in front of what it entered or crossed between `from` and `to` (m, world); zero if nothing.
// floor: of column_floor. even: the floor that pushes the body out by itself, and does not count; null: none.
Vector way_back(const ContactStep& step, float scale, uint32_t floor, const MeshFloor* even, Vector from, Vector to,
                const ContactSubstep& substep);

// Takes up to contact_lanes bodies near colliders through a step.
class ContactGroup {
public:
    // The arrays have contact_lanes bodies: the first `count` are real, the rest copies of the last.
    ContactGroup(const ContactStep& step, const StepInput& in, const BatchArrays& arrays, uint32_t count);

    // After a substep, in two parts. In between a body's contacts can be taken out, to be solved together with other bodies'.
    void collect(const ContactSubstep& substep);
    // submerged: share of each body in water; null: all are dry.
    void solve(const ContactSubstep& substep, const float* submerged);
    uint32_t contacts(uint32_t lane) const { return filled_[lane]; }
    SlotContact contact(uint32_t lane, uint32_t k) const { return contact_in(slots_.slot[k], lane); }
    float least_gap(uint32_t lane) const; // m, before they were solved; no_contact without any
    void take_out(uint32_t lane);

    // The sleeping body of a contact, whose collider is then `sleeping_body`.
    struct Asleep {
        uint32_t batch, index;
    };
    Asleep at_rest(uint32_t lane, uint32_t k) const { return at_rest_[k][lane]; }
    // Calls function(sleeping body, contact, whether they touched) for contacts with sleeping bodies in the last substep.
    template <class Function> void visit_asleep(uint32_t lane, Function&& function) const {
        for (uint32_t k = 0; k < filled_[lane]; ++k)
            if (slots_.slot[k].collider[lane] == sleeping_body)
                function(at_rest_[k][lane], contact(lane, k), slots_.slot[k].impulse[lane] >= 0.0f);
    }

    // Colliders of a body's strongest contacts in the last substep: slot + 1 each, strongest first, 0 after the last.
    void touched(uint32_t lane, uint32_t (&out)[4]) const;
    // Whether a touching collider carries the body along slower than `fast` (m/s).
    bool carried(uint32_t lane, float fast) const;
    // The touch with such a collider in that substep: the place of the strongest contact, the impulse of all.
    Touch touch_with(uint32_t lane, uint32_t collider, const ContactSubstep& substep) const;
    // m/s^2: acceleration of its fall from rest in the fluid around it.
    float fall(uint32_t lane) const { return step_->gravity * (wet_[lane] ? water_->fall : 1.0f); }

private:
    // Candidates in a box: that of the step, or, among many things, the part of it that a substep needs. A list that overflows keeps only planes and
    // heightfields; the others are searched when they are asked for, a list at a time.
    struct Near {
        Box of_step, box;
        uint32_t count;
        bool among_many, overflowed;
        // Bits of candidates: planes and heightfields; all others; those of them that the body can meet in this substep.
        uint64_t grounds, finite, others;
        Candidate candidate[most_candidates];
        bool meets_others() const { return overflowed || others != 0; }
        bool lists(const Box& around) const { return !overflowed && contains(box, around); }
        // Whether a path meets nothing but this collider.
        bool only(uint32_t slot, const Box& path) const {
            return lists(path) && count > 0 && candidate[0].slot == slot && candidate[count - 1].slot == slot;
        }
    };
    static constexpr uint32_t among_few = 16; // testing as many costs as much as a search
    void list_near(Near& near) const;         // what is in its box
    void find_others(const ContactSubstep& substep);
    template <class Found> void each_candidate(uint32_t lane, const Box& around, Found&& found) const;
    template <class Found> void any_order(uint32_t lane, const Box& around, Found&& found) const;
    ContactBodies bodies(const ContactSubstep& substep) const;
    void resolve(const ContactSubstep& substep);
    void ground_effect(const ContactSubstep& substep);
    void find_floors(const ContactSubstep& substep);
    std::optional<FlatSide> side_below(uint32_t lane, const Collider& collider, const Pose& at,
                                       const ContactSubstep& substep, bool& fast) const;
    Vector lift(uint32_t lane, const Pose& at, float part, const ContactSubstep& substep, Vector& slow) const;
    Pose lifted_start(uint32_t lane, const ContactSubstep& substep) const;
    void leave_floors(const ContactSubstep& substep);
    void stay_in_front(const ContactSubstep& substep);
    void stop_before_passing_through(const ContactSubstep& substep);
    GroundSurface surface_of(uint32_t slot, const ContactSubstep& substep) const;
    void touch_grounds(const ContactSubstep& substep);
    void touch_floors(const ContactSubstep& substep);
    // The normal, on its side and in the world frame, of the mesh's triangle that the body's centre of mass was over as the substep began; 0: of none.
    Vector face_below(uint32_t lane, const ContactSubstep& substep) const;
    void touch_others(uint32_t lane, const ContactSubstep& substep);
    void touch_sleeping(uint32_t lane, const ContactSubstep& substep);
    uint32_t put(uint32_t lane, const SlotContact& contact);
    // Contacts with one collider, given in its frame at the end of the substep, of a body seen higher by `lifted`.
    void add(uint32_t lane, uint32_t collider, const Contact* contacts, uint32_t count, const ContactSubstep& substep,
             Vector lifted = {});
    uint32_t place(uint32_t lane, const SlotContact& contact);
    Pose pose_of(uint32_t lane) const { return pose_in(arrays_.field, lane); }
    float margin_of(uint32_t lane, float h) const;

    const ContactStep* step_;
    const BodyConstants* body_;
    const WaterBody* water_; // null without water
    BatchArrays arrays_;
    uint32_t count_;
    uint32_t ground_count_ = 0;
    uint32_t grounds_[contact_lanes * most_candidates]; // room for all: one body's must not displace another's
    uint8_t filled_[contact_lanes];
    bool wet_[contact_lanes] = {}; // carries the water's added mass
    Near near_[contact_lanes];
    MeshFloor floor_[contact_lanes]; // of this substep
    // m: takes a body out of all that supports it, and of what it is not swept over, before it meets other things.
    Vector up_[contact_lanes], lift_[contact_lanes];
    Asleep at_rest_[contact_slots][contact_lanes];
    ContactSlots slots_;
};

// Calls found for candidates whose box, over the whole step, overlaps `around`, in order of slots and parts; with a complete list, for those that
// the body can meet in the substep.
template <class Found> void ContactGroup::each_candidate(uint32_t i, const Box& around, Found&& found) const {
    const Near& near = near_[i];
    if (near.lists(around)) {
        for (uint64_t left = near.grounds | near.others; left != 0; left &= left - 1)
            found(near.candidate[std::countr_zero(left)]);
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

// The same in any order: sorting would be slow on a long path among very many.
template <class Found> void ContactGroup::any_order(uint32_t i, const Box& around, Found&& found) const {
    if (!near_[i].lists(around))
        step_->colliders->visit(around, step_->settings->layers, found);
    else
        each_candidate(i, around, found);
}

// Bodies of [begin, end) that can touch something within `dt`. Stops after near_range bodies, or once field_block are found.
class NearContacts {
public:
    static constexpr uint32_t near_range = 16 * field_block;
    NearContacts(const ContactStep& step, const BatchArrays& arrays, uint32_t live, uint32_t begin, uint32_t end,
                 float dt);
    uint32_t end() const { return end_; } // of the bodies examined
    uint32_t count() const { return count_; }
    uint32_t index(uint32_t i) const { return index_[i]; }
    bool holds(uint32_t body) const { return near_[body - begin_] != 0; }
    bool near_finite(uint32_t body) const { return (near_[body - begin_] & near_bits) != 0; } // or not known
    bool over_ground(uint32_t body) const { return (near_[body - begin_] & near_ground) != 0; }
    // Sorts by class (below `classes`), then by index: a vector runs until its last lane is done, so similar bodies should share it.
    template <class Class> void arrange(uint32_t classes, Class&& class_of) {
        uint32_t sorted[field_block], of[field_block], at = 0;
        for (uint32_t i = 0; i < count_; ++i) of[i] = class_of(index_[i]);
        for (uint32_t c = 0; c < classes; ++c)
            for (uint32_t i = 0; i < count_; ++i)
                if (of[i] == c) sorted[at++] = index_[i];
        std::copy_n(sorted, count_, index_);
    }
    const uint32_t* marks() const { return near_; } // for each body from `begin` on: 0 if it is far

private:
    uint32_t begin_, end_, count_ = 0;
    alignas(64) uint32_t near_[near_range];
    uint32_t index_[field_block];
};
} // namespace lr
