// Where two bodies meet in a substep: contacts as it begins, held against the way that both go. docs/maintainers/contact.md
#pragma once

#include "contact/body_pair.h"

#include <cstdint>

namespace lr {

struct PairBody {
    const MeetingShape* shape;
    float scale;
    Pose from, to;
    // m: of the centre of mass, and of the farthest point about it.
    Vector shift;
    float turns;
    // How far its farthest point goes.
    float way() const { return length(shift) + turns; }
};
PairBody pair_body(const MeetingShape& shape, float scale, const Pose& from, const Pose& to);

struct WayContact {
    PairContact begin;
    float end; // m, the gap at the end of the way
};

// Of those that end nearer than `margin` (m): how near they must be as the substep begins (m), and which of those that are near then
// count. Returns how many.
float near_enough(const PairBody& a, const PairBody& b, float margin);
uint32_t keep_way_contacts(const PairBody& a, const PairBody& b, float margin,
                           const PairContact (&found)[most_pair_contacts], uint32_t count,
                           WayContact (&out)[most_pair_contacts]);

} // namespace lr
