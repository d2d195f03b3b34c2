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

class IAssetTools {
public:
    static IAssetTools& Get();
    UObject* CreateAsset(const FString& AssetName, const FString& PackagePath, UClass* AssetClass, UFactory* Factory,
                         FName CallingContext = NAME_None);
};

class FSlateIcon {};
struct FToolMenuContext {
    TArray<UObject*> ShimSelected;
};
using FToolMenuExecuteAction = TDelegate<void(const FToolMenuContext&)>;
struct FToolUIAction {
    FToolMenuExecuteAction ExecuteAction;
};
struct FToolMenuSection {
    void AddMenuEntry(FName Name, const FText& Label, const FText&, const FSlateIcon&, const FToolUIAction& Action) {
        ShimName = Name, ShimLabel = Label, ShimAction = Action;
    }
    FName ShimName;
    FText ShimLabel;
    FToolUIAction ShimAction;
};
class UToolMenu {
public:
    FToolMenuSection& FindOrAddSection(FName) { return ShimSection; }
    FToolMenuSection ShimSection;
};
class UToolMenus {
public:
    static void RegisterStartupCallback(const TDelegate<void()>& Callback) { Callback.Execute(); }
    static void UnregisterOwner(FName) {}
};
struct FToolMenuOwnerScoped {
    explicit FToolMenuOwnerScoped(FName) {}
    ~FToolMenuOwnerScoped() {}
};
namespace UE::ContentBrowser {
UToolMenu* ExtendToolMenu_AssetContextMenu(UClass* Class);
}
class UContentBrowserAssetContextMenuContext {
public:
    static const UContentBrowserAssetContextMenuContext* FindContextWithAssets(const FToolMenuContext& Menu) {
        static UContentBrowserAssetContextMenuContext Context;
        Context.Selected = Menu.ShimSelected;
        return Context.Selected.Num() > 0 ? &Context : nullptr;
    }
    template <class T> TArray<T*> LoadSelectedObjects() const {
        TArray<T*> Found;
        for (UObject* Object : Selected) {
            if (T* One = Cast<T>(Object)) Found.Add(One);
        }
        return Found;
    }

private:
    TArray<UObject*> Selected;
};
