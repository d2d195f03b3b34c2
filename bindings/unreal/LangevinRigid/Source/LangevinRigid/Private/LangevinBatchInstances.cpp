// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
// Turns a batch's bodies into instances, and into snapshots for other threads.
#include "Async/ParallelFor.h"
#include "Engine/StaticMesh.h"
#include "LangevinBatchComponent.h"
#include "LangevinConversion.h"
#include "LangevinHost.h"
#include "LangevinTypes.h"
#include "LangevinWorldSubsystem.h"

#include <langevin_rigid.h>

using LangevinTypes::From;
using LangevinTypes::To;

namespace {
constexpr int32 RecordFloats = 8; // LR_TRANSFORM_POSITION_QUATERNION_SCALE
constexpr int32 Chunk = 2048;     // instances for a task: some tens of microseconds

void InChunks(int32 Count, TFunctionRef<void(int32 Begin, int32 End)> Body) {
    const int32 Chunks = FMath::DivideAndRoundUp(Count, Chunk);
    ParallelFor(
        Chunks, [Count, &Body](int32 Index) { Body(Index * Chunk, FMath::Min(Count, (Index + 1) * Chunk)); },
        Chunks < 2 ? EParallelForFlags::ForceSingleThread : EParallelForFlags::None);
}
} // namespace

void ULangevinBatchComponent::WriteAllInstances() {
    bWriteAll = true;
    Snapshot.Reset();
    WriteInstances(0.0, 0.0);
}

void ULangevinBatchComponent::WriteInstances(double AheadSeconds, double FrameSeconds) {
    lr_world* World = LibraryWorld();
    lr_batch_view View = {};
    View.struct_size = sizeof(View);
    if (World == nullptr || Batch.id == 0 || lr_batch_get_view(World, Batch, &View) != LR_OK) return;

    const int32 Count = static_cast<int32>(View.count);
    const int32 Awake = static_cast<int32>(View.awake_count);
    const FTransform& Frame = GetComponentTransform();
    // Instances are relative to the component: if it moves, those of sleeping bodies must be written again.
    const bool bAll = bWriteAll || View.revision != WrittenRevision || Count != GetInstanceCount() ||
                      !Frame.Equals(WrittenFrame, 0.0);
    const int32 Written = bAll ? Count : FMath::Max(Awake, WrittenAwake);
    bWriteAll = false;
    WrittenRevision = View.revision;
    WrittenAwake = Awake;
    WrittenFrame = Frame;
    LastWritten = Written;
    SetInstanceCount(Count);
    if (Written == 0) return;

    Records.SetNumUninitialized(Written * RecordFloats);
    Transforms.SetNumUninitialized(Written, EAllowShrinking::No);
    Previous.SetNumUninitialized(Written, EAllowShrinking::No);
    if (!LangevinHost::Check(lr_batch_write_transforms(World, Batch, LR_TRANSFORM_POSITION_QUATERNION_SCALE,
                                                       Records.GetData(), 0, static_cast<uint32>(Written), nullptr),
                             TEXT("Transforms"))) {
        return;
    }
    // By velocities, as a body has no fixed place in the array, and may have jumped to the emitter.
    const bool bMoving = AheadSeconds > 0.0 || FrameSeconds > 0.0;
    const int32 Movers = bMoving ? Awake : 0; // bodies [0, Movers)
    Moving.SetNumUninitialized(Movers * 6, EAllowShrinking::No);
    if (!LangevinHost::Check(
            lr_batch_write_velocities(World, Batch, Moving.GetData(), 0, static_cast<uint32>(Movers), nullptr),
            TEXT("Velocities"))) {
        return;
    }
    const LangevinConversion::FVec Offset = From(MeshOrigin);
    const LangevinConversion::FVec Origin = From(Subsystem->GetOrigin());
    const auto Place = [&Offset, &Origin](const float* Record) {
        const LangevinConversion::FPose Pose = LangevinConversion::InstancePose(Record, Offset, Origin);
        return FTransform(To(Pose.Rotation), To(Pose.Location), FVector(Pose.Scale));
    };
    InChunks(Written, [this, &Place, Movers, AheadSeconds, FrameSeconds](int32 Begin, int32 End) {
        for (int32 Index = Begin; Index < End; ++Index) {
            float* Record = &Records[Index * RecordFloats];
            if (Index < Movers) LangevinConversion::AdvanceRecord(Record, &Moving[Index * 6], AheadSeconds);
            Transforms[Index] = Place(Record);
            if (Index < Movers) LangevinConversion::AdvanceRecord(Record, &Moving[Index * 6], -FrameSeconds);
            Previous[Index] = Index < Movers ? Place(Record) : Transforms[Index];
        }
    });
    GrowBounds(0, Written, bAll);
    BatchUpdateInstancesTransforms(0, Transforms, Previous, true, true, true);
    UpdateBounds();
}

// Instances are added and removed at the end; the others keep their places and are written anyway.
void ULangevinBatchComponent::SetInstanceCount(int32 Count) {
    const int32 Have = GetInstanceCount();
    if (Have < Count) {
        TArray<FTransform> Added;
        Added.Init(FTransform::Identity, Count - Have);
        AddInstances(Added, false, true, false);
    } else if (Count == 0) {
        if (Have > 0) {
            ClearInstances();
            // Some versions of the engine keep previous transforms of the cleared instances, and then use none any more.
            SetHasPerInstancePrevTransforms(false);
            SetHasPerInstancePrevTransforms(true);
        }
    } else if (Have > Count) {
        TArray<int32> Removed;
        Removed.Reserve(Have - Count);
        for (int32 Index = Have - 1; Index >= Count; --Index) Removed.Add(Index);
        RemoveInstances(Removed);
    }
}

void ULangevinBatchComponent::GrowBounds(int32 First, int32 Count, bool bAnew) {
    if (bAnew) BodyBounds = FBox(ForceInit);
    const double Radius = GetStaticMesh() != nullptr
                              ? GetStaticMesh()->GetBounds().SphereRadius + GetStaticMesh()->GetBounds().Origin.Size()
                              : 0.0;
    double Largest = 0.0;
    FBox Box(ForceInit);
    for (int32 Index = First; Index < First + Count; ++Index) {
        Box += Transforms[Index].GetLocation();
        Largest = FMath::Max(Largest, Transforms[Index].GetScale3D().X);
    }
    BodyBounds += Box.ExpandBy(Radius * Largest);
}

// From the instances last written: the engine's own function visits all instances every time.
FBoxSphereBounds ULangevinBatchComponent::CalcBounds(const FTransform& LocalToWorld) const {
    if (Batch.id == 0 || !BodyBounds.IsValid || GetInstanceCount() == 0) return Super::CalcBounds(LocalToWorld);
    const FBox Local = BodyBounds.TransformBy(WrittenFrame.Inverse());
    return FBoxSphereBounds(Local.TransformBy(LocalToWorld));
}

TSharedPtr<const FLangevinSnapshot, ESPMode::ThreadSafe> ULangevinBatchComponent::GetSnapshot() const {
    lr_batch_view View = {};
    View.struct_size = sizeof(View);
    if (Batch.id == 0 || lr_batch_get_view(LibraryWorld(), Batch, &View) != LR_OK) return nullptr;
    if (Snapshot.IsValid() && Snapshot->Frame == StepCount) return Snapshot;
    const TSharedRef<FLangevinSnapshot, ESPMode::ThreadSafe> Taken =
        MakeShared<FLangevinSnapshot, ESPMode::ThreadSafe>();
    const int32 Count = static_cast<int32>(View.count);
    Taken->AwakeCount = static_cast<int32>(View.awake_count);
    Taken->Frame = StepCount;
    Taken->Locations.SetNumUninitialized(Count);
    Taken->Rotations.SetNumUninitialized(Count);
    Taken->Velocities.SetNumUninitialized(Count);
    Taken->Spins.SetNumUninitialized(Count);
    Taken->Ages.Append(View.age, Count);
    Taken->Scales.Append(View.scale, Count);
    TArray<float> Velocities;
    Velocities.SetNumUninitialized(Count * 6);
    lr_batch_write_velocities(LibraryWorld(), Batch, Velocities.GetData(), 0, View.count, nullptr);
    const LangevinConversion::FVec Origin = From(Subsystem->GetOrigin());
    InChunks(Count, [&View, &Velocities, &Taken, &Origin](int32 Begin, int32 End) {
        for (int32 Index = Begin; Index < End; ++Index) {
            const LangevinConversion::FRotation Rotation{View.orientation[0][Index], View.orientation[1][Index],
                                                         View.orientation[2][Index], View.orientation[3][Index]};
            Taken->Locations[Index] = To(LangevinConversion::PositionToUnreal(
                {View.position[0][Index], View.position[1][Index], View.position[2][Index]}, Origin));
            Taken->Rotations[Index] = FQuat4f(To(LangevinConversion::MirrorRotation(Rotation)));
            const float* V = &Velocities[Index * 6];
            Taken->Velocities[Index] = FVector3f(To(LangevinConversion::VectorToUnreal({V[0], V[1], V[2]})));
            Taken->Spins[Index] = FVector3f(To(LangevinConversion::MirrorSpin({V[3], V[4], V[5]})));
        }
    });
    Snapshot = Taken;
    return Snapshot;
}
