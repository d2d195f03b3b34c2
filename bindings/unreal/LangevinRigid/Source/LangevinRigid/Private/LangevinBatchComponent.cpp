// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
// A component's batch in the library: bodies, their emitter and their rules. Drawing is in
// LangevinBatchInstances.cpp.
#include "LangevinBatchComponent.h"

#include "Engine/World.h"
#include "LangevinAsset.h"
#include "LangevinConversion.h"
#include "LangevinHost.h"
#include "LangevinRigidModule.h"
#include "LangevinTypes.h"
#include "LangevinWorldSubsystem.h"

#include <langevin_rigid.h>

using LangevinHost::Check;
using LangevinTypes::From;
using LangevinTypes::Store;
using LangevinTypes::To;

ULangevinBatchComponent::ULangevinBatchComponent(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer) {
    PrimaryComponentTick.bCanEverTick = false;
    // The engine's own physics would build a body for each instance, and move it every frame.
    SetCollisionEnabled(ECollisionEnabled::NoCollision);
    SetGenerateOverlapEvents(false);
    SetCanEverAffectNavigation(false);
    SetMobility(EComponentMobility::Movable);
    // Instances are stored relative to the component; a scale of the component would shear rotating bodies.
    SetUsingAbsoluteScale(true);
}

void ULangevinBatchComponent::BeginPlay() {
    Super::BeginPlay();
    if (Asset != nullptr) BeginBatch();
}

void ULangevinBatchComponent::EndPlay(const EEndPlayReason::Type EndPlayReason) {
    EndBatch();
    Super::EndPlay(EndPlayReason);
}

lr_world* ULangevinBatchComponent::LibraryWorld() const {
    return Subsystem != nullptr ? Subsystem->GetLibraryWorld() : nullptr;
}

bool ULangevinBatchComponent::BeginBatch() {
    if (Batch.id != 0) return true;
    const UWorld* Level = GetWorld();
    Subsystem = Level != nullptr ? Level->GetSubsystem<ULangevinWorldSubsystem>() : nullptr;
    lr_world* World = LibraryWorld();
    if (World == nullptr) return false; // the module logged the reason when it started
    const lr_asset* Handle = Asset != nullptr ? Asset->GetHandle() : nullptr;
    if (Handle == nullptr) {
        UE_LOG(LogLangevinRigid, Error, TEXT("%s has no asset: import a .lrb file and set it as Asset"),
               *GetPathName());
        return false;
    }
    if (GetStaticMesh() == nullptr) {
        UE_LOG(LogLangevinRigid, Warning, TEXT("%s has no static mesh: its bodies are invisible"), *GetPathName());
    }

    lr_batch_desc Desc;
    lr_batch_desc_init(&Desc, sizeof(Desc));
    Desc.asset = Handle;
    Desc.capacity = static_cast<uint32>(FMath::Max(Capacity, 1));
    Desc.load_model = static_cast<int32>(Loads);
    Desc.variation = FMath::Clamp(Variation, 0.0f, 0.5f);
    if (!Check(lr_batch_create(World, &Desc, &Batch), *GetPathName())) return false;
    MeshOrigin = -Asset->GetCenterOfMass();
    SetHasPerInstancePrevTransforms(true); // for motion vectors: temporal anti-aliasing, motion blur

    lr_load_gains Gains;
    lr_load_gains_init(&Gains, sizeof(Gains));
    Gains.drag = DragGain;
    Gains.lift = LiftGain;
    Gains.turbulence = TurbulenceGain;
    const uint32 Divisor = static_cast<uint32>(FMath::Clamp(RateDivisor, 1, 1024));
    const bool bGood = Check(lr_batch_set_load_gains(World, Batch, &Gains), TEXT("Gains")) &&
                       Check(lr_batch_set_rate(World, Batch, Divisor), TEXT("Rate")) && ApplyEmitter() &&
                       ApplyRules() && ApplyContact();
    if (!bGood) {
        lr_batch_destroy(World, Batch);
        Batch = {};
        return false;
    }
    ClearInstances();
    Subsystem->RegisterBatch(*this);
    bWriteAll = true;
    if (InitialCount > 0) EmitBodies(FMath::Min(InitialCount, Capacity));
    WriteAllInstances();
    return true;
}

void ULangevinBatchComponent::EndBatch() {
    if (Batch.id == 0) return;
    if (lr_world* World = LibraryWorld()) Check(lr_batch_destroy(World, Batch), *GetPathName());
    Batch = {};
    Snapshot.Reset();
    if (Subsystem != nullptr) Subsystem->UnregisterBatch(*this);
    Subsystem = nullptr;
    ClearInstances();
}

void ULangevinBatchComponent::NameBatch(const lr_event& From, FLangevinEvent& Event) {
    if (GetLibraryBatch() == From.batch) Event.Batch = this;
}

bool ULangevinBatchComponent::ApplyEmitter() {
    EmitterPlace = GetComponentTransform();
    lr_emitter_desc Desc;
    lr_emitter_desc_init(&Desc, sizeof(Desc));
    Desc.shape = static_cast<int32>(EmitterShape);
    Store(Desc.position,
          LangevinConversion::PositionToLangevin(From(EmitterPlace.GetLocation()), From(Subsystem->GetOrigin())));
    Store(Desc.orientation, LangevinConversion::MirrorRotation(From(EmitterPlace.GetRotation())));
    const FVector Extent = EmitterExtent.GetAbs() / LangevinConversion::CentimetresPerMetre;
    Store(Desc.size, From(Extent));
    const float Speed = static_cast<float>(LangevinConversion::LengthToMetres(InitialVelocity.Size()));
    if (Speed > 0.0f) Store(Desc.direction, LangevinConversion::VectorToLangevin(From(InitialVelocity)));
    Desc.speed_min = Desc.speed_max = Speed;
    Desc.spin_max = InitialSpin;
    Desc.scale_min = static_cast<float>(FMath::Min(ScaleRange.X, ScaleRange.Y));
    Desc.scale_max = static_cast<float>(FMath::Max(ScaleRange.X, ScaleRange.Y));
    Desc.rate = EmitterRate;
    return Check(lr_batch_set_emitter(LibraryWorld(), Batch, &Desc), TEXT("Emitter"));
}

bool ULangevinBatchComponent::ApplyRules() {
    if (MaxAge <= 0.0f && !bKillBelow && !bRespawn) return true;
    lr_batch_rules Rules;
    lr_batch_rules_init(&Rules, sizeof(Rules));
    Rules.action = bRespawn ? LR_END_RESPAWN : LR_END_DESTROY;
    Rules.max_age = FMath::Max(MaxAge, 0.0f);
    if (bKillBelow) {
        Rules.volume_count = 1;
        lr_kill_volume& Volume = Rules.volumes[0];
        Volume.shape = LR_VOLUME_PLANE;
        Volume.side = LR_KILL_INSIDE;
        const FVector Point(Subsystem->GetOrigin().X, Subsystem->GetOrigin().Y, KillHeight);
        Store(Volume.center, LangevinConversion::PositionToLangevin(From(Point), From(Subsystem->GetOrigin())));
        Store(Volume.size, LangevinConversion::MirrorDirection({0.0, 0.0, 1.0}));
    }
    return Check(lr_batch_set_rules(LibraryWorld(), Batch, &Rules), TEXT("Rules"));
}

bool ULangevinBatchComponent::ApplyContact() {
    lr_batch_contact Contact;
    lr_batch_contact_init(&Contact, sizeof(Contact));
    Contact.friction = Friction;
    Contact.restitution = Restitution;
    if (!bCollide) Contact.layers = 0;
    return Check(lr_batch_set_contact(LibraryWorld(), Batch, &Contact), TEXT("Contact")) &&
           (!bCollideWithEachOther ||
            Check(lr_batch_set_body_contact(LibraryWorld(), Batch, Batch, 1), TEXT("Contact of bodies")));
}

void ULangevinBatchComponent::PrepareStep() {
    ++StepCount;
    if (!GetComponentTransform().Equals(EmitterPlace, 0.0)) ApplyEmitter();
}

TArray<FLangevinBody> ULangevinBatchComponent::SpawnBodies(const TArray<FTransform>& InTransforms, FVector Velocity) {
    TArray<FLangevinBody> Bodies;
    if (Batch.id == 0 || InTransforms.Num() == 0) return Bodies;
    TArray<lr_body_desc> Descs;
    for (const FTransform& Transform : InTransforms) {
        lr_body_desc Desc;
        lr_body_desc_init(&Desc, sizeof(Desc));
        Desc.scale = static_cast<float>(Transform.GetScale3D().X);
        const FVector Center = Transform.GetLocation() - Transform.GetRotation().RotateVector(MeshOrigin * Desc.scale);
        Store(Desc.position, LangevinConversion::PositionToLangevin(From(Center), From(Subsystem->GetOrigin())));
        Store(Desc.orientation, LangevinConversion::MirrorRotation(From(Transform.GetRotation())));
        Store(Desc.linear_velocity, LangevinConversion::VectorToLangevin(From(Velocity)));
        Descs.Add(Desc);
    }
    TArray<lr_body> Ids;
    Ids.SetNumZeroed(Descs.Num());
    const lr_status Status =
        lr_body_create(LibraryWorld(), Batch, Descs.GetData(), static_cast<uint32>(Descs.Num()), Ids.GetData());
    if (!Check(Status, TEXT("SpawnBodies"))) return Bodies;
    Snapshot.Reset();
    for (const lr_body Id : Ids) {
        FLangevinBody Body;
        Body.Id = static_cast<int64>(Id.id);
        Bodies.Add(Body);
    }
    return Bodies;
}

bool ULangevinBatchComponent::EmitBodies(int32 Count) {
    if (Batch.id == 0 || Count < 0) return false;
    Snapshot.Reset();
    return Check(lr_batch_spawn(LibraryWorld(), Batch, static_cast<uint32>(Count), nullptr), TEXT("EmitBodies"));
}

bool ULangevinBatchComponent::DestroyBodies(const TArray<FLangevinBody>& Bodies) {
    if (Batch.id == 0) return false;
    TArray<lr_body> Ids;
    for (const FLangevinBody& Body : Bodies) Ids.Add(lr_body{static_cast<uint64_t>(Body.Id)});
    Snapshot.Reset();
    return Check(lr_body_destroy(LibraryWorld(), Ids.GetData(), static_cast<uint32>(Ids.Num())), TEXT("DestroyBodies"));
}

bool ULangevinBatchComponent::GetBodyState(FLangevinBody Body, FTransform& Transform, FVector& Velocity, FVector& Spin,
                                           bool& bResting) const {
    lr_body_state State = {};
    State.struct_size = sizeof(State);
    if (Batch.id == 0 || lr_body_get_state(LibraryWorld(), lr_body{static_cast<uint64_t>(Body.Id)}, &State) != LR_OK)
        return false;
    const float Record[8] = {State.position[0],    State.position[1],    State.position[2],    State.orientation[0],
                             State.orientation[1], State.orientation[2], State.orientation[3], State.scale};
    const LangevinConversion::FPose Pose =
        LangevinConversion::InstancePose(Record, From(MeshOrigin), From(Subsystem->GetOrigin()));
    Transform = FTransform(To(Pose.Rotation), To(Pose.Location), FVector(Pose.Scale));
    Velocity = To(LangevinConversion::VectorToUnreal(From(State.linear_velocity)));
    Spin = To(LangevinConversion::MirrorSpin(From(State.angular_velocity)));
    bResting = State.sleep_state == LR_SLEEP_ASLEEP;
    return true;
}

bool ULangevinBatchComponent::AddImpulseToBody(FLangevinBody Body, FVector Impulse, FVector Location,
                                               bool bAtLocation) {
    if (Batch.id == 0) return false;
    lr_body_force Force;
    lr_body_force_init(&Force, sizeof(Force));
    Force.mode = LR_FORCE_MODE_IMPULSE;
    Force.body = lr_body{static_cast<uint64_t>(Body.Id)};
    Store(Force.force, LangevinConversion::ForceToLangevin(From(Impulse)));
    if (bAtLocation) {
        Force.flags = LR_FORCE_AT_POINT;
        Store(Force.point, LangevinConversion::PositionToLangevin(From(Location), From(Subsystem->GetOrigin())));
    }
    return Check(lr_body_add_force(LibraryWorld(), &Force, 1), TEXT("AddImpulseToBody"));
}

bool ULangevinBatchComponent::SetAcceleration(FVector Acceleration) {
    if (Batch.id == 0) return false;
    lr_batch_force Force;
    lr_batch_force_init(&Force, sizeof(Force));
    Store(Force.acceleration, LangevinConversion::VectorToLangevin(From(Acceleration)));
    return Check(lr_batch_set_force(LibraryWorld(), Batch, &Force), TEXT("SetAcceleration"));
}

int32 ULangevinBatchComponent::GetBodyCount() const {
    lr_batch_view View = {};
    View.struct_size = sizeof(View);
    return Batch.id != 0 && lr_batch_get_view(LibraryWorld(), Batch, &View) == LR_OK ? static_cast<int32>(View.count)
                                                                                     : 0;
}

int32 ULangevinBatchComponent::GetAwakeCount() const {
    lr_batch_view View = {};
    View.struct_size = sizeof(View);
    return Batch.id != 0 && lr_batch_get_view(LibraryWorld(), Batch, &View) == LR_OK
               ? static_cast<int32>(View.awake_count)
               : 0;
}
