// All bodies of one asset: dense arrays, and the slots behind the handles.
#pragma once

#include "asset/asset.h"
#include "contact/body_pair.h"
#include "contact/contact_group.h"
#include "field/contact_run.h"
#include "kernel/batch_arrays.h"
#include "kernel/step.h"
#include "world/allocator.h"
#include "world/contact_events.h"
#include "world/external_forces.h"
#include "world/faults.h"
#include "world/handles.h"
#include "world/pace.h"
#include "world/resting.h"

namespace lr {

class Lifecycle;

struct BatchSettings {
    Loads loads = Loads::langevin;
    Clock clock = Clock::speed;
    Integrator integrator = Integrator::splitting;
    bool loop = false;
    Gains gains;
    double fluid_density = 1.2; // kg/m^3
    double viscosity = 1.5e-5;  // m^2/s, kinematic
};

// A body's state in the frames of storage: position and orientation in the world, velocities in the body frame.
struct BodyState {
    float value[field_count];
    uint32_t key;
};

// k-epsilon samples in the units of the bake.
struct TableView {
    const float* chi;
    const float* epsilon;
    uint32_t count, stationary;
    double dt, u0, l, c0;
};

class Batch {
public:
    static constexpr uint32_t free_bit = 1u << 31; // above every dense index

    // Null after an error: LR_ERROR_OUT_OF_MEMORY or LR_ERROR_INTERNAL.
    static Batch* create(Allocator& allocator, const lr_asset& asset, uint32_t capacity, const BatchSettings& settings,
                         uint32_t index, uint32_t first_generation, lr_status& status);
    static void destroy(Batch* batch);

    lr_body add(const BodyState& state); // count() < capacity(); awake
    void remove(lr_body body);           // find(body) holds
    // The dense index of a living body; false for a stale one.
    bool find(lr_body body, uint32_t& index) const;
    // False when marked already. Marks are for the length of one call.
    bool mark(uint32_t index);
    void unmark(uint32_t index);
    BodyState read(uint32_t index) const;
    void write(uint32_t index, const BodyState& state);
    // After a step: none is older than most_age (kernel/limits.h).
    void grow_older(double seconds);

    // Both leave the old table in place when they fail.
    bool set_table(const TableView& table);
    bool set_asset_table();
    // What is not less than any sample of a table with this stationary one, u0 of which is 0 without a table but the asset's; and
    // between which rates (1/s) its samples follow each other.
    TurbulenceSample strongest_turbulence(const TurbulenceSample& stationary, double& least_rate,
                                          double& most_rate) const;
    // Quasi-steady loads other than the asset's own; false, and nothing has changed, when they cannot be used.
    bool set_aerodynamics(const AerodynamicData& loads, const Gains& gains);
    bool can_use(const AerodynamicData& loads, const Gains& gains) const;
    const AerodynamicData& aerodynamics() const { return aerodynamics_; }
    const Gains& gains() const { return settings_.gains; }

    // Bodies [0, awake()) move, [awake(), count()) are at rest and are not stepped. Order in either part has no meaning.
    uint32_t count() const { return count_; }
    uint32_t awake() const { return awake_; }
    uint32_t capacity() const { return capacity_; }
    uint32_t padded_count() const; // whole lane blocks
    uint32_t padded_awake() const;
    bool rests(uint32_t index) const { return index >= awake_; }
    bool held(uint32_t index) const; // where it was when it left physics
    void judge(uint32_t index);      // a body that moves, after a change of its velocity: it may have left physics
    // Return the body's new index. Its velocities and the forces on it end where it comes to rest; its age is exact when it wakes.
    uint32_t rest(uint32_t index); // awake, and reserve_rest() has held
    uint32_t wake(uint32_t index); // at rest
    void wake_all();
    // Calls fn(index) for bodies at rest whose boxes, position +- reach() times scale, reach into [low, high] (m): for some more
    // than once, in no order. fn may wake the body.
    template <class Function> void visit_resting(const Box& box, Function&& function) {
        if (awake_ == count_) return;
        const auto look_at = [&](uint32_t index) {
            if (reaches_into(index, box)) function(index);
        };
        if (resting_->grid.visit(box, count_ - awake_, [&](uint32_t slot) { look_at(dense_[slot]); })) return;
        // One that wakes changes places with one that has been looked at.
        for (uint32_t i = awake_; i < count_; ++i) look_at(i);
    }
    // For those of which the box of what others can touch reaches into [low, high]. Any thread, while no body comes to rest or wakes.
    template <class Function> void look_at_resting(const Box& box, Function&& function) const {
        if (awake_ == count_) return;
        const auto look_at = [&](uint32_t slot) {
            if (overlap(resting_->box(slot), box)) function(dense_[slot]);
        };
        if (resting_->grid.visit(box, count_ - awake_, look_at)) return;
        for (uint32_t i = awake_; i < count_; ++i) look_at(unpack(ids_[i]).slot);
    }
    bool reserve_rest();                          // false when out of memory
    Resting* resting() const { return resting_; } // null before reserve_rest()
    // Ages of bodies at rest, in the arrays, up to the present.
    void make_ages_exact();
    double reach() const { return reach_; } // m: no part of a body of scale 1 is farther from its centre of mass
    // Grows whenever bodies at rest wake, end, or change their indices.
    uint64_t revision() const { return revision_; }

    // Memory for ContactArrays; false when out of memory.
    bool reserve_contact();
    // After all bodies are back. from: a Resting::Record and a birth for each body, of any alignment; null: none rests.
    // before: how many bodies there were.
    void restore_rest(const unsigned char* from, uint32_t before);
    void forget_touched_bodies(); // it meets none any more
    ContactArrays contact_arrays() const { return resting_ ? resting_->contact : ContactArrays{}; }
    // A body of a chunk that is stepped is to rest from the end of the step on; from any thread.
    void note_rest(uint32_t index) { resting_->note(index); }
    void settle_noted(); // after the step
    void wake_noted();   // bodies at rest that were noted, before that
    const lr_asset& asset() const { return *asset_; }
    const BatchArrays& arrays() const { return arrays_; }
    const lr_body* ids() const { return ids_.data(); }
    uint32_t last_generation() const { return last_generation_; } // the highest in any handle given out so far
    const BatchSettings& settings() const { return settings_; }

    // Its bodies under a surface; made anew when that or the loads have changed. Null when it cannot be, and then `failed`
    // is set once.
    const WaterBody* water_body(const lr_surface_desc& surface, bool& failed);

    ExternalForces external;
    bool reserve_forces(); // for forces on single bodies; false when out of memory

    Lifecycle* lifecycle() const { return lifecycle_; } // null before the first rules or emitter
    bool reserve_lifecycle();                           // false when out of memory

    ContactSettings contact;
    BodyShape shape{};      // what of its bodies can touch
    MeetingShape meeting{}; // what of them others can touch
    ContactBook contact_book();

    ContactEvents* events() const { return events_; } // null where none are kept
    bool reserve_events();                            // false when out of memory
    void drop_events();

    BodyFaults faults;
    StepInput step; // constants of the shape, filled up by World::step
    Pace pace;

    // Arrays of BatchArrays::field that it has: the last three are those of AERODYNAMIC loads.
    size_t fields() const { return settings_.loads == Loads::aerodynamic ? field_count : field_gust_x; }

private:
    friend class SnapshotAccess;
    Batch(Allocator& allocator, double length) : pace(length), allocator_(&allocator) {}
    ~Batch();
    bool allocate(uint32_t capacity);
    void clear_lane(uint32_t index);
    void swap(uint32_t a, uint32_t b);
    void lie_down(uint32_t index, double birth);
    Box resting_box(uint32_t index) const;
    void clear_lanes(uint32_t begin, uint32_t end);
    bool reaches_into(uint32_t index, const Box& box) const;
    void move(uint32_t from, uint32_t to);
    bool fill_table(const TableView& table);
    bool is_diagonal_with(const AerodynamicData& loads) const;
    bool make_loads(const AerodynamicData& loads, const Gains& gains, BodyConstants& out) const;

    Allocator* allocator_;
    const lr_asset* asset_ = nullptr;
    BatchSettings settings_;
    uint32_t index_ = 0;
    uint32_t capacity_ = 0, count_ = 0, awake_ = 0;
    uint64_t revision_ = 0;
    double reach_ = 0.0;
    uint32_t first_generation_ = 1, last_generation_ = 0;
    BatchArrays arrays_{};
    Buffer<float> fields_; // arrays of padded capacity
    Buffer<uint32_t> keys_;
    Buffer<lr_body> ids_;          // by dense index
    Buffer<uint32_t> dense_;       // by slot: the body's dense index, or free_bit and the next free slot
    Buffer<uint32_t> generations_; // by slot: of the body in it, or of the next
    // A queue, so that a slot rests long before its next life. Without meaning when all slots are in use.
    uint32_t free_first_ = 0, free_last_ = 0;
    Buffer<float> table_; // alpha, then beta^2
    AerodynamicData aerodynamics_;
    WaterBody water_{};
    bool water_made_ = false, water_usable_ = false; // for these:
    float water_density_ = 0.0f, water_viscosity_ = 0.0f;
    TurbulenceSample stationary_{}; // of a table set by the user; u0 is 0 without one
    double oldest_ = 0.0;           // s, that no body that moves is older than
    Lifecycle* lifecycle_ = nullptr;
    Resting* resting_ = nullptr;
    ContactEvents* events_ = nullptr;
};

} // namespace lr
