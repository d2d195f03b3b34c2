// Contacts of pairs of bodies: found at the beginning of a substep, tested against the paths of both. Pairs of the same two shapes are searched side
// by side, one per lane. docs/maintainers/contact.md, section 12.
#pragma once

#include "base/float4.h"
#include "collision/body_narrow_phase.h"
#include "kernel/contact/gjk_pairs.h"

#include <cstdint>

namespace lr {

// Relative placement of two bodies in the first one's own frame, in units of its scale.
struct RelativePair {
    const PairHull* a;
    const PairHull* b;
    float ratio;    // of the scales, b over a
    Vector offset;  // from a's origin to b's
    Vector axes[3]; // of b's own frame, unit
    float size;     // the larger of the cores' reaches
};
struct PlacedPair : RelativePair {
    alignas(16) float x[most_shape_points], y[most_shape_points], z[most_shape_points]; // of b's points

    explicit PlacedPair(const RelativePair& pair) : RelativePair(pair) {
        const Vector u = ratio * axes[0], v = ratio * axes[1], w = ratio * axes[2];
        for (uint32_t i = 0; i < b->padded; i += PairHull::lanes) {
            const Float4 bx = load(b->x + i), by = load(b->y + i), bz = load(b->z + i);
            store(offset.x + bx * u.x + by * v.x + bz * w.x, x + i);
            store(offset.y + bx * u.y + by * v.y + bz * w.y, y + i);
            store(offset.z + bx * u.z + by * v.z + bz * w.z, z + i);
        }
    }
    Vector turned(Vector of_b) const { return of_b.x * axes[0] + of_b.y * axes[1] + of_b.z * axes[2]; }
    Vector to_b(Vector d) const { return {dot(axes[0], d), dot(axes[1], d), dot(axes[2], d)}; }
    Vector point_b(uint32_t i) const { return {x[i], y[i], z[i]}; }
};

// A pair whose boxes are near each other.
struct NearPair {
    RelativePair pair;
    Rotation own_a; // takes vectors from a's own frame to the world
    float scale_a, scale_b;
    // In units of a's scale: b's rounding; core gap below which they touch; tolerance of distances.
    float radius_b, enough, tolerance;
    Vector start; // first guess of the normal
    bool swapped; // a and b are swapped relative to the call
};
// Places the pair at the beginning of the substep; symmetric in a and b. False if farther apart than `margin` (m, >= 0), or not finite.
bool relate(const PairBody& a, const PairBody& b, float margin, NearPair& out);

// Share of the larger core: cores closer than this give a direction that is only rounding.
inline constexpr float touching_cores = 3e-5f;

struct Closest {
    enum class State : uint8_t { apart, beyond, overlap };
    State state;
    Vector normal;     // unit, from b to a
    float distance;    // of the two points
    Vector on_a, on_b; // a's point with the shift of a's core
};

// Converts points on cores to contacts of bodies.
class ContactFrame {
public:
    // normal: from b to a, in the pair's frame. shift: displacement that drew a's core out of b's.
    ContactFrame(const NearPair& near, Vector normal, Vector shift);
    // gap: between the cores at this point, shift included.
    PairContact contact(Vector on_core_b, float gap) const;

private:
    const NearPair& near_;
    Vector normal_, world_normal_, shift_;
};

// Manifold of a pair from its nearest points: the contacts that hold it best. Returns their number.
uint32_t contacts_of(const NearPair& near, Closest closest, PairContact (&out)[most_pair_contacts]);

struct WayContact {
    static constexpr uint32_t swept = UINT32_MAX;
    PairContact begin;
    float end;     // m, gap at the end of the substep
    uint32_t from; // index of the contact in the manifold; swept: none, made for the end of the substep
    Vector end_a;  // m: a's arm at the end of the substep
};
// All contacts of a pair at the beginning of the substep.
struct Manifold {
    PairContact contact[most_pair_contacts];
    uint32_t count;
};

// Gap (m) at the beginning below which a contact can come closer than `margin` (m) by the end.
float near_enough(const PairBody& a, const PairBody& b, float margin);
// Box of a body for NearBoxes, which searches pairs that come nearer than the smaller of their margins (m).
PlacedBox placed_box(const PairBody& body, float margin);
uint32_t keep_way_contacts(const PairBody& a, const PairBody& b, float margin, const Manifold& found,
                           WayContact (&out)[most_pair_contacts]);

// The result of a pair does not depend on the other pairs of the batch.
class PairBatch {
public:
    explicit PairBatch(PairSearch* target) : target_(target) {}

    // Calls found(id, contacts, count, manifold) once for each pair, in this or a later call, at the latest in finish(); bodies must live until then.
    // farther: m, by which the manifold reaches beyond the contacts of this substep, so that it can be kept.
    template <class Found>
    void find(const PairBody& a, const PairBody& b, float margin, float farther, uint32_t id, const Found& found) {
        Waiting& next = waiting_[count_];
        if (!relate(a, b, near_enough(a, b, margin) + farther, next.near)) {
            found(id, nullptr, 0, Manifold{});
            return;
        }
        next.a = &a;
        next.b = &b;
        next.margin = margin;
        next.id = id;
        if (++count_ == most) finish(found);
    }
    template <class Found> void finish(const Found& found) {
        for (uint32_t first = 0; first < count_;) {
            const uint32_t lanes = search(first);
            for (uint32_t lane = 0; lane < lanes; ++lane, ++first) {
                const Waiting& waiting = waiting_[order_[first]];
                const Manifold manifold = manifold_at(first, lane);
                WayContact contacts[most_pair_contacts];
                const uint32_t count = keep_way_contacts(*waiting.a, *waiting.b, waiting.margin, manifold, contacts);
                found(waiting.id, contacts, count, manifold);
            }
        }
        count_ = 0;
    }

private:
    static constexpr uint32_t most = 4 * search_lanes;
    struct Waiting {
        NearPair near;
        const PairBody *a, *b;
        float margin;
        uint32_t id;
    };
    // Searches the pairs from `first` on that have its shapes; returns their number.
    uint32_t search(uint32_t first);
    Manifold manifold_at(uint32_t at, uint32_t lane) const;

    PairSearch* target_;
    uint32_t count_ = 0;
    uint32_t order_[most];
    Waiting waiting_[most];
    SearchBlock block_;
};
} // namespace lr
