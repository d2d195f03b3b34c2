// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#include "LangevinShapes.h"

#include "Components/InstancedStaticMeshComponent.h"
#include "Components/PrimitiveComponent.h"
#include "Components/StaticMeshComponent.h"
#include "Engine/StaticMesh.h"
#include "Interface_CollisionDataProviderCore.h"
#include "LandscapeHeightfieldCollisionComponent.h"
#include "LandscapeProxy.h"
#include "LangevinConversion.h"
#include "LangevinRigidModule.h"
#include "LangevinTypes.h"
#include "PhysicsEngine/BodySetup.h"

#include <langevin_rigid.h>

namespace LangevinShapes {
namespace {
float Metres(double Centimetres) {
    return static_cast<float>(LangevinConversion::LengthToMetres(Centimetres));
}

void AppendPoint(TArray<float>& Out, const FVector& Point) {
    float V[3];
    LangevinTypes::Store(V, LangevinConversion::VectorToLangevin(LangevinTypes::From(Point)));
    Out.Append(V, 3);
}

void AddConvex(const FKConvexElem& Elem, const FVector& Scale, TArray<FLangevinShape>& Out) {
    TArray<FVector> Points;
    const FTransform Place = Elem.GetTransform();
    for (const FVector& Vertex : Elem.VertexData) Points.Add(Place.TransformPosition(Vertex) * Scale);
    if (Points.Num() < 4) return;
    if (Points.Num() > static_cast<int32>(LR_MAX_HULL_VERTICES)) Points = Outermost(Points, LR_MAX_HULL_VERTICES);
    FLangevinShape Shape;
    Shape.Kind = LR_COLLIDER_HULL;
    for (const FVector& Point : Points) AppendPoint(Shape.Vertices, Point);
    Out.Add(MoveTemp(Shape));
}

void AddSimple(const FKAggregateGeom& Geometry, const FVector& Scale, TArray<FLangevinShape>& Out) {
    for (const FKBoxElem& Elem : Geometry.BoxElems) {
        const FKBoxElem Scaled = Elem.GetFinalScaled(Scale, FTransform::Identity);
        FLangevinShape Shape;
        Shape.Kind = LR_COLLIDER_BOX;
        Shape.Local = Scaled.GetTransform();
        Shape.Size[0] = Metres(0.5 * Scaled.X);
        Shape.Size[1] = Metres(0.5 * Scaled.Y);
        Shape.Size[2] = Metres(0.5 * Scaled.Z);
        Out.Add(MoveTemp(Shape));
    }
    for (const FKSphereElem& Elem : Geometry.SphereElems) {
        const FKSphereElem Scaled = Elem.GetFinalScaled(Scale, FTransform::Identity);
        FLangevinShape Shape;
        Shape.Kind = LR_COLLIDER_SPHERE;
        Shape.Local = Scaled.GetTransform();
        Shape.Size[0] = Metres(Scaled.Radius);
        Out.Add(MoveTemp(Shape));
    }
    for (const FKSphylElem& Elem : Geometry.SphylElems) {
        const FKSphylElem Scaled = Elem.GetFinalScaled(Scale, FTransform::Identity);
        FLangevinShape Shape;
        Shape.Local = Scaled.GetTransform();
        Shape.Size[0] = Metres(Scaled.Radius);
        // Length is the distance between the centers of both ends.
        Shape.Size[1] = Metres(0.5 * Scaled.Length);
        Shape.bUpright = Shape.Size[1] > 0.0f;
        Shape.Kind = Shape.bUpright ? LR_COLLIDER_CAPSULE : LR_COLLIDER_SPHERE;
        Out.Add(MoveTemp(Shape));
    }
    for (const FKConvexElem& Elem : Geometry.ConvexElems) AddConvex(Elem, Scale, Out);
}

void AddTriangles(UPrimitiveComponent& Component, const FVector& Scale, TArray<FLangevinShape>& Out) {
    const UStaticMeshComponent* MeshComponent = Cast<UStaticMeshComponent>(&Component);
    UStaticMesh* Mesh = MeshComponent != nullptr ? MeshComponent->GetStaticMesh() : nullptr;
    if (Mesh == nullptr) return;
    FTriMeshCollisionData Data;
    if (!Mesh->GetPhysicsTriMeshData(&Data, true) || Data.Indices.Num() == 0) {
        UE_LOG(
            LogLangevinRigid, Warning,
            TEXT("%s has no simple collision, and its triangles cannot be read: give %s simple collision, or Allow CPU "
                 "Access. Bodies fall through it."),
            *Component.GetPathName(), *Mesh->GetPathName());
        return;
    }
    FLangevinShape Shape;
    Shape.Kind = LR_COLLIDER_MESH;
    for (const FVector3f& Vertex : Data.Vertices) AppendPoint(Shape.Vertices, FVector(Vertex) * Scale);
    for (const FTriIndices& Triangle : Data.Indices) {
        Shape.Indices.Add(static_cast<uint32>(Triangle.v0));
        Shape.Indices.Add(static_cast<uint32>(Triangle.v1));
        Shape.Indices.Add(static_cast<uint32>(Triangle.v2));
    }
    Out.Add(MoveTemp(Shape));
}

void GatherScaled(UPrimitiveComponent& Component, const FVector& Scale, bool bComplex, TArray<FLangevinShape>& Out) {
    const UBodySetup* Setup = Component.GetBodySetup();
    if (Setup == nullptr) return;
    const bool bByTriangles =
        Setup->GetCollisionTraceFlag() == CTF_UseComplexAsSimple || Setup->AggGeom.GetElementCount() == 0;
    if (!bByTriangles) {
        AddSimple(Setup->AggGeom, Scale, Out);
    } else if (bComplex) {
        AddTriangles(Component, Scale, Out);
    }
}
} // namespace

void Gather(UPrimitiveComponent& Component, bool bComplex, TArray<FLangevinShape>& Out) {
    const UInstancedStaticMeshComponent* Instanced = Cast<UInstancedStaticMeshComponent>(&Component);
    if (Instanced == nullptr) {
        GatherScaled(Component, Component.GetComponentScale(), bComplex, Out);
        return;
    }
    const FTransform Frame(Component.GetComponentQuat(), Component.GetComponentLocation());
    for (int32 Index = 0; Index < Instanced->GetInstanceCount(); ++Index) {
        FTransform Instance;
        if (!Instanced->GetInstanceTransform(Index, Instance, true)) continue;
        const int32 First = Out.Num();
        GatherScaled(Component, Instance.GetScale3D(), bComplex, Out);
        const FTransform Place = FTransform(Instance.GetRotation(), Instance.GetLocation()).GetRelativeTransform(Frame);
        for (int32 Shape = First; Shape < Out.Num(); ++Shape) Out[Shape].Local = Out[Shape].Local * Place;
    }
}

bool GatherLandscape(const ULandscapeHeightfieldCollisionComponent& Component, FLangevinShape& Out) {
    const ALandscapeProxy* Proxy = Component.GetLandscapeProxy();
    const int32 Quads = Component.CollisionSizeQuads;
    if (Proxy == nullptr || Quads < 1) return false;
    const FTransform& Frame = Component.GetComponentTransform();
    if (Frame.GetUnitAxis(EAxis::Z).Z < 0.9999) {
        UE_LOG(LogLangevinRigid, Warning, TEXT("%s is tilted: bodies fall through it."), *Proxy->GetPathName());
        return false;
    }
    Out.Kind = LR_COLLIDER_HEIGHTFIELD;
    Out.bUpright = true;
    Out.Counts[0] = Out.Counts[1] = static_cast<uint32>(Quads + 1);
    Out.Spacing[0] = Metres(Component.CollisionScale * Frame.GetScale3D().X);
    Out.Spacing[1] = Metres(Component.CollisionScale * Frame.GetScale3D().Y);
    Out.Heights.Reserve((Quads + 1) * (Quads + 1));
    const double Base = Frame.GetLocation().Z;
    constexpr float Hole = TNumericLimits<float>::Lowest();
    float Lowest = TNumericLimits<float>::Max();
    for (int32 Row = 0; Row <= Quads; ++Row) {
        for (int32 Column = 0; Column <= Quads; ++Column) {
            // A border belongs to no component: sample slightly inside it.
            const double X = FMath::Clamp(static_cast<double>(Column), 1e-3, Quads - 1e-3) * Component.CollisionScale;
            const double Y = FMath::Clamp(static_cast<double>(Row), 1e-3, Quads - 1e-3) * Component.CollisionScale;
            const TOptional<float> Height =
                Proxy->GetHeightAtLocation(Frame.TransformPosition(FVector(X, Y, 0.0)), EHeightfieldSource::Complex);
            const float Value = Height.IsSet() ? Metres(Height.GetValue() - Base) : Hole;
            if (Height.IsSet()) Lowest = FMath::Min(Lowest, Value);
            Out.Heights.Add(Value);
        }
    }
    if (Lowest == TNumericLimits<float>::Max()) return false;
    // A heightfield cannot have holes: they become shafts of ten metres.
    for (float& Height : Out.Heights) {
        if (Height == Hole) Height = Lowest - 10.0f;
    }
    return true;
}

TArray<FVector> Outermost(const TArray<FVector>& Points, int32 Count) {
    TArray<bool> Taken;
    Taken.Init(false, Points.Num());
    TArray<FVector> Out;
    const double Golden = UE_DOUBLE_PI * (3.0 - FMath::Sqrt(5.0));
    for (int32 Direction = 0; Direction < Count; ++Direction) {
        const double Z = 1.0 - 2.0 * (Direction + 0.5) / Count;
        const double R = FMath::Sqrt(1.0 - Z * Z);
        const FVector Way(R * FMath::Cos(Golden * Direction), R * FMath::Sin(Golden * Direction), Z);
        int32 Best = 0;
        for (int32 Index = 1; Index < Points.Num(); ++Index) {
            if (FVector::DotProduct(Points[Index], Way) > FVector::DotProduct(Points[Best], Way)) Best = Index;
        }
        if (!Taken[Best]) Out.Add(Points[Best]);
        Taken[Best] = true;
    }
    return Out;
}
} // namespace LangevinShapes
