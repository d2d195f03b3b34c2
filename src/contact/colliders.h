// The colliders of a world: what they are, where they go in a step, and which of them are near a body.
#pragma once

#include "contact/geometry.h"
#include "contact/geometry_store.h"
#include "contact/narrow.h"
#include "contact/proxy_grid.h"
#include "kernel/contact.h"
#include "langevin_rigid.h"
#include "world/allocator.h"

#include <cstdint>

namespace lr {

struct Collider {
    Geometry geometry;
    Pose begin, end; // of the present step; between steps `begin` is where it is
    float friction, restitution;
    uint32_t layers;
    bool moves; // in this step
};

// A collider, or a part of a mesh, whose box reaches into a body's.
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
    Vector rest;            // m, what rounding has taken from the position
    bool pending;           // the next step goes to Collider::end, and ends the motion
};

void set_shared(Geometry& geometry, const SharedGeometry* shared);

class Colliders {
public:
    explicit Colliders(Allocator& allocator) : geometries_(allocator), allocator_(&allocator) {}
    ~Colliders();
    Colliders(const Colliders&) = delete;
    Colliders& operator=(const Colliders&) = delete;

    // Creating, all or none: begin_create, then create for each, then finish_create; cancel_create after a failure of any
    // of them. Descs have been checked.
    lr_status begin_create(uint32_t count);
    lr_status create(const lr_collider_desc& desc);
    lr_status finish_create(lr_collider* ids); // ids: may be null
    void cancel_create();

    bool find(lr_collider collider, uint32_t& slot) const;
    // All or none; LR_ERROR_STALE_COLLIDER also when one is given twice.
    // False where one is stale, or given twice.
    bool can_destroy(const lr_collider* ids, uint32_t count);
    lr_status destroy(const lr_collider* ids, uint32_t count);

    // Moving several: reserve_move for each, finish_reserve, and then move each, which cannot fail.
    void begin_reserve() { reserved_ = mover_proxies_; }
    void reserve_move(uint32_t slot, const lr_collider_motion& motion);
    bool finish_reserve();
    void move(uint32_t slot, const lr_collider_motion& motion);
    void set_surface(uint32_t slot, float friction, float restitution, uint32_t layers);

    // A step begins: where colliders are at its ends, and what the broad phase needs of it. Allocates nothing. reach: m, of
    // ordinary bodies and their way in the step.
    void begin_step(double dt, float reach);
    // Colliders are at the ends of their ways.
    void end_step();

    bool any() const { return count_ != 0; }
    uint32_t count() const { return count_; }
    const NearColliders& near() const { return near_; } // of the step
    const Collider& at(uint32_t slot) const { return colliders_[slot]; }
    const ColliderMotion& motion(uint32_t slot) const { return motions_[slot]; }
    lr_collider id(uint32_t slot) const;
    uint32_t slots() const { return used_; }
    bool in_use(uint32_t slot) const { return slot < used_ && slots_[slot].where != Where::free; }
    const SharedGeometry* shared(uint32_t slot) const { return slots_[slot].shared; } // null where it has none
    void rename_shared(uint32_t slot, uint64_t hash) {
        if (slots_[slot].shared) geometries_.rename(slots_[slot].shared, hash);
    }
    // visit(hash, desc) of each collider with shared geometry: the desc makes the same again.
    template <class Visit> void visit_shared(Visit&& visit) const {
        for (uint32_t i = 0; i < used_; ++i)
            if (in_use(i) && slots_[i].shared) visit(slots_[i].shared->hash, desc_of(*slots_[i].shared));
    }

    // Calls found(candidate) for those whose boxes, over all of the step, reach into `box` (m, world) and that are in one of `layers`, each
    // once, in no certain order. Any thread.
    template <class Found> void visit(const Box& box, uint32_t layers, Found&& found) const {
        const auto take = [&](uint32_t slot, ColliderPart part) {
            if ((colliders_[slot].layers & layers) != 0) found(Candidate{slot, part});
        };
        each_finite(box, take);
        for (uint32_t i = 0; i < unbounded_count_; ++i)
            if (in_reach(colliders_[unbounded_[i]], box)) take(unbounded_[i], {0, 0});
    }
    // The same in order of slots and parts, at most most_candidates: the first ones behind `after`, which may be null. more: there are
    // others behind them.
    uint32_t candidates(const Box& box, uint32_t layers, const Candidate* after, Candidate (&out)[most_candidates],
                        bool& more) const;
    // The same of planes and heightfields alone; of more than there is room for the first.
    uint32_t grounds(const Box& box, uint32_t layers, Candidate (&out)[most_candidates]) const;

    // Whether there would be any: planes and heightfields, or others.
    bool any_ground(const Box& box, uint32_t layers) const;
    bool any_finite(const Box& box, uint32_t layers) const;
    // Whether each plane and heightfield is in one of `layers`.
    bool all_grounds(uint32_t layers) const;
    // Before a step: each collider that was made or placed since the last.
    template <class F> void for_fresh(F&& f) {
        if (!any_fresh_) return;
        any_fresh_ = false;
        const auto take = [&](uint32_t slot) {
            if (slots_[slot].fresh) f(slot);
            slots_[slot].fresh = false;
        };
        for (uint32_t i = 0; i < active_count_; ++i) take(active_[i]);
        for (uint32_t i = 0; i < unbounded_count_; ++i) take(unbounded_[i]);
    }
    // Each collider that moves in this step.
    template <class F> void for_moving(F&& f) const {
        for (uint32_t i = 0; i < active_count_; ++i)
            if (colliders_[active_[i]].moves) f(active_[i]);
        for (uint32_t i = 0; i < unbounded_count_; ++i)
            if (colliders_[unbounded_[i]].moves) f(unbounded_[i]);
    }
    // Around all of a collider and of its way in the step; of a plane, everything.
    Box box_of(uint32_t slot) const;

    // Of everything that matters for motion; 0 without colliders. Independent of the order of slots but for their ids.
    uint64_t hash() const;

private:
    friend class ColliderSnapshot;
    static constexpr uint32_t none = UINT32_MAX;
    enum class Where : uint8_t { free, still, active, unbounded };
    struct Slot {
        SharedGeometry* shared;
        uint32_t generation; // of the collider in it, or of the next
        uint32_t link;       // free: the next free slot; active, unbounded: its index in that list
        Where where;
        bool marked; // to be destroyed
        bool fresh;  // made or placed since the last step
    };
    // The slots that the next colliders will be in.
    struct Cursor {
        uint32_t free, used;
    };

    bool reserve_slots(uint32_t slots);
    bool reserve_grids(uint64_t proxies, uint64_t movers);
    bool reserve_unbounded(uint64_t count);
    uint32_t next_slot(Cursor& cursor) const;
    uint32_t proxies_of(uint32_t slot) const; // 0 for planes and heightfields
    bool moving(uint32_t slot) const;         // in the next step
    void enlist(uint32_t slot);
    void delist(uint32_t slot);
    void release(uint32_t slot);
    void advance(uint32_t slot, double dt);
    void add_proxies(uint32_t slot, ProxyGrid& to) const;
    void rebuild_still();
    void fill_near();
    void add_near(uint32_t slot);
    bool in_reach(const Collider& collider, const Box& box) const;
    // Calls found(slot, part) for each finite collider, or part of one, whose box reaches into `box`.
    template <class Found> void each_finite(const Box& box, Found&& found) const {
        const auto take = [&](const ProxyGrid& grid, Where where) {
            grid.query(box, [&](const Proxy& p) {
                if (slots_[p.slot].where == where) found(p.slot, p.part);
            });
        };
        take(still_grid_, Where::still);
        take(active_grid_, Where::active);
    }

    GeometryStore geometries_;
    Allocator* allocator_;
    Buffer<Collider> colliders_;
    Buffer<ColliderMotion> motions_;
    Buffer<Slot> slots_;
    // Finite colliders are in the grid of those that stand still, which is built now and then, or in `active_`, of which a
    // grid is built in each step: those that move, and those that do not but have not been entered in the other yet.
    Buffer<uint32_t> active_, unbounded_;
    ProxyGrid still_grid_{true}, active_grid_{false};
    NearColliders near_{};

    uint32_t used_ = 0, count_ = 0; // slots
    uint32_t free_first_ = none, free_last_ = none;
    uint32_t active_count_ = 0, unbounded_count_ = 0;
    uint64_t proxies_ = 0, mover_proxies_ = 0; // of all finite colliders; of those that move in the next step
    uint64_t still_proxies_ = 0;               // of those in the still grid
    uint64_t debt_ = 0;                        // entries that a newer still grid would have saved
    bool any_fresh_ = false;
    bool stale_ = false; // the still grid must be built
    float dilation_ = 0.0f;

    Cursor staging_{none, 0};
    uint32_t staged_ = 0;
    uint64_t reserved_ = 0;
    lr_collider_desc last_desc_{}; // while creating: the last with shared geometry
    SharedGeometry* last_shared_ = nullptr;
};

} // namespace lr
