// All bodies of one asset: dense arrays, and slots for the handles.
#pragma once

#include "asset/asset.h"
#include "base/allocator.h"
#include "base/handles.h"
#include "base/lane_arrays.h"
#include "collision/body_narrow_phase.h"
#include "collision/collider_contact_group.h"
#include "kernel/body_copies.h"
#include "kernel/integrator/step.h"
#include "world/batch/body_columns.h"
#include "world/batch/external_forces.h"
#include "world/events/contact_events.h"
#include "world/schedule/batch_schedule.h"
#include "world/sleep/sleeping_bodies.h"
#include "world/step/step_near_colliders.h"

#include <algorithm>
#include <utility>

struct lr_world;

namespace lr {

class Lifecycle;

struct BatchSettings {
    lr_batch_desc desc = LR_BATCH_DESC_INIT; // as given at creation
    Gains gains;
    double fluid_density = 1.2; // kg/m^3
    double viscosity = 1.5e-5;  // m^2/s, kinematic
};

// A body's state as it is stored: position and orientation in the world, velocities in the body frame.
struct BodyState {
    float value[field_count];
    uint32_t noise_seed;
    uint64_t user;
};

// Header of a k-epsilon table in the units of the bake. In snapshots, count 0 stands for the asset's own table.
struct TableHead {
    uint32_t count = 0, stationary = 0;
    double dt = 0.0, u0 = 0.0, l = 0.0, c0 = 0.0;

    TurbulenceSample sample(float chi, float epsilon) const { return {wide(chi), wide(epsilon), u0, l, c0}; }
};
inline const char* wrong_in(const TableHead& t) {
    if (t.count == 0 || t.count > 65536) return "count is not 1 to 65536";
    if (!in_range(t.dt, least_interval, most_interval)) return "dt is not positive";
    if (const char* why = wrong_in(t.sample(0.0f, 0.0f))) return why;
    return t.stationary < t.count ? nullptr : "stationary is not less than count";
}

// Diverged bodies stay where they were last valid, or end. docs/reference/bodies.md
struct DivergedCounts {
    uint32_t noted = 0; // set in a step in which a body diverges (StepInput::faults)
    uint32_t last = 0;  // number in the last step
    uint64_t total = 0;
};

// Settings that calls can change at any time. Snapshots contain this struct, so it has only 32-bit numbers.
struct BatchOptions {
    int32_t divergence_policy = LR_DIVERGENCE_AUTO;
    uint32_t reserved = 0; // keeps the size a multiple of 8 bytes
};
inline const char* wrong_in(const BatchOptions& o) {
    if (o.divergence_policy < LR_DIVERGENCE_AUTO || o.divergence_policy > LR_DIVERGENCE_REMOVE) return "unknown policy";
    return o.reserved != 0 ? "reserved is not 0" : nullptr;
}

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
    // False if the body is marked already: finds repeats within one call.
    bool mark(uint32_t index);
    void unmark(uint32_t index);
    BodyState read(uint32_t index) const;
    void write(uint32_t index, const BodyState& state); // all but noise seed and user value
    // After a step. Ages stop at most_age (kernel/limits.h).
    void grow_older(double seconds);

    // On failure the old table stays. chi: null for the asset's own samples.
    bool set_table(const TableHead& head, const float* chi, const float* epsilon);
    TableHead asset_table() const;
    const TableHead& table() const { return table_head_; }
    const float* table_chi() const { return table_.data(); }
    const float* table_epsilon() const { return table_.data() + table_head_.count; }
    // Replaces the asset's quasi-steady loads. Returns false and changes nothing if these cannot be used.
    bool set_aerodynamics(const AerodynamicData& loads, const Gains& gains);
    const AerodynamicData& aerodynamics() const { return aerodynamics_; }
    const Gains& gains() const { return settings_.gains; }

    // Bodies [0, awake()) are awake and stepped, [awake(), count()) asleep. Order within either part has no meaning.
    uint32_t count() const { return count_; }
    uint32_t awake() const { return awake_; }
    uint32_t capacity() const { return capacity_; }
    uint32_t slot() const { return index_; } // in the world
    uint32_t padded_count() const { return whole_blocks(count_); }
    uint32_t padded_awake() const { return whole_blocks(awake_); }
    bool asleep(uint32_t index) const { return index >= awake_; }
    bool held(uint32_t index) const { return !asleep(index) && is_held(arrays_.field[field_age_remainder][index]); }
    // Checks an awake body for divergence after its velocity was set.
    void judge(uint32_t index) {
        hold_if_insane(arrays_, index, &faults.noted, [&](size_t f) { return arrays_.field[f][index]; });
    }
    // Both return the new index. Falling asleep clears velocities and forces; waking makes the age exact.
    uint32_t fall_asleep(uint32_t index); // awake, and reserve_sleep() has held
    uint32_t wake(uint32_t index);        // asleep
    void wake_all();
    // Sleeping bodies whose box, position +- reach() times scale, overlaps this one.
    void wake_in(const Box& box) { wake_near(box, 0.0, 0.0); }
    // The same, and bodies that may lie on something in it: above it by the slop of contact (contact.md, section 4), or by their room if they tremble
    // in place.
    void wake_on(const Box& box) { wake_near(box, SleepingGrid::room, 2e-6); }
    // Calls function for sleeping bodies whose contact box overlaps `box`. Any thread, while none falls asleep or wakes.
    template <class Function> void visit_sleeping(const Box& box, Function&& function) const {
        if (awake_ == count_) return;
        const auto look_at = [&](uint32_t slot) {
            if (overlap(sleeping_->box(slot), box)) function(dense_[slot]);
        };
        if (sleeping_->grid.visit(box, count_ - awake_, look_at)) return;
        for (uint32_t i = awake_; i < count_; ++i) look_at(unpack(ids()[i]).slot);
    }
    void enter(lr_world& world) { world_ = &world; } // whose bodies are uncovered when one of this batch wakes
    // Stores the wind that a sleeping body has withstood (m/s; 0: none), and whether it needed shelter for that. See WakeByFlow.
    void store_wind(uint32_t index, Vector wind, bool sheltered);
    // A sleeping body's support may have left: at its turn it takes a trial, even in still air. Any thread, in a batch with contact.
    void doubt(uint32_t index);
    bool doubted(uint32_t index) const { return columns_.row<float>(column_lee)[index] < 0.0f; }
    void set_lee(uint32_t index, float lee) { columns_.row<float>(column_lee)[index] = lee; }
    void forget_shelter(uint32_t index); // a body that withstood the wind in shelter has to take a trial again
    bool reserve_sleep();                // false when out of memory
    SleepingBodies* sleeping() const { return sleeping_.get(); } // null before reserve_sleep()
    // Updates the ages of sleeping bodies in the arrays.
    void make_ages_exact();
    double reach() const { return reach_; } // m: greatest distance of the surface from the centre of mass, at scale 1
    Box box() const;                        // of all bodies; with none, from FLT_MAX to -FLT_MAX
    // Increases whenever sleeping bodies wake, end or change their indices.
    uint64_t revision() const { return revision_; }

    // Allocates the columns of contact; false when out of memory.
    bool reserve_contact();
    bool any_contact() const; // whether any of their values is not 0
    // Clears contacts and forces, since the body respawned or was placed.
    void forget(uint32_t index) { columns_.clear(index, index + 1, column_force, column_noise_seed - column_force); }
    void forget_touched_bodies(); // the batch has no body contact any more
    // Marks an awake body to fall asleep, or a sleeping one to wake, at the end of the step. Any thread.
    void note_sleep(uint32_t index);
    void settle_noted(); // after the step
    void wake_noted();   // wakes marked sleeping bodies; before settle_noted()
    const lr_asset& asset() const { return *asset_; }
    const BodyColumns& columns() const { return columns_; }
    const BatchArrays& arrays() const { return arrays_; }
    const lr_body* ids() const { return columns_.row<lr_body>(column_ids); }
    const uint64_t* users() const { return columns_.row<uint64_t>(column_user); } // null before reserve_users()
    uint64_t user(uint32_t index) const { return users() ? users()[index] : 0; }
    void set_user(uint32_t index, uint64_t user);                 // requires reserve_users(), unless user is 0
    uint32_t last_generation() const { return last_generation_; } // highest generation in any handle given out
    const BatchSettings& settings() const { return settings_; }

    // Constants in water, recomputed when water or loads have changed. Null if the batch cannot be in water; the first time `failed` is set.
    const WaterBody* water_body(const lr_water_desc& surface, bool& failed);

    ExternalForces external;
    // False when out of memory.
    bool reserve_users() { return columns_.reserve(*allocator_, part_user, whole_blocks(capacity_)); }
    bool reserve_forces(); // for forces on single bodies; false when out of memory

    Lifecycle* lifecycle() const { return lifecycle_.get(); } // null before the first rules or emitter
    bool reserve_lifecycle();                                 // false when out of memory

    const lr_batch_contact& contact() const { return contact_; }
    void set_contact(const lr_batch_contact& contact);       // while no body sleeps
    const PairHull& pair_hull() const { return pair_hull_; } // shape against other bodies
    ContactCache contact_cache();

    ContactEvents* events() const { return events_.get(); }                   // null while events are off
    bool reserve_events() { return events_.reserve(*allocator_, capacity_); } // false when out of memory
    void drop_events() { events_.reset(); }

    DivergedCounts faults;
    BatchOptions options;
    StepInput step{}; // constants; World::step adds the rest
    BatchClock pace;

private:
    friend class SnapshotAccess;
    friend class Allocator;
    Batch(Allocator& allocator, double length);
    ~Batch();
    bool allocate(uint32_t capacity);
    void move(uint32_t from, uint32_t to); // `to` must be unused
    void swap(uint32_t a, uint32_t b);
    void moved(uint32_t index); // updates the slot of a body that now has this index
    void lie_down(uint32_t index);
    void wake_near(const Box& box, double share, double round);
    // Both clear the mark that they return.
    bool take_cut(uint32_t cut) { return std::exchange(cut_noted_[cut], uint8_t{0}) != 0; }
    bool take_note(uint32_t index) { return std::exchange(columns_.row<uint32_t>(column_noted)[index], 0u) != 0; }
    bool is_diagonal_with(const AerodynamicData& loads) const;
    bool copy_table(const TableHead& head, const void* chi, const void* epsilon, Buffer<float>& out) const;
    bool use_table(Buffer<float>& table, const TableHead& head, bool of_asset); // takes its memory
    bool make_loads(const AerodynamicData& loads, const Gains& gains, BodyConstants& out) const;

    Allocator* allocator_;
    const lr_asset* asset_ = nullptr;
    BatchSettings settings_;
    lr_batch_contact contact_ = initial_contact;
    PairHull pair_hull_{};
    uint32_t index_ = 0;
    uint32_t capacity_ = 0, count_ = 0, awake_ = 0;
    uint64_t revision_ = 0;
    double reach_ = 0.0;
    uint32_t first_generation_ = 1, last_generation_ = 0;
    BatchArrays arrays_{};
    BodyColumns columns_;
    Buffer<uint8_t> cut_noted_;    // by cut: whether bodies in it are marked
    Buffer<uint32_t> dense_;       // by slot: the body's dense index, or free_bit and the next free slot
    Buffer<uint32_t> generations_; // by slot: of its body, or of the next one
    // Free slots form a queue, so that a slot is reused as late as possible. Undefined while all are in use.
    uint32_t free_first_ = 0, free_last_ = 0;
    Buffer<float> table_, next_table_; // chi, epsilon, alpha, beta^2; next_table_: of a snapshot being restored
    TableHead table_head_;
    bool asset_table_ = true;
    AerodynamicData aerodynamics_;
    WaterBody water_{};
    bool water_made_ = false, water_usable_ = false; // for these:
    float water_density_ = 0.0f, water_viscosity_ = 0.0f;
    TurbulenceSample stationary_{}; // of a table set by the user; u0 is 0 without one
    double oldest_ = 0.0;           // s: bound of the ages of awake bodies
    lr_world* world_ = nullptr;
    Owned<Lifecycle> lifecycle_;
    Owned<SleepingBodies> sleeping_;
    Owned<ContactEvents> events_;
};

// Calls move(), which steps lanes [begin, end), and restores the sleeping bodies among the last lanes.
template <class Move> void move_awake(const Batch& batch, uint32_t begin, uint32_t end, const Move& move) {
    const uint32_t first = std::max(begin, batch.awake()), past = std::min(end, batch.count());
    if (first >= past) return move();
    BodyCopies<lane_block> kept;
    kept.take(batch.arrays(), past - first, [first](uint32_t i) { return first + i; });
    move();
    kept.put_back(batch.arrays());
}
} // namespace lr
