// The module, its version check, assets, import. SPDX-License-Identifier: MIT
#include "AssetDefinition_LangevinAsset.h"
#include "LangevinAssetFactory.h"
#include "LangevinBake.h"
#include "ToolMenus.h"
#include "fixture.h"

#define DOCTEST_CONFIG_IMPLEMENT
#include <cstdio>
#include <doctest/doctest.h>
#include <fstream>

// Without UHT's registration a world needs a list of its subsystems.
extern UClass* const ShimWorldSubsystems[];
UClass* const ShimWorldSubsystems[] = {ULangevinWorldSubsystem::StaticClass(), nullptr};

namespace {
constexpr uint32 version(uint32 major, uint32 minor, uint32 patch) {
    return major << 22 | minor << 12 | patch;
}

struct Editor {
    Editor() { GEditor = &engine; }
    UEditorEngine engine;
};

UObject* import(ULangevinAssetFactory* factory, const TArray<uint8>& bytes, FFeedbackContext& warn) {
    const uint8* begin = bytes.GetData();
    UFactory::CurrentFilename = FString(ShimWiden(environment("LANGEVIN_TEST_LEAF")));
    return factory->FactoryCreateBinary(ULangevinAsset::StaticClass(), nullptr, FName(TEXT("leaf")), RF_Public, nullptr,
                                        TEXT("lrb"), begin, begin + bytes.Num(), &warn);
}
} // namespace

int main(int argc, char** argv) {
    // Without the library: the messages for users of an unpackaged plugin.
    ShimStartModule("LangevinRigid");
    bool good = logged(ShimTakeLog(), "plugin folder of LangevinRigid was not found");
    ShimStopModule("LangevinRigid");
    IPluginManager::Get().ShimBaseDir = FString(TEXT("/nowhere"));
    ShimStartModule("LangevinRigid");
    good =
        good && logged(ShimTakeLog(), "is missing: package the plugin") && !FLangevinRigidModule::IsLibraryAvailable();
    ShimStopModule("LangevinRigid");
    const UWorld* empty = UWorld::ShimCreate();
    good = good && empty->GetSubsystem<ULangevinWorldSubsystem>()->GetLibraryWorld() == nullptr;
    const_cast<UWorld*>(empty)->ShimBeginPlay();
    const_cast<UWorld*>(empty)->ShimTick(0.016f);
    const_cast<UWorld*>(empty)->ShimEnd();
    if (!good) return std::fputs("a missing library is not reported, or not survived\n", stderr), 1;

    IPluginManager::Get().ShimBaseDir = FString(ShimWiden(environment("LANGEVIN_TEST_PLUGIN")));
    ShimStartModule("LangevinRigid");
    for (const std::string& line : ShimTakeLog()) std::puts(line.c_str());
    if (!FLangevinRigidModule::IsLibraryAvailable()) return 1;
    ShimStartModule("LangevinRigidNiagara");
    ShimStartModule("LangevinRigidEditor");
    doctest::Context context(argc, argv);
    const int result = context.run();
    ShimStopModule("LangevinRigid");
    return result != 0 || FLangevinRigidModule::IsLibraryAvailable();
}

TEST_CASE("versions: before 1.0 minors differ in their ABI, from then on majors do") {
    CHECK(FLangevinRigidModule::IsCompatible(version(0, 1, 0), version(0, 1, 7)));
    CHECK_FALSE(FLangevinRigidModule::IsCompatible(version(0, 1, 0), version(0, 2, 0)));
    CHECK_FALSE(FLangevinRigidModule::IsCompatible(version(0, 1, 0), version(1, 1, 0)));
    CHECK(FLangevinRigidModule::IsCompatible(version(1, 2, 0), version(1, 5, 3)));
    CHECK_FALSE(FLangevinRigidModule::IsCompatible(version(1, 2, 0), version(2, 2, 0)));
}

TEST_CASE("an asset shows what is in it, in centimetres and grams") {
    ULangevinAsset* asset = make_leaf();
    lr_asset_info info = {};
    info.struct_size = sizeof info;
    REQUIRE(lr_asset_get_info(asset->GetHandle(), &info) == LR_OK);
    CHECK(asset->Mass == doctest::Approx(1000 * info.mass));
    CHECK(asset->Mass == doctest::Approx(0.18).epsilon(0.1)); // assets/README.md: 0.18 g
    CHECK(asset->Length == doctest::Approx(7.0).epsilon(0.02));
    CHECK(asset->Volume == doctest::Approx(1e6 * info.volume));
    CHECK(asset->GetCenterOfMass().Y == doctest::Approx(-100 * info.center_of_mass[1]));
    CHECK(asset->GetCenterOfMass().Z == doctest::Approx(100 * info.center_of_mass[2]));
    CHECK(asset->HullVertices > 3);
    const lr_asset* handle = asset->GetHandle();
    CHECK(asset->GetHandle() == handle);
    ShimDestroy(asset);
}

TEST_CASE("damaged bytes are refused with what to do, and change nothing") {
    ULangevinAsset* asset = make_leaf();
    TArray<uint8> bytes = leaf_bytes();
    bytes[bytes.Num() / 2] ^= 0x55;
    TArray<FString> faults;
    CHECK_FALSE(asset->SetBytes(bytes, faults));
    REQUIRE(faults.Num() > 0);
    CHECK(ShimNarrow(*faults[0]).find(" at ") != std::string::npos);
    CHECK(asset->GetBytes() == leaf_bytes());
    CHECK(asset->GetHandle() != nullptr);
    faults.Reset();
    CHECK_FALSE(NewObject<ULangevinAsset>(nullptr)->SetBytes(TArray<uint8>{1, 2, 3}, faults));
}

TEST_CASE("a loaded asset is ready, as after a cooked package") {
    const ULangevinAsset* saved = make_leaf();
    auto* loaded = NewObject<ULangevinAsset>(nullptr);
    CHECK(loaded->GetHandle() == nullptr); // no bytes
    TArray<FString> faults;
    loaded->SetBytes(saved->GetBytes(), faults);
    loaded->PostLoad();
    CHECK(loaded->Mass == saved->Mass);
}

// A plate of 8 x 4 x 0.2 cm whose faces do not share vertices, as in the engine; wound by the engine's left hand.
UStaticMesh* make_plate(bool flipped) {
    auto* mesh = NewObject<UStaticMesh>(nullptr, FName(TEXT("/Game/Leaves/Plate")));
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = -1; side <= 1; side += 2) {
            const int32 first = mesh->ShimTriangles.Vertices.Num();
            for (int corner = 0; corner < 4; ++corner) {
                float at[3];
                at[axis] = static_cast<float>(side);
                at[(axis + 1) % 3] = corner & 1 ? 1.0f : -1.0f;
                at[(axis + 2) % 3] = corner & 2 ? 1.0f : -1.0f;
                mesh->ShimTriangles.Vertices.Add(FVector3f(4.0f * at[0], 2.0f * at[1], 0.1f * at[2]));
            }
            const bool turn = (side > 0) == flipped;
            mesh->ShimTriangles.Indices.Add({first, first + (turn ? 1 : 2), first + (turn ? 2 : 1)});
            mesh->ShimTriangles.Indices.Add({first + 3, first + (turn ? 2 : 1), first + (turn ? 1 : 2)});
        }
    }
    return mesh;
}

TEST_CASE("a mesh is baked in the editor") {
    const Editor editor;
    for (const bool flipped : {false, true}) {
        UStaticMesh* plate = make_plate(flipped);
        ULangevinAsset* asset = ULangevinBake::BakeStaticMesh(plate, 500.0f, 0.0f);
        REQUIRE(asset != nullptr);
        CHECK(asset->GetPathName() == FString(TEXT("/Game/Leaves/Plate_Langevin")));
        CHECK(asset->Mass == doctest::Approx(8 * 4 * 0.2 * 0.5).epsilon(1e-4)); // g
        CHECK(asset->Length == doctest::Approx(8.0).epsilon(1e-4));
        CHECK(asset->DirtyCount > 0);
        CHECK(ULangevinBake::BakeStaticMesh(plate, 1000.0f, 0.0f) == asset); // in place
        CHECK(asset->Mass == doctest::Approx(8 * 4 * 0.2).epsilon(1e-4));
        plate->MarkAsGarbage();
    }
    // A sheet, through the menu.
    auto* sheet = NewObject<UStaticMesh>(nullptr, FName(TEXT("/Game/Leaves/Sheet")));
    for (const FVector3f& at : {FVector3f(-4, -2, 0), FVector3f(4, -2, 0), FVector3f(4, 2, 0), FVector3f(-4, 2, 0)})
        sheet->ShimTriangles.Vertices.Add(at);
    sheet->ShimTriangles.Indices.Add({0, 1, 2});
    sheet->ShimTriangles.Indices.Add({0, 2, 3});
    auto& settings = *GetMutableDefault<ULangevinSettings>();
    settings.BakeDensity = 800.0f;
    settings.BakeSheetThickness = 0.01f;
    const FToolMenuSection& section = UE::ContentBrowser::ExtendToolMenu_AssetContextMenu(nullptr)->ShimSection;
    CHECK(section.ShimLabel.ToString() == FString(TEXT("Bake for Langevin Rigid")));
    FToolMenuContext menu;
    menu.ShimSelected.Add(sheet);
    section.ShimAction.ExecuteAction.Execute(menu);
    auto* baked = LoadObject<ULangevinAsset>(nullptr, TEXT("/Game/Leaves/Sheet_Langevin.Sheet_Langevin"));
    REQUIRE(baked != nullptr);
    CHECK(baked->Mass == doctest::Approx(8 * 4 * 0.01 * 0.8).epsilon(1e-3));
    settings = ULangevinSettings();

    ShimTakeLog();
    CHECK(ULangevinBake::BakeStaticMesh(nullptr) == nullptr);
    CHECK(logged(ShimTakeLog(), "there is no mesh"));
    CHECK(ULangevinBake::BakeStaticMesh(NewObject<UStaticMesh>(nullptr)) == nullptr);
    CHECK(logged(ShimTakeLog(), "no triangles"));
    CHECK(ULangevinBake::BakeStaticMesh(sheet, -1.0f) == nullptr); // the baker's own words
    CHECK(logged(ShimTakeLog(), "was not baked: "));
    const FString plugin = IPluginManager::Get().ShimBaseDir;
    IPluginManager::Get().ShimBaseDir = FString(TEXT("/nowhere"));
    CHECK(ULangevinBake::BakeStaticMesh(sheet) == nullptr);
    CHECK(logged(ShimTakeLog(), "lr_bake is missing: package the plugin"));
    IPluginManager::Get().ShimBaseDir = plugin;
}

TEST_CASE("the factory imports, refuses, and reimports") {
    Editor editor;
    auto* factory = NewObject<ULangevinAssetFactory>(nullptr);
    auto* imports = GEditor->GetEditorSubsystem<UImportSubsystem>();
    CHECK(factory->FactoryCanImport(FString(TEXT("C:/meshes/Leaf.LRB"))));
    CHECK_FALSE(factory->FactoryCanImport(FString(TEXT("leaf.obj"))));
    CHECK(factory->SupportedClass.Get() == ULangevinAsset::StaticClass());
    REQUIRE(factory->Formats.Num() == 1);
    CHECK(factory->Formats[0] == FString(TEXT("lrb;Langevin Rigid asset")));

    FFeedbackContext warn;
    const int32 pre = imports->ShimPre, post = imports->ShimPost;
    auto* asset = Cast<ULangevinAsset>(import(factory, leaf_bytes(), warn));
    REQUIRE(asset != nullptr);
    CHECK(asset->Mass > 0.0f);
    CHECK(imports->ShimPre == pre + 1);
    CHECK(imports->ShimPost == post + 1);
    CHECK(imports->ShimCreated == asset);

    ShimTakeLog();
    CHECK(import(factory, TArray<uint8>{'n', 'o'}, warn) == nullptr);
    CHECK(imports->ShimCreated == nullptr);
    CHECK(logged(ShimTakeLog(), "FeedbackContext: Error"));

    TArray<FString> files;
    REQUIRE(factory->CanReimport(asset, files));
    REQUIRE(files.Num() == 1);
    CHECK(ShimNarrow(*files[0]) == environment("LANGEVIN_TEST_LEAF"));
    const int32 dirty = asset->DirtyCount;
    CHECK(factory->Reimport(asset) == EReimportResult::Succeeded);
    CHECK(asset->DirtyCount == dirty + 1);
    factory->SetReimportPaths(asset, TArray<FString>{FString(TEXT("/nowhere/leaf.lrb"))});
    CHECK(factory->Reimport(asset) == EReimportResult::Failed);
    CHECK(logged(ShimTakeLog(), "cannot read /nowhere/leaf.lrb"));
    CHECK_FALSE(factory->CanReimport(factory, files));
}

TEST_CASE("the content browser knows it") {
    auto* definition = NewObject<UAssetDefinition_LangevinAsset>(nullptr);
    CHECK(definition->GetAssetClass().Get() == ULangevinAsset::StaticClass());
    REQUIRE(definition->GetAssetCategories().Num() == 1);
    CHECK(definition->GetAssetCategories()[0].GetCategoryText().ToString() == FString(TEXT("Physics")));
    CHECK_FALSE(definition->GetAssetDisplayName().ToString().IsEmpty());
    CHECK(definition->CanImport());
}
