// Stand-ins for the parts of Unreal's Engine, Landscape and PhysicsCore that the plugin uses. SPDX-License-Identifier: MIT
#pragma once

#include "object.h"

class AActor;
class ULevel;
class UPhysicalMaterial;

namespace EWorldType {
enum Type { None, Game, Editor, PIE, EditorPreview, GamePreview };
}
namespace EComponentMobility {
enum Type { Static, Stationary, Movable };
}
namespace ECollisionEnabled {
enum Type { NoCollision, QueryOnly, PhysicsOnly, QueryAndPhysics };
}
namespace EEndPlayReason {
enum Type { Destroyed, LevelTransition, EndPlayInEditor, RemovedFromWorld, Quit };
}
enum ECollisionChannel { ECC_WorldStatic, ECC_WorldDynamic, ECC_Pawn };
enum ECollisionResponse { ECR_Ignore, ECR_Overlap, ECR_Block };
enum ECollisionTraceFlag { CTF_UseDefault, CTF_UseSimpleAndComplex, CTF_UseSimpleAsComplex, CTF_UseComplexAsSimple };

struct FKShapeElem {};
struct FKBoxElem : FKShapeElem {
    FVector Center;
    FRotator Rotation;
    float X = 0.0f, Y = 0.0f, Z = 0.0f;
    FTransform GetTransform() const { return FTransform(Rotation, Center); }
    FKBoxElem GetFinalScaled(const FVector& Scale3D, const FTransform& RelativeTM) const;
};
struct FKSphereElem : FKShapeElem {
    FVector Center;
    float Radius = 0.0f;
    FTransform GetTransform() const { return FTransform(Center); }
    FKSphereElem GetFinalScaled(const FVector& Scale3D, const FTransform& RelativeTM) const;
};
struct FKSphylElem : FKShapeElem {
    FVector Center;
    FRotator Rotation;
    float Radius = 0.0f, Length = 0.0f;
    FTransform GetTransform() const { return FTransform(Rotation, Center); }
    FKSphylElem GetFinalScaled(const FVector& Scale3D, const FTransform& RelativeTM) const;
};
struct FKConvexElem : FKShapeElem {
    TArray<FVector> VertexData;
    FTransform GetTransform() const { return Transform; }

private:
    FTransform Transform;
};
struct FKAggregateGeom {
    TArray<FKSphereElem> SphereElems;
    TArray<FKBoxElem> BoxElems;
    TArray<FKSphylElem> SphylElems;
    TArray<FKConvexElem> ConvexElems;
    int32 GetElementCount() const { return SphereElems.Num() + BoxElems.Num() + SphylElems.Num() + ConvexElems.Num(); }
};

class UBodySetup : public UObject {
    SHIM_OBJECT(UBodySetup, UObject)
public:
    FKAggregateGeom AggGeom;
    ECollisionTraceFlag CollisionTraceFlag = CTF_UseDefault;
    ECollisionTraceFlag GetCollisionTraceFlag() const { return CollisionTraceFlag; }
};

class UPhysicalMaterial : public UObject {
    SHIM_OBJECT(UPhysicalMaterial, UObject)
public:
    float Friction = 0.7f;
    float Restitution = 0.3f;
};

struct FBodyInstance {
    UPhysicalMaterial* GetSimplePhysicalMaterial() const { return ShimMaterial; }
    UPhysicalMaterial* ShimMaterial = nullptr;
};

struct FTriIndices {
    int32 v0 = 0, v1 = 0, v2 = 0;
};
struct FTriMeshCollisionData {
    TArray<FVector3f> Vertices;
    TArray<FTriIndices> Indices;
    bool bFlipNormals = false;
};

class UStaticMesh : public UObject {
    SHIM_OBJECT(UStaticMesh, UObject)
public:
    FBoxSphereBounds GetBounds() const { return ShimBounds; }
    bool GetPhysicsTriMeshData(FTriMeshCollisionData* CollisionData, bool InUseAllTriData);

    FBoxSphereBounds ShimBounds;
    TObjectPtr<UBodySetup> ShimBodySetup;
    FTriMeshCollisionData ShimTriangles;
    bool bAllowCPUAccess = true;
};

struct FTickFunction {
    bool bCanEverTick = false;
};

class UActorComponent : public UObject {
    SHIM_OBJECT(UActorComponent, UObject)
public:
    UActorComponent() = default;
    explicit UActorComponent(const FObjectInitializer&) {}
    AActor* GetOwner() const;
    virtual UWorld* GetWorld() const override;
    bool IsRegistered() const { return bRegistered; }
    bool IsActive() const { return bActive; }
    void SetCanEverAffectNavigation(bool bRelevant) { bCanEverAffectNavigation = bRelevant; }
    bool ComponentHasTag(FName Tag) const { return ComponentTags.Contains(Tag); }
    void RegisterComponent();
    void UnregisterComponent() { bRegistered = false; }
    virtual void BeginPlay() { bHasBegunPlay = true; }
    virtual void EndPlay(const EEndPlayReason::Type EndPlayReason);

    FTickFunction PrimaryComponentTick;
    TArray<FName> ComponentTags;
    bool bRegistered = false, bActive = true, bHasBegunPlay = false, bCanEverAffectNavigation = true;
};

class USceneComponent : public UActorComponent {
    SHIM_OBJECT(USceneComponent, UActorComponent)
public:
    using UActorComponent::UActorComponent;
    const FTransform& GetComponentTransform() const { return ComponentToWorld; }
    FVector GetComponentLocation() const { return ComponentToWorld.GetLocation(); }
    FQuat GetComponentQuat() const { return ComponentToWorld.GetRotation(); }
    FVector GetComponentScale() const { return ComponentToWorld.GetScale3D(); }
    void SetWorldTransform(const FTransform& NewTransform);
    void SetMobility(EComponentMobility::Type NewMobility) { Mobility = NewMobility; }
    void SetUsingAbsoluteScale(bool bInAbsoluteScale) { bAbsoluteScale = bInAbsoluteScale; }
    USceneComponent* GetAttachParent() const { return AttachParent; }
    virtual FBoxSphereBounds CalcBounds(const FTransform& LocalToWorld) const;
    void UpdateBounds() { Bounds = CalcBounds(ComponentToWorld); }
    virtual bool IsCollisionEnabled() const { return false; }

    FBoxSphereBounds Bounds;
    EComponentMobility::Type Mobility = EComponentMobility::Static;
    USceneComponent* AttachParent = nullptr;
    FTransform ComponentToWorld;
    bool bAbsoluteScale = false;
};

class UPrimitiveComponent : public USceneComponent {
    SHIM_OBJECT(UPrimitiveComponent, USceneComponent)
public:
    using USceneComponent::USceneComponent;
    virtual UBodySetup* GetBodySetup() { return nullptr; }
    ECollisionChannel GetCollisionObjectType() const { return ShimChannel; }
    ECollisionResponse GetCollisionResponseToChannel(ECollisionChannel) const { return ShimResponse; }
    void SetCollisionEnabled(ECollisionEnabled::Type NewType) { ShimCollision = NewType; }
    void SetGenerateOverlapEvents(bool bInGenerate) { bGenerateOverlapEvents = bInGenerate; }
    virtual bool IsCollisionEnabled() const override { return ShimCollision != ECollisionEnabled::NoCollision; }

    FBodyInstance BodyInstance;
    ECollisionChannel ShimChannel = ECC_WorldStatic;
    ECollisionResponse ShimResponse = ECR_Block;
    ECollisionEnabled::Type ShimCollision = ECollisionEnabled::QueryAndPhysics;
    bool bGenerateOverlapEvents = true;
};

class UStaticMeshComponent : public UPrimitiveComponent {
    SHIM_OBJECT(UStaticMeshComponent, UPrimitiveComponent)
public:
    using UPrimitiveComponent::UPrimitiveComponent;
    TObjectPtr<UStaticMesh> GetStaticMesh() const { return StaticMesh; }
    virtual bool SetStaticMesh(UStaticMesh* NewMesh) { return StaticMesh = NewMesh, true; }
    virtual UBodySetup* GetBodySetup() override;
    virtual FBoxSphereBounds CalcBounds(const FTransform& LocalToWorld) const override;

private:
    TObjectPtr<UStaticMesh> StaticMesh;
};

class UInstancedStaticMeshComponent : public UStaticMeshComponent {
    SHIM_OBJECT(UInstancedStaticMeshComponent, UStaticMeshComponent)
public:
    using UStaticMeshComponent::UStaticMeshComponent;
    virtual TArray<int32> AddInstances(const TArray<FTransform>& InstanceTransforms, bool bShouldReturnIndices,
                                       bool bWorldSpace = false, bool bUpdateNavigation = true);
    virtual bool RemoveInstances(const TArray<int32>& InstancesToRemove);
    virtual void ClearInstances() { Instances.Empty(); }
    int32 GetInstanceCount() const { return Instances.Num(); }
    bool GetInstanceTransform(int32 InstanceIndex, FTransform& OutInstanceTransform, bool bWorldSpace = false) const;
    virtual bool BatchUpdateInstancesTransforms(int32 StartInstanceIndex,
                                                const TArray<FTransform>& NewInstancesTransforms,
                                                bool bWorldSpace = false, bool bMarkRenderStateDirty = false,
                                                bool bTeleport = false);
    virtual bool BatchUpdateInstancesTransforms(int32 StartInstanceIndex,
                                                const TArray<FTransform>& NewInstancesTransforms,
                                                const TArray<FTransform>& NewInstancesPrevTransforms,
                                                bool bWorldSpace = false, bool bMarkRenderStateDirty = false,
                                                bool bTeleport = false);
    void SetHasPerInstancePrevTransforms(bool bInHasPreviousTransforms) {
        if (bInHasPreviousTransforms && !bHasPrevious) PrevInstances = Instances;
        if (!bInHasPreviousTransforms) PrevInstances.Empty();
        bHasPrevious = bInHasPreviousTransforms;
    }
    bool GetInstancePrevTransform(int32 InstanceIndex, FTransform& OutInstanceTransform,
                                  bool bWorldSpace = false) const;
    virtual FBoxSphereBounds CalcBounds(const FTransform& BoundTransform) const override;

    int32 ShimUpdates = 0;         // number of calls of BatchUpdateInstancesTransforms
    int32 ShimUpdated = 0;         // instances in the last call
    bool bShimMarkedDirty = false; // in the last call

private:
    TArray<FTransform> Instances; // relative to the component, as in the engine
    TArray<FTransform> PrevInstances;
    bool bHasPrevious = false;
};

class UWindDirectionalSourceComponent : public USceneComponent {
    SHIM_OBJECT(UWindDirectionalSourceComponent, USceneComponent)
public:
    float Strength = 0.1f;
    float Speed = 0.1f;
    float MinGustAmount = 0.1f;
    float MaxGustAmount = 0.2f;
    float Radius = 0.0f;
    uint32 bPointWind : 1 = 0;
};

class AActor : public UObject {
    SHIM_OBJECT(AActor, UObject)
public:
    AActor() = default;
    explicit AActor(const FObjectInitializer&) {}
    bool ActorHasTag(FName Tag) const { return Tags.Contains(Tag); }
    template <typename T> T* FindComponentByClass() const {
        for (UActorComponent* Component : ShimComponents) {
            if (T* Found = Cast<T>(Component)) return Found;
        }
        return nullptr;
    }
    template <typename T> T* CreateDefaultSubobject(FName InName) {
        T* Component = NewObject<T>(this, InName);
        ShimComponents.Add(Component);
        return Component;
    }
    bool SetRootComponent(USceneComponent* NewRoot) { return RootComponent = NewRoot, true; }
    virtual void BeginPlay() {}
    ULevel* GetLevel() const;

    TArray<FName> Tags;
    TObjectPtr<USceneComponent> RootComponent;
    TArray<UActorComponent*> ShimComponents;
};

template <class T> class TInlineComponentArray : public TArray<T> {
public:
    explicit TInlineComponentArray(const AActor* Actor, bool bIncludeFromChildActors = false) {
        static_cast<void>(bIncludeFromChildActors);
        for (UActorComponent* Component : Actor->ShimComponents) {
            if (T Found = Cast<std::remove_pointer_t<T>>(Component)) this->Add(Found);
        }
    }
};

class ULevel : public UObject {
    SHIM_OBJECT(ULevel, UObject)
public:
    TArray<TObjectPtr<AActor>> Actors;
};

enum class EHeightfieldSource { None, Simple, Complex, Editor };
class ALandscapeProxy : public AActor {
    SHIM_OBJECT(ALandscapeProxy, AActor)
public:
    TOptional<float> GetHeightAtLocation(FVector Location,
                                         EHeightfieldSource HeightFieldSource = EHeightfieldSource::Complex) const;
    std::function<TOptional<float>(FVector)> ShimHeight;
};
class ULandscapeHeightfieldCollisionComponent : public UPrimitiveComponent {
    SHIM_OBJECT(ULandscapeHeightfieldCollisionComponent, UPrimitiveComponent)
public:
    ALandscapeProxy* GetLandscapeProxy() const { return Cast<ALandscapeProxy>(GetOwner()); }
    int32 CollisionSizeQuads = 0;
    float CollisionScale = 1.0f;
};

class FSubsystemCollectionBase {};
class USubsystem : public UObject {
    SHIM_OBJECT(USubsystem, UObject)
public:
    USubsystem() = default;
    explicit USubsystem(FVTableHelper& Helper) : UObject(Helper) {}
    virtual void Initialize(FSubsystemCollectionBase&) {}
    virtual void Deinitialize() {}
};
class UWorldSubsystem : public USubsystem {
    SHIM_OBJECT(UWorldSubsystem, USubsystem)
public:
    using USubsystem::USubsystem;
    virtual void OnWorldBeginPlay(UWorld&) {}
    bool ShimSupports(EWorldType::Type Type) const { return DoesSupportWorldType(Type); }

protected:
    virtual bool DoesSupportWorldType(const EWorldType::Type WorldType) const;
};
class FTickableGameObject {
public:
    virtual ~FTickableGameObject() = default;
    virtual void Tick(float DeltaTime) = 0;
    virtual TStatId GetStatId() const = 0;
    virtual bool IsTickable() const { return true; }
    virtual bool IsTickableWhenPaused() const { return false; }
};
class UTickableWorldSubsystem : public UWorldSubsystem, public FTickableGameObject {
    SHIM_OBJECT(UTickableWorldSubsystem, UWorldSubsystem)
public:
    using UWorldSubsystem::UWorldSubsystem;
    virtual void Initialize(FSubsystemCollectionBase& Collection) override;
    virtual void Deinitialize() override;
    virtual void Tick(float) override {}
    virtual TStatId GetStatId() const override { return {}; }
    virtual bool IsTickable() const override { return bInitialized; }

private:
    bool bInitialized = false;
};

class UWorld : public UObject {
    SHIM_OBJECT(UWorld, UObject)
public:
    virtual UWorld* GetWorld() const override { return const_cast<UWorld*>(this); }
    float GetGravityZ() const { return ShimGravityZ; }
    const TArray<ULevel*>& GetLevels() const { return Levels; }
    bool HasBegunPlay() const { return bBegunPlay; }
    bool IsPaused() const { return bShimPaused; }
    template <typename T> T* GetSubsystem() const {
        for (UWorldSubsystem* Subsystem : Subsystems) {
            if (T* Found = Cast<T>(Subsystem)) return Found;
        }
        return nullptr;
    }
    template <typename T> T* SpawnActor() { return static_cast<T*>(ShimSpawn(T::StaticClass(), Levels[0])); }

    /** A game world with one level and all registered world subsystems, created as in the engine. */
    static UWorld* ShimCreate(EWorldType::Type Type = EWorldType::Game);
    AActor* ShimSpawn(const UClass* Class, ULevel* Level);
    ULevel* ShimAddLevel(bool bVisible);
    void ShimShowLevel(ULevel* Level);
    void ShimHideLevel(ULevel* Level);
    void ShimBeginPlay();
    void ShimTick(float DeltaSeconds);
    void ShimEnd();

    float ShimGravityZ = -980.0f;
    bool bShimPaused = false;

private:
    TArray<ULevel*> Levels;
    TArray<UWorldSubsystem*> Subsystems;
    bool bBegunPlay = false;
};

struct FWorldDelegates {
    using FOnLevelChanged = TMulticastDelegate<void(ULevel*, UWorld*)>;
    static FOnLevelChanged LevelAddedToWorld;
    static FOnLevelChanged LevelRemovedFromWorld;
};

class UDeveloperSettings : public UObject {
    SHIM_OBJECT(UDeveloperSettings, UObject)
public:
    virtual FName GetCategoryName() const { return NAME_None; }
};

class UAssetImportData : public UObject {
    SHIM_OBJECT(UAssetImportData, UObject)
public:
    void Update(const FString& AbsoluteFilename) { Filename = AbsoluteFilename; }
    void UpdateFilenameOnly(const FString& InPath) { Filename = InPath; }
    FString GetFirstFilename() const { return Filename; }
    void ExtractFilenames(TArray<FString>& AbsoluteFilenames) const { AbsoluteFilenames.Add(Filename); }

private:
    FString Filename;
};

class UBlueprintFunctionLibrary : public UObject {
    SHIM_OBJECT(UBlueprintFunctionLibrary, UObject)
};
