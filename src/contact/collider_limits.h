// What colliders may be given: of setters and of snapshots.
#pragma once

#include "kernel/limits.h"
#include "langevin_rigid.h"

namespace lr {

// Null when fine, else what is wrong.
inline const char* wrong_velocity(const float (&linear)[3], const float (&angular)[3]) {
    if (!within(linear, most_speed)) return "linear_velocity is over 1e6 m/s";
    return within(angular, most_speed) ? nullptr : "angular_velocity is over 1e6 rad/s";
}
inline const char* wrong_surface(float friction, float restitution) {
    if (!in_range(friction, 0.0, 10.0)) return "friction is not 0 to 10";
    return in_range(restitution, 0.0, 1.0) ? nullptr : "restitution is not 0 to 1";
}
// How many sizes a kind has; the others are 0.
constexpr int sizes_of(int32_t kind) {
    return kind == LR_COLLIDER_SPHERE ? 1 : kind == LR_COLLIDER_CAPSULE ? 2 : kind == LR_COLLIDER_BOX ? 3 : 0;
}
inline const char* wrong_sizes(int32_t kind, const float (&size)[3]) {
    for (int i = 0; i < sizes_of(kind); ++i)
        if (!(size[i] > 0.0f) || !in_range(size[i], 0.0, most_size)) return "size is not over 0, up to 1e6 m";
    return nullptr;
}

} // namespace lr
