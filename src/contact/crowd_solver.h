// Bodies that touch each other, solved together: pairs in colours that share no body, and sweeps over these. docs/maintainers/contact.md
#pragma once

#include "contact/pose.h"
#include "kernel/crowd.h"
#include "world/allocator.h"
#include "world/workers.h"

#include <cstdint>

namespace lr {

struct CrowdContact {
    Vector arm_a, arm_b; // m, body frames, from the centres of mass
    Vector normal;       // world, unit, from b to a
    float gap;           // m: of a pair as the substep began, with nobody at its end
    Vector surface, lag; // m/s, m: of nobody, as ContactSlots
    float friction, restitution;
    bool solid; // a collider's
};

// Up to block_contacts contacts of a body with another, or with what is not moved.
struct CrowdUnit {
    static constexpr uint32_t nobody = UINT32_MAX;
    uint32_t a, b; // bodies by index; b: nobody, or another
    const CrowdContact* contact;
    uint32_t count;
    // Of the solver.
    uint32_t colour, block, lane;
    bool swapped; // a and b are not those of the contacts
};

// Bodies [begin, begin + count) are of a kind; each kind begins at a multiple of contact_lanes.
struct CrowdRange {
    uint32_t kind, begin, count;
};

class CrowdSolver {
public:
    explicit CrowdSolver(Allocator& allocator) : allocator_(&allocator) {}

    // Room for so many, padding of kinds included; false when out of memory. Their contents are lost.
    bool reserve_bodies(uint32_t count);
    CrowdBody* bodies() { return bodies_.data(); }

    // Units in an order that is the same on every machine; those of a body with nobody one after the other. The bodies of a unit
    // may change places. False when out of memory, and then nothing has been done.
    bool solve(const CrowdTarget& target, float h, float gravity, const CrowdKind* kinds, const CrowdRange* ranges,
               uint32_t range_count, CrowdUnit* units, uint32_t unit_count, const Workers& workers);

    // After it. The impulse along the normal over a's mass unit, m/s; negative where they do not touch.
    float pressed(const CrowdUnit& unit, uint32_t contact) const {
        const PairContacts& c = blocks_[unit.block].contact[contact];
        return c.touching[unit.lane] > 0.0f ? c.pressed[unit.lane] : -1.0f;
    }

private:
    bool lay_out(const CrowdKind* kinds, const CrowdRange* ranges, uint32_t range_count, CrowdUnit* units,
                 uint32_t unit_count);
    void order_pairs(const CrowdKind* kinds, CrowdUnit* units, uint32_t unit_count);
    void colour(CrowdUnit* units, uint32_t unit_count);
    void fill(const CrowdKind* kinds, const CrowdUnit* const* units, PairBlock& block) const;
    template <class Function> void each_block(const Workers& workers, uint32_t from, Function&& function);
    template <class Function> void each_group(const Workers& workers, Function&& function);
    void sweep(const CrowdTarget& target, const CrowdInput& in, const Workers& workers, bool rolls);
    void restrain(const CrowdTarget& target, const CrowdInput& in, const Workers& workers);

    Allocator* allocator_;
    uint32_t body_count_ = 0, unit_count_ = 0, block_count_ = 0, group_count_ = 0;
    uint32_t colour_count_ = 0, pair_colours_ = 0; // what is not moved has the last
    Buffer<CrowdBody> bodies_;                     // and nobody
    Buffer<CrowdTwist> twists_;
    Buffer<uint64_t> used_colours_; // by body
    Buffer<uint32_t> kind_of_;      // by group of bodies
    Buffer<const CrowdUnit*> order_, spare_;
    Buffer<PairBlock> blocks_;
    Buffer<uint32_t> first_block_; // by colour, and the end
    Buffer<uint32_t> first_unit_;  // by block, and the end
};

} // namespace lr
