// Points of a body that are held against a heightfield: its corners, and some on its faces, which a ridge between two slopes
// would else go through.
#pragma once

#include "contact/body_shape.h"

namespace lr {

inline constexpr uint32_t most_ground_samples = most_shape_points + 16;

struct GroundSamples {
    uint32_t count;
    float x[most_ground_samples], y[most_ground_samples], z[most_ground_samples]; // m, as BodyShape's points
};

GroundSamples make_ground_samples(const BodyShape& shape);

} // namespace lr
