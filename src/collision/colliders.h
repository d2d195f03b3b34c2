// The colliders of a world: their data, their motion in a step, and the broad phase that finds them.
#pragma once

#include "base/allocator.h"
#include "collision/collider_broad_phase.h"
#include "collision/collider_geometry.h"
#include "collision/geometry_store.h"
#include "kernel/contact/collider_contact.h"
#include "kernel/limits.h"
#include "langevin_rigid.h"

#include <cstdint>

namespace lr {

// Null if valid, else the reason. For setters and snapshots.
inline const char* wrong_velocity(const float (&linear)[3], const float (&angular)[3]) {
    if (!within(linear, most_speed)) return "linear_velocity is over 1e6 m/s";
    return within(angular, most_speed) ? nullptr : "angular_velocity is over 1e6 rad/s";
}
inline const char* wrong_material(float friction, float restitution) {
    if (!in_range(friction, 0.0, 10.0)) return "friction is not 0 to 10";
    return in_range(restitution, 0.0, 1.0) ? nullptr : "restitution is not 0 to 1";
}
// Number of sizes that a kind uses; the others are 0.
constexpr int sizes_of(int32_t kind) {
    return kind == LR_COLLIDER_SPHERE ? 1 : kind == LR_COLLIDER_CAPSULE ? 2 : kind == LR_COLLIDER_BOX ? 3 : 0;
}
inline const char* wrong_sizes(int32_t kind, const float (&size)[3]) {
    for (int i = 0; i < sizes_of(kind); ++i)
        if (!(size[i] > 0.0f) || !in_range(size[i], 0.0, most_size)) return "size is not above 0 and up to 1e6 m";
    return nullptr;
}

struct Collider {
    Geometry geometry;
    Pose begin, end; // of this step; between steps `begin` is the pose
    float friction, restitution;
    uint32_t layers;
    bool moves; // in this step
};

// A collider, or a mesh part, whose box overlaps a body's.
struct Candidate {
    uint32_t slot;
    ColliderPart part;
};
inline constexpr uint32_t most_candidates = 64;
inline bool comes_before(const Candidate& a, const Candidate& b) {
    return a.slot != b.slot ? a.slot < b.slot : a.part.first < b.part.first;
}

struct ColliderMotion {
    Vector linear, angular; // m/s, rad/s
    Vector remainder;       // m, rounding error of the position, carried over
    bool pending;           // the next step moves it to Collider::end, and it stops there

    bool moves() const { // in the next step
        const auto is_zero = [](Vector v) { return v.x == 0.0f && v.y == 0.0f && v.z == 0.0f; };
        return pending || !is_zero(linear) || !is_zero(angular);
    }
};

// The state of a collider between steps: saved in snapshots, and hashed.
struct ColliderRecord {
    int32_t kind;
    float size[3];
    uint64_t data; // hash of hull, heightfield or mesh; else 0
    Pose begin, end;
    Vector linear, angular, remainder;
    float friction, restitution;
    uint32_t layers;
    uint32_t pending, fresh;
};

// A box in a collider's own frame, with a rounding around it.
struct LocalBounds {
    Box box;
    float round; // m
};

LocalBounds bounds_of(const Geometry& geometry, const SharedGeometry* shared);

// A box around all poses from begin to end, as Colliders interpolates them.
Box swept_box(const LocalBounds& local, const Pose& begin, const Pose& end, bool moves);

// m: upper bound of the displacement of any point within `local`.
float most_travel(const Box& local, const Pose& begin, const Pose& end);

// The pose after dt at these velocities. remainder: rounding error of the position, carried over and updated.
Pose advanced(const Pose& from, Vector linear, Vector angular, double dt, Vector& remainder);

// The same orientation, with the quaternion's sign on the side of `to`.
Rotation nearer_to(const Rotation& to, const Rotation& q);

class Colliders {
public:
    explicit Colliders(Allocator& allocator) : geometries_(allocator), allocator_(&allocator) {}
    ~Colliders();
    Colliders(const Colliders&) = delete;
    Colliders& operator=(const Colliders&) = delete;

    // Creates all or none: begin_create, create for each, finish_create; after any failure cancel_create. Descs have been checked.
    lr_status begin_create(uint32_t count);
    lr_status create(const lr_collider_desc& desc);
    lr_status finish_create(lr_collider* ids); // ids: can be null
    void cancel_create();

    bool find(lr_collider collider, uint32_t& slot) const;
    // False if an id is stale or repeated.
    bool can_destroy(const lr_collider* ids, uint32_t count);
    void destroy(const lr_collider* ids, uint32_t count);

    // To move several: reserve_move for each, finish_reserve, then move for each. Only finish_reserve can fail.
    void begin_reserve() { reserved_ = mover_proxies_; }
    void reserve_move(uint32_t slot, const lr_collider_motion& motion);
    bool finish_reserve();
    void move(uint32_t slot, const lr_collider_motion& motion);
    void set_surface(uint32_t slot, float friction, float restitution, uint32_t layers);

    // Begins a step: poses at its ends and the broad phase. Allocates nothing. reach: m, of ordinary bodies with their path in the step.
    void begin_step(double dt, float reach);
    // Moves colliders to their poses at the end of the step.
    void end_step();

    bool any() const { return count_ != 0; }
    uint32_t count() const { return count_; }
    const NearColliders& near() const { return near_; } // of the step
    const Collider& at(uint32_t slot) const { return colliders_[slot]; }
    const ColliderMotion& motion(uint32_t slot) const { return motions_[slot]; }
    lr_collider id(uint32_t slot) const;
    uint32_t slots() const { return used_; }
    bool in_use(uint32_t slot) const { return slot < used_ && slots_[slot].where != Where::free; }
    const SharedGeometry* shared(uint32_t slot) const { return slots_[slot].shared; } // null if it has none
    void rename_shared(uint32_t slot, uint64_t hash) {
        if (slots_[slot].shared) geometries_.rename(slots_[slot].shared, hash);
    }
    // Calls visit(hash, desc) for each collider with shared geometry; the desc recreates the geometry.
    template <class Visit> void visit_shared(Visit&& visit) const {
        for (uint32_t i = 0; i < used_; ++i)
            if (in_use(i) && slots_[i].shared) visit(slots_[i].shared->hash, desc_of(*slots_[i].shared));
    }

    // Calls found(candidate) once for each box, over the whole step, that overlaps `box` (m, world), if in `layers`. In no order. Any thread.
    template <class Found> void visit(const Box& box, uint32_t layers, Found&& found) const {
        const auto take = [&](uint32_t slot, ColliderPart part) {
            if ((colliders_[slot].layers & layers) != 0) found(Candidate{slot, part});
            return true;
        };
        each_finite(box, take);
        for (const uint32_t slot : unbounded_)
            if (in_reach(colliders_[slot], box)) take(slot, {0, 0});
    }
    // The same in order of slots and parts: the first most_candidates after `after` (null: from the beginning). more: others follow.
    uint32_t candidates(const Box& box, uint32_t layers, const Candidate* after, Candidate (&out)[most_candidates],
                        bool& more) const;
    // Planes and heightfields alone, in the same order; if there are too many, the first ones.
    uint32_t grounds(const Box& box, uint32_t layers, Candidate (&out)[most_candidates]) const;

    // Whether any plane or heightfield, or any other collider, overlaps the box.
    bool any_ground(const Box& box, uint32_t layers) const;
    bool any_finite(const Box& box, uint32_t layers) const;
    // Whether each plane and heightfield is in one of `layers`.
    bool all_grounds(uint32_t layers) const;
    // Calls f for each collider created or placed since the last step.
    template <class F> void for_fresh(F&& f) {
        if (!any_fresh_) return;
        any_fresh_ = false;
        sort_lists();
        each_listed([&](uint32_t slot) {
            if (slots_[slot].fresh) f(slot);
            slots_[slot].fresh = false;
        });
    }
    // Calls f for each collider that moves in this step.
    template <class F> void for_moving(F&& f) {
        sort_lists();
        each_listed([&](uint32_t slot) {
            if (colliders_[slot].moves) f(slot);
        });
    }
    // A box around a collider and its path in the step; everything for a plane.
    Box box_of(uint32_t slot) const;
    bool any_moves() const { return any_moves_; } // in this step
    bool move_into(const Box& box) const;         // whether one that moves may come into a box

    // Hash of everything that affects motion; 0 without colliders. Slots count only through their ids.
    uint64_t hash() const;

private:
    friend class ColliderSnapshot;
    static constexpr uint32_t none = UINT32_MAX;
    enum class Where : uint8_t { free, still, active, unbounded };
    struct Slot {
        SharedGeometry* shared;
        uint32_t generation; // of the collider in it, or of the next
        uint32_t link;       // free: next free slot; active, unbounded: index in that list
        Where where;
        bool marked; // to be destroyed
        bool fresh;  // created or placed since the last step
    };
    // The slots of the next colliders.
    struct Cursor {
        uint32_t free, used;
    };

    // A list of slots. Slot::link has the index of each in it, so removal takes constant time.
    struct List {
        Buffer<uint32_t> slots;
        uint32_t count = 0;
        const uint32_t* begin() const { return slots.data(); }
        const uint32_t* end() const { return slots.data() + count; }
    };

    bool reserve_slots(uint32_t slots);
    bool reserve_grids(uint64_t proxies, uint64_t movers);
    bool reserve_unbounded(uint64_t count);
    uint32_t next_slot(Cursor& cursor) const;
    uint32_t proxies_of(uint32_t slot) const; // 0 for planes and heightfields
    bool moving(uint32_t slot) const { return motions_[slot].moves(); }
    List& list_of(uint32_t slot) { return is_ground(colliders_[slot].geometry.kind) ? unbounded_ : active_; }
    template <class F> void each_listed(F&& f) const {
        for (const List* list : {&active_, &unbounded_})
            for (const uint32_t slot : *list) f(slot);
    }
    ColliderRecord record(uint32_t slot) const;
    void set_shared(uint32_t slot, SharedGeometry* shared);
    void enlist(uint32_t slot);
    void delist(uint32_t slot);
    void sort_lists(); // by slot: the order in which colliders began to move is in no snapshot
    void release(uint32_t slot);
    void add_proxies(uint32_t slot, ColliderBroadPhase& to) const;
    void rebuild_still();
    void fill_near();
    void add_near(uint32_t slot);
    bool in_reach(const Collider& collider, const Box& box) const;
    // Calls found(slot, part) for each finite collider, or part of one, whose box overlaps `box`, until it returns false. Returns false then.
    template <class Found> bool each_finite(const Box& box, Found&& found) const {
        const auto all = [&](const ColliderBroadPhase& grid, Where where) {
            return grid.query(box,
                              [&](const Proxy& p) { return slots_[p.slot].where != where || found(p.slot, p.part); });
        };
        return all(still_grid_, Where::still) && all(active_grid_, Where::active);
    }

    GeometryStore geometries_;
    Allocator* allocator_;
    Buffer<Collider> colliders_;
    Buffer<ColliderMotion> motions_;
    Buffer<Slot> slots_;
    // The static grid is rebuilt now and then. `active_` has the moving colliders, and still ones added since; its grid is rebuilt in each step.
    List active_, unbounded_;
    ColliderBroadPhase still_grid_{true}, active_grid_{false};
    NearColliders near_{};

    uint32_t used_ = 0, count_ = 0; // slots
    uint32_t free_first_ = none, free_last_ = none;
    uint64_t proxies_ = 0, mover_proxies_ = 0; // of all finite colliders; of those moving in the next step
    uint64_t still_proxies_ = 0;               // in the static grid
    uint64_t debt_ = 0;                        // entries that a rebuilt static grid would have saved the other
    bool any_fresh_ = false, any_moves_ = false;
    bool stale_ = false; // the static grid must be rebuilt
    float dilation_ = 0.0f;

    Cursor staging_{none, 0};
    uint32_t staged_ = 0;
    uint64_t reserved_ = 0;
    lr_collider_desc last_desc_{}; // during creation: the last one with shared geometry
    SharedGeometry* last_shared_ = nullptr;
};
} // namespace lr
