// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Engine/DeveloperSettings.h"

#include "LangevinSettings.generated.h"

UENUM(BlueprintType)
enum class ELangevinStepping : uint8 {
    /** One step per frame, as long as the frame. */
    Frame,
    /** Steps of FixedStep, as many as are due: the same motion at any frame rate, and in replays. */
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

    /** s, length of a step if Stepping is Fixed. */
    UPROPERTY(Config, EditAnywhere, Category = "Time", meta = (ClampMin = "0.001", ClampMax = "0.1"))
    float FixedStep = 1.0f / 60.0f;

    /** The most steps per frame; further time is lost, so that a slow frame does not slow down the next. */
    UPROPERTY(Config, EditAnywhere, Category = "Time", meta = (ClampMin = "1", ClampMax = "32"))
    int32 MaxStepsPerFrame = 4;

    /** s: a step is divided into substeps no longer than this. 1/120 suits leaves of some centimetres, 1/240 petals and confetti. */
    UPROPERTY(Config, EditAnywhere, Category = "Time", meta = (ClampMin = "0.0005", ClampMax = "0.1"))
    float LongestSubstep = 1.0f / 120.0f;

    /** s: longer frames count as this long. */
    UPROPERTY(Config, EditAnywhere, Category = "Time", meta = (ClampMin = "0.01", ClampMax = "1.0"))
    float LongestFrame = 0.1f;

    /** Extrapolate bodies by their velocities between fixed steps. */
    UPROPERTY(Config, EditAnywhere, Category = "Time")
    bool bSmoothFixedSteps = true;

    /** Seed of all noise. The same seed gives the same fall. */
    UPROPERTY(Config, EditAnywhere, Category = "Simulation")
    int64 Seed = 0;

    /** Step on the engine's worker threads. Results do not change. */
    UPROPERTY(Config, EditAnywhere, Category = "Simulation")
    bool bUseEngineTasks = true;

    /** cm: the point of the level where the simulation has its origin. Single precision is 1 mm at 8 km from it. */
    UPROPERTY(Config, EditAnywhere, Category = "Simulation")
    FVector Origin = FVector::ZeroVector;

    /** The most substeps of single bodies per step; beyond it batches take longer substeps and turns. 0: no limit. */
    UPROPERTY(Config, EditAnywhere, Category = "Simulation", meta = (ClampMin = "0"))
    int32 Budget = 0;

    /** Static collision of the level becomes colliders when play begins, and when levels stream in. */
    UPROPERTY(Config, EditAnywhere, Category = "Collision")
    bool bCollideWithLevel = true;

    /** Landscapes too, as heightfields. */
    UPROPERTY(Config, EditAnywhere, Category = "Collision")
    bool bCollideWithLandscapes = true;

    /** Meshes without simple collision, by their triangles (needs Allow CPU Access in packaged games). */
    UPROPERTY(Config, EditAnywhere, Category = "Collision")
    bool bUseComplexCollision = true;

    /** Components with this tag are ignored. */
    UPROPERTY(Config, EditAnywhere, Category = "Collision")
    FName IgnoreTag = FName(TEXT("LangevinIgnore"));

    /** The most events per step passed to OnEvents; 0: none, which saves memory. */
    UPROPERTY(Config, EditAnywhere, Category = "Collision", meta = (ClampMin = "0"))
    int32 MaxEvents = 0;

    /** Directional wind sources of the level blow on bodies. */
    UPROPERTY(Config, EditAnywhere, Category = "Wind")
    bool bUseWindSources = true;

    /** m/s of a wind source whose Speed is 1: the engine gives it no unit. */
    UPROPERTY(Config, EditAnywhere, Category = "Wind", meta = (ClampMin = "0.0", ClampMax = "1000.0"))
    float WindSpeedScale = 10.0f;

    /** m/s, root mean square of the air's own turbulence; 0: none. */
    UPROPERTY(Config, EditAnywhere, Category = "Wind", meta = (ClampMin = "0.0", ClampMax = "100.0"))
    float TurbulenceSpeed = 0.0f;

    /** cm, size of its largest eddies. */
    UPROPERTY(Config, EditAnywhere, Category = "Wind", meta = (ClampMin = "1.0"))
    float TurbulenceSize = 200.0f;
};
