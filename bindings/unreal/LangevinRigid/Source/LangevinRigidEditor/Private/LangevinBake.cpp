// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#include "LangevinBake.h"

#include "Engine/StaticMesh.h"
#include "HAL/FileManager.h"
#include "HAL/PlatformProcess.h"
#include "IAssetTools.h"
#include "Interface_CollisionDataProviderCore.h"
#include "Interfaces/IPluginManager.h"
#include "LangevinAsset.h"
#include "LangevinConversion.h"
#include "LangevinRigidModule.h"
#include "Misc/FileHelper.h"
#include "Misc/PackageName.h"
#include "Misc/Paths.h"

namespace {
FString BakerPath() {
    const TSharedPtr<IPlugin> Plugin = IPluginManager::Get().FindPlugin(TEXT("LangevinRigid"));
    if (!Plugin.IsValid()) return FString();
#if PLATFORM_WINDOWS
    const TCHAR* const Name = TEXT("lr_bake.exe");
#else
    const TCHAR* const Name = TEXT("lr_bake");
#endif
    return FPaths::ConvertRelativePathToFull(FPaths::Combine(Plugin->GetBaseDir(),
                                                             TEXT("Source/ThirdParty/LangevinRigidLibrary/bin"),
                                                             FPlatformProcess::GetBinariesSubdirectory(), Name));
}

ULangevinAsset* Fail(const UStaticMesh* Mesh, const FString& Why) {
    UE_LOG(LogLangevinRigid, Error, TEXT("%s was not baked: %s"),
           Mesh != nullptr ? *Mesh->GetPathName() : TEXT("Nothing"), *Why);
    return nullptr;
}
} // namespace

FString ULangevinBake::WriteObj(UStaticMesh& Mesh) {
    FTriMeshCollisionData Data;
    if (!Mesh.GetPhysicsTriMeshData(&Data, true) || Data.Indices.Num() == 0) return FString();
    FString Text;
    TArray<LangevinConversion::FVec> Points;
    for (const FVector3f& Vertex : Data.Vertices) {
        Points.Add(LangevinConversion::PositionToLangevin({Vertex.X, Vertex.Y, Vertex.Z}, {0.0, 0.0, 0.0}));
        const LangevinConversion::FVec& Point = Points.Last();
        Text += FString::Printf(TEXT("v %.9g %.9g %.9g\n"), Point.X, Point.Y, Point.Z);
    }
    // Outward, whatever the engine's and the mirror's winding: a closed body has a positive volume.
    double Volume = 0.0;
    for (const FTriIndices& Triangle : Data.Indices) {
        const LangevinConversion::FVec &A = Points[Triangle.v0], &B = Points[Triangle.v1], &C = Points[Triangle.v2];
        Volume += A.X * (B.Y * C.Z - B.Z * C.Y) + A.Y * (B.Z * C.X - B.X * C.Z) + A.Z * (B.X * C.Y - B.Y * C.X);
    }
    for (const FTriIndices& Triangle : Data.Indices) {
        Text += FString::Printf(TEXT("f %d %d %d\n"), Triangle.v0 + 1, (Volume < 0.0 ? Triangle.v2 : Triangle.v1) + 1,
                                (Volume < 0.0 ? Triangle.v1 : Triangle.v2) + 1);
    }
    return Text;
}

ULangevinAsset* ULangevinBake::BakeStaticMesh(UStaticMesh* Mesh, float Density, float SheetThickness) {
    if (Mesh == nullptr) return Fail(Mesh, TEXT("there is no mesh"));
    const FString Obj = WriteObj(*Mesh);
    if (Obj.IsEmpty()) return Fail(Mesh, TEXT("it has no triangles that can be read"));
    const FString Baker = BakerPath();
    if (!FPaths::FileExists(Baker)) {
        return Fail(Mesh,
                    FString::Printf(TEXT("%s is missing: package the plugin from a prefix with lr_bake"), *Baker));
    }
    const FString Folder = FPaths::ConvertRelativePathToFull(FPaths::ProjectIntermediateDir());
    const FString Source = FPaths::CreateTempFilename(*Folder, TEXT("Langevin"), TEXT(".obj"));
    const FString Baked = Source + TEXT(".lrb");
    FString Options = FString::Printf(TEXT("mesh \"%s\" -o \"%s\" --unit m --density %g --name \"%s\" --quiet"),
                                      *Source, *Baked, Density, *Mesh->GetName());
    if (SheetThickness > 0.0f) Options += FString::Printf(TEXT(" --sheet --thickness %g"), 0.01 * SheetThickness);

    int32 Code = -1;
    FString Out, Errors;
    TArray<uint8> Bytes;
    TArray<FString> Faults;
    if (!FFileHelper::SaveStringToFile(Obj, *Source, FFileHelper::EEncodingOptions::ForceUTF8WithoutBOM)) {
        Errors = FString::Printf(TEXT("%s cannot be written"), *Source);
    } else if (!FPlatformProcess::ExecProcess(*Baker, *Options, &Code, &Out, &Errors)) {
        Errors = FString::Printf(TEXT("%s could not be started"), *Baker);
    } else if (Code == 0 && !FFileHelper::LoadFileToArray(Bytes, *Baked)) {
        Errors = FString::Printf(TEXT("%s cannot be read"), *Baked);
    }
    IFileManager::Get().Delete(*Source);
    IFileManager::Get().Delete(*Baked);
    if (Bytes.Num() == 0) return Fail(Mesh, Errors);

    const FString Name = Mesh->GetName() + TEXT("_Langevin");
    const FString Path = FPackageName::GetLongPackagePath(Mesh->GetOutermost()->GetName());
    ULangevinAsset* Asset = LoadObject<ULangevinAsset>(nullptr, *FString::Printf(TEXT("%s/%s.%s"), *Path, *Name, *Name),
                                                       nullptr, LOAD_NoWarn | LOAD_Quiet);
    if (Asset == nullptr) {
        Asset =
            Cast<ULangevinAsset>(IAssetTools::Get().CreateAsset(Name, Path, ULangevinAsset::StaticClass(), nullptr));
    }
    if (Asset == nullptr) return Fail(Mesh, FString::Printf(TEXT("%s/%s cannot be created"), *Path, *Name));
    if (!Asset->SetBytes(Bytes, Faults)) return Fail(Mesh, Faults[0]);
    Asset->MarkPackageDirty();
    UE_LOG(LogLangevinRigid, Log, TEXT("%s: %.3g g, %.3g cm long"), *Asset->GetPathName(), Asset->Mass, Asset->Length);
    return Asset;
}
