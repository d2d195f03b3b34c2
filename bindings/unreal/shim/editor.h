// Stand-ins for the parts of UnrealEd and AssetDefinition that the plugin uses. SPDX-License-Identifier: MIT
#pragma once

#include "engine.h"

class UFactory : public UObject {
    SHIM_OBJECT(UFactory, UObject)
public:
    explicit UFactory(const FObjectInitializer&) {}
    UFactory() = default;
    virtual bool FactoryCanImport(const FString&) { return false; }
    virtual UObject* FactoryCreateBinary(UClass*, UObject*, FName, EObjectFlags, UObject*, const TCHAR*, const uint8*&,
                                         const uint8*, FFeedbackContext*) {
        return nullptr;
    }
    static FString GetCurrentFilename() { return CurrentFilename; }
    static FString CurrentFilename;
    int32 ImportPriority = 100;

    TSubclassOf<UObject> SupportedClass;
    TArray<FString> Formats;
    uint32 bCreateNew : 1 = 0;
    uint32 bEditorImport : 1 = 0;
    uint32 bText : 1 = 0;
};

namespace EReimportResult {
enum Type { Failed, Succeeded, Cancelled };
}
class FReimportHandler {
public:
    virtual ~FReimportHandler() = default;
    virtual bool CanReimport(UObject* Obj, TArray<FString>& OutFilenames) = 0;
    virtual void SetReimportPaths(UObject* Obj, const TArray<FString>& NewReimportPaths) = 0;
    virtual EReimportResult::Type Reimport(UObject* Obj) = 0;
    virtual int32 GetPriority() const { return 100; }
};

class UImportSubsystem : public UObject {
    SHIM_OBJECT(UImportSubsystem, UObject)
public:
    void BroadcastAssetPreImport(UFactory*, UClass*, UObject*, const FName&, const TCHAR*) { ++ShimPre; }
    void BroadcastAssetPostImport(UFactory*, UObject* InCreatedObject) {
        ++ShimPost;
        ShimCreated = InCreatedObject;
    }
    int32 ShimPre = 0, ShimPost = 0;
    UObject* ShimCreated = nullptr;
};

class UEditorEngine {
public:
    template <typename T> T* GetEditorSubsystem() { return GetMutableDefault<T>(); }
};
extern UEditorEngine* GEditor;

class FAssetCategoryPath {
public:
    FAssetCategoryPath(const FText& InCategory) : Category(InCategory) {}
    FText GetCategoryText() const { return Category; }

private:
    FText Category;
};
struct EAssetCategoryPaths {
    static FAssetCategoryPath Physics;
};

class UAssetDefinition : public UObject {
    SHIM_OBJECT(UAssetDefinition, UObject)
public:
    virtual FText GetAssetDisplayName() const { return FText(); }
    virtual FLinearColor GetAssetColor() const { return FLinearColor(1, 1, 1); }
    virtual TSoftClassPtr<UObject> GetAssetClass() const { return nullptr; }
    virtual TConstArrayView<FAssetCategoryPath> GetAssetCategories() const { return {nullptr, 0}; }
    virtual bool CanImport() const { return false; }
};
class UAssetDefinitionDefault : public UAssetDefinition {
    SHIM_OBJECT(UAssetDefinitionDefault, UAssetDefinition)
};
