// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#include "LangevinAssetFactory.h"

#include "Editor.h"
#include "EditorFramework/AssetImportData.h"
#include "LangevinAsset.h"
#include "LangevinRigidModule.h"
#include "Misc/FeedbackContext.h"
#include "Misc/FileHelper.h"
#include "Misc/Paths.h"
#include "Subsystems/ImportSubsystem.h"

ULangevinAssetFactory::ULangevinAssetFactory(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    SupportedClass = ULangevinAsset::StaticClass();
    Formats.Add(TEXT("lrb;Langevin Rigid asset"));
    bCreateNew = false;
    bEditorImport = true;
    bText = false;
}

bool ULangevinAssetFactory::FactoryCanImport(const FString& Filename) {
    return FPaths::GetExtension(Filename).Equals(TEXT("lrb"), ESearchCase::IgnoreCase);
}

UObject* ULangevinAssetFactory::FactoryCreateBinary(UClass* InClass, UObject* InParent, FName InName,
                                                    EObjectFlags Flags, UObject*, const TCHAR* Type,
                                                    const uint8*& Buffer, const uint8* BufferEnd,
                                                    FFeedbackContext* Warn) {
    UImportSubsystem* Imports = GEditor->GetEditorSubsystem<UImportSubsystem>();
    Imports->BroadcastAssetPreImport(this, InClass, InParent, InName, Type);
    ULangevinAsset* Asset = NewObject<ULangevinAsset>(InParent, InClass, InName, Flags);
    TArray<uint8> Bytes;
    Bytes.Append(Buffer, static_cast<int32>(BufferEnd - Buffer));
    TArray<FString> Faults;
    if (!Asset->SetBytes(Bytes, Faults)) {
        for (const FString& Fault : Faults) {
            Warn->Logf(ELogVerbosity::Error, TEXT("%s: %s"), *GetCurrentFilename(), *Fault);
        }
        Asset->MarkAsGarbage();
        Asset = nullptr;
    } else {
        Asset->AssetImportData->Update(GetCurrentFilename());
    }
    Imports->BroadcastAssetPostImport(this, Asset);
    return Asset;
}

bool ULangevinAssetFactory::CanReimport(UObject* Obj, TArray<FString>& OutFilenames) {
    const ULangevinAsset* Asset = Cast<ULangevinAsset>(Obj);
    if (Asset == nullptr || Asset->AssetImportData == nullptr) return false;
    Asset->AssetImportData->ExtractFilenames(OutFilenames);
    return true;
}

void ULangevinAssetFactory::SetReimportPaths(UObject* Obj, const TArray<FString>& NewReimportPaths) {
    ULangevinAsset* Asset = Cast<ULangevinAsset>(Obj);
    if (Asset != nullptr && NewReimportPaths.Num() == 1)
        Asset->AssetImportData->UpdateFilenameOnly(NewReimportPaths[0]);
}

EReimportResult::Type ULangevinAssetFactory::Reimport(UObject* Obj) {
    ULangevinAsset* Asset = Cast<ULangevinAsset>(Obj);
    if (Asset == nullptr) return EReimportResult::Failed;
    const FString Filename = Asset->AssetImportData->GetFirstFilename();
    TArray<uint8> Bytes;
    if (Filename.IsEmpty() || !FFileHelper::LoadFileToArray(Bytes, *Filename)) {
        UE_LOG(LogLangevinRigid, Error, TEXT("%s: cannot read %s"), *Asset->GetPathName(), *Filename);
        return EReimportResult::Failed;
    }
    TArray<FString> Faults;
    if (!Asset->SetBytes(Bytes, Faults)) {
        for (const FString& Fault : Faults) UE_LOG(LogLangevinRigid, Error, TEXT("%s: %s"), *Filename, *Fault);
        return EReimportResult::Failed;
    }
    Asset->AssetImportData->Update(Filename);
    Asset->MarkPackageDirty();
    return EReimportResult::Succeeded;
}
