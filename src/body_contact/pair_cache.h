// Pairs of touching bodies, kept from substep to substep: where they were searched, the contacts found, and the impulses that held
// them. State: hash and snapshots contain it. docs/maintainers/contact.md
#pragma once

#include "base/allocator.h"
#include "base/pose.h"
#include "collision/body_narrow_phase.h"

#include <cstdint>
#include <type_traits>

namespace lr {

// A body across substeps: its batch's slot and its noise seed.
constexpr uint64_t pair_key(uint32_t slot, uint32_t noise_seed) {
    return uint64_t{slot} << 32 | noise_seed;
}
constexpr uint32_t slot_of_key(uint64_t key) {
    return static_cast<uint32_t>(key >> 32);
}

// Two touching bodies; a has the lower key. Frames: of the bodies themselves.
struct CachedPair {
    uint64_t a, b;  // keys
    Vector offset;  // m, a's frame: from a to b as they were searched
    Rotation turn;  // of b, in a's frame
    float within;   // m: all contacts with smaller gaps were found
    Vector normal;  // from b to a, in the frame of the body whose face it is
    uint16_t count; // of contacts
    uint16_t of_b;  // whose face: 0: a's, 1: b's
    // Impulses of the path projection, over h^2 and the lighter body's mass unit, m/s^2: friction on a, in its frame, and about the normal.
    Vector drag;
    float spin; // over the lighter body's d s
    struct Contact {
        Vector arm_a, arm_b; // m
        float pressed;
    } contact[most_pair_contacts];
};
static_assert(std::is_trivially_copyable_v<CachedPair> && sizeof(CachedPair) % 8 == 0);

class PairCache {
public:
    // Null: not kept. a < b.
    const CachedPair* find(uint64_t a, uint64_t b) const;

    // Room for so many pairs. False when out of memory. The pairs stay as they are.
    bool reserve(Allocator& allocator, uint32_t count);

    // Replaces the pairs of batches for which replaces(slot): room for `most` new ones, which are then filled in, then commit(). Until then
    // the former pairs can be read. False when out of memory: the pairs stay as they are.
    template <class Replaces> bool begin(Allocator& allocator, uint32_t most, const Replaces& replaces) {
        if (!reserve(allocator, most + count_)) return false;
        next_count_ = 0;
        for (uint32_t i = 0; i < count_; ++i)
            if (!replaces(slot_of_key(pairs_[i].a)) || !replaces(slot_of_key(pairs_[i].b)))
                next_[next_count_++] = pairs_[i];
        return true;
    }
    CachedPair* next() { return next_.data() + next_count_; }
    void commit(uint32_t most); // new ones without contacts are dropped
    void clear();
    void forget(uint32_t slot); // a batch that ends

    uint64_t hash() const; // of the pairs in any order; 0 without pairs

    // As in a snapshot, bytes of any alignment.
    const CachedPair* pairs() const { return pairs_.data(); }
    uint32_t count() const { return count_; }
    static bool consistent(const unsigned char* from, uint32_t count, uint32_t slots); // for so many batches
    void fill(const unsigned char* from, uint32_t count);                              // reserved before

private:
    void index();

    Buffer<CachedPair> pairs_, next_;
    Buffer<uint32_t> table_; // hash table of indices + 1; 0: empty
    uint32_t count_ = 0, next_count_ = 0, mask_ = 0;
};
} // namespace lr
