// Pairs of touching bodies, kept from substep to substep: their poses when they were searched, the contacts found, and the impulses that
// held them. It is state: hash and snapshots contain it. docs/maintainers/contact.md
#pragma once

#include "base/allocator.h"
#include "base/pose.h"
#include "collision/body_narrow_phase.h"

#include <algorithm>
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

// To the nearest of 65,535 steps from -1 to 1.
constexpr int16_t packed_part(float x) {
    const float steps = 32767.0f * std::clamp(x, -1.0f, 1.0f);
    return static_cast<int16_t>(static_cast<int32_t>(steps + (steps < 0.0f ? -0.5f : 0.5f)));
}
struct PackedVector {
    int16_t part[3];
    static constexpr PackedVector of(Vector v, float most) {
        const float scale = 1.0f / most;
        return {{packed_part(scale * v.x), packed_part(scale * v.y), packed_part(scale * v.z)}};
    }
    constexpr Vector times(float most) const {
        const float step = most * (1.0f / 32767.0f);
        return {step * static_cast<float>(part[0]), step * static_cast<float>(part[1]),
                step * static_cast<float>(part[2])};
    }
};
// A unit quaternion: its largest component, which is made positive, follows from the others.
struct PackedRotation {
    uint64_t bits;
    static PackedRotation of(Rotation q);
    Rotation unpacked() const;
};

// Two touching bodies; a has the lower key. Frames: of the bodies themselves.
struct CachedPair {
    uint64_t a, b;       // keys
    PackedRotation turn; // of b, in a's frame, when they were searched
    Vector offset;       // m, a's frame: from a to b, likewise
    float within;        // m: all contacts with smaller gaps were found
    PackedVector normal; // unit, from b to a, in the frame of the body whose face it is
    uint8_t count;       // of contacts
    uint8_t sides;       // bits: whose frame `normal` is in, and whose points `arm` holds
    // Impulses of the path projection over h^2 and the lighter body's mass unit, m/s^2: friction on a, in a's frame; friction about the
    // normal; normal impulses.
    Vector drag;
    float spin; // over the lighter body's d s
    float pressed[most_pair_contacts];
    float gap[most_pair_contacts]; // m
    PackedVector
        arm[most_pair_contacts]; // of the smaller body, over its reach; the other's point lies along the normal

    static constexpr uint8_t face_of_b = 1, arms_of_b = 2;
};
static_assert(std::is_trivially_copyable_v<CachedPair> && sizeof(CachedPair) == 120);

class PairCache {
public:
    // Null: not kept. a < b.
    const CachedPair* find(uint64_t a, uint64_t b) const;

    // Room for so many pairs. False when out of memory. The pairs stay as they are.
    bool reserve(Allocator& allocator, uint32_t count);

    // Replaces the pairs of batches for which replaces(slot): makes room for `most` new ones at next(). The caller fills them in and calls
    // commit(). Until then the former pairs can be read. False when out of memory: the pairs stay as they are.
    template <class Replaces> bool begin(Allocator& allocator, uint32_t most, const Replaces& replaces) {
        const auto stays = [&](const CachedPair& pair) {
            return !replaces(slot_of_key(pair.a)) || !replaces(slot_of_key(pair.b));
        };
        const CachedPair* from = pairs_.data();
        const auto kept = std::count_if(from, from + count_, stays);
        if (!reserve(allocator, most + static_cast<uint32_t>(kept))) return false;
        from = pairs_.data();
        next_count_ = static_cast<uint32_t>(std::copy_if(from, from + count_, next_.data(), stays) - next_.data());
        return true;
    }
    CachedPair* next() { return next_.data() + next_count_; }
    void commit(uint32_t most); // drops new ones without contacts
    void clear() { count_ = mask_ = 0; }
    void forget(uint32_t slot); // pairs of a batch that ends, or whose bodies have changed their shape

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
