// Where two bodies meet in a substep: contacts as it begins, held against the way that both go. docs/body_contact.md
#pragma once

#include "contact/body_pair.h"

#include <cstdint>

namespace lr {

struct PairBody {
    const MeetingShape& shape;
    float scale;
    Pose from, to;
    float way; // m, of its farthest point
};
// How far the farthest point of a body of this reach (m) goes.
float way_of(const Pose& from, const Pose& to, float reach);

struct WayContact {
    PairContact begin;
    float end; // m, the gap at the end of the way
};

// Those that end nearer than `margin` (m). Returns how many.
uint32_t find_way_contacts(const PairBody& a, const PairBody& b, float margin, WayContact (&out)[most_pair_contacts]);

} // namespace lr
