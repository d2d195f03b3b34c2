// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "LangevinEvents.h"
#include "Subsystems/WorldSubsystem.h"
#include "Templates/UniquePtr.h"

#include "LangevinWorldSubsystem.generated.h"

class FLangevinBatchCalls;
class FLangevinColliders;
class FLangevinJobs;
class FLangevinRecording;
class FLangevinWind;
class ULevel;
class UPrimitiveComponent;
struct lr_world;

/** A world of the library for each game world. It steps after actors and components have ticked, then writes the instances
 * of all batches. */
UCLASS()
class LANGEVINRIGID_API ULangevinWorldSubsystem : public UTickableWorldSubsystem {
    GENERATED_BODY()

public:
    ULangevinWorldSubsystem();
    ULangevinWorldSubsystem(FVTableHelper& Helper); // a generated constructor would need the pointers' types below
    virtual ~ULangevinWorldSubsystem() override;

    virtual void Initialize(FSubsystemCollectionBase& Collection) override;
    virtual void Deinitialize() override;
    virtual void OnWorldBeginPlay(UWorld& InWorld) override;
    virtual void Tick(float DeltaTime) override;
    virtual TStatId GetStatId() const override;
    virtual bool IsTickableWhenPaused() const override { return true; } // to stand still once

    /** Contacts, landings and ends of each step, at most Max Events of the project settings. */
    UPROPERTY(BlueprintAssignable, Category = "Langevin Rigid")
    FLangevinEvents OnEvents;

    /** Pauses all bodies, but not the game. A paused game pauses them too. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid")
    void SetPaused(bool bInPaused);

    /** Sets wind in addition to the level's sources, cm/s. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|Wind")
    void SetWind(FVector Velocity);

    /** The velocity of the air at a point, from all sources, cm/s. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|Wind")
    FVector SampleWind(FVector Location) const;

    /** Adds an unbounded plane; everything behind it is solid. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|Collision")
    bool AddPlane(FVector Point, FVector Normal, float Friction = 0.5f, float Restitution = 0.2f);

    /** Adds this component's collision; set bFollow if it moves. Returns the number of colliders. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|Collision")
    int32 AddCollider(UPrimitiveComponent* Component, bool bFollow);

    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|Collision")
    bool RemoveCollider(UPrimitiveComponent* Component);

    UFUNCTION(BlueprintPure, Category = "Langevin Rigid|Collision")
    int32 GetColliderCount() const;

    /** Wakes sleeping bodies in a box, for footsteps and explosions. Returns their number. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid")
    int32 WakeBox(FVector Min, FVector Max);

    /** The state of all bodies, wind and colliders, for saved games, replays and rollback. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|State")
    bool SaveState(TArray<uint8>& State) const;

    /** Restores a state. Its batches must exist, created in the same order from the same assets. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|State")
    bool RestoreState(const TArray<uint8>& State);

    /** A hash that is equal for equal states, to find where two machines diverge. */
    UFUNCTION(BlueprintPure, Category = "Langevin Rigid|State")
    int64 GetStateHash() const;

    /** Writes all calls on this world to a file for lr_replay, until StopRecording or the end of the game world. Send it with a
     * bug report. FPaths::ProjectSavedDir is writable in shipped games. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|State")
    bool StartRecording(const FString& Filename);

    /** Stops the recording. False if there is none, or if the file is incomplete. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|State")
    bool StopRecording();

    /** Simulated time, s. */
    UFUNCTION(BlueprintPure, Category = "Langevin Rigid")
    double GetSimulatedTime() const;

    UFUNCTION(BlueprintPure, Category = "Langevin Rigid")
    int32 GetBodyCount() const;

    /** For functions of langevin_rigid.h that have no counterpart here. Game thread, between ticks. Null without the library. */
    lr_world* GetLibraryWorld() const { return World; }

    FVector GetOrigin() const { return Origin; }

    /** Number of tasks passed to the engine so far. */
    uint64 GetLaunchedTasks() const;

    void RegisterBatch(FLangevinBatchCalls& Batch);
    void UnregisterBatch(FLangevinBatchCalls& Batch);

protected:
    virtual bool DoesSupportWorldType(const EWorldType::Type WorldType) const override;

private:
    void Step(float Seconds);
    void TellEvents();
    void StandStill();
    void OnLevelAdded(ULevel* Level, UWorld* InWorld);
    void OnLevelRemoved(ULevel* Level, UWorld* InWorld);

    lr_world* World = nullptr;
    TUniquePtr<FLangevinRecording> Recording;
    TUniquePtr<FLangevinJobs> Jobs;
    TUniquePtr<FLangevinColliders> Colliders;
    TUniquePtr<FLangevinWind> Wind;
    FVector Origin = FVector::ZeroVector;
    double Due = 0.0; // s of frame time that no fixed step has covered yet
    bool bPaused = false;
    bool bGamePaused = false;
    bool bToldLost = false;
    FDelegateHandle LevelAdded;
    FDelegateHandle LevelRemoved;

    // Actors own their components. A component leaves by UnregisterBatch when its play ends.
    TArray<FLangevinBatchCalls*> Batches;
};
