// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
// Converts the engine's vectors to those of LangevinConversion.h and to the library's arrays.
#pragma once

#include "CoreMinimal.h"
#include "LangevinConversion.h"

namespace LangevinTypes {
inline LangevinConversion::FVec From(const FVector& V) {
    return {V.X, V.Y, V.Z};
}

inline LangevinConversion::FRotation From(const FQuat& Q) {
    return {Q.X, Q.Y, Q.Z, Q.W};
}

inline FVector To(const LangevinConversion::FVec& V) {
    return FVector(V.X, V.Y, V.Z);
}

inline FQuat To(const LangevinConversion::FRotation& Q) {
    return FQuat(Q.X, Q.Y, Q.Z, Q.W);
}

inline LangevinConversion::FVec From(const float* V) {
    return {V[0], V[1], V[2]};
}

inline void Store(float* Out, const LangevinConversion::FVec& V) {
    Out[0] = static_cast<float>(V.X);
    Out[1] = static_cast<float>(V.Y);
    Out[2] = static_cast<float>(V.Z);
}

inline void Store(float* Out, const LangevinConversion::FRotation& Q) {
    Out[0] = static_cast<float>(Q.X);
    Out[1] = static_cast<float>(Q.Y);
    Out[2] = static_cast<float>(Q.Z);
    Out[3] = static_cast<float>(Q.W);
}
} // namespace LangevinTypes
