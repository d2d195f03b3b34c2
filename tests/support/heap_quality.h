// Quality of a heap of equal boxes: overlaps by separating axes, height and tremor. Shares no code with the library, whose poses it reads through the
// public API.
#pragma once

#include "support/vector.h"

#include "langevin_rigid.h"

#include <cstdint>
#include <vector>

namespace test {

struct Pose {
    Vec position; // m, the centre of the box
    Quat turn;    // box to world
};

// Depth of two boxes in each other, m: the least overlap over the 15 axes that can separate them. Negative if they are apart. half: half extents.
double overlap_depth(const Vec& half, const Pose& a, const Pose& b);

struct HeapQuality {
    double overlaps = 0.0;                     // pairs deeper than 0.1 mm, over bodies
    double depth_median = 0.0, depth_99 = 0.0; // m, over pairs deeper than 0.01 mm; 0 if there are none
    double share_deep = 0.0;                   // of bodies deeper in another one than their thickness
    double height_mean = 0.0, height_95 = 0.0; // m, of centres above y = 0
};
HeapQuality heap_quality(const Vec& half, const std::vector<Pose>& poses);

// The largest distance that any corner moved, m. Both lists hold the same bodies in the same order.
double largest_movement(const Vec& half, const std::vector<Pose>& before, const std::vector<Pose>& after);

struct HeapState {
    std::vector<Pose> poses; // by id
    uint32_t awake = 0;
    double awake_speed = 0.0; // m/s, rms over awake bodies
};
// Empty after an error.
HeapState heap_state(const lr_world* world, lr_batch batch);

} // namespace test
