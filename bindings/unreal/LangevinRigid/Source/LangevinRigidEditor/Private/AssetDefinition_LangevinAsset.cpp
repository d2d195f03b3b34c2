// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#include "AssetDefinition_LangevinAsset.h"

#define LOCTEXT_NAMESPACE "AssetDefinition_LangevinAsset"

FText UAssetDefinition_LangevinAsset::GetAssetDisplayName() const {
    return LOCTEXT("DisplayName", "Langevin Rigid Asset");
}

FLinearColor UAssetDefinition_LangevinAsset::GetAssetColor() const {
    return FLinearColor(0.62f, 0.36f, 0.07f);
}

TSoftClassPtr<UObject> UAssetDefinition_LangevinAsset::GetAssetClass() const {
    return ULangevinAsset::StaticClass();
}

TConstArrayView<FAssetCategoryPath> UAssetDefinition_LangevinAsset::GetAssetCategories() const {
    static const FAssetCategoryPath Categories[] = {EAssetCategoryPaths::Physics};
    return Categories;
}

#undef LOCTEXT_NAMESPACE
