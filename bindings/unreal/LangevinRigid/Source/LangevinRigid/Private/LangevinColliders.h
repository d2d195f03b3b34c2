// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
// The level's collision as colliders of the library, static and moving.
#pragma once

#include "CoreMinimal.h"
#include "LangevinShapes.h"
#include "UObject/WeakObjectPtr.h"

#include <langevin_rigid.h>

class ULangevinSettings;
class ULevel;
class UPrimitiveComponent;

class FLangevinColliders {
public:
    FLangevinColliders(lr_world* InWorld, const FVector& InOrigin, const ULangevinSettings& InSettings);

    /** Adds the blocking static collision of a level. Returns the number of colliders. */
    int32 AddLevel(const ULevel& Level);
    void RemoveLevel(const ULevel& Level);

    /** Adds a component, whatever its mobility and channels. bFollow: its colliders follow its motion. */
    int32 AddComponent(UPrimitiveComponent& Component, bool bFollow);
    bool RemoveComponent(const UPrimitiveComponent& Component);

    bool AddPlane(const FVector& Point, const FVector& Normal, float Friction, float Restitution);

    /** Before a step: moves colliders to their components during the step, and removes those without a component. */
    void Update();

    /** After a state was restored, which has the library's colliders of then: those that have come since are made again, those that have
     * gone go again, and those that follow are where their components are from the next step on. */
    void Restored();

    /** The component of a collider; null for planes. */
    UPrimitiveComponent* Find(lr_collider Collider) const;

    int32 Num() const;

private:
    struct FPart {
        lr_collider Collider{};
        FTransform Local;
        bool bUpright = false;
    };
    struct FEntry {
        TWeakObjectPtr<UPrimitiveComponent> Component;
        const ULevel* Level = nullptr; // compared only
        FTransform Last;
        TArray<FPart> Parts;
        bool bFollow = false;
        bool bRestored = false; // perhaps elsewhere
    };

    bool IsWanted(const UPrimitiveComponent& Component) const;
    int32 AddEntry(UPrimitiveComponent& Component, const ULevel* Level, bool bFollow,
                   const TArray<FLangevinShape>& Shapes);
    void Place(const FPart& Part, const FTransform& Frame, float* Position, float* Orientation) const;
    void Gather(UPrimitiveComponent& Component, TArray<FLangevinShape>& Shapes) const;
    bool IsAt(const lr_collider_motion& Motion) const;
    void Destroy(const FEntry& Entry);

    lr_world* World;
    FVector Origin;
    const ULangevinSettings& Settings;
    TArray<FEntry> Entries;
    TArray<lr_collider> Gone; // a restored state can bring them back
};
