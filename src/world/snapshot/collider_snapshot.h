// The colliders in a snapshot: written, and restored in two steps, so that nothing changes before all of it is valid.
#pragma once

#include "collision/colliders.h"

namespace lr {

class ColliderSnapshot {
public:
    // Part of the snapshot's header.
    struct Head {
        uint32_t slots, count;
        uint32_t free_first, free_last;
    };
    static Head head(const Colliders& c) { return {c.used_, c.count_, c.free_first_, c.free_last_}; }
    // Size of the slots and colliders after the header: a multiple of 8.
    static uint64_t bytes(const Head& head) {
        return sizeof(Slot) * uint64_t{head.slots} + sizeof(ColliderRecord) * uint64_t{head.count};
    }
    static void save(const Colliders& colliders, unsigned char* to);

    explicit ColliderSnapshot(Colliders& colliders) : to_(&colliders) {}

    // from: the slots; at most `size` bytes remain in the snapshot. Kept for commit().
    lr_status read(const Head& head, const unsigned char* from, uint64_t size);
    // After read(): whether there are colliders.
    bool any() const { return head_.count != 0; }
    // Only after read(); cannot fail.
    void commit();

private:
    struct Slot {
        uint32_t generation;
        uint32_t link; // the next free slot, or `taken`
    };
    static constexpr uint32_t taken = UINT32_MAX - 1, none = UINT32_MAX;

    template <class Write> static bool visit(const Colliders& colliders, Write&& write);
    bool is_there() const;
    bool free_slots_make_a_chain() const;
    Slot slot(uint32_t i) const;
    ColliderRecord record(uint32_t i) const;
    SharedGeometry* shared(const ColliderRecord& record) const;

    Colliders* to_;
    const unsigned char* slots_ = nullptr;
    Head head_{};
    bool same_ = false; // they equal the world's present ones
};
} // namespace lr
