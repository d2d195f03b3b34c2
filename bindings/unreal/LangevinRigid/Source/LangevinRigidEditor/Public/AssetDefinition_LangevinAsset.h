// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#pragma once

#include "AssetDefinitionDefault.h"
#include "CoreMinimal.h"
#include "LangevinAsset.h"

#include "AssetDefinition_LangevinAsset.generated.h"

/** Describes ULangevinAsset to the content browser. */
UCLASS()
class LANGEVINRIGIDEDITOR_API UAssetDefinition_LangevinAsset : public UAssetDefinitionDefault {
    GENERATED_BODY()

public:
    virtual FText GetAssetDisplayName() const override;
    virtual FLinearColor GetAssetColor() const override;
    virtual TSoftClassPtr<UObject> GetAssetClass() const override;
    virtual TConstArrayView<FAssetCategoryPath> GetAssetCategories() const override;
    virtual bool CanImport() const override { return true; }
};
