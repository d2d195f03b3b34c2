// SPDX-License-Identifier: MIT
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

/** One world of the library for each game world. It steps after actors and components have ticked, and then writes the
    instances of all batches. */
UCLASS()
class LANGEVINRIGID_API ULangevinWorldSubsystem : public UTickableWorldSubsystem {
    GENERATED_BODY()

public:
    ULangevinWorldSubsystem();
    ULangevinWorldSubsystem(FVTableHelper& Helper); // the generated one would need what the pointers below point to
    virtual ~ULangevinWorldSubsystem() override;

    virtual void Initialize(FSubsystemCollectionBase& Collection) override;
    virtual void Deinitialize() override;
    virtual void OnWorldBeginPlay(UWorld& InWorld) override;
    virtual void Tick(float DeltaTime) override;
    virtual TStatId GetStatId() const override;

    /** Contacts, landings and ends of each step; Max Events of the project settings says how many. */
    UPROPERTY(BlueprintAssignable, Category = "Langevin Rigid")
    FLangevinEvents OnEvents;

    /** Pauses all bodies, and nothing else. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid")
    void SetPaused(bool bInPaused);

    /** Wind in addition to the level's sources. cm/s. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|Wind")
    void SetWind(FVector Velocity);

    /** The velocity of the air at a point, from all sources. cm/s. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|Wind")
    FVector SampleWind(FVector Location) const;

    /** Everything behind the plane is solid, without bounds. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|Collision")
    bool AddPlane(FVector Point, FVector Normal, float Friction = 0.5f, float Restitution = 0.2f);

    /** Adds this component's collision; set bFollow if it moves. Returns the number of its parts. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|Collision")
    int32 AddCollider(UPrimitiveComponent* Component, bool bFollow);

    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|Collision")
    bool RemoveCollider(UPrimitiveComponent* Component);

    UFUNCTION(BlueprintPure, Category = "Langevin Rigid|Collision")
    int32 GetColliderCount() const;

    /** Wakes sleeping bodies in a box: footsteps, explosions. Returns how many. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid")
    int32 WakeBox(FVector Min, FVector Max);

    /** The state of all bodies, wind and colliders, for saved games, replays and roll-back. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|State")
    bool SaveState(TArray<uint8>& State) const;

    /** Restores a state. Its batches must exist, created in the same order from the same assets. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|State")
    bool RestoreState(const TArray<uint8>& State);

    /** Equal for equal states: finds where two machines diverge. */
    UFUNCTION(BlueprintPure, Category = "Langevin Rigid|State")
    int64 GetStateHash() const;

    /** Writes all that happens in this world to a file, for lr_replay to play again, until StopRecording or the end of the game
        world: send it with a bug report. FPaths::ProjectSavedDir can be written in shipped games. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|State")
    bool StartRecording(const FString& Filename);

    /** False if there is no recording, or if the file could not be written completely. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid|State")
    bool StopRecording();

    /** s of simulated time. */
    UFUNCTION(BlueprintPure, Category = "Langevin Rigid")
    double GetSimulatedTime() const;

    UFUNCTION(BlueprintPure, Category = "Langevin Rigid")
    int32 GetBodyCount() const;

    /** For everything that has no function here: langevin_rigid.h. Game thread, between ticks. Null without the library. */
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
    void OnLevelAdded(ULevel* Level, UWorld* InWorld);
    void OnLevelRemoved(ULevel* Level, UWorld* InWorld);

    lr_world* World = nullptr;
    TUniquePtr<FLangevinRecording> Recording;
    TUniquePtr<FLangevinJobs> Jobs;
    TUniquePtr<FLangevinColliders> Colliders;
    TUniquePtr<FLangevinWind> Wind;
    FVector Origin = FVector::ZeroVector;
    double Due = 0.0; // s of frames that no fixed step has made up for yet
    bool bPaused = false;
    bool bToldLost = false;
    FDelegateHandle LevelAdded;
    FDelegateHandle LevelRemoved;

    // Actors keep their components; these leave by UnregisterBatch when their play ends.
    TArray<FLangevinBatchCalls*> Batches;
};
