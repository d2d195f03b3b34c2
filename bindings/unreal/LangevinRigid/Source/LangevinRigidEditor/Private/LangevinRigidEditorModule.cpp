// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#include "ContentBrowserMenuContexts.h"
#include "Engine/StaticMesh.h"
#include "LangevinBake.h"
#include "LangevinSettings.h"
#include "Modules/ModuleManager.h"
#include "ToolMenus.h"

#define LOCTEXT_NAMESPACE "LangevinRigidEditor"

namespace {
void BakeSelected(const FToolMenuContext& Menu) {
    const ULangevinSettings& Settings = *GetDefault<ULangevinSettings>();
    const UContentBrowserAssetContextMenuContext* Context =
        UContentBrowserAssetContextMenuContext::FindContextWithAssets(Menu);
    if (Context == nullptr) return;
    for (UStaticMesh* Mesh : Context->LoadSelectedObjects<UStaticMesh>()) {
        ULangevinBake::BakeStaticMesh(Mesh, Settings.BakeDensity, Settings.BakeSheetThickness);
    }
}

// In the content browser's menu of static meshes.
void AddMenu() {
    FToolMenuOwnerScoped Owner(TEXT("LangevinRigidEditor"));
    UToolMenu* Menu = UE::ContentBrowser::ExtendToolMenu_AssetContextMenu(UStaticMesh::StaticClass());
    FToolMenuSection& Section = Menu->FindOrAddSection(TEXT("GetAssetActions"));
    FToolUIAction Action;
    Action.ExecuteAction = FToolMenuExecuteAction::CreateStatic(&BakeSelected);
    Section.AddMenuEntry(TEXT("LangevinBake"), LOCTEXT("Bake", "Bake for Langevin Rigid"),
                         LOCTEXT("BakeTip",
                                 "Makes the asset by which bodies of this shape fall. Density and thickness are in the "
                                 "project settings: Plugins > Langevin Rigid."),
                         FSlateIcon(), Action);
}
} // namespace

class FLangevinRigidEditorModule : public IModuleInterface {
public:
    virtual void StartupModule() override {
        UToolMenus::RegisterStartupCallback(FSimpleMulticastDelegate::FDelegate::CreateStatic(&AddMenu));
    }
    virtual void ShutdownModule() override {
        if (UObjectInitialized()) UToolMenus::UnregisterOwner(TEXT("LangevinRigidEditor"));
    }
};

IMPLEMENT_MODULE(FLangevinRigidEditorModule, LangevinRigidEditor)

#undef LOCTEXT_NAMESPACE
