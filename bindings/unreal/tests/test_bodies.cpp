// Bodies in a running world: time, instances, tasks, events, state. SPDX-License-Identifier: MIT
#include "LangevinHost.h"
#include "LeafStormActor.h"
#include "fixture.h"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <thread>

namespace {
/** The expected transform of a drawn body, calculated from the library's state without the plugin's conversion. */
FTransform expected(const Game& game, const ULangevinAsset& asset, const lr_body_state& s) {
    lr_asset_info info = {};
    info.struct_size = sizeof info;
    REQUIRE(lr_asset_get_info(const_cast<ULangevinAsset&>(asset).GetHandle(), &info) == LR_OK);
    const FQuat library(s.orientation[0], s.orientation[1], s.orientation[2], s.orientation[3]);
    const FVector com(info.center_of_mass[0], info.center_of_mass[1], info.center_of_mass[2]);
    const FVector origin =
        FVector(s.position[0], s.position[1], s.position[2]) - library.RotateVector(com) * static_cast<double>(s.scale);
    const FVector o = game.langevin->GetOrigin();
    return FTransform(FQuat(-s.orientation[0], s.orientation[1], -s.orientation[2], s.orientation[3]),
                      FVector(100 * origin.X + o.X, -100 * origin.Y + o.Y, 100 * origin.Z + o.Z), FVector(s.scale));
}

void check_instances(const Game& game, const ULangevinBatchComponent& batch) {
    lr_batch_view view = {};
    view.struct_size = sizeof view;
    REQUIRE(lr_batch_get_view(game.langevin->GetLibraryWorld(), batch.GetLibraryBatch(), &view) == LR_OK);
    REQUIRE(batch.GetInstanceCount() == static_cast<int32>(view.count));
    int wrong = 0, outside = 0;
    // A body without a mesh is a point on the box's face: centre plus extent, and to local space and back, round in the last bits.
    const FBox bounds = batch.Bounds.GetBox().ExpandBy(1e-9);
    for (uint32 i = 0; i < view.count; ++i) {
        lr_body_state state = {};
        state.struct_size = sizeof state;
        REQUIRE(lr_body_get_state(game.langevin->GetLibraryWorld(), view.ids[i], &state) == LR_OK);
        FTransform drawn;
        REQUIRE(batch.GetInstanceTransform(static_cast<int32>(i), drawn, true));
        wrong += !drawn.Equals(expected(game, *batch.Asset, state), 2e-3);
        // The mesh reaches 4.06 cm from its origin, here along a diagonal.
        const FVector reach = FVector(batch.GetStaticMesh() != nullptr ? 2.3 : 0.0) * drawn.GetScale3D();
        outside +=
            !bounds.IsInsideOrOn(drawn.GetLocation() + reach) || !bounds.IsInsideOrOn(drawn.GetLocation() - reach);
    }
    CHECK(wrong == 0);
    CHECK(outside == 0);
}

int64 run_storm(bool tasks, int32 count, uint64* launched) {
    Game game;
    Game::settings().bUseEngineTasks = tasks;
    Game::settings().Seed = 42;
    Game::settings().TurbulenceSpeed = 1.0f;
    game.create();
    game.world->ShimBeginPlay();
    game.add_batch(count, count);
    game.run(20);
    if (launched != nullptr) *launched = game.langevin->GetLaunchedTasks();
    return game.langevin->GetStateHash();
}

struct Listener : UObject {
    void hear(const TArray<FLangevinEvent>& events) { all.Append(events); }
    TArray<FLangevinEvent> all;
};
} // namespace

TEST_CASE("leaves fall down along Z, and are drawn where they are") {
    Game game;
    Game::settings().Origin = FVector(50000, -30000, 2000);
    game.create();
    game.world->ShimBeginPlay();
    ULangevinBatchComponent* batch = game.add_batch(500, 500, FTransform(FVector(50100, -30200, 3000)));
    CHECK(batch->GetBodyCount() == 500);
    check_instances(game, *batch);
    FTransform first;
    batch->GetInstanceTransform(0, first, true);
    CHECK(std::abs(first.GetLocation().X - 50100) < 110); // in the emitter's box of 1 m
    CHECK(std::abs(first.GetLocation().Y + 30200) < 110);
    game.run(60);
    check_instances(game, *batch);
    FTransform later;
    batch->GetInstanceTransform(0, later, true);
    CHECK(later.GetLocation().Z < first.GetLocation().Z - 50);
    CHECK(game.langevin->GetSimulatedTime() == doctest::Approx(1.0).epsilon(1e-5));
    CHECK(batch->bShimMarkedDirty);
    const FBox bounds = batch->Bounds.GetBox();
    CHECK(bounds.IsInsideOrOn(later.GetLocation()));
    CHECK(bounds.Max.Z - bounds.Min.Z < 2000);
}

TEST_CASE("the component gives the same bits as the library used directly") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    ULangevinBatchComponent* batch = game.add_batch(3, 0);
    const TArray<FLangevinBody> bodies =
        batch->SpawnBodies({FTransform(FVector(0, 0, 500)), FTransform(FRotator(20, 30, 40), FVector(100, 200, 500))},
                           FVector(10, 20, 30));
    REQUIRE(bodies.Num() == 2);
    lr_world_desc wd;
    lr_world_desc_init(&wd, sizeof wd);
    wd.gravity[1] = 0, wd.gravity[2] = -9.8f;
    lr_world* world = nullptr;
    REQUIRE(lr_world_create(&wd, &world) == LR_OK);
    lr_batch_desc bd;
    lr_batch_desc_init(&bd, sizeof bd);
    bd.asset = batch->Asset->GetHandle();
    bd.capacity = 3;
    lr_batch raw{};
    REQUIRE(lr_batch_create(world, &bd, &raw) == LR_OK);
    lr_emitter_desc emitter; // as in the component: part of the hash
    lr_emitter_desc_init(&emitter, sizeof emitter);
    emitter.shape = LR_EMIT_BOX;
    emitter.size[0] = emitter.size[1] = emitter.size[2] = 1;
    REQUIRE(lr_batch_set_emitter(world, raw, &emitter) == LR_OK);
    for (const FLangevinBody& body : bodies) {
        lr_body_state state = {};
        state.struct_size = sizeof state;
        REQUIRE(lr_body_get_state(game.langevin->GetLibraryWorld(), lr_body{static_cast<uint64_t>(body.Id)}, &state) ==
                LR_OK);
        lr_body_desc desc;
        lr_body_desc_init(&desc, sizeof desc);
        for (int i = 0; i < 3; ++i)
            desc.position[i] = state.position[i], desc.linear_velocity[i] = state.linear_velocity[i];
        for (int i = 0; i < 4; ++i) desc.orientation[i] = state.orientation[i];
        lr_body copy{};
        REQUIRE(lr_body_create(world, raw, &desc, 1, &copy) == LR_OK);
        // From the same numbers: reading a state and setting it again would round once more.
        REQUIRE(lr_body_set_state(game.langevin->GetLibraryWorld(), lr_body{static_cast<uint64_t>(body.Id)}, &state) ==
                LR_OK);
        REQUIRE(lr_body_set_state(world, copy, &state) == LR_OK);
    }
    game.run(30);
    for (int i = 0; i < 30; ++i) REQUIRE(lr_world_step(world, 1.0f / 60.0f, 2) == LR_OK);
    lr_batch_view a = {}, b = {};
    a.struct_size = b.struct_size = sizeof a;
    lr_batch_get_view(game.langevin->GetLibraryWorld(), batch->GetLibraryBatch(), &a);
    lr_batch_get_view(world, raw, &b);
    float va[12], vb[12];
    lr_batch_write_velocities(game.langevin->GetLibraryWorld(), batch->GetLibraryBatch(), va, 0, 2, nullptr);
    lr_batch_write_velocities(world, raw, vb, 0, 2, nullptr);
    for (uint32 i = 0; i < 2; ++i) {
        CHECK(a.position[0][i] == b.position[0][i]);
        CHECK(a.position[1][i] == b.position[1][i]);
        CHECK(a.position[2][i] == b.position[2][i]);
        CHECK(va[6 * i + 3] == vb[6 * i + 3]);
    }
    lr_world_destroy(world);
}

TEST_CASE("spawned bodies are where the mesh was asked to be, and say so") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    ULangevinBatchComponent* batch = game.add_batch(2, 0);
    const FTransform place(FRotator(10, 50, -30), FVector(300, -200, 900), FVector(1.5));
    const TArray<FLangevinBody> bodies = batch->SpawnBodies({place}, FVector(100, 200, -50));
    REQUIRE(bodies.Num() == 1);
    FTransform transform;
    FVector velocity, spin;
    bool resting = true;
    REQUIRE(batch->GetBodyState(bodies[0], transform, velocity, spin, resting));
    CHECK(transform.Equals(place, 1e-3));
    CHECK(velocity.Equals(FVector(100, 200, -50), 1e-3));
    CHECK_FALSE(resting);
    // Too many: none are created, and the log says so.
    CHECK(batch->SpawnBodies({place, place}, FVector()).Num() == 0);
    CHECK(logged(ShimTakeLog(), "SpawnBodies"));
    CHECK(batch->GetBodyCount() == 1);
    CHECK(batch->DestroyBodies(bodies));
    CHECK_FALSE(batch->GetBodyState(bodies[0], transform, velocity, spin, resting));
    game.run(1);
    CHECK(batch->GetInstanceCount() == 0);
}

TEST_CASE("impulses and accelerations have the engine's units and directions") {
    Game game;
    game.world = nullptr;
    game.create();
    game.world->ShimGravityZ = 0.0f;
    game.world->ShimBeginPlay();
    ULangevinBatchComponent* batch = game.add_batch(2, 0);
    const TArray<FLangevinBody> bodies =
        batch->SpawnBodies({FTransform(FVector(0, 0, 0)), FTransform(FVector(0, 500, 0))}, FVector());
    FTransform t;
    FVector v, w;
    bool r;
    REQUIRE(batch->AddImpulseToBody(bodies[0], FVector(0, 0.0001, 0), FVector(), false));
    batch->GetBodyState(bodies[0], t, v, w, r);
    CHECK(v.Y > 0.05); // kg cm/s on 0.18 g and its added mass
    CHECK(v.Y < 0.0001 / 0.00018 + 1e-3);
    // Upward at the end of the leaf along +X: it must turn X towards Z, a spin about -Y.
    REQUIRE(batch->AddImpulseToBody(bodies[1], FVector(0, 0, 0.0001), FVector(3, 500, 0), true));
    batch->GetBodyState(bodies[1], t, v, w, r);
    CHECK(w.Y < -0.01);
    REQUIRE(batch->SetAcceleration(FVector(0, 0, 500)));
    game.run(6);
    batch->GetBodyState(bodies[0], t, v, w, r);
    CHECK(v.Z > 5);
}

TEST_CASE("a step runs on the engine's threads, with the same bits") {
    const uint64 before = ShimTasksElsewhere();
    uint64 launched = 0;
    const int64 threaded = run_storm(true, 20000, &launched);
    CHECK(launched > 0);
    CHECK(ShimTasksElsewhere() > before);
    uint64 none = 1;
    CHECK(run_storm(false, 20000, &none) == threaded);
    CHECK(none == 0);
}

TEST_CASE("tasks: each index once, and all of them done when finish returns") {
    struct Work {
        std::atomic<int> indices[8] = {};
    } work;
    FLangevinJobs jobs;
    const lr_job_system callbacks = jobs.Callbacks();
    for (int round = 1; round <= 20; ++round) {
        void* token = callbacks.enqueue(
            callbacks.user,
            [](void* task, uint32_t begin, uint32_t end) {
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
                for (uint32_t i = begin; i < end; ++i) ++static_cast<Work*>(task)->indices[i];
            },
            &work, 8);
        callbacks.finish(callbacks.user, token);
        for (const std::atomic<int>& count : work.indices) CHECK(count == round);
    }
    CHECK(jobs.GetLaunched() == 160);
    CHECK(FLangevinJobs::WorkerCount() == 3);
}

TEST_CASE("fixed steps: the same motion at any frame rate, and none lost") {
    int64 hashes[2] = {};
    const float rates[2] = {1.0f / 30.0f, 1.0f / 144.0f};
    for (int i = 0; i < 2; ++i) {
        Game game;
        Game::settings().Stepping = ELangevinStepping::Fixed;
        game.create();
        game.world->ShimBeginPlay();
        ULangevinBatchComponent* batch = game.add_batch(100, 100);
        while (game.langevin->GetSimulatedTime() < 1.0 - 1e-4) game.world->ShimTick(rates[i]);
        CHECK(game.langevin->GetSimulatedTime() == doctest::Approx(1.0).epsilon(1e-5));
        hashes[i] = game.langevin->GetStateHash();
        CHECK_FALSE(logged(ShimTakeLog(), "Max Steps Per Frame"));
        CHECK(batch->GetBodyCount() == 100);
    }
    CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("between fixed steps bodies are drawn moved on, if asked for") {
    for (const bool smooth : {true, false}) {
        Game game;
        Game::settings().Stepping = ELangevinStepping::Fixed;
        Game::settings().FixedStep = 0.05f;
        Game::settings().bSmoothFixedSteps = smooth;
        game.create();
        game.world->ShimBeginPlay();
        ULangevinBatchComponent* batch = game.add_batch(10, 10);
        game.run(20, 0.05f);
        FTransform at_step, between;
        batch->GetInstanceTransform(0, at_step, true);
        game.run(1, 0.02f);
        batch->GetInstanceTransform(0, between, true);
        FTransform t;
        FVector v, w;
        bool r;
        lr_batch_view view = {};
        view.struct_size = sizeof view;
        lr_batch_get_view(game.langevin->GetLibraryWorld(), batch->GetLibraryBatch(), &view);
        FLangevinBody body;
        body.Id = static_cast<int64>(view.ids[0].id);
        REQUIRE(batch->GetBodyState(body, t, v, w, r));
        const FVector moved = between.GetLocation() - at_step.GetLocation();
        if (smooth) {
            CHECK(moved.Equals(v * 0.02, 0.3)); // the mesh's origin is not quite the centre of mass
            CHECK(moved.Size() > 0.5);
        } else {
            CHECK(moved.Size() == 0.0);
        }
    }
}

TEST_CASE("frames that are too long are cut, and steps that are lost are told of once") {
    Game game;
    Game::settings().Stepping = ELangevinStepping::Fixed;
    game.create();
    game.world->ShimBeginPlay();
    game.run(2, 5.0f); // limited to 0.1 s: six steps due, four taken
    CHECK(game.langevin->GetSimulatedTime() == doctest::Approx(8.0 / 60.0));
    int told = 0;
    for (const std::string& line : ShimTakeLog()) told += line.find("Max Steps Per Frame") != std::string::npos;
    CHECK(told == 1);
    game.langevin->SetPaused(true);
    game.run(10);
    CHECK(game.langevin->GetSimulatedTime() == doctest::Approx(8.0 / 60.0));
}

TEST_CASE("instances know where they were in the frame before: motion vectors") {
    for (const ELangevinStepping stepping : {ELangevinStepping::Frame, ELangevinStepping::Fixed}) {
        Game game;
        Game::settings().Stepping = stepping;
        game.create();
        game.world->ShimBeginPlay();
        REQUIRE(game.langevin->AddPlane(FVector(0, 0, 0), FVector(0, 0, 1)));
        ULangevinBatchComponent* batch = game.add_batch(100, 100, FTransform(FVector(0, 0, 300)));
        game.run(30);
        TArray<FTransform> before;
        FTransform at, previous;
        for (int32 index = 0; index < 100; ++index) {
            REQUIRE(batch->GetInstanceTransform(index, at, true));
            before.Add(at);
        }
        const float dt = 1.0f / 72.0f; // fixed steps of 1/60 s: one in most frames
        game.run(1, dt);
        double moved = 0.0;
        for (int32 index = 0; index < 100; ++index) {
            REQUIRE(batch->GetInstancePrevTransform(index, previous, true));
            REQUIRE(batch->GetInstanceTransform(index, at, true));
            moved += (at.GetLocation() - previous.GetLocation()).Size();
            CHECK((previous.GetLocation() - before[index].GetLocation()).Size() < 1.0); // cm; of some 2
            CHECK(previous.GetScale3D().Equals(at.GetScale3D(), 0.0));
        }
        CHECK(moved > 100 * 0.5);
        const auto check_still = [&] { // what is drawn again and again
            for (int32 index = 0; index < 100; ++index) {
                REQUIRE(batch->GetInstancePrevTransform(index, previous, true));
                REQUIRE(batch->GetInstanceTransform(index, at, true));
                CHECK(previous.Equals(at, 0.0));
            }
        };
        game.langevin->SetPaused(true);
        check_still();
        game.langevin->SetPaused(false);
        game.run(2, dt);
        const double time = game.langevin->GetSimulatedTime();
        game.world->bShimPaused = true; // UGameplayStatics::SetGamePaused
        game.run(5, dt);
        check_still();
        CHECK(game.langevin->GetSimulatedTime() == time);
        game.world->bShimPaused = false;
        game.run(60 * 12);
        REQUIRE(batch->GetAwakeCount() < 50);
        REQUIRE(batch->GetInstancePrevTransform(99, previous, true));
        REQUIRE(batch->GetInstanceTransform(99, at, true));
        CHECK(previous.Equals(at, 0.0)); // sleeps
    }
}

TEST_CASE("bodies at rest are not written again, and stay when the component moves") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    REQUIRE(game.langevin->AddPlane(FVector(0, 0, 0), FVector(0, 0, 1)));
    ULangevinBatchComponent* batch = game.add_batch(300, 300, FTransform(FVector(0, 0, 150)));
    game.run(60 * 8);
    const int32 awake = batch->GetAwakeCount();
    REQUIRE(awake < 100);
    check_instances(game, *batch);
    game.run(1);
    CHECK(batch->GetLastWritten() < 300);
    CHECK(batch->GetLastWritten() >= batch->GetAwakeCount());
    check_instances(game, *batch);
    const int32 updates = batch->ShimUpdates;
    game.run(1);
    CHECK(batch->ShimUpdates <= updates + 1); // at most one call per frame

    batch->SetWorldTransform(FTransform(FRotator(0, 30, 0), FVector(500, 0, 150)));
    game.run(1);
    CHECK(batch->GetLastWritten() == 300);
    check_instances(game, *batch);

    // Waking changes the order: all instances must be right afterwards.
    CHECK(game.langevin->WakeBox(FVector(-100, 0, -50), FVector(100, 100, 50)) > 0);
    game.run(1);
    check_instances(game, *batch);
    CHECK(game.langevin->WakeBox(FVector(1e5, 1e5, 1e5), FVector(1.1e5, 1.1e5, 1.1e5)) == 0);
}

TEST_CASE("emitters, ages and kill heights: instances come and go") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    AActor* actor = game.world->SpawnActor<AActor>();
    auto* batch = NewObject<ULangevinBatchComponent>(actor);
    batch->Asset = make_leaf();
    batch->Capacity = 200;
    batch->EmitterRate = 100.0f;
    batch->MaxAge = 0.5f;
    batch->RegisterComponent();
    CHECK(logged(ShimTakeLog(), "has no static mesh"));
    game.run(120);
    CHECK(batch->GetBodyCount() > 40);
    CHECK(batch->GetBodyCount() < 60); // rate times age
    check_instances(game, *batch);

    auto* falling = NewObject<ULangevinBatchComponent>(actor);
    falling->Asset = make_leaf();
    falling->Capacity = falling->InitialCount = 100;
    falling->bKillBelow = true;
    falling->KillHeight = -50.0;
    falling->EmitterShape = ELangevinEmitterShape::Point;
    falling->bRespawn = true;
    falling->RegisterComponent();
    double lowest = 0.0;
    for (int frame = 0; frame < 240; ++frame) {
        game.run(1);
        REQUIRE(falling->GetBodyCount() == 100);
        for (int32 i = 0; i < 100; ++i) {
            FTransform t;
            falling->GetInstanceTransform(i, t, true);
            lowest = std::min(lowest, t.GetLocation().Z);
        }
    }
    CHECK(lowest < -40);
    CHECK(lowest > -60);
    batch->EndBatch();
    CHECK(batch->GetInstanceCount() == 0);
    CHECK(batch->GetBodyCount() == 0);
}

TEST_CASE("an emitter follows its component") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    ULangevinBatchComponent* batch = game.add_batch(10, 0);
    batch->SetWorldTransform(FTransform(FVector(4000, 5000, 600)));
    game.run(1);
    REQUIRE(batch->EmitBodies(1));
    game.run(1);
    FTransform t;
    REQUIRE(batch->GetInstanceTransform(0, t, true));
    CHECK(t.GetLocation().Equals(FVector(4000, 5000, 600), 110));
}

TEST_CASE("a listener pauses in the middle of a frame") {
    struct Pauser : UObject {
        ULangevinWorldSubsystem* langevin = nullptr;
        void hear(const TArray<FLangevinEvent>&) { langevin->SetPaused(true); }
    };
    for (const ELangevinStepping stepping : {ELangevinStepping::Frame, ELangevinStepping::Fixed}) {
        Game game;
        Game::settings().Stepping = stepping;
        Game::settings().MaxEvents = 1000;
        game.create();
        game.world->ShimBeginPlay();
        auto* pauser = new Pauser();
        pauser->langevin = game.langevin;
        ULangevinBatchComponent* batch = game.add_batch(20, 10);
        game.run(10);
        game.langevin->OnEvents.AddDynamic(pauser, &Pauser::hear);
        REQUIRE(batch->EmitBodies(1));
        const double before = game.langevin->GetSimulatedTime();
        game.run(5, 1.0f / 20.0f); // three fixed steps: the first tells the spawn
        const double step = stepping == ELangevinStepping::Fixed ? 1.0 / 60.0 : 1.0 / 20.0;
        CHECK(game.langevin->GetSimulatedTime() - before == doctest::Approx(step));
        FTransform at, previous;
        for (int32 index = 0; index < batch->GetInstanceCount(); ++index) {
            REQUIRE(batch->GetInstancePrevTransform(index, previous, true));
            REQUIRE(batch->GetInstanceTransform(index, at, true));
            CHECK(previous.Equals(at, 0.0));
        }
    }
}

TEST_CASE("landings are told, with who, where and on what") {
    Game game;
    Game::settings().MaxEvents = 1000;
    game.create();
    UStaticMeshComponent* floor = game.add_block(box_of(1000, 1000, 100), FTransform(FVector(0, 0, -50)));
    game.world->ShimBeginPlay();
    auto* listener = new Listener();
    game.langevin->OnEvents.AddDynamic(listener, &Listener::hear);
    ULangevinBatchComponent* batch = game.add_batch(20, 20, FTransform(FVector(0, 0, 110)));
    game.run(60 * 6);
    int begun = 0, landed = 0;
    for (const FLangevinEvent& event : listener->all) {
        CHECK(event.Batch == batch);
        CHECK(event.Body.Id != 0);
        if (event.Kind == ELangevinEvent::Hit) {
            ++begun;
            CHECK(event.Other.Get() == floor);
            CHECK(std::abs(event.Location.Z) < 2.0);
            CHECK(event.Normal.Z > 0.9);
            CHECK(event.Speed >= 0.0f);
        }
        landed += event.Kind == ELangevinEvent::Landed;
    }
    CHECK(begun >= 20);
    CHECK(landed > 10);
}

TEST_CASE("a saved state goes on as it did, and is drawn at once") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    ULangevinBatchComponent* batch = game.add_batch(200, 200);
    game.run(30);
    TArray<uint8> state;
    REQUIRE(game.langevin->SaveState(state));
    const int64 then = game.langevin->GetStateHash();
    game.run(30);
    const int64 later = game.langevin->GetStateHash();
    CHECK(later != then);
    REQUIRE(game.langevin->RestoreState(state));
    CHECK(game.langevin->GetStateHash() == then);
    check_instances(game, *batch);
    game.run(30);
    CHECK(game.langevin->GetStateHash() == later);
    CHECK_FALSE(game.langevin->RestoreState(TArray<uint8>{1, 2, 3}));
}

// test.sh replays the files with lr_replay.
TEST_CASE("the calls of a game are recorded") {
    const std::string folder = environment("LANGEVIN_TEST_RECORDINGS");
    const auto size_of = [&](const char* name) { return std::filesystem::file_size(folder + "/" + name); };
    const auto path = [&](const char* name) { return FString(ShimWiden(folder + "/" + name)); };
    {
        Game game;
        game.create();
        game.world->ShimBeginPlay();
        game.add_batch(200, 200);
        game.run(10);
        CHECK_FALSE(game.langevin->StopRecording());
        REQUIRE(game.langevin->StartRecording(path("game.lrrec")));
        CHECK_FALSE(game.langevin->StartRecording(path("other.lrrec")));
        game.langevin->SetWind(FVector(300.0, 0.0, 0.0));
        game.run(20);
        const auto running = size_of("game.lrrec");
        CHECK(running > 10000);
        CHECK(game.langevin->StopRecording());
        const auto whole = size_of("game.lrrec");
        game.run(2);
        CHECK((whole >= running && size_of("game.lrrec") == whole));
        REQUIRE(game.langevin->StartRecording(path("left.lrrec")));
        game.run(5);
    }
    CHECK(size_of("left.lrrec") > 10000);
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    CHECK_FALSE(game.langevin->StartRecording(path("none/a.lrrec")));
    CHECK(logged(ShimTakeLog(), "cannot be written"));
    if (std::filesystem::exists("/dev/full")) CHECK_FALSE(game.langevin->StartRecording(TEXT("/dev/full")));
    CHECK(game.langevin->StartRecording(path("again.lrrec")));
}

TEST_CASE("components without an asset say what is missing") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    auto* batch = NewObject<ULangevinBatchComponent>(game.world->SpawnActor<AActor>());
    batch->RegisterComponent(); // BeginPlay waits for a component
    CHECK(batch->GetLibraryBatch().id == 0);
    CHECK_FALSE(batch->BeginBatch());
    CHECK(logged(ShimTakeLog(), "has no asset: import a .lrb file"));
    CHECK(batch->SpawnBodies({FTransform()}, FVector()).Num() == 0);
    CHECK_FALSE(batch->EmitBodies(1));
}

TEST_CASE("all memory comes from the engine, and goes back") {
    const int64 before = ShimLiveAllocations();
    {
        Game game;
        game.create();
        CHECK(ShimLiveAllocations() > before);
        game.world->ShimBeginPlay();
        game.add_batch(1000, 1000);
        game.run(5);
    }
    CHECK(ShimLiveAllocations() == before);
}

TEST_CASE("editor worlds have no simulation") {
    UWorld* world = UWorld::ShimCreate(EWorldType::Editor);
    CHECK(world->GetSubsystem<ULangevinWorldSubsystem>() == nullptr);
    world->ShimEnd();
}

TEST_CASE("the sample: a storm that never ends") {
    Game game;
    Game::settings().MaxEvents = 4000;
    game.create();
    game.add_block(box_of(4000, 4000, 100), FTransform(FVector(0, 0, -250)));
    auto* storm = game.world->SpawnActor<ALeafStormActor>();
    storm->Leaf = make_leaf();
    storm->LeafMesh = make_mesh();
    game.world->ShimBeginPlay();
    game.run(60 * 6);
    CHECK(storm->Leaves->GetInstanceCount() == 2000);
    CHECK(storm->Landed > 100);
    double drift = 0.0;
    for (int32 i = 0; i < 2000; ++i) {
        FTransform t;
        storm->Leaves->GetInstanceTransform(i, t, true);
        drift += t.GetLocation().X / 2000;
    }
    CHECK(drift > 30); // with the wind
    check_instances(game, *storm->Leaves);
}
