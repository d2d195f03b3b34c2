// The level's collision in the library, checked by its own rays. SPDX-License-Identifier: MIT
#include "Components/InstancedStaticMeshComponent.h"
#include "LandscapeHeightfieldCollisionComponent.h"
#include "LandscapeProxy.h"
#include "LangevinShapes.h"
#include "PhysicalMaterials/PhysicalMaterial.h"
#include "fixture.h"

namespace {
/** Compares heights of a surface with the expected ones. */
template <typename F>
void check_surface(const Game& game, const FVector& middle, double reach, F height, double tolerance = 0.05) {
    for (int i = -3; i <= 3; ++i) {
        for (int k = -3; k <= 3; ++k) {
            const FVector at = middle + FVector(reach * (i + 0.1) / 3.3, reach * (k + 0.05) / 3.3, 5000);
            INFO(at.X, " ", at.Y);
            CHECK(std::abs(game.ground_below(at) - height(at.X, at.Y)) < tolerance);
        }
    }
}
} // namespace

TEST_CASE("boxes: place, turn, scale and the turn of the shape itself") {
    Game game;
    Game::settings().Origin = FVector(1000, 2000, 300);
    game.create();
    // Half extents 100, 50, 25 cm after scaling, at (3000, -4000, 500), rotated by 30 degrees about Z.
    game.add_block(box_of(100, 100, 100),
                   FTransform(FRotator(0, 30, 0), FVector(3000, -4000, 500), FVector(2, 1, 0.5)));
    game.world->ShimBeginPlay();
    REQUIRE(game.langevin->GetColliderCount() == 1);
    const FQuat yaw = FRotator(0, 30, 0).Quaternion();
    const FVector middle(3000, -4000, 500);
    // Inside and outside of its long side and its short one.
    CHECK(game.ground_below(middle + yaw.RotateVector(FVector(95, 0, 500))) == doctest::Approx(525));
    CHECK(game.ground_below(middle + yaw.RotateVector(FVector(105, 0, 500))) < -1e8);
    CHECK(game.ground_below(middle + yaw.RotateVector(FVector(0, 45, 500))) == doctest::Approx(525));
    CHECK(game.ground_below(middle + yaw.RotateVector(FVector(0, 55, 500))) < -1e8);
}

TEST_CASE("a ramp rises to the side that it does in the engine") {
    Game game;
    game.create();
    // Pitch 20 degrees: +X goes up.
    game.add_block(box_of(400, 400, 10), FTransform(FRotator(20, 0, 0), FVector(0, 0, 0)));
    game.world->ShimBeginPlay();
    const double slope = std::tan(20 * UE_DOUBLE_PI / 180), top = 5 / std::cos(20 * UE_DOUBLE_PI / 180);
    check_surface(game, FVector(), 150, [&](double x, double) { return top + slope * x; });
}

TEST_CASE("a ramp by roll, and one by the rotation of its shape: +Y goes down") {
    for (const bool by_shape : {false, true}) {
        Game game;
        game.create();
        const FRotator roll(0, 0, 20);
        game.add_block(box_of(400, 400, 10, FVector(), by_shape ? roll : FRotator()),
                       FTransform(by_shape ? FRotator() : roll, FVector()));
        game.world->ShimBeginPlay();
        const double slope = std::tan(20 * UE_DOUBLE_PI / 180), top = 5 / std::cos(20 * UE_DOUBLE_PI / 180);
        check_surface(game, FVector(), 150, [&](double, double y) { return top - slope * y; });
    }
}

TEST_CASE("spheres and capsules, standing along Z") {
    Game game;
    game.create();
    FKAggregateGeom geometry;
    FKSphereElem sphere;
    sphere.Center = FVector(0, 300, 0);
    sphere.Radius = 60;
    geometry.SphereElems.Add(sphere);
    FKSphylElem capsule;
    capsule.Radius = 40;
    capsule.Length = 120; // between the centres of the ends
    geometry.SphylElems.Add(capsule);
    FKSphylElem ball; // a capsule of length 0
    ball.Center = FVector(0, -300, 0);
    ball.Radius = 30;
    geometry.SphylElems.Add(ball);
    game.add_block(geometry, FTransform(FVector(100, 200, 0)));
    game.world->ShimBeginPlay();
    REQUIRE(game.langevin->GetColliderCount() == 3);
    CHECK(game.ground_below(FVector(100, 500, 500)) == doctest::Approx(60));
    CHECK(game.ground_below(FVector(136, 500, 500)) == doctest::Approx(48));
    CHECK(game.ground_below(FVector(100, 200, 500)) == doctest::Approx(100));
    CHECK(game.ground_below(FVector(132, 200, 500)) == doctest::Approx(60 + 24));
    CHECK(game.ground_below(FVector(100, -100, 500)) == doctest::Approx(30));
}

TEST_CASE("a capsule lies along what its rotation says") {
    Game game;
    game.create();
    FKAggregateGeom geometry;
    FKSphylElem capsule;
    capsule.Rotation = FRotator(0, 0, 90); // lies along Y
    capsule.Radius = 40;
    capsule.Length = 200;
    geometry.SphylElems.Add(capsule);
    game.add_block(geometry, FTransform(FRotator(0, 45, 0), FVector()));
    game.world->ShimBeginPlay();
    const double d = 90 / std::sqrt(2.0);
    CHECK(game.ground_below(FVector(-d, d, 500)) == doctest::Approx(40)); // Y, turned by 45 degrees from X towards Y
    CHECK(game.ground_below(FVector(d, d, 500)) < -1e8);
}

TEST_CASE("convex hulls and triangles that tell left from right") {
    for (const bool triangles : {false, true}) {
        Game game;
        game.create();
        // A wedge that is high at +Y: if it were mirrored it would be high at -Y.
        const FVector corners[] = {{-100, -100, 0}, {100, -100, 0},  {-100, 100, 0},
                                   {100, 100, 0},   {-100, 100, 80}, {100, 100, 80}};
        FKAggregateGeom geometry;
        if (!triangles) {
            FKConvexElem hull;
            for (const FVector& c : corners) hull.VertexData.Add(c);
            geometry.ConvexElems.Add(hull);
        }
        UStaticMeshComponent* block =
            game.add_block(geometry, FTransform(FRotator(0, 0, 0), FVector(50, 60, 0), FVector(1, 2, 1)));
        if (triangles) {
            FTriMeshCollisionData& data = block->GetStaticMesh()->ShimTriangles;
            for (const FVector& c : corners) data.Vertices.Add(FVector3f(c));
            for (const auto& t : {FTriIndices{0, 1, 5}, FTriIndices{0, 5, 4}}) data.Indices.Add(t);
        }
        game.world->ShimBeginPlay();
        REQUIRE(game.langevin->GetColliderCount() == 1);
        check_surface(game, FVector(50, 60, 0), 90, [](double, double y) { return 80 * (y - 60 + 200) / 400; });
    }
}

TEST_CASE("triangles that cannot be read are told of; complex collision can be left out") {
    for (const bool complex : {true, false}) {
        Game game;
        Game::settings().bUseComplexCollision = complex;
        game.create();
        UStaticMeshComponent* block = game.add_block(FKAggregateGeom(), FTransform());
        block->GetStaticMesh()->bAllowCPUAccess = false;
        game.world->ShimBeginPlay();
        CHECK(game.langevin->GetColliderCount() == 0);
        CHECK(logged(ShimTakeLog(), "Allow CPU Access") == complex);
    }
}

TEST_CASE("hulls with too many corners keep those farthest out") {
    TArray<FVector> points;
    for (int i = 0; i < 2000; ++i) {
        const double a = 0.37 * i, z = -1.0 + 2.0 * i / 1999;
        const double r = std::sqrt(std::max(0.0, 1 - z * z));
        points.Add(FVector(r * std::cos(a), r * std::sin(a), z) * 100.0);
    }
    for (int i = 0; i < 2000; ++i) points.Add(points[i] * 0.5);
    const TArray<FVector> kept = LangevinShapes::Outermost(points, 256);
    CHECK(kept.Num() <= 256);
    CHECK(kept.Num() > 128);
    for (const FVector& p : kept) CHECK(p.Size() == doctest::Approx(100));
}

TEST_CASE("instances of an instanced mesh are colliders each") {
    Game game;
    game.create();
    AActor* actor = game.world->SpawnActor<AActor>();
    auto* instanced = NewObject<UInstancedStaticMeshComponent>(actor);
    UStaticMesh* mesh = make_mesh();
    mesh->ShimBodySetup = NewObject<UBodySetup>(mesh);
    mesh->ShimBodySetup->AggGeom = box_of(100, 100, 100, FVector(0, 0, 20));
    instanced->SetStaticMesh(mesh);
    instanced->SetWorldTransform(FTransform(FRotator(0, 90, 0), FVector(1000, 0, 0)));
    instanced->AddInstances(
        {FTransform(FVector(0, 0, 0)), FTransform(FQuat::Identity, FVector(500, 0, 0), FVector(1, 1, 3))}, false);
    instanced->RegisterComponent();
    game.world->ShimBeginPlay();
    CHECK(game.langevin->GetColliderCount() == 2);
    CHECK(game.ground_below(FVector(1000, 0, 900)) == doctest::Approx(70));
    CHECK(game.ground_below(FVector(1000, 500, 900)) == doctest::Approx(210)); // X of the component is Y of the world
}

TEST_CASE("landscapes: slopes to the right side, and holes") {
    Game game;
    game.create();
    auto* proxy = game.world->SpawnActor<ALandscapeProxy>();
    const auto surface = [](double x, double y) { return 200 + 0.1 * (x - 5000) + 0.03 * (y - 7000); };
    proxy->ShimHeight = [&](FVector at) -> TOptional<float> {
        if (at.X < 5000 || at.Y < 7000 || at.X > 5000 + 31 * 100 || at.Y > 7000 + 31 * 200) return {};
        if (at.X > 7000 && at.Y > 11000) return {};
        return static_cast<float>(surface(at.X, at.Y));
    };
    auto* component = NewObject<ULandscapeHeightfieldCollisionComponent>(proxy);
    component->CollisionSizeQuads = 31;
    component->SetWorldTransform(FTransform(FQuat::Identity, FVector(5000, 7000, 100), FVector(100, 200, 50)));
    component->RegisterComponent();
    game.world->ShimBeginPlay();
    REQUIRE(game.langevin->GetColliderCount() == 1);
    check_surface(game, FVector(6000, 9000, 0), 900, surface, 0.2);
    CHECK(game.ground_below(FVector(7800, 12500, 9000)) < -700); // the shaft under a hole
    CHECK(game.ground_below(FVector(4900, 9000, 9000)) < -1e8);
}

TEST_CASE("tilted landscapes are left out, with a word") {
    Game game;
    game.create();
    auto* proxy = game.world->SpawnActor<ALandscapeProxy>();
    proxy->ShimHeight = [](FVector) -> TOptional<float> { return 0.0f; };
    auto* component = NewObject<ULandscapeHeightfieldCollisionComponent>(proxy);
    component->CollisionSizeQuads = 7;
    component->SetWorldTransform(FTransform(FRotator(10, 0, 0), FVector()));
    component->RegisterComponent();
    game.world->ShimBeginPlay();
    CHECK(game.langevin->GetColliderCount() == 0);
    CHECK(logged(ShimTakeLog(), "is tilted"));
}

TEST_CASE("collision that does not block is skipped: movable, tagged, overlap, none") {
    Game game;
    game.create();
    const FKAggregateGeom cube = box_of(100, 100, 100);
    game.add_block(cube, FTransform())->SetMobility(EComponentMobility::Movable);
    game.add_block(cube, FTransform())->ComponentTags.Add(FName(TEXT("LangevinIgnore")));
    game.add_block(cube, FTransform())->GetOwner()->Tags.Add(FName(TEXT("LangevinIgnore")));
    game.add_block(cube, FTransform())->ShimResponse = ECR_Overlap;
    game.add_block(cube, FTransform())->SetCollisionEnabled(ECollisionEnabled::NoCollision);
    game.add_block(cube, FTransform())->ShimChannel = ECC_Pawn;
    game.add_block(cube, FTransform(FVector(0, 0, 1000)))->SetMobility(EComponentMobility::Stationary);
    game.world->ShimBeginPlay();
    CHECK(game.langevin->GetColliderCount() == 1);
}

TEST_CASE("levels stream in and out") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    ULevel* level = game.world->ShimAddLevel(false);
    game.add_block(box_of(100, 100, 100), FTransform(FVector(0, 0, 0)), level);
    game.world->ShimShowLevel(level);
    CHECK(game.langevin->GetColliderCount() == 1);
    game.world->ShimShowLevel(level); // showing it twice has no effect
    CHECK(game.langevin->GetColliderCount() == 1);
    game.world->ShimHideLevel(level);
    CHECK(game.langevin->GetColliderCount() == 0);
    CHECK(game.ground_below(FVector(0, 0, 500)) < -1e8);
}

TEST_CASE("a component that moves takes its colliders along, and one that is gone takes them away") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    UStaticMeshComponent* lift = game.add_block(box_of(200, 200, 20), FTransform(FVector(0, 0, 0)));
    CHECK(game.langevin->AddCollider(lift, true) == 1);
    CHECK(game.langevin->AddCollider(lift, true) == 1); // again, but not twice
    CHECK(game.langevin->GetColliderCount() == 1);
    ULangevinBatchComponent* batch = game.add_batch(5, 5, FTransform(FVector(0, 0, 60)));
    batch->EmitterExtent = FVector(20, 20, 20);
    for (int frame = 0; frame < 60; ++frame) {
        lift->SetWorldTransform(FTransform(FVector(0, 0, frame)));
        game.run(1);
    }
    game.run(1);
    CHECK(game.ground_below(FVector(0, 0, 500)) == doctest::Approx(69));
    ShimDestroy(lift);
    game.run(1);
    CHECK(game.langevin->GetColliderCount() == 0);
    CHECK_FALSE(game.langevin->RemoveCollider(lift));
}

TEST_CASE("friction comes from the physical material") {
    Game game;
    game.create();
    UStaticMeshComponent* block = game.add_block(box_of(100, 100, 100), FTransform());
    auto* ice = NewObject<UPhysicalMaterial>(nullptr);
    ice->Friction = 0.05f;
    ice->Restitution = 0.6f;
    block->BodyInstance.ShimMaterial = ice;
    game.world->ShimBeginPlay();
    lr_ray ray;
    lr_ray_init(&ray, sizeof ray);
    ray.origin[2] = 5;
    ray.direction[1] = 0, ray.direction[2] = -1;
    lr_ray_hit hit;
    REQUIRE(lr_world_ray_cast(game.langevin->GetLibraryWorld(), &ray, 1, &hit) == LR_OK);
    lr_collider_state state = {};
    state.struct_size = sizeof state;
    REQUIRE(lr_collider_get_state(game.langevin->GetLibraryWorld(), hit.collider, &state) == LR_OK);
    CHECK(state.friction == 0.05f);
    CHECK(state.restitution == 0.6f);
}

TEST_CASE("planes: solid behind their normal") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    REQUIRE(game.langevin->AddPlane(FVector(0, 0, 30), FVector(0, -1, 2)));
    check_surface(game, FVector(), 300, [](double, double y) { return 30 + 0.5 * y; });
    CHECK_FALSE(game.langevin->AddPlane(FVector(), FVector()));
}

TEST_CASE("a followed collider leaves with its component") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    UStaticMeshComponent* door = game.add_block(box_of(100, 100, 100), FTransform(FVector(0, 0, 50)));
    CHECK(game.langevin->AddCollider(door, true) == 1);
    game.run(1);
    CHECK(game.ground_below(FVector(0, 0, 500)) == doctest::Approx(100));
    door->UnregisterComponent(); // as where its level is hidden: the object lives on
    game.run(1);
    CHECK(game.langevin->GetColliderCount() == 0);
    game.run(1); // rays see the colliders of the last step
    CHECK(game.ground_below(FVector(0, 0, 500)) == -1e9);
}

// The state holds the library's colliders; what the game has added, moved and removed since must not freeze or haunt the others.
TEST_CASE("a restored state has the colliders that the game has now") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    const auto add = [&](double x) {
        UStaticMeshComponent* const block = game.add_block(box_of(100, 100, 100), FTransform(FVector(x, 0, 0)));
        REQUIRE(game.langevin->AddCollider(block, true) == 1);
        return block;
    };
    const auto top = [&](double x) { return game.ground_below(FVector(x, 0, 5000)); };
    UStaticMeshComponent *const lift = add(0), *const gone = add(1000), *const door = add(2000);
    game.run(2);
    TArray<uint8> state;
    REQUIRE(game.langevin->SaveState(state));
    UStaticMeshComponent* const fresh = add(3000);
    door->SetWorldTransform(FTransform(FVector(2000, 0, 100)));
    REQUIRE(game.langevin->RemoveCollider(gone));
    game.run(2);
    REQUIRE(game.langevin->RestoreState(state));
    lift->SetWorldTransform(FTransform(FVector(0, 0, 200)));
    game.run(2);
    CHECK(top(0) == doctest::Approx(250));
    CHECK(top(1000) < -1e8);
    CHECK(top(2000) == doctest::Approx(150)); // the game did not close it
    CHECK(top(3000) == doctest::Approx(50));
    fresh->SetWorldTransform(FTransform(FVector(3000, 0, 300)));
    game.run(2);
    CHECK(top(3000) == doctest::Approx(350));
    CHECK(game.langevin->GetColliderCount() == 3);
}
