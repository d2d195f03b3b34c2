// A game world of the shim with the plugin in it. SPDX-License-Identifier: MIT
#pragma once

#include "Components/StaticMeshComponent.h"
#include "LangevinAsset.h"
#include "LangevinBatchComponent.h"
#include "LangevinConversion.h"
#include "LangevinRigidModule.h"
#include "LangevinSettings.h"
#include "LangevinWorldSubsystem.h"
#include "shim.h"

#include <cstdlib>
#include <doctest/doctest.h>
#include <langevin_rigid.h>
#include <string>

inline std::string environment(const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr ? value : "";
}

inline bool logged(const std::vector<std::string>& lines, const std::string& part) {
    for (const std::string& line : lines) {
        if (line.find(part) != std::string::npos) return true;
    }
    return false;
}

inline TArray<uint8> leaf_bytes() {
    TArray<uint8> bytes;
    REQUIRE(FFileHelper::LoadFileToArray(bytes, *FString(ShimWiden(environment("LANGEVIN_TEST_LEAF")))));
    return bytes;
}

inline ULangevinAsset* make_leaf() {
    auto* asset = NewObject<ULangevinAsset>(nullptr);
    TArray<FString> faults;
    REQUIRE(asset->SetBytes(leaf_bytes(), faults));
    return asset;
}

inline UStaticMesh* make_mesh() {
    auto* mesh = NewObject<UStaticMesh>(nullptr);
    mesh->ShimBounds = FBoxSphereBounds(FBox(FVector(-3.5, -2, -0.5), FVector(3.5, 2, 0.5)));
    return mesh;
}

/** Settings are those of a new project at the start of each test. */
struct Game {
    Game() {
        settings() = ULangevinSettings();
        ShimTakeLog();
    }
    ~Game() {
        if (world != nullptr) world->ShimEnd();
        settings() = ULangevinSettings();
    }
    static ULangevinSettings& settings() { return *GetMutableDefault<ULangevinSettings>(); }

    /** Change settings before this. */
    void create() {
        world = UWorld::ShimCreate();
        langevin = world->GetSubsystem<ULangevinWorldSubsystem>();
        REQUIRE(langevin != nullptr);
        REQUIRE(langevin->GetLibraryWorld() != nullptr);
    }
    ULangevinBatchComponent* add_batch(int32 capacity, int32 count, const FTransform& place = FTransform()) {
        AActor* actor = world->SpawnActor<AActor>();
        auto* batch = NewObject<ULangevinBatchComponent>(actor);
        batch->Asset = make_leaf();
        batch->SetStaticMesh(make_mesh());
        batch->Capacity = capacity;
        batch->InitialCount = count;
        batch->SetWorldTransform(place);
        batch->RegisterComponent();
        return batch;
    }
    /** A static component with simple collision. */
    UStaticMeshComponent* add_block(const FKAggregateGeom& geometry, const FTransform& place, ULevel* level = nullptr) {
        AActor* actor = world->ShimSpawn(AActor::StaticClass(), level != nullptr ? level : world->GetLevels()[0]);
        auto* block = NewObject<UStaticMeshComponent>(actor);
        UStaticMesh* mesh = make_mesh();
        mesh->ShimBodySetup = NewObject<UBodySetup>(mesh);
        mesh->ShimBodySetup->AggGeom = geometry;
        block->SetStaticMesh(mesh);
        block->SetWorldTransform(place);
        block->RegisterComponent();
        return block;
    }
    void run(int frames, float dt = 1.0f / 60.0f) {
        for (int i = 0; i < frames; ++i) world->ShimTick(dt);
    }
    /** The height below a point where the library's own ray hits, in cm, or -1e9. */
    double ground_below(const FVector& from) const {
        lr_ray ray;
        REQUIRE(lr_ray_init(&ray, sizeof ray) == LR_OK);
        ray.flags = LR_RAY_COLLIDERS;
        const FVector origin = langevin->GetOrigin();
        ray.origin[0] = static_cast<float>((from.X - origin.X) / 100);
        ray.origin[1] = static_cast<float>(-(from.Y - origin.Y) / 100);
        ray.origin[2] = static_cast<float>((from.Z - origin.Z) / 100);
        ray.direction[0] = ray.direction[1] = 0;
        ray.direction[2] = -1;
        lr_ray_hit hit;
        REQUIRE(lr_world_ray_cast(langevin->GetLibraryWorld(), &ray, 1, &hit) == LR_OK);
        return hit.collider.id == 0 ? -1e9 : origin.Z + 100.0 * static_cast<double>(hit.position[2]);
    }

    UWorld* world = nullptr;
    ULangevinWorldSubsystem* langevin = nullptr;
};

inline FKAggregateGeom box_of(float x, float y, float z, const FVector& center = FVector(),
                              const FRotator& rotation = FRotator()) {
    FKAggregateGeom geometry;
    FKBoxElem box;
    box.Center = center;
    box.Rotation = rotation;
    box.X = x, box.Y = y, box.Z = z;
    geometry.BoxElems.Add(box);
    return geometry;
}
