// The collision of the engine's components as colliders of the library, in the frame of their component.
// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"

class ULandscapeHeightfieldCollisionComponent;
class UPrimitiveComponent;

struct FLangevinShape {
    int32 Kind = 0; // LR_COLLIDER_*
    /** In the component's frame without its scale, which the sizes hold. cm. */
    FTransform Local = FTransform::Identity;
    /** Stands along Z here and along y in the library. */
    bool bUpright = false;
    /** The library's units and axes from here on. */
    float Size[3] = {};
    TArray<float> Vertices;
    TArray<uint32> Indices;
    TArray<float> Heights;
    uint32 Counts[2] = {};
    float Spacing[2] = {1.0f, 1.0f};
};

namespace LangevinShapes {
/** Boxes, spheres, capsules and convex hulls of a component, of each of its instances if it is instanced, or its triangles
    where it has none of these and bComplex. */
void Gather(UPrimitiveComponent& Component, bool bComplex, TArray<FLangevinShape>& Out);

/** A part of a landscape. False where there is nothing, or it is tilted. */
bool GatherLandscape(const ULandscapeHeightfieldCollisionComponent& Component, FLangevinShape& Out);

/** Takes the points that lie farthest out in Count directions: the library takes 256 for a hull. */
TArray<FVector> Outermost(const TArray<FVector>& Points, int32 Count);
} // namespace LangevinShapes
