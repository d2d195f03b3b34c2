// Solves touching bodies together: Gauss-Seidel over the pairs within each tile, then over pairs between tiles. docs/maintainers/contact.md
#pragma once

#include "base/allocator.h"
#include "base/pose.h"
#include "base/step_workers.h"
#include "kernel/contact/body_contact.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace lr {

struct BodyContactPoint {
    Vector arm_a, arm_b;  // m, body frames, from the centres of mass; time as for the gap
    float gap;            // m: between bodies at the beginning of the substep; to a fixed thing at its end
    float pressed = 0.0f; // warm start of the first short step: impulse over the lighter body's mass unit, m
    uint32_t from = 0;    // which contact of the pair's manifold, or WayContact::swept
};

// Friction impulses of a short step over the lighter body's mass unit, m: the force on a in the world frame; the couple about the
// normal.
struct PathFriction {
    Vector drag{};
    float spin = 0.0f; // over a's d s
};

// The same for all contacts of a unit.
struct BodyContactFrame {
    Vector normal;       // world, unit, from b to a
    Vector surface, lag; // m/s, m: motion of a fixed thing, as in ContactSlots
    float friction, restitution;
    bool solid; // the fixed thing is a collider
    PathFriction guess{};
};

// A unit: up to block_contacts contacts of a body with another one, or with a fixed thing.
struct BodyContactPair {
    static constexpr uint32_t nobody = UINT32_MAX;
    uint32_t a, b; // bodies by index; b: nobody, or another
    const BodyContactFrame* frame;
    const BodyContactPoint* contact;
    uint32_t count;
    uint32_t source = 0; // the caller's own number for the unit
    // Set by the solver.
    uint32_t group = 0, block = 0, lane = 0;
    bool swapped = false; // a and b are swapped relative to the contacts
};

// Bodies [begin, begin + count) are of one kind; each kind begins at a multiple of contact_lanes.
struct BodyContactRange {
    uint32_t kind, begin, count;
};

struct BodyContactScene {
    const SolverBodyKind* kinds;
    const BodyContactRange* ranges;
    uint32_t range_count;
    // In the same order on every machine. A body's units with fixed things are consecutive. solve() can swap the bodies of a unit.
    BodyContactPair* units;
    uint32_t unit_count;
    const uint32_t* tile; // by body
    uint32_t tile_levels; // tiles are below 2^tile_levels (contact_tiles.h)
};

class BodyContactSolver {
public:
    explicit BodyContactSolver(Allocator& allocator) : allocator_(&allocator) {}

    // Room for so many bodies, with the padding of kinds; contents are lost. False when out of memory.
    bool reserve_bodies(uint32_t count);
    SolverBody* bodies() { return bodies_.data(); }

    // False when out of memory; nothing has then been done.
    bool solve(const BodyContactTarget& target, float h, float gravity, const BodyContactScene& scene,
               const Workers& workers);

    // After solve(): the impulse along the normal over a's mass unit, m/s; negative if they do not touch. Below the solver's tolerance impulses are
    // not corrected: a contact that carries nothing can have a small negative one.
    float pressed(const BodyContactPair& unit, uint32_t contact) const {
        const PairBlock& block = blocks_[unit.block];
        const bool touching = block.place[contact].touching[unit.lane] > 0.0f;
        return touching ? std::max(block.row[contact].pressed[unit.lane], 0.0f) : -1.0f;
    }
    // After solve(): the impulse of the last short step, as BodyContactPoint::pressed. 0 after a blow faster than `slow` (m/s): it does not
    // come again.
    float path_pressed(const BodyContactPair& unit, uint32_t contact, float slow) const {
        const PairBlock::Place& place = blocks_[unit.block].place[contact];
        return place.came[unit.lane] < -slow ? 0.0f : place.start[unit.lane];
    }
    PathFriction path_friction(const BodyContactPair& unit) const {
        const PairBlock& block = blocks_[unit.block];
        const Vector on_a = vector_in(block.start_drag, 0, unit.lane);
        return {unit.swapped ? -on_a : on_a, block.start_spin[unit.lane]};
    }

private:
    uint32_t kind_of(uint32_t body) const { return kind_of_[body / static_cast<uint32_t>(contact_lanes)]; }
    uint32_t kind_b(const BodyContactPair& u) const { return kind_of(u.b == BodyContactPair::nobody ? u.a : u.b); }
    float mass(const SolverBodyKind* kinds, uint32_t body) const;
    bool lay_out(const BodyContactScene& scene);
    uint32_t group_of(const BodyContactScene& scene, const BodyContactPair& unit) const;
    bool sort_units(const BodyContactScene& scene);
    void fill_blocks(const BodyContactScene& scene);
    void fill(const SolverBodyKind* kinds, uint32_t index);
    bool list_tiles(const BodyContactScene& scene);
    std::span<PairBlock> blocks_of(uint32_t task);
    template <class Function> void each_task(const Workers& workers, const Function& function);
    template <class Function> void each_block(const Workers& workers, const Function& function);
    template <class Function> void each_lanes(const Workers& workers, const Function& function);
    void sweep(const BodyContactTarget& target, const BodyContactInput& in, const Workers& workers, bool rolls,
               uint32_t most);
    void start_velocities(const BodyContactScene& scene, float h);
    void hold(const BodyContactTarget& target, const BodyContactInput& in, const Workers& workers);
    void restrain(const BodyContactTarget& target, const BodyContactInput& in, const Workers& workers);

    Allocator* allocator_;
    uint32_t body_count_ = 0, block_count_ = 0, lanes_count_ = 0;
    uint32_t tile_levels_ = 0, task_count_ = 0, group_count_ = 0;
    Buffer<SolverBody> bodies_; // the last one stands for fixed things
    Buffer<SolverTwist> twists_, twists_before_, directions_;
    Buffer<SolverSteps> steps_;
    Buffer<uint32_t> kind_of_; // by contact_lanes of bodies
    struct Run {
        uint32_t begin, end; // bodies
    };
    Buffer<uint32_t> first_run_; // by tile, and the end
    Buffer<Run> runs_;
    Buffer<uint32_t> first_unit_, first_block_; // by group, and the end
    Buffer<const BodyContactPair*> order_, spare_;
    Buffer<const BodyContactPair*> unit_of_; // by block and lane; null: none
    Buffer<PairBlock> blocks_;
    // Disjoint sets of bodies that touch. A heap's first body holds the sums over the heap's units.
    struct Heap {
        uint32_t parent;
        double stopping, moving;
    };
    Buffer<Heap> heaps_; // by body
    // Result of a task's last sweep. Each has its own cache line, as the core that sweeps the task writes it.
    struct alignas(64) Swept {
        double squares;
        bool changed;
    };
    Buffer<Swept> swept_;
    // The blocks that hold a body already: bits, from the first block of the current window of 64 blocks.
    struct Holding {
        uint32_t window;
        uint64_t blocks;
    };
    Buffer<Holding> holding_; // by body
};
} // namespace lr
