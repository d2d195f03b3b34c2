// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#include "LangevinColliders.h"

#include "Components/PrimitiveComponent.h"
#include "Engine/Level.h"
#include "GameFramework/Actor.h"
#include "LandscapeHeightfieldCollisionComponent.h"
#include "LangevinConversion.h"
#include "LangevinHost.h"
#include "LangevinRigidModule.h"
#include "LangevinSettings.h"
#include "LangevinTypes.h"
#include "PhysicalMaterials/PhysicalMaterial.h"

FLangevinColliders::FLangevinColliders(lr_world* InWorld, const FVector& InOrigin, const ULangevinSettings& InSettings)
    : World(InWorld), Origin(InOrigin), Settings(InSettings) {}

bool FLangevinColliders::IsWanted(const UPrimitiveComponent& Component) const {
    const AActor* Owner = Component.GetOwner();
    return Component.IsCollisionEnabled() && Component.Mobility != EComponentMobility::Movable &&
           Component.GetCollisionObjectType() == ECC_WorldStatic &&
           Component.GetCollisionResponseToChannel(ECC_WorldDynamic) == ECR_Block &&
           !Component.ComponentHasTag(Settings.IgnoreTag) &&
           (Owner == nullptr || !Owner->ActorHasTag(Settings.IgnoreTag));
}

void FLangevinColliders::Gather(UPrimitiveComponent& Component, TArray<FLangevinShape>& Shapes) const {
    if (const auto* Landscape = Cast<ULandscapeHeightfieldCollisionComponent>(&Component)) {
        FLangevinShape Shape;
        if (Settings.bCollideWithLandscapes && LangevinShapes::GatherLandscape(*Landscape, Shape)) {
            Shapes.Add(MoveTemp(Shape));
        }
    } else {
        LangevinShapes::Gather(Component, Settings.bUseComplexCollision, Shapes);
    }
}

int32 FLangevinColliders::AddLevel(const ULevel& Level) {
    int32 Added = 0;
    for (const AActor* Actor : Level.Actors) {
        if (Actor == nullptr) continue;
        TInlineComponentArray<UPrimitiveComponent*> Components(Actor);
        for (UPrimitiveComponent* Component : Components) {
            if (!IsWanted(*Component)) continue;
            TArray<FLangevinShape> Shapes;
            Gather(*Component, Shapes);
            Added += AddEntry(*Component, &Level, false, Shapes);
        }
    }
    return Added;
}

void FLangevinColliders::RemoveLevel(const ULevel& Level) {
    for (int32 Index = Entries.Num() - 1; Index >= 0; --Index) {
        if (Entries[Index].Level != &Level) continue;
        Destroy(Entries[Index]);
        Entries.RemoveAtSwap(Index);
    }
}

int32 FLangevinColliders::AddComponent(UPrimitiveComponent& Component, bool bFollow) {
    RemoveComponent(Component);
    TArray<FLangevinShape> Shapes;
    LangevinShapes::Gather(Component, Settings.bUseComplexCollision, Shapes);
    const int32 Added = AddEntry(Component, nullptr, bFollow, Shapes);
    if (Added == 0) {
        UE_LOG(LogLangevinRigid, Warning, TEXT("%s has no collision for bodies"), *Component.GetPathName());
    }
    return Added;
}

bool FLangevinColliders::RemoveComponent(const UPrimitiveComponent& Component) {
    for (int32 Index = 0; Index < Entries.Num(); ++Index) {
        if (Entries[Index].Component.Get() != &Component) continue;
        Destroy(Entries[Index]);
        Entries.RemoveAtSwap(Index);
        return true;
    }
    return false;
}

bool FLangevinColliders::AddPlane(const FVector& Point, const FVector& Normal, float Friction, float Restitution) {
    const FVector Unit = Normal.GetSafeNormal();
    if (Unit.IsZero()) {
        UE_LOG(LogLangevinRigid, Warning, TEXT("A plane needs a normal"));
        return false;
    }
    lr_collider_desc Desc;
    lr_collider_desc_init(&Desc, sizeof(Desc));
    Desc.kind = LR_COLLIDER_PLANE;
    LangevinTypes::Store(
        Desc.position, LangevinConversion::PositionToLangevin(LangevinTypes::From(Point), LangevinTypes::From(Origin)));
    LangevinTypes::Store(Desc.orientation, LangevinConversion::RotationFromYTo(
                                               LangevinConversion::MirrorDirection(LangevinTypes::From(Unit))));
    Desc.friction = Friction;
    Desc.restitution = Restitution;
    lr_collider Plane{};
    if (!LangevinHost::Check(lr_collider_create(World, &Desc, 1, &Plane), TEXT("A plane"))) return false;
    Gone.Remove(Plane); // after a restored state handles are given again
    return true;
}

void FLangevinColliders::Place(const FPart& Part, const FTransform& Frame, float* Position, float* Orientation) const {
    const FTransform Pose = Part.Local * FTransform(Frame.GetRotation(), Frame.GetLocation());
    const LangevinConversion::FRotation Rotation = LangevinTypes::From(Pose.GetRotation());
    LangevinTypes::Store(Position, LangevinConversion::PositionToLangevin(LangevinTypes::From(Pose.GetLocation()),
                                                                          LangevinTypes::From(Origin)));
    LangevinTypes::Store(Orientation, Part.bUpright ? LangevinConversion::UprightToLangevin(Rotation)
                                                    : LangevinConversion::MirrorRotation(Rotation));
}

int32 FLangevinColliders::AddEntry(UPrimitiveComponent& Component, const ULevel* Level, bool bFollow,
                                   const TArray<FLangevinShape>& Shapes) {
    FEntry Entry;
    Entry.Component = &Component;
    Entry.Level = Level;
    Entry.Last = Component.GetComponentTransform();
    Entry.bFollow = bFollow;
    const UPhysicalMaterial* Material = Component.BodyInstance.GetSimplePhysicalMaterial();
    for (const FLangevinShape& Shape : Shapes) {
        FPart Part;
        Part.Local = Shape.Local;
        Part.bUpright = Shape.bUpright;
        lr_collider_desc Desc;
        lr_collider_desc_init(&Desc, sizeof(Desc));
        Desc.kind = Shape.Kind;
        Place(Part, Entry.Last, Desc.position, Desc.orientation);
        for (int32 Axis = 0; Axis < 3; ++Axis) Desc.size[Axis] = Shape.Size[Axis];
        if (Material != nullptr) {
            Desc.friction = FMath::Clamp(Material->Friction, 0.0f, 10.0f);
            Desc.restitution = FMath::Clamp(Material->Restitution, 0.0f, 1.0f);
        }
        Desc.vertex_count = static_cast<uint32>(Shape.Vertices.Num() / 3);
        Desc.triangle_count = static_cast<uint32>(Shape.Indices.Num() / 3);
        Desc.vertices = Shape.Vertices.GetData();
        Desc.indices = Shape.Indices.GetData();
        Desc.heights = Shape.Heights.GetData();
        for (int32 Axis = 0; Axis < 2; ++Axis) {
            Desc.counts[Axis] = Shape.Counts[Axis];
            Desc.spacing[Axis] = Shape.Spacing[Axis];
        }
        const lr_status Status = lr_collider_create(World, &Desc, 1, &Part.Collider);
        if (Status == LR_OK) {
            Entry.Parts.Add(Part);
            Gone.Remove(Part.Collider);
        } else {
            UE_LOG(LogLangevinRigid, Warning, TEXT("A part of the collision of %s was skipped: %s"),
                   *Component.GetPathName(), UTF8_TO_TCHAR(lr_status_string(Status)));
        }
    }
    const int32 Added = Entry.Parts.Num();
    if (Added > 0) Entries.Add(MoveTemp(Entry));
    return Added;
}

void FLangevinColliders::Update() {
    TArray<lr_collider_motion> Motions;
    for (int32 Index = Entries.Num() - 1; Index >= 0; --Index) {
        FEntry& Entry = Entries[Index];
        const UPrimitiveComponent* Component = Entry.Component.Get();
        // Unregistered: its actor or its level has left the world.
        if (Component == nullptr || !Component->IsRegistered()) {
            Destroy(Entry);
            Entries.RemoveAtSwap(Index);
            continue;
        }
        if (!Entry.bFollow) continue;
        const FTransform& Now = Component->GetComponentTransform();
        if (!Entry.bRestored && Now.Equals(Entry.Last, 0.0)) continue;
        Entry.Last = Now;
        for (const FPart& Part : Entry.Parts) {
            lr_collider_motion Motion;
            lr_collider_motion_init(&Motion, sizeof(Motion));
            Motion.mode = LR_MOVE_TO;
            Motion.collider = Part.Collider;
            Place(Part, Now, Motion.position, Motion.orientation);
            if (!Entry.bRestored || !IsAt(Motion)) Motions.Add(Motion);
        }
        Entry.bRestored = false;
    }
    LangevinHost::Check(lr_collider_move(World, Motions.GetData(), static_cast<uint32>(Motions.Num())),
                        TEXT("Moving colliders"));
}

bool FLangevinColliders::IsAt(const lr_collider_motion& Motion) const {
    lr_collider_state State;
    lr_collider_state_init(&State, sizeof(State));
    if (lr_collider_get_state(World, Motion.collider, &State) != LR_OK) return false;
    bool bAt = true;
    for (int32 Axis = 0; Axis < 3; ++Axis) bAt = bAt && State.position[Axis] == Motion.position[Axis];
    for (int32 Part = 0; Part < 4; ++Part) bAt = bAt && State.orientation[Part] == Motion.orientation[Part];
    return bAt;
}

void FLangevinColliders::Restored() {
    for (const lr_collider& Collider : Gone) {
        if (lr_collider_is_valid(World, Collider)) {
            LangevinHost::Check(lr_collider_destroy(World, &Collider, 1), TEXT("Removing a collider"));
        }
    }
    for (int32 Index = Entries.Num() - 1; Index >= 0; --Index) {
        FEntry& Entry = Entries[Index];
        bool bWhole = true;
        for (const FPart& Part : Entry.Parts) bWhole = bWhole && lr_collider_is_valid(World, Part.Collider);
        Entry.bRestored = true;
        UPrimitiveComponent* const Component = Entry.Component.Get();
        if (bWhole || Component == nullptr) continue;
        for (const FPart& Part : Entry.Parts) {
            if (lr_collider_is_valid(World, Part.Collider)) lr_collider_destroy(World, &Part.Collider, 1);
        }
        TArray<FLangevinShape> Shapes;
        Gather(*Component, Shapes);
        const ULevel* const Level = Entry.Level;
        const bool bFollow = Entry.bFollow;
        Entries.RemoveAtSwap(Index);
        AddEntry(*Component, Level, bFollow, Shapes);
    }
}

void FLangevinColliders::Destroy(const FEntry& Entry) {
    for (const FPart& Part : Entry.Parts) {
        if (!lr_collider_is_valid(World, Part.Collider)) continue; // a restored state is from before it
        Gone.Add(Part.Collider);
        LangevinHost::Check(lr_collider_destroy(World, &Part.Collider, 1), TEXT("Removing a collider"));
    }
}

UPrimitiveComponent* FLangevinColliders::Find(lr_collider Collider) const {
    for (const FEntry& Entry : Entries) {
        for (const FPart& Part : Entry.Parts) {
            if (Part.Collider == Collider) return Entry.Component.Get();
        }
    }
    return nullptr;
}

int32 FLangevinColliders::Num() const {
    int32 Count = 0;
    for (const FEntry& Entry : Entries) Count += Entry.Parts.Num();
    return Count;
}
