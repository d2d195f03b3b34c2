// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
// Passes the level's wind sources to a world of the library.
#pragma once

#include "CoreMinimal.h"
#include "LangevinPointWind.h"
#include "UObject/WeakObjectPtr.h"

class ULangevinSettings;
class UWindDirectionalSourceComponent;
class UWorld;

class FLangevinWind {
public:
    FLangevinWind(lr_world* InWorld, const FVector& InOrigin, const ULangevinSettings& InSettings);
    ~FLangevinWind();

    /** Sets the wind besides the level's sources, cm/s. */
    void SetExtra(const FVector& Velocity) { Extra = Velocity; }

    /** Before a step. Searches for sources twice a second, and reads their values every time. */
    void Update(const UWorld& Level, float DeltaSeconds);

    /** After a state was restored: its gusts may be there or not, with other values. */
    void Restored();

private:
    void Find(const UWorld& Level);
    void SetGusts(const FVector& Direction, float Speed);
    void AddTurbulence();

    lr_world* World;
    FVector Origin;
    const ULangevinSettings& Settings;
    FVector Extra = FVector::ZeroVector;
    TArray<TWeakObjectPtr<UWindDirectionalSourceComponent>> Sources;
    float UntilSearch = 0.0f;
    lr_wind_source Gusts{};
    TArray<lr_wind_source> Made; // gusts at any time: a restored state has them again
    FVector GustDirection = FVector::ZeroVector;
    float GustSpeed = 0.0f;
    TArray<FLangevinPointWind> Points;
    LangevinPointWind::FField Field = {nullptr, 0};
    bool bCallback = false; // is this object's
};
