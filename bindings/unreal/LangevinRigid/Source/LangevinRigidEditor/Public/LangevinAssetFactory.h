// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "EditorReimportHandler.h"
#include "Factories/Factory.h"

#include "LangevinAssetFactory.generated.h"

/** Imports .lrb files by drag and drop or Import, and reimports them on request or when the file changes. */
UCLASS()
class LANGEVINRIGIDEDITOR_API ULangevinAssetFactory : public UFactory, public FReimportHandler {
    GENERATED_BODY()

public:
    ULangevinAssetFactory(const FObjectInitializer& ObjectInitializer);

    virtual bool FactoryCanImport(const FString& Filename) override;
    virtual UObject* FactoryCreateBinary(UClass* InClass, UObject* InParent, FName InName, EObjectFlags Flags,
                                         UObject* Context, const TCHAR* Type, const uint8*& Buffer,
                                         const uint8* BufferEnd, FFeedbackContext* Warn) override;

    virtual bool CanReimport(UObject* Obj, TArray<FString>& OutFilenames) override;
    virtual void SetReimportPaths(UObject* Obj, const TArray<FString>& NewReimportPaths) override;
    virtual EReimportResult::Type Reimport(UObject* Obj) override;
    virtual int32 GetPriority() const override { return ImportPriority; }
};
