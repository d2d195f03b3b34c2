// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
// Wind that blows outward from points, for wind sources with bPointWind. Plain C++: called from worker threads.
#pragma once

#include <cmath>
#include <cstdint>
#include <langevin_rigid.h>

struct FLangevinPointWind {
    float Position[3]; // m, library's axes
    float Radius;      // m
    float Speed;       // m/s, largest speed, reached a tenth of the radius from the middle
};

namespace LangevinPointWind {
/** Adds the velocity at a point. It is 0 in the middle, where it has no direction, and 0 at the radius, so that no body
 * crosses a jump. */
inline void Add(const FLangevinPointWind& Wind, const float* Point, float* Velocity) {
    const float D[3] = {Point[0] - Wind.Position[0], Point[1] - Wind.Position[1], Point[2] - Wind.Position[2]};
    const float Distance = std::sqrt(D[0] * D[0] + D[1] * D[1] + D[2] * D[2]);
    const float S = Distance / Wind.Radius;
    if (!(S < 1.0f) || Distance <= 0.0f) return;
    constexpr float Core = 0.1f;
    const float Profile = S < Core ? S / Core : (1.0f - S) / (1.0f - Core);
    for (int Axis = 0; Axis < 3; ++Axis) Velocity[Axis] += Wind.Speed * Profile * D[Axis] / Distance;
}

struct FField {
    const FLangevinPointWind* Winds;
    int32_t Count;
};

/** lr_wind_fn; User: FField, which does not change while a step runs. */
inline void Callback(void* User, const lr_wind_query* Query) {
    const FField& Field = *static_cast<const FField*>(User);
    for (uint32_t Body = 0; Body < Query->count; ++Body) {
        const float Point[3] = {Query->position[0][Body], Query->position[1][Body], Query->position[2][Body]};
        float Velocity[3] = {};
        for (int32_t Index = 0; Index < Field.Count; ++Index) Add(Field.Winds[Index], Point, Velocity);
        for (int Axis = 0; Axis < 3; ++Axis) Query->velocity[Axis][Body] = Velocity[Axis];
    }
}
} // namespace LangevinPointWind
