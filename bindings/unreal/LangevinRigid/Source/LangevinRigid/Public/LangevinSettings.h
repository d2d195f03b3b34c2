// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Engine/DeveloperSettings.h"

#include "LangevinSettings.generated.h"

UENUM(BlueprintType)
enum class ELangevinStepping : uint8 {
    /** One step per frame, as long as the frame. */
    Frame,
    /** All due steps of length FixedStep: the same motion at any frame rate, and in replays. */
    Fixed,
};

/** Project Settings > Plugins > Langevin Rigid. Read when a world is created. */
UCLASS(Config = Game, DefaultConfig, meta = (DisplayName = "Langevin Rigid"))
class LANGEVINRIGID_API ULangevinSettings : public UDeveloperSettings {
    GENERATED_BODY()

public:
    virtual FName GetCategoryName() const override { return FName(TEXT("Plugins")); }

    UPROPERTY(Config, EditAnywhere, Category = "Time")
    ELangevinStepping Stepping = ELangevinStepping::Frame;

    /** Length of a step if Stepping is Fixed, s. */
    UPROPERTY(Config, EditAnywhere, Category = "Time", meta = (ClampMin = "0.001", ClampMax = "0.1"))
    float FixedStep = 1.0f / 60.0f;

    /** Largest number of steps per frame. Time beyond it is skipped, so that a slow frame does not slow down the next. */
    UPROPERTY(Config, EditAnywhere, Category = "Time", meta = (ClampMin = "1", ClampMax = "32"))
    int32 MaxStepsPerFrame = 4;

    /** Largest substep, s. 1/120 for leaves of a few centimetres, 1/240 for petals and confetti. */
    UPROPERTY(Config, EditAnywhere, Category = "Time", meta = (ClampMin = "0.0005", ClampMax = "0.1"))
    float LongestSubstep = 1.0f / 120.0f;

    /** Largest frame time, s; longer frames count as this. */
    UPROPERTY(Config, EditAnywhere, Category = "Time", meta = (ClampMin = "0.01", ClampMax = "1.0"))
    float LongestFrame = 0.1f;

    /** Extrapolates bodies by their velocities between fixed steps. */
    UPROPERTY(Config, EditAnywhere, Category = "Time")
    bool bSmoothFixedSteps = true;

    /** Seed of all random numbers. The same seed gives the same motion. */
    UPROPERTY(Config, EditAnywhere, Category = "Simulation")
    int64 Seed = 0;

    /** Steps on the engine's worker threads. Results do not change. */
    UPROPERTY(Config, EditAnywhere, Category = "Simulation")
    bool bUseEngineTasks = true;

    /** Point of the level at the origin of the simulation, cm. Single precision is 1 mm at 8 km from it. */
    UPROPERTY(Config, EditAnywhere, Category = "Simulation")
    FVector Origin = FVector::ZeroVector;

    /** Largest number of body substeps per step; beyond it batches take longer substeps, in turns. 0: no limit. */
    UPROPERTY(Config, EditAnywhere, Category = "Simulation", meta = (ClampMin = "0"))
    int32 Budget = 0;

    /** Makes colliders from static collision of the level when play begins, and when levels stream in. */
    UPROPERTY(Config, EditAnywhere, Category = "Collision")
    bool bCollideWithLevel = true;

    /** Includes landscapes, as heightfields. */
    UPROPERTY(Config, EditAnywhere, Category = "Collision")
    bool bCollideWithLandscapes = true;

    /** Uses the triangles of meshes without simple collision (needs Allow CPU Access in packaged games). */
    UPROPERTY(Config, EditAnywhere, Category = "Collision")
    bool bUseComplexCollision = true;

    /** Ignores components with this tag. */
    UPROPERTY(Config, EditAnywhere, Category = "Collision")
    FName IgnoreTag = FName(TEXT("LangevinIgnore"));

    /** Largest number of events per step passed to OnEvents. 0: no events, which saves memory. */
    UPROPERTY(Config, EditAnywhere, Category = "Collision", meta = (ClampMin = "0"))
    int32 MaxEvents = 0;

    /** Applies directional wind sources of the level to bodies. */
    UPROPERTY(Config, EditAnywhere, Category = "Wind")
    bool bUseWindSources = true;

    /** Wind speed of a source with Speed 1, m/s: the engine's Speed has no unit. */
    UPROPERTY(Config, EditAnywhere, Category = "Wind", meta = (ClampMin = "0.0", ClampMax = "1000.0"))
    float WindSpeedScale = 10.0f;

    /** Root mean square of ambient turbulence, m/s. 0: none. */
    UPROPERTY(Config, EditAnywhere, Category = "Wind", meta = (ClampMin = "0.0", ClampMax = "100.0"))
    float TurbulenceSpeed = 0.0f;

    /** Size of its largest eddies, cm. */
    UPROPERTY(Config, EditAnywhere, Category = "Wind", meta = (ClampMin = "1.0"))
    float TurbulenceSize = 200.0f;

    /** Density of meshes that the content browser's menu bakes, kg/m^3: dry leaves 350, paper and petals 800. */
    UPROPERTY(Config, EditAnywhere, Category = "Bake", meta = (ClampMin = "0.001"))
    float BakeDensity = 350.0f;

    /** Thickness of meshes that are the middle surface of a sheet, cm. 0: meshes are the surfaces of bodies. */
    UPROPERTY(Config, EditAnywhere, Category = "Bake", meta = (ClampMin = "0.0"))
    float BakeSheetThickness = 0.0f;
};
