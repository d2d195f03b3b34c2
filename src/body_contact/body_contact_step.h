// A step of batches with body contact. In each substep all bodies move, then touching ones are solved together (docs/maintainers/contact.md).
#pragma once

#include "base/float_mode.h"
#include "base/step_workers.h"
#include "body_contact/body_contact_solver.h"
#include "body_contact/contact_tiles.h"
#include "body_contact/pair_cache.h"
#include "collision/body_broad_phase.h"
#include "collision/body_narrow_phase.h"
#include "collision/collider_contact_group.h"
#include "world/schedule/step_chunks.h"
#include "world/step/step_near_colliders.h"

#include <algorithm>
#include <atomic>
#include <cstdint>

struct lr_world;

namespace lr {

struct Manifold;
struct WayContact;

// The sleeping bodies that a batch's bodies can touch: of its partners, and its own if it is paired with itself.
class SleepingNeighbours final : public SleepingContacts {
public:
    // nearer: share of the reach by which all gaps are taken to be smaller than they are.
    SleepingNeighbours(const lr_world& world, uint32_t slot, float nearer = 0.0f);
    bool any() const { return any_; }
    uint32_t touched_by(uint32_t noise_seed, float scale, const Pose& from, const Pose& to, float margin,
                        SleepingTouch (&out)[most_sleeping]) const override;

private:
    const lr_world* world_;
    uint32_t slot_; // of the batch
    float nearer_;
    bool any_ = false;
};

struct BodyContactBatch {
    StepItem item;
    uint32_t slot;
    uint32_t first, count;   // its bodies' indices in the step, consecutive from `first`
    uint32_t first_place[2]; // by kind: the first place of its bodies that touch others in air, and in water
    bool own;                // its bodies can touch each other
    ContactRun run;
    SleepingNeighbours sleeping;
    SolverBodyKind kind[2]; // in air, in water
};

// Memory of such steps. It grows on demand and is kept.
struct BodyContactBuffers {
    explicit BodyContactBuffers(Allocator& allocator) : solver(allocator) {}

    // A body's contact with a collider or a sleeping body.
    struct Held {
        uint32_t collider; // slot, or sleeping_body
        ContactGroup::Asleep at_rest;
    };
    struct Moved {
        PairBody body;
        float margin; // m
        uint32_t member;
        uint64_t key; // of PairCache
    };
    // Two bodies whose boxes are near each other.
    struct Pair {
        uint32_t a, b; // bodies, by their indices in the step
        uint32_t count;
    };

    Buffer<BodyContactBatch> members;
    Buffer<float> before;    // pose_fields rows of all bodies, as the substep began
    Buffer<float> submerged; // by body: the part of it in water; used only if there is any
    Buffer<Moved> moved;     // by body
    BodyBroadPhase grid;
    Buffer<uint32_t> first_pair; // by body, and the end: the first of the pairs that it has found
    Buffer<PlacedBox> placed;    // by body
    // By body: the others that can touch it and whose pair it finds. Of more than this number the first by batch and noise seed.
    static constexpr uint32_t most_seen = 48;
    Buffer<uint32_t> seen;
    Buffer<Pair> pairs;
    CachedPair* found = nullptr;      // by pair: the manifold for the next substep, in the cache; count 0: none
    Buffer<const CachedPair*> cached; // by pair: the manifold of the substep before, or null
    struct PairContacts {
        BodyContactFrame frame;
        BodyContactPoint contact[block_contacts];
    };
    Buffer<PairContacts> pair_contacts;                      // by pair
    static constexpr Hidden unasked{UINT32_MAX, UINT32_MAX}; // no face has so many points
    Buffer<Hidden> hidden;  // by body; unasked: its shelter is not found in this substep
    Buffer<uint32_t> place; // by body: its number among those that touch others, or UINT32_MAX
    Buffer<TiledBody> tiled;
    // By place; padding is UINT32_MAX. After find_carried() `tile` tells whether a slow collider carries the body.
    Buffer<uint32_t> body_at, tile, first_held, held_count, first_unit;
    Buffer<float> deepest; // m, by place: the least gap to another awake body that it touches, or no_contact
    Buffer<Held> held;
    Buffer<BodyContactFrame> held_frames; // as `held`
    Buffer<BodyContactPoint> held_contacts;
    Buffer<BodyContactPair> units;
    Buffer<SolverBodyKind> kinds;
    Buffer<BodyContactRange> ranges;
    BodyContactSolver solver;
};

class BodyContactStep {
public:
    // items: batches with the same substeps at the same times.
    BodyContactStep(lr_world& world, const StepItem* items, uint32_t count, const WaterStep* surface,
                    const FloatMode& mode);
    // False when out of memory; nothing has then been done.
    bool prepare();
    void run();
    bool starved() const { return starved_; } // for lack of memory, bodies passed through each other

private:
    static constexpr uint32_t none = UINT32_MAX;

    BodyContactBatch& member_of(uint32_t body) const;
    float* before(uint32_t body, size_t field) const;
    bool wet(const BodyContactBatch& member, uint32_t body) const;
    Pose began(uint32_t body) const;
    // Calls function(member, begin, end) for pieces of batches, `length` lanes each; a thread takes `grain` of them.
    template <class Function> void each_piece(uint32_t length, uint32_t grain, const Function& function) const {
        const auto pieces_of = [&](const BodyContactBatch& member) {
            return (whole_blocks(member.count) + length - 1) / length;
        };
        uint32_t pieces = 0;
        for (uint32_t m = 0; m < member_count_; ++m) pieces += pieces_of(buffers_->members[m]);
        workers_.run(pieces, grain, [&](uint32_t first, uint32_t past) {
            for (uint32_t at = first; at < past; ++at) {
                const BodyContactBatch* member = buffers_->members.data();
                uint32_t piece = at;
                for (; piece >= pieces_of(*member); ++member) piece -= pieces_of(*member);
                function(*member, piece * length, std::min((piece + 1) * length, whole_blocks(member->count)));
            }
        });
    }

    void move_alone(uint32_t substep);
    void move_cut(const BodyContactBatch& member, uint32_t begin, uint32_t end, uint32_t substep) const;

    // body_contact/body_contact_pairs.cpp
    bool find_pairs(uint32_t substep);
    float margin_of(const BodyContactBatch& member, uint32_t index) const;
    bool finds(uint32_t one, uint32_t other, bool mutual) const;
    void set_box(const BodyContactBatch& member, uint32_t index);
    void keep_first(uint32_t* seen, uint32_t body) const;
    void meet(uint32_t begin, uint32_t end);
    bool number_touching();

    // body_contact/body_contact_shelter.cpp
    void ask_for_shelter(const BodyContactBatch& member, uint32_t index, uint32_t substep);
    void hide_each_other(uint32_t one, uint32_t other);
    void find_shelter();
    bool in_question(const BodyContactBatch& member, uint32_t index, uint32_t substep) const;
    void move_sheltered(const BodyContactBatch& member, uint32_t begin, uint32_t end, uint32_t substep) const;

    // body_contact/body_contact_manifolds.cpp
    bool in_order(const BodyContactBuffers::Pair& pair) const; // a has the lower key
    void enter_manifold(uint32_t at, const Manifold& manifold, float within);
    void enter_contacts(uint32_t at, const WayContact* found);
    PathFriction friction_before(uint32_t at) const; // of a pair, the guess for this substep
    void keep_impulses();
    bool begin_pairs(uint32_t most);

    // body_contact/body_contact_response.cpp
    // apart: bodies that touch no other awake one. touching: all others, one by one, if there is no memory to solve them together.
    enum class Held { apart, touching };
    void hold(uint32_t substep, Held which);
    void hold_group(const BodyContactBatch& member, uint32_t first, uint32_t substep, Held which);
    void take_out(ContactGroup& group, uint32_t lane, uint32_t place);
    bool solve();
    void fill_body(uint32_t place);
    uint32_t list_units();
    void find_carried(); // marks bodies that touch a slow collider, if only through others
    void put_back(uint32_t place, uint32_t substep);
    Touch touch_with(uint32_t place, uint32_t collider) const;
    // Calls function(k, impulse) for each contact of a body with fixed things; impulse as in BodyContactSolver::pressed().
    template <class Function> void each_held(uint32_t place, const Function& function) const;
    bool last(uint32_t substep) const { return substep + 1 == time_.substeps; }

    lr_world* world_;
    BodyContactBuffers* buffers_;
    const StepItem* items_;
    Workers workers_;
    uint32_t member_count_, body_count_ = 0, place_count_ = 0, unit_count_ = 0, tile_levels_ = 0;
    StepTime time_{};
    WaterStep surface_{};
    bool wet_, starved_ = false;
    std::atomic<uint32_t> held_used_{0};
};
} // namespace lr
