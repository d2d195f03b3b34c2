// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#include "LangevinWorldSubsystem.h"

#include "Components/PrimitiveComponent.h"
#include "Engine/Level.h"
#include "Engine/World.h"
#include "LangevinBatchCalls.h"
#include "LangevinColliders.h"
#include "LangevinConversion.h"
#include "LangevinHost.h"
#include "LangevinRecording.h"
#include "LangevinRigidModule.h"
#include "LangevinSettings.h"
#include "LangevinTypes.h"
#include "LangevinWind.h"

#include <langevin_rigid.h>

DECLARE_STATS_GROUP(TEXT("LangevinRigid"), STATGROUP_LangevinRigid, STATCAT_Advanced);
DECLARE_CYCLE_STAT(TEXT("Step"), STAT_LangevinStep, STATGROUP_LangevinRigid);
DECLARE_CYCLE_STAT(TEXT("Write instances"), STAT_LangevinWrite, STATGROUP_LangevinRigid);

using LangevinHost::Check;

ULangevinWorldSubsystem::ULangevinWorldSubsystem() = default;
ULangevinWorldSubsystem::ULangevinWorldSubsystem(FVTableHelper& Helper) : Super(Helper) {}
ULangevinWorldSubsystem::~ULangevinWorldSubsystem() = default;

bool ULangevinWorldSubsystem::DoesSupportWorldType(const EWorldType::Type WorldType) const {
    return WorldType == EWorldType::Game || WorldType == EWorldType::PIE;
}

void ULangevinWorldSubsystem::Initialize(FSubsystemCollectionBase& Collection) {
    Super::Initialize(Collection);
    if (!FLangevinRigidModule::IsLibraryAvailable()) return;
    const ULangevinSettings& Settings = *GetDefault<ULangevinSettings>();
    Origin = Settings.Origin;

    lr_world_desc Desc;
    lr_world_desc_init(&Desc, sizeof(Desc));
    Desc.seed = static_cast<uint64>(Settings.Seed);
    Desc.allocator = LangevinHost::Allocator();
    Desc.log = &LangevinHost::Log;
    if (Settings.bUseEngineTasks && FLangevinJobs::WorkerCount() > 0) {
        Jobs = MakeUnique<FLangevinJobs>();
        Desc.jobs = Jobs->Callbacks();
        Desc.worker_count = FLangevinJobs::WorkerCount();
    }
    const UWorld* Level = GetWorld();
    const float GravityZ = Level != nullptr ? Level->GetGravityZ() : -980.0f;
    LangevinTypes::Store(Desc.gravity, LangevinConversion::VectorToLangevin({0.0, 0.0, GravityZ}));
    if (!Check(lr_world_create(&Desc, &World), TEXT("A world"))) return;

    if (Settings.Budget > 0) Check(lr_world_set_budget(World, static_cast<uint64>(Settings.Budget)), TEXT("A budget"));
    if (Settings.MaxEvents > 0) {
        Check(lr_world_set_events(World, static_cast<uint32>(Settings.MaxEvents), LR_EVENTS_ALL),
              TEXT("Contact events"));
    }
    Colliders = MakeUnique<FLangevinColliders>(World, Origin, Settings);
    Wind = MakeUnique<FLangevinWind>(World, Origin, Settings);
    if (Settings.bCollideWithLevel) {
        LevelAdded = FWorldDelegates::LevelAddedToWorld.AddUObject(this, &ULangevinWorldSubsystem::OnLevelAdded);
        LevelRemoved =
            FWorldDelegates::LevelRemovedFromWorld.AddUObject(this, &ULangevinWorldSubsystem::OnLevelRemoved);
    }
}

void ULangevinWorldSubsystem::Deinitialize() {
    FWorldDelegates::LevelAddedToWorld.Remove(LevelAdded);
    FWorldDelegates::LevelRemovedFromWorld.Remove(LevelRemoved);
    const TArray<FLangevinBatchCalls*> Left = Batches;
    for (FLangevinBatchCalls* Batch : Left) Batch->EndBatch();
    Batches.Empty();
    Wind.Reset();
    Colliders.Reset();
    if (World != nullptr) lr_world_destroy(World);
    World = nullptr;
    Recording.Reset();
    Jobs.Reset();
    Super::Deinitialize();
}

void ULangevinWorldSubsystem::OnWorldBeginPlay(UWorld& InWorld) {
    Super::OnWorldBeginPlay(InWorld);
    if (World == nullptr) return;
    // World settings can override gravity, and are not available earlier.
    float Gravity[3];
    LangevinTypes::Store(Gravity, LangevinConversion::VectorToLangevin({0.0, 0.0, InWorld.GetGravityZ()}));
    Check(lr_world_set_gravity(World, Gravity), TEXT("Gravity"));
    if (!GetDefault<ULangevinSettings>()->bCollideWithLevel) return;
    for (const ULevel* Level : InWorld.GetLevels()) {
        if (Level != nullptr) Colliders->AddLevel(*Level);
    }
    UE_LOG(LogLangevinRigid, Log, TEXT("%d colliders from the level"), Colliders->Num());
}

void ULangevinWorldSubsystem::OnLevelAdded(ULevel* Level, UWorld* InWorld) {
    if (Level == nullptr || InWorld != GetWorld() || !InWorld->HasBegunPlay()) return;
    Colliders->RemoveLevel(*Level); // it may already be there
    Colliders->AddLevel(*Level);
}

void ULangevinWorldSubsystem::OnLevelRemoved(ULevel* Level, UWorld* InWorld) {
    // Null: all levels leave, and this world with them.
    if (Level != nullptr && InWorld == GetWorld()) Colliders->RemoveLevel(*Level);
}

TStatId ULangevinWorldSubsystem::GetStatId() const {
    RETURN_QUICK_DECLARE_CYCLE_STAT(ULangevinWorldSubsystem, STATGROUP_Tickables);
}

void ULangevinWorldSubsystem::Tick(float DeltaTime) {
    Super::Tick(DeltaTime);
    const bool bWasPaused = bGamePaused;
    bGamePaused = GetWorld()->IsPaused();
    if (bGamePaused && !bWasPaused) StandStill();
    if (World == nullptr || bPaused || bGamePaused || DeltaTime <= 0.0f) return;
    const ULangevinSettings& Settings = *GetDefault<ULangevinSettings>();
    const float Frame = FMath::Min(DeltaTime, Settings.LongestFrame);
    double Ahead = 0.0, Moved = Frame;
    if (Settings.Stepping == ELangevinStepping::Frame) {
        Step(Frame);
    } else {
        const double Before = Settings.bSmoothFixedSteps ? Due : 0.0;
        Due += Frame;
        // The tolerance keeps a frame of exactly one step from waiting for the next frame because of rounding.
        const int32 Whole = FMath::FloorToInt32(Due / Settings.FixedStep + 1e-4);
        const int32 Steps = FMath::Min(Whole, Settings.MaxStepsPerFrame);
        for (int32 Index = 0; Index < Steps && !bPaused; ++Index) Step(Settings.FixedStep);
        Due = FMath::Max(0.0, Due - static_cast<double>(Whole) * Settings.FixedStep);
        if (Whole > Steps && !bToldLost) {
            bToldLost = true;
            UE_LOG(LogLangevinRigid, Warning,
                   TEXT("A frame needed %d fixed steps, of which %d were made: bodies fall slower than they should. "
                        "Raise Max "
                        "Steps Per Frame or Fixed Step in the project settings."),
                   Whole, Steps);
        }
        if (Settings.bSmoothFixedSteps) Ahead = Due;
        Moved = Steps * static_cast<double>(Settings.FixedStep) + Ahead - Before;
    }
    if (bPaused) Moved = 0.0; // by a listener: no later frame would make the instances stand still
    SCOPE_CYCLE_COUNTER(STAT_LangevinWrite);
    for (FLangevinBatchCalls* Batch : Batches) Batch->WriteInstances(Ahead, Moved);
}

void ULangevinWorldSubsystem::Step(float Seconds) {
    SCOPE_CYCLE_COUNTER(STAT_LangevinStep);
    Colliders->Update();
    Wind->Update(*GetWorld(), Seconds);
    for (FLangevinBatchCalls* Batch : Batches) Batch->PrepareStep();
    const float Longest = GetDefault<ULangevinSettings>()->LongestSubstep;
    const int32 Substeps = FMath::Clamp(FMath::CeilToInt32(Seconds / Longest - 1e-3f), 1, 1024);
    const lr_status Status = lr_world_step(World, Seconds, static_cast<uint32>(Substeps));
    // With too little memory for all contacts, the step is still taken.
    if (Check(Status, TEXT("A step")) || Status == LR_ERROR_OUT_OF_MEMORY) TellEvents();
}

void ULangevinWorldSubsystem::TellEvents() {
    lr_event_list List = {};
    List.struct_size = sizeof(List);
    if (lr_world_get_events(World, &List) != LR_OK || List.count == 0) return;
    TArray<FLangevinEvent> Events;
    Events.Reserve(static_cast<int32>(List.count));
    for (uint32 Index = 0; Index < List.count; ++Index) {
        const lr_event& From = List.events[Index];
        FLangevinEvent Event;
        Event.Kind = static_cast<ELangevinEvent>(From.kind);
        Event.Body.Id = static_cast<int64>(From.body.id);
        Event.User = static_cast<int64>(From.user);
        for (FLangevinBatchCalls* Batch : Batches) Batch->NameBatch(From, Event);
        if (From.collider.id != 0) Event.Other = Colliders->Find(From.collider);
        Event.Location = LangevinTypes::To(
            LangevinConversion::PositionToUnreal(LangevinTypes::From(From.position), LangevinTypes::From(Origin)));
        Event.Normal = LangevinTypes::To(LangevinConversion::MirrorDirection(LangevinTypes::From(From.normal)));
        Event.Speed = static_cast<float>(LangevinConversion::LengthToCentimetres(From.speed));
        Event.Impulse = static_cast<float>(LangevinConversion::LengthToCentimetres(From.impulse));
        Events.Add(Event);
    }
    // Listeners can create and destroy bodies: do not use the library's list below.
    OnEvents.Broadcast(Events);
}

void ULangevinWorldSubsystem::SetPaused(bool bInPaused) {
    bPaused = bInPaused;
    if (bPaused) StandStill();
}

// Bodies as they are now, but still: the instances keep the movement of their last update.
void ULangevinWorldSubsystem::StandStill() {
    const ULangevinSettings& Settings = *GetDefault<ULangevinSettings>();
    const bool bAhead = Settings.Stepping == ELangevinStepping::Fixed && Settings.bSmoothFixedSteps;
    for (FLangevinBatchCalls* Batch : Batches) Batch->WriteInstances(bAhead ? Due : 0.0, 0.0);
}

void ULangevinWorldSubsystem::SetWind(FVector Velocity) {
    if (Wind.IsValid()) Wind->SetExtra(Velocity);
}

FVector ULangevinWorldSubsystem::SampleWind(FVector Location) const {
    float Values[3] = {};
    if (World == nullptr) return FVector::ZeroVector;
    LangevinTypes::Store(
        Values, LangevinConversion::PositionToLangevin(LangevinTypes::From(Location), LangevinTypes::From(Origin)));
    if (!Check(lr_world_sample_wind(World, Values, 1, Values), TEXT("Wind"))) return FVector::ZeroVector;
    return LangevinTypes::To(LangevinConversion::VectorToUnreal(LangevinTypes::From(Values)));
}

bool ULangevinWorldSubsystem::AddPlane(FVector Point, FVector Normal, float Friction, float Restitution) {
    return Colliders.IsValid() && Colliders->AddPlane(Point, Normal, Friction, Restitution);
}

int32 ULangevinWorldSubsystem::AddCollider(UPrimitiveComponent* Component, bool bFollow) {
    return Colliders.IsValid() && Component != nullptr ? Colliders->AddComponent(*Component, bFollow) : 0;
}

bool ULangevinWorldSubsystem::RemoveCollider(UPrimitiveComponent* Component) {
    return Colliders.IsValid() && Component != nullptr && Colliders->RemoveComponent(*Component);
}

int32 ULangevinWorldSubsystem::GetColliderCount() const {
    return Colliders.IsValid() ? Colliders->Num() : 0;
}

int32 ULangevinWorldSubsystem::WakeBox(FVector Min, FVector Max) {
    if (World == nullptr) return 0;
    // y changes its sign, so low and high change places.
    float Low[3], High[3];
    LangevinTypes::Store(Low,
                         LangevinConversion::PositionToLangevin({Min.X, Max.Y, Min.Z}, LangevinTypes::From(Origin)));
    LangevinTypes::Store(High,
                         LangevinConversion::PositionToLangevin({Max.X, Min.Y, Max.Z}, LangevinTypes::From(Origin)));
    uint32 Woken = 0;
    Check(lr_world_wake_box(World, Low, High, &Woken), TEXT("WakeBox"));
    return static_cast<int32>(Woken);
}

bool ULangevinWorldSubsystem::SaveState(TArray<uint8>& State) const {
    if (World == nullptr) return false;
    State.SetNumUninitialized(static_cast<int32>(lr_world_snapshot_size(World)));
    return Check(lr_world_snapshot_save(World, State.GetData(), static_cast<uint64>(State.Num()), nullptr),
                 TEXT("Saving the state"));
}

bool ULangevinWorldSubsystem::RestoreState(const TArray<uint8>& State) {
    if (World == nullptr) return false;
    if (!Check(lr_world_snapshot_restore(World, State.GetData(), static_cast<uint64>(State.Num())),
               TEXT("Restoring a state"))) {
        return false;
    }
    Due = 0.0;
    Colliders->Restored();
    Wind->Restored();
    for (FLangevinBatchCalls* Batch : Batches) Batch->WriteAllInstances();
    return true;
}

int64 ULangevinWorldSubsystem::GetStateHash() const {
    uint64_t Hash = 0; // another type than uint64 on Linux
    if (World != nullptr) lr_world_hash(World, &Hash);
    return static_cast<int64>(Hash);
}

bool ULangevinWorldSubsystem::StartRecording(const FString& Filename) {
    if (World == nullptr || Recording.IsValid()) return false;
    Recording = FLangevinRecording::Start(World, Filename);
    return Recording.IsValid();
}

bool ULangevinWorldSubsystem::StopRecording() {
    if (!Recording.IsValid()) return false;
    const bool bWhole = Recording->Stop(World);
    Recording.Reset();
    return bWhole;
}

double ULangevinWorldSubsystem::GetSimulatedTime() const {
    lr_world_info Info = {};
    Info.struct_size = sizeof(Info);
    return World != nullptr && lr_world_get_info(World, &Info) == LR_OK ? Info.time : 0.0;
}

int32 ULangevinWorldSubsystem::GetBodyCount() const {
    lr_world_info Info = {};
    Info.struct_size = sizeof(Info);
    return World != nullptr && lr_world_get_info(World, &Info) == LR_OK ? static_cast<int32>(Info.body_count) : 0;
}

uint64 ULangevinWorldSubsystem::GetLaunchedTasks() const {
    return Jobs.IsValid() ? Jobs->GetLaunched() : 0;
}

void ULangevinWorldSubsystem::RegisterBatch(FLangevinBatchCalls& Batch) {
    Batches.AddUnique(&Batch);
}

void ULangevinWorldSubsystem::UnregisterBatch(FLangevinBatchCalls& Batch) {
    Batches.Remove(&Batch);
}
