// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#pragma once

#include "Components/InstancedStaticMeshComponent.h"
#include "CoreMinimal.h"
#include "LangevinBatchCalls.h"
#include "LangevinEvents.h"
#include "Templates/SharedPointer.h"

#include <langevin_rigid.h>

#include "LangevinBatchComponent.generated.h"

class ULangevinAsset;
class ULangevinWorldSubsystem;

UENUM(BlueprintType)
enum class ELangevinLoads : uint8 {
    /** The library's default. */
    Default = 0,
    /** Gravity, buoyancy and added mass only. */
    None = 1,
    /** The paper's random turbulent loads. */
    Langevin = 2,
    /** Quasi-steady drag and lift in a turbulent fluid. */
    Aerodynamic = 3,
};

UENUM(BlueprintType)
enum class ELangevinEmitterShape : uint8 {
    Point = 0,
    Box = 1,
    Sphere = 2,
    /** In the component's XY plane. */
    Disc = 3,
};

/** A copy of the state of a batch's bodies, for other threads such as Niagara's. */
struct LANGEVINRIGID_API FLangevinSnapshot {
    TArray<FVector> Locations;    // cm, world: centres of mass
    TArray<FQuat4f> Rotations;    // of the mesh
    TArray<FVector3f> Velocities; // cm/s, world
    TArray<FVector3f> Spins;      // rad/s, world
    TArray<float> Ages;           // s
    TArray<float> Scales;
    int32 AwakeCount = 0; // the first bodies are awake, the others asleep
    uint64 Frame = 0;

    int32 Num() const { return Locations.Num(); }
};

/**
 * All bodies of an asset, drawn as instances of the component's static mesh. Set the mesh from which the asset was baked, and
 * press play. The subsystem writes the instances; do not add or remove them by hand.
 */
UCLASS(ClassGroup = "Langevin Rigid", meta = (BlueprintSpawnableComponent))
class LANGEVINRIGID_API ULangevinBatchComponent : public UInstancedStaticMeshComponent, public FLangevinBatchCalls {
    GENERATED_BODY()

public:
    ULangevinBatchComponent(const FObjectInitializer& ObjectInitializer);

    /** The falling body: a .lrb file in the content browser. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Langevin Rigid")
    TObjectPtr<ULangevinAsset> Asset;

    /** Largest number of bodies; their memory is allocated when play begins. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Langevin Rigid", meta = (ClampMin = "1"))
    int32 Capacity = 1000;

    /** Number of bodies that the emitter spawns when play begins. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Langevin Rigid", meta = (ClampMin = "0"))
    int32 InitialCount = 0;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Langevin Rigid", AdvancedDisplay)
    ELangevinLoads Loads = ELangevinLoads::Default;

    /** Level of detail: takes one substep where other batches take this number. For distant batches. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Langevin Rigid", AdvancedDisplay,
              meta = (ClampMin = "1", ClampMax = "1024"))
    int32 RateDivisor = 1;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Emitter")
    ELangevinEmitterShape EmitterShape = ELangevinEmitterShape::Box;

    /** Half extents along the component's axes, cm. The emitter moves and rotates with the component. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Emitter")
    FVector EmitterExtent = FVector(100.0, 100.0, 100.0);

    /** Bodies spawned per second. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Emitter", meta = (ClampMin = "0.0"))
    float EmitterRate = 0.0f;

    /** Initial velocity, cm/s, world. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Emitter")
    FVector InitialVelocity = FVector::ZeroVector;

    /** Largest initial spin, rad/s, about a random axis. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Emitter", meta = (ClampMin = "0.0"))
    float InitialSpin = 0.0f;

    /** Smallest and largest scale. 1: the baked size. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Emitter")
    FVector2D ScaleRange = FVector2D(1.0, 1.0);

    /** Age at which bodies end, s. 0: no limit. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Ends", meta = (ClampMin = "0.0"))
    float MaxAge = 0.0f;

    /** Ends bodies that fall below KillHeight. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Ends")
    bool bKillBelow = false;

    /** Height below which bodies end, cm, world. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Ends", meta = (EditCondition = "bKillBelow"))
    double KillHeight = -10000.0;

    /** Ended bodies respawn from the emitter, so that the storm never stops. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Ends")
    bool bRespawn = false;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Contact")
    bool bCollide = true;

    /** Contact between bodies of this batch, so that they pile up. Costs much more. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Contact")
    bool bCollideWithEachOther = false;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Contact", meta = (ClampMin = "0.0", ClampMax = "10.0"))
    float Friction = 0.5f;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Contact", meta = (ClampMin = "0.0", ClampMax = "1.0"))
    float Restitution = 0.1f;

    /** Factors on the loads, for artistic control. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Art", meta = (ClampMin = "0.0", ClampMax = "100.0"))
    float DragGain = 1.0f;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Art", meta = (ClampMin = "0.0", ClampMax = "100.0"))
    float LiftGain = 1.0f;

    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Art", meta = (ClampMin = "0.0", ClampMax = "100.0"))
    float TurbulenceGain = 1.0f;

    /** Natural spread of drag and lift from body to body. 0: all bodies are alike. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Art", meta = (ClampMin = "0.0", ClampMax = "0.5"))
    float Variation = 0.15f;

    /** Creates the batch now if it does not exist. BeginPlay calls it; call it if the asset is set later. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid")
    bool BeginBatch();

    /** Destroys the batch with all its bodies. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid")
    virtual void EndBatch() override;

    /** Creates bodies from transforms of the mesh, all or none. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid")
    TArray<FLangevinBody> SpawnBodies(const TArray<FTransform>& Transforms, FVector Velocity);

    /** Spawns bodies from the emitter, all or none. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid")
    bool EmitBodies(int32 Count);

    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid")
    bool DestroyBodies(const TArray<FLangevinBody>& Bodies);

    /** Reads the transform of the mesh (world), velocity (cm/s) and spin (rad/s). False if the body no longer exists. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid")
    bool GetBodyState(FLangevinBody Body, FTransform& Transform, FVector& Velocity, FVector& Spin,
                      bool& bResting) const;

    /** Adds an impulse, kg cm/s, at the centre of mass, or at Location if bAtLocation. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid")
    bool AddImpulseToBody(FLangevinBody Body, FVector Impulse, FVector Location, bool bAtLocation);

    /** Accelerates all bodies of the batch, cm/s^2, until changed. */
    UFUNCTION(BlueprintCallable, Category = "Langevin Rigid")
    bool SetAcceleration(FVector Acceleration);

    UFUNCTION(BlueprintPure, Category = "Langevin Rigid")
    int32 GetBodyCount() const;

    /** Number of awake bodies. */
    UFUNCTION(BlueprintPure, Category = "Langevin Rigid")
    int32 GetAwakeCount() const;

    /** The state of all bodies, copied at most once per step. Null without a batch. Game thread. */
    TSharedPtr<const FLangevinSnapshot, ESPMode::ThreadSafe> GetSnapshot() const;

    /** The batch's handle for functions of langevin_rigid.h; its id is 0 without a batch. */
    lr_batch GetLibraryBatch() const { return Batch; }

    /** Number of instances written by the last update. */
    int32 GetLastWritten() const { return LastWritten; }

    virtual void BeginPlay() override;
    virtual void EndPlay(const EEndPlayReason::Type EndPlayReason) override;
    virtual FBoxSphereBounds CalcBounds(const FTransform& LocalToWorld) const override;

    /** Called by the subsystem before and after a step. */
    virtual void PrepareStep() override;
    virtual void WriteInstances(double AheadSeconds, double FrameSeconds) override;
    virtual void WriteAllInstances() override;
    virtual void NameBatch(const lr_event& From, FLangevinEvent& Event) override;

private:
    lr_world* LibraryWorld() const;
    bool ApplyRules();
    bool ApplyEmitter();
    bool ApplyContact();
    void SetInstanceCount(int32 Count);
    void GrowBounds(int32 First, int32 Count, bool bAnew);

    UPROPERTY(Transient)
    TObjectPtr<ULangevinWorldSubsystem> Subsystem;

    lr_batch Batch = {};
    FTransform EmitterPlace;
    FVector MeshOrigin = FVector::ZeroVector;
    TArray<float> Records, Moving; // Moving: of lr_batch_write_velocities
    TArray<FTransform> Transforms, Previous;
    FTransform WrittenFrame;
    uint64 WrittenRevision = 0;
    int32 WrittenAwake = 0;
    int32 LastWritten = 0;
    bool bWriteAll = true;
    FBox BodyBounds = FBox(ForceInit);
    uint64 StepCount = 0;
    mutable TSharedPtr<const FLangevinSnapshot, ESPMode::ThreadSafe> Snapshot;
};
