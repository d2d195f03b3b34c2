// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
// Converts collision of the engine's components to colliders of the library, in their component's frame.
#pragma once

#include "CoreMinimal.h"

class ULandscapeHeightfieldCollisionComponent;
class UPrimitiveComponent;

struct FLangevinShape {
    int32 Kind = 0; // LR_COLLIDER_*
    /** In the component's frame without its scale, which the sizes include. cm. */
    FTransform Local = FTransform::Identity;
    /** Its axis is Z in Unreal and y in the library. */
    bool bUpright = false;
    /** The members below have the library's units and axes. */
    float Size[3] = {};
    TArray<float> Vertices;
    TArray<uint32> Indices;
    TArray<float> Heights;
    uint32 Counts[2] = {};
    float Spacing[2] = {1.0f, 1.0f};
};

namespace LangevinShapes {
/** The boxes, spheres, capsules and convex hulls of a component, and of each of its instances. If it has none of these, and
 * bComplex is true: its triangles. */
void Gather(UPrimitiveComponent& Component, bool bComplex, TArray<FLangevinShape>& Out);

/** Converts a part of a landscape. False if it is empty or tilted. */
bool GatherLandscape(const ULandscapeHeightfieldCollisionComponent& Component, FLangevinShape& Out);

/** The points farthest out in Count directions: a hull of the library has at most 256. */
TArray<FVector> Outermost(const TArray<FVector>& Points, int32 Count);
} // namespace LangevinShapes
