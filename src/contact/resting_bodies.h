// Bodies at rest as those that move see them: they stand still, and hold what touches them.
#pragma once

#include "contact/body_pair.h"

#include <cstdint>

namespace lr {

inline constexpr uint32_t most_resting = 32; // near one body, by batch and key

struct RestingTouch {
    uint32_t batch, index; // of the body at rest: batch slot and dense index
    float friction, restitution;
    uint32_t count;
    PairContact contact[most_pair_contacts]; // a: the body that moves; gaps at the end of its way
};

class RestingBodies {
public:
    // Those that the body of this key touches at `to`, or will be nearer to than `margin` (m). Returns how many. Any thread.
    virtual uint32_t touched_by(uint32_t key, float scale, const Pose& from, const Pose& to, float margin,
                                RestingTouch (&out)[most_resting]) const = 0;

protected:
    RestingBodies() = default;
    RestingBodies(const RestingBodies&) = default;
    RestingBodies& operator=(const RestingBodies&) = default;
    ~RestingBodies() = default;
};

} // namespace lr
