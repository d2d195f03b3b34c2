// The shim's objects, components and worlds. SPDX-License-Identifier: MIT
#include "shim.h"

UEditorEngine* GEditor = nullptr;
FString UFactory::CurrentFilename;
FAssetCategoryPath EAssetCategoryPaths::Physics{FText(FString(TEXT("Physics")))};
FWorldDelegates::FOnLevelChanged FWorldDelegates::LevelAddedToWorld;
FWorldDelegates::FOnLevelChanged FWorldDelegates::LevelRemovedFromWorld;
TArray<UClass*> FNiagaraTypeRegistry::ShimRegistered;

namespace {
std::vector<UObject*> Objects;
}

const std::vector<UObject*>& ShimObjects() {
    return Objects;
}

UObject::UObject() = default;

UClass* UObject::StaticClass() {
    static UClass Class{FName(TEXT("UObject")), nullptr, &ShimConstruct<UObject>};
    return &Class;
}

UObject* UClass::GetDefaultObject() {
    if (Default == nullptr) {
        Default = Construct();
        Default->ShimFlags = RF_ClassDefaultObject;
        Default->PostInitProperties();
    }
    return Default;
}

UObject* ShimNewObject(UObject* Outer, const UClass* Class, FName Name, uint32 Flags) {
    const_cast<UClass*>(Class)->GetDefaultObject();
    UObject* Object = Class->Construct();
    Object->ShimOuter = Outer;
    Object->ShimName = Name == NAME_None ? Class->Name : Name;
    Object->ShimFlags = Flags;
    Objects.push_back(Object);
    Object->PostInitProperties();
    return Object;
}

void ShimDestroy(UObject* Object) {
    Object->MarkAsGarbage();
    Object->BeginDestroy();
}

// ---------------------------------------------------------------------------------------------------------------------
// Collision

// As in the engine, the smallest scale counts for shapes that cannot scale differently along their axes.
FKBoxElem FKBoxElem::GetFinalScaled(const FVector& Scale3D, const FTransform&) const {
    FKBoxElem Scaled = *this;
    const FVector Scale = Scale3D.GetAbs();
    Scaled.X *= static_cast<float>(Scale.X);
    Scaled.Y *= static_cast<float>(Scale.Y);
    Scaled.Z *= static_cast<float>(Scale.Z);
    Scaled.Center = Center * Scale3D;
    return Scaled;
}

FKSphereElem FKSphereElem::GetFinalScaled(const FVector& Scale3D, const FTransform&) const {
    FKSphereElem Scaled = *this;
    const FVector Scale = Scale3D.GetAbs();
    Scaled.Radius *= static_cast<float>(std::min({Scale.X, Scale.Y, Scale.Z}));
    Scaled.Center = Center * Scale3D;
    return Scaled;
}

FKSphylElem FKSphylElem::GetFinalScaled(const FVector& Scale3D, const FTransform&) const {
    FKSphylElem Scaled = *this;
    const FVector Scale = Scale3D.GetAbs();
    Scaled.Radius *= static_cast<float>(std::min(Scale.X, Scale.Y));
    Scaled.Length *= static_cast<float>(Scale.Z);
    Scaled.Center = Center * Scale3D;
    return Scaled;
}

bool UStaticMesh::GetPhysicsTriMeshData(FTriMeshCollisionData* CollisionData, bool) {
    if (!bAllowCPUAccess) return false;
    *CollisionData = ShimTriangles;
    return true;
}

UBodySetup* UStaticMeshComponent::GetBodySetup() {
    return StaticMesh != nullptr ? StaticMesh->ShimBodySetup : nullptr;
}

TOptional<float> ALandscapeProxy::GetHeightAtLocation(FVector Location, EHeightfieldSource) const {
    return ShimHeight ? ShimHeight(Location) : TOptional<float>();
}

// ---------------------------------------------------------------------------------------------------------------------
// Components

AActor* UActorComponent::GetOwner() const {
    return Cast<AActor>(ShimOuter);
}
UWorld* UActorComponent::GetWorld() const {
    return ShimOuter != nullptr ? ShimOuter->GetWorld() : nullptr;
}
ULevel* AActor::GetLevel() const {
    return Cast<ULevel>(ShimOuter);
}

void UActorComponent::RegisterComponent() {
    bRegistered = true;
    AActor* Owner = GetOwner();
    if (Owner != nullptr && !Owner->ShimComponents.Contains(this)) Owner->ShimComponents.Add(this);
    if (GetWorld() != nullptr && GetWorld()->HasBegunPlay() && !bHasBegunPlay) BeginPlay();
}

void UActorComponent::EndPlay(const EEndPlayReason::Type) {
    bHasBegunPlay = false;
}

void USceneComponent::SetWorldTransform(const FTransform& NewTransform) {
    ComponentToWorld = NewTransform;
    if (bAbsoluteScale) ComponentToWorld.SetScale3D(FVector::OneVector);
}

FBoxSphereBounds USceneComponent::CalcBounds(const FTransform& LocalToWorld) const {
    return FBoxSphereBounds(FBox(LocalToWorld.GetLocation(), LocalToWorld.GetLocation()));
}

FBoxSphereBounds UStaticMeshComponent::CalcBounds(const FTransform& LocalToWorld) const {
    if (StaticMesh == nullptr) return USceneComponent::CalcBounds(LocalToWorld);
    return FBoxSphereBounds(StaticMesh->GetBounds().GetBox().TransformBy(LocalToWorld));
}

FBoxSphereBounds UInstancedStaticMeshComponent::CalcBounds(const FTransform& BoundTransform) const {
    FBox Box(ForceInit);
    const FBox Mesh = GetStaticMesh() != nullptr ? GetStaticMesh()->GetBounds().GetBox() : FBox(FVector(), FVector());
    for (const FTransform& Instance : Instances) Box += Mesh.TransformBy(Instance * BoundTransform);
    return Box.IsValid ? FBoxSphereBounds(Box) : USceneComponent::CalcBounds(BoundTransform);
}

TArray<int32> UInstancedStaticMeshComponent::AddInstances(const TArray<FTransform>& InstanceTransforms,
                                                          bool bShouldReturnIndices, bool bWorldSpace, bool) {
    TArray<int32> Indices;
    for (const FTransform& Transform : InstanceTransforms) {
        const int32 Index =
            Instances.Add(bWorldSpace ? Transform.GetRelativeTransform(GetComponentTransform()) : Transform);
        if (bShouldReturnIndices) Indices.Add(Index);
    }
    return Indices;
}

bool UInstancedStaticMeshComponent::RemoveInstances(const TArray<int32>& InstancesToRemove) {
    std::vector<int32> Sorted(InstancesToRemove.begin(), InstancesToRemove.end());
    std::sort(Sorted.rbegin(), Sorted.rend());
    for (const int32 Index : Sorted) {
        if (Index < 0 || Index >= Instances.Num()) return false;
        Instances.RemoveAtSwap(Index);
    }
    return true;
}

bool UInstancedStaticMeshComponent::GetInstanceTransform(int32 InstanceIndex, FTransform& Out, bool bWorldSpace) const {
    if (InstanceIndex < 0 || InstanceIndex >= Instances.Num()) return false;
    Out = bWorldSpace ? Instances[InstanceIndex] * GetComponentTransform() : Instances[InstanceIndex];
    return true;
}

bool UInstancedStaticMeshComponent::BatchUpdateInstancesTransforms(int32 Start, const TArray<FTransform>& New,
                                                                   bool bWorldSpace, bool bMarkRenderStateDirty, bool) {
    if (Start < 0 || Start + New.Num() > Instances.Num()) return false;
    ++ShimUpdates;
    ShimUpdated = New.Num();
    bShimMarkedDirty = bMarkRenderStateDirty;
    for (int32 Index = 0; Index < New.Num(); ++Index) {
        Instances[Start + Index] = bWorldSpace ? New[Index].GetRelativeTransform(GetComponentTransform()) : New[Index];
    }
    return true;
}

bool UInstancedStaticMeshComponent::BatchUpdateInstancesTransforms(int32 Start, const TArray<FTransform>& New,
                                                                   const TArray<FTransform>& Prev, bool bWorldSpace,
                                                                   bool bMarkRenderStateDirty, bool bTeleport) {
    if (Prev.Num() != New.Num() || !bHasPrevious) return false;
    if (!BatchUpdateInstancesTransforms(Start, New, bWorldSpace, bMarkRenderStateDirty, bTeleport)) return false;
    PrevInstances.SetNum(Instances.Num());
    for (int32 Index = 0; Index < Prev.Num(); ++Index) {
        PrevInstances[Start + Index] =
            bWorldSpace ? Prev[Index].GetRelativeTransform(GetComponentTransform()) : Prev[Index];
    }
    return true;
}

bool UInstancedStaticMeshComponent::GetInstancePrevTransform(int32 Index, FTransform& Out, bool bWorldSpace) const {
    if (Index < 0 || Index >= PrevInstances.Num() || PrevInstances.Num() != Instances.Num()) return false;
    Out = bWorldSpace ? PrevInstances[Index] * GetComponentTransform() : PrevInstances[Index];
    return true;
}

// ---------------------------------------------------------------------------------------------------------------------
// Worlds

bool UWorldSubsystem::DoesSupportWorldType(const EWorldType::Type WorldType) const {
    return WorldType == EWorldType::Game || WorldType == EWorldType::Editor || WorldType == EWorldType::PIE;
}

void UTickableWorldSubsystem::Initialize(FSubsystemCollectionBase& Collection) {
    Super::Initialize(Collection);
    bInitialized = true;
}

void UTickableWorldSubsystem::Deinitialize() {
    bInitialized = false;
    Super::Deinitialize();
}

extern UClass* const ShimWorldSubsystems[];

UWorld* UWorld::ShimCreate(EWorldType::Type Type) {
    UWorld* World = NewObject<UWorld>(nullptr);
    World->ShimAddLevel(true);
    FSubsystemCollectionBase Collection;
    for (UClass* const* Class = ShimWorldSubsystems; *Class != nullptr; ++Class) {
        if (!static_cast<UWorldSubsystem*>((*Class)->GetDefaultObject())->ShimSupports(Type)) continue;
        auto* Subsystem = NewObject<UWorldSubsystem>(World, *Class);
        World->Subsystems.Add(Subsystem);
        Subsystem->Initialize(Collection);
    }
    return World;
}

AActor* UWorld::ShimSpawn(const UClass* Class, ULevel* Level) {
    AActor* Actor = NewObject<AActor>(Level, Class);
    Level->Actors.Add(Actor);
    const TArray<UActorComponent*> Components = Actor->ShimComponents;
    for (UActorComponent* Component : Components) Component->RegisterComponent();
    if (bBegunPlay) Actor->BeginPlay();
    return Actor;
}

ULevel* UWorld::ShimAddLevel(bool bVisible) {
    ULevel* Level = NewObject<ULevel>(this);
    if (bVisible) Levels.Add(Level);
    return Level;
}

void UWorld::ShimShowLevel(ULevel* Level) {
    Levels.AddUnique(Level);
    FWorldDelegates::LevelAddedToWorld.Broadcast(Level, this);
}

void UWorld::ShimHideLevel(ULevel* Level) {
    Levels.Remove(Level);
    FWorldDelegates::LevelRemovedFromWorld.Broadcast(Level, this);
}

void UWorld::ShimBeginPlay() {
    for (UWorldSubsystem* Subsystem : Subsystems) Subsystem->OnWorldBeginPlay(*this);
    bBegunPlay = true;
    for (const ULevel* Level : Levels) {
        for (AActor* Actor : Level->Actors) {
            for (UActorComponent* Component : Actor->ShimComponents) {
                if (Component->IsRegistered() && !Component->bHasBegunPlay) Component->BeginPlay();
            }
            Actor->BeginPlay();
        }
    }
}

void UWorld::ShimTick(float DeltaSeconds) {
    for (UWorldSubsystem* Subsystem : Subsystems) {
        auto* Tickable = Cast<UTickableWorldSubsystem>(Subsystem);
        if (Tickable != nullptr && Tickable->IsTickable() && (!bShimPaused || Tickable->IsTickableWhenPaused()))
            Tickable->Tick(DeltaSeconds);
    }
}

void UWorld::ShimEnd() {
    for (const ULevel* Level : Levels) {
        for (AActor* Actor : Level->Actors) {
            for (UActorComponent* Component : Actor->ShimComponents) {
                if (Component->bHasBegunPlay) Component->EndPlay(EEndPlayReason::Quit);
                Component->MarkAsGarbage();
            }
        }
    }
    for (UWorldSubsystem* Subsystem : Subsystems) Subsystem->Deinitialize();
    Subsystems.Empty();
}

// ---------------------------------------------------------------------------------------------------------------------
// Niagara

void FNiagaraTypeRegistry::Register(const FNiagaraTypeDefinition& NewType, ENiagaraTypeRegistryFlags) {
    ShimRegistered.AddUnique(NewType.GetClass());
}

#define SHIM_NIAGARA_TYPE(Name, Registers)                                                                             \
    const FNiagaraTypeDefinition& FNiagaraTypeDefinition::Name() {                                                     \
        static const FNiagaraTypeDefinition Type(Registers);                                                           \
        return Type;                                                                                                   \
    }
SHIM_NIAGARA_TYPE(GetIntDef, 1)
SHIM_NIAGARA_TYPE(GetBoolDef, 1)
SHIM_NIAGARA_TYPE(GetFloatDef, 1)
SHIM_NIAGARA_TYPE(GetVec3Def, 3)
SHIM_NIAGARA_TYPE(GetQuatDef, 4)
SHIM_NIAGARA_TYPE(GetPositionDef, 3)

// ---------------------------------------------------------------------------------------------------------------------
// Packages and the editor's tools

FString UObject::GetName() const {
    if (dynamic_cast<const UPackage*>(this) != nullptr) return ShimName.ToString();
    const std::u16string Text = *ShimName.ToString();
    return FString(Text.substr(Text.rfind(u'/') + 1));
}

// One package for each object, of its name: an object's name is its path here.
UPackage* UObject::GetOutermost() const {
    auto* Package = new UPackage;
    Package->ShimName = ShimName;
    return Package;
}

UObject* ShimFind(const TCHAR* Name, const UClass* Class) {
    const std::u16string Text(Name);
    for (UObject* Object : ShimObjects()) {
        if (!Object->bGarbage && Object->GetClass()->IsChildOf(Class) &&
            Object->ShimName == FName(Text.substr(0, Text.rfind(u'.')).c_str()))
            return Object;
    }
    return nullptr;
}

IAssetTools& IAssetTools::Get() {
    static IAssetTools Tools;
    return Tools;
}

UObject* IAssetTools::CreateAsset(const FString& AssetName, const FString& PackagePath, UClass* AssetClass, UFactory*,
                                  FName) {
    return ShimNewObject(nullptr, AssetClass, FName(*FString::Printf(TEXT("%s/%s"), *PackagePath, *AssetName)),
                         RF_Public);
}

UToolMenu* UE::ContentBrowser::ExtendToolMenu_AssetContextMenu(UClass*) {
    static UToolMenu Menu;
    return &Menu;
}
