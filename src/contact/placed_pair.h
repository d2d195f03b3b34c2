// Two bodies as they lie to each other: in the own frame of the first, its scale as the unit of length.
#pragma once

#include "contact/body_pair.h"
#include "contact/four.h"

namespace lr {

struct RelativePair {
    const MeetingShape* a;
    const MeetingShape* b;
    float ratio;    // of the scales, b over a
    Vector offset;  // from a's origin to b's
    Vector axes[3]; // of b's own frame, unit
    float size;     // the larger of the cores' reaches
};
struct PlacedPair : RelativePair {
    alignas(16) float x[MeetingShape::room], y[MeetingShape::room], z[MeetingShape::room]; // of b's points

    Vector turned(Vector of_b) const { return of_b.x * axes[0] + of_b.y * axes[1] + of_b.z * axes[2]; }
    Vector to_b(Vector d) const { return {dot(axes[0], d), dot(axes[1], d), dot(axes[2], d)}; }
    Vector point_a(uint32_t i) const { return {a->x[i], a->y[i], a->z[i]}; }
    Vector point_b(uint32_t i) const { return {x[i], y[i], z[i]}; }
    void place_points() {
        const Vector u = ratio * axes[0], v = ratio * axes[1], w = ratio * axes[2];
        // Room for the ends of the last edges too.
        for (uint32_t i = 0; i < b->padded + (b->padded < MeetingShape::room ? MeetingShape::lanes : 0);
             i += MeetingShape::lanes) {
            const Four bx = load(b->x + i), by = load(b->y + i), bz = load(b->z + i);
            store(offset.x + bx * u.x + by * v.x + bz * w.x, x + i);
            store(offset.y + bx * u.y + by * v.y + bz * w.y, y + i);
            store(offset.z + bx * u.z + by * v.z + bz * w.z, z + i);
        }
    }
};

// The point of a core farthest along a direction, and how far.
inline uint32_t farthest(const float* x, const float* y, const float* z, uint32_t padded, Vector d, float& along) {
    Greatest found(load(x) * d.x + load(y) * d.y + load(z) * d.z);
    for (uint32_t i = MeetingShape::lanes; i < padded; i += MeetingShape::lanes)
        found.offer(load(x + i) * d.x + load(y + i) * d.y + load(z + i) * d.z, static_cast<int32_t>(i));
    uint32_t at = 0;
    along = found.get(at);
    return at;
}
// In a plate's own plane.
inline uint32_t farthest(const float* x, const float* y, uint32_t padded, float dx, float dy, float& along) {
    Greatest found(load(x) * dx + load(y) * dy);
    for (uint32_t i = MeetingShape::lanes; i < padded; i += MeetingShape::lanes)
        found.offer(load(x + i) * dx + load(y + i) * dy, static_cast<int32_t>(i));
    uint32_t at = 0;
    along = found.get(at);
    return at;
}
inline uint32_t farthest_of_a(const PlacedPair& pair, Vector d, float& along) {
    const MeetingShape& a = *pair.a;
    return a.flat ? farthest(a.x, a.y, a.padded, d.x, d.y, along) : farthest(a.x, a.y, a.z, a.padded, d, along);
}
inline uint32_t farthest_of_b(const PlacedPair& pair, Vector d, float& along) {
    return farthest(pair.x, pair.y, pair.z, pair.b->padded, d, along);
}
// The same without how far.
inline uint32_t support_of_b(const PlacedPair& pair, Vector d) {
    const MeetingShape& b = *pair.b;
    float along = 0.0f;
    return b.flat ? farthest(b.x, b.y, b.padded, dot(pair.axes[0], d), dot(pair.axes[1], d), along)
                  : farthest(pair.x, pair.y, pair.z, b.padded, d, along);
}

// A pair whose boxes are near each other.
struct NearPair {
    RelativePair pair;
    Rotation own_a; // takes vectors from a's own frame to the world
    float scale_a, scale_b;
    float radius_b, enough,
        tolerance; // a's scale as the unit: b's rounding; gaps of cores below which they touch; of distances
    Vector start;  // a guess of the normal
    bool swapped;  // a and b are the other way round than they were given
};
// False: farther apart than `margin` (m).
bool relate(const MeetingShape& a, float scale_a, const Pose& at_a, const MeetingShape& b, float scale_b,
            const Pose& at_b, float margin, NearPair& out);

// Nearer than the larger core times this, rounding decides what the direction is.
inline constexpr float touching_cores = 3e-5f;

// Where the cores are nearest.
struct Closest {
    enum class State : uint8_t { apart, beyond, overlap };
    State state;
    Vector normal;     // unit, from b to a
    float distance;    // of the two points
    Vector on_a, on_b; // of a with its shift
};

// What holds the pair: points on both cores, up to most_pair_contacts of them.
struct PairPoint {
    Vector on_a, on_b; // of the cores, of a without the shift
    float gap;         // along the normal, cores without the shift
};
// closest: of the pair with a moved by `shift`. enough: greatest gap of cores.
uint32_t spread_points(const PlacedPair& pair, const Closest& closest, Vector shift, float enough,
                       PairPoint (&out)[most_pair_contacts]);

// With what is known of that: where they touch.
uint32_t contacts_of(const NearPair& near, const PlacedPair& pair, Closest closest,
                     PairContact (&out)[most_pair_contacts]);
// All of it, for one pair.
uint32_t search_contacts(const NearPair& near, PairContact (&out)[most_pair_contacts]);

} // namespace lr
