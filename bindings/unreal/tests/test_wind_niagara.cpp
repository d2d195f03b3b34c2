// Wind of the level's sources, and Niagara's data interface. SPDX-License-Identifier: MIT
#include "Components/WindDirectionalSourceComponent.h"
#include "NiagaraDataInterfaceLangevin.h"
#include "NiagaraSystemInstance.h"
#include "fixture.h"

#include <thread>

namespace {
UWindDirectionalSourceComponent* add_wind(const Game& game, const FTransform& place, float speed) {
    auto* wind = NewObject<UWindDirectionalSourceComponent>(game.world->SpawnActor<AActor>());
    wind->Speed = speed;
    wind->MinGustAmount = wind->MaxGustAmount = 0.0f;
    wind->SetWorldTransform(place);
    wind->RegisterComponent();
    return wind;
}

float as_float(uint32 bits) {
    float value;
    std::memcpy(&value, &bits, 4);
    return value;
}
} // namespace

TEST_CASE("a directional source blows along its arrow") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    UWindDirectionalSourceComponent* wind = add_wind(game, FTransform(FRotator(0, 90, 0), FVector()), 0.3f);
    game.run(2);
    // Yaw 90: towards +Y. Speed 0.3 at 10 m/s per unit is 300 cm/s.
    CHECK(game.langevin->SampleWind(FVector(100, 200, 300)).Equals(FVector(0, 300, 0), 1e-2));
    game.langevin->SetWind(FVector(50, 0, -20));
    game.run(1);
    CHECK(game.langevin->SampleWind(FVector()).Equals(FVector(50, 300, -20), 1e-2));
    wind->SetWorldTransform(FTransform(FRotator(-30, 0, 0), FVector()));
    game.run(1);
    CHECK(game.langevin->SampleWind(FVector()).Z < -20 - 149);
    wind->bActive = false;
    game.run(1);
    CHECK(game.langevin->SampleWind(FVector()).Equals(FVector(50, 0, -20), 1e-2));
}

TEST_CASE("bodies drift with the wind, to the side where it blows") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    add_wind(game, FTransform(FRotator(0, 90, 0), FVector()), 0.2f);
    ULangevinBatchComponent* batch = game.add_batch(100, 100);
    game.run(90);
    double y = 0.0;
    for (int32 i = 0; i < 100; ++i) {
        FTransform t;
        batch->GetInstanceTransform(i, t, true);
        y += t.GetLocation().Y / 100;
    }
    CHECK(y > 50);
}

TEST_CASE("gusts: about the mean, by the source's amounts, and gone when they are 0") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    UWindDirectionalSourceComponent* wind = add_wind(game, FTransform(), 0.5f);
    wind->MinGustAmount = 0.2f, wind->MaxGustAmount = 0.4f;
    double sum = 0, squares = 0;
    const int frames = 3000;
    for (int i = 0; i < frames; ++i) {
        game.run(1, 0.1f);
        const double x = game.langevin->SampleWind(FVector()).X;
        sum += x / frames, squares += x * x / frames;
    }
    CHECK(sum == doctest::Approx(500).epsilon(0.15));
    CHECK(std::sqrt(squares - sum * sum) == doctest::Approx(150).epsilon(0.35)); // 0.3 of 500
    wind->MinGustAmount = wind->MaxGustAmount = 0.0f;
    game.run(1);
    CHECK(game.langevin->SampleWind(FVector()).Equals(FVector(500, 0, 0), 1e-2));
}

TEST_CASE("a restored state has the gusts that the level has now") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    UWindDirectionalSourceComponent* wind = add_wind(game, FTransform(), 0.5f);
    TArray<uint8> calm, gusty;
    game.run(1);
    REQUIRE(game.langevin->SaveState(calm));
    const auto gusts = [&](float amount) {
        wind->MinGustAmount = wind->MaxGustAmount = amount;
        game.run(1);
        double most = 0;
        for (int i = 0; i < 100; ++i) {
            game.run(1, 0.1f);
            most = FMath::Max(most, std::fabs(game.langevin->SampleWind(FVector()).X - 500));
        }
        return most;
    };
    CHECK(gusts(0.3f) > 50);
    REQUIRE(game.langevin->SaveState(gusty));
    REQUIRE(game.langevin->RestoreState(calm));
    CHECK(gusts(0.3f) > 50); // again, though the state has none
    CHECK(gusts(0.0f) < 1e-2);
    REQUIRE(game.langevin->RestoreState(gusty));
    CHECK(gusts(0.0f) < 1e-2); // none, though the state has some
    CHECK(gusts(0.3f) > 50);
    CHECK_FALSE(logged(ShimTakeLog(), "Error"));
}

TEST_CASE("a game's own wind callback stays") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    ULangevinBatchComponent* batch = game.add_batch(10, 10);
    int calls = 0;
    const lr_wind_fn count = [](void* user, const lr_wind_query*) { ++*static_cast<int*>(user); };
    lr_world_set_wind_callback(game.langevin->GetLibraryWorld(), count, &calls);
    game.run(3);
    CHECK(calls > 2);
    batch->EndBatch();
}

TEST_CASE("a point source blows outward, also while bodies are stepped on many threads") {
    Game game;
    Game::settings().Origin = FVector(5000, 6000, 700);
    game.create();
    game.world->ShimBeginPlay();
    UWindDirectionalSourceComponent* wind = add_wind(game, FTransform(FVector(5000, 6000, 700)), 0.4f);
    wind->bPointWind = 1;
    wind->Radius = 500.0f;
    ULangevinBatchComponent* batch = game.add_batch(20000, 20000, FTransform(FVector(5000, 6000, 700)));
    game.run(1);
    // It is strongest a tenth of the radius from the middle.
    CHECK(game.langevin->SampleWind(FVector(5000, 6050, 700)).Equals(FVector(0, 400, 0), 0.1));
    CHECK(game.langevin->SampleWind(FVector(5000, 5950, 700)).Equals(FVector(0, -400, 0), 0.1));
    CHECK(game.langevin->SampleWind(FVector(5000, 6000, 1300)).IsZero());
    game.run(20);
    double out = 0.0;
    for (int32 i = 0; i < 20000; ++i) {
        FTransform t;
        batch->GetInstanceTransform(i, t, true);
        out += (t.GetLocation() - FVector(5000, 6000, 700)).Size() / 20000;
    }
    CHECK(out > 105); // the emitter's box has 96
    ShimDestroy(wind);
    game.run(1);
    CHECK(game.langevin->SampleWind(FVector(5000, 6050, 700)).IsZero());
}

TEST_CASE("turbulence of the settings is there, and wind sources can be left out") {
    Game game;
    Game::settings().TurbulenceSpeed = 2.0f;
    Game::settings().bUseWindSources = false;
    game.create();
    game.world->ShimBeginPlay();
    add_wind(game, FTransform(), 1.0f);
    game.run(2);
    double squares = 0;
    for (int i = 0; i < 1000; ++i) {
        const FVector v = game.langevin->SampleWind(FVector(173.0 * i, 91.0 * i, 47.0 * i));
        squares += FVector::DotProduct(v, v) / 3000;
    }
    CHECK(std::sqrt(squares) == doctest::Approx(200).epsilon(0.1));
}

TEST_CASE("Niagara reads what the bodies do") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    ULangevinBatchComponent* batch = game.add_batch(64, 64, FTransform(FVector(100, 200, 300)));
    game.run(30);
    auto* reader = NewObject<UNiagaraDataInterfaceLangevin>(nullptr);
    CHECK(FNiagaraTypeRegistry::ShimRegistered.Contains(UNiagaraDataInterfaceLangevin::StaticClass()));
    CHECK(reader->CanExecuteOnTarget(ENiagaraSimTarget::CPUSim));
    CHECK_FALSE(reader->CanExecuteOnTarget(ENiagaraSimTarget::GPUComputeSim));

    FNiagaraSystemInstance system;
    system.ShimAttach = batch;
    system.ShimTile = FVector(50, 60, 70);
    std::vector<char> memory(static_cast<std::size_t>(reader->PerInstanceDataSize()));
    REQUIRE(reader->InitPerInstanceData(memory.data(), &system));
    CHECK(reader->HasPreSimulateTick());
    CHECK_FALSE(reader->PerInstanceTick(memory.data(), &system, 0.016f));

    TArray<FNiagaraFunctionSignature> functions;
    reader->GetFunctionSignatures(functions);
    REQUIRE(functions.Num() == 2);
    for (const FNiagaraFunctionSignature& function : functions) {
        FVectorVMExternalFunctionContext context;
        context.ShimInstances = 66;
        context.ShimUserPtr = memory.data();
        std::size_t inputs = 0, outputs = 0;
        for (const FNiagaraVariable& input : function.Inputs)
            inputs += static_cast<std::size_t>(input.GetType().ShimRegisters());
        for (const FNiagaraVariable& output : function.Outputs)
            outputs += static_cast<std::size_t>(output.GetType().ShimRegisters());
        for (std::size_t i = 0; i < inputs; ++i) {
            context.ShimInputs.emplace_back();
            for (uint32 particle = 0; particle < 66; ++particle)
                context.ShimInputs.back().push_back(particle == 65 ? ~0u : particle);
        }
        FVMExternalFunction call;
        reader->GetVMExternalFunction({function.Name}, memory.data(), call);
        REQUIRE(call.IsBound());
        std::thread([&] { call.Execute(context); }).join(); // like Niagara's simulations
        // It reads and writes exactly the registers of its signature.
        CHECK(context.ShimNextInput == inputs);
        CHECK(context.ShimOutputs.size() == outputs);
        if (function.Name == FName(TEXT("GetNumBodies"))) {
            CHECK(context.ShimOutputs[0][7] == 64);
            CHECK(context.ShimOutputs[1][7] == 64);
            continue;
        }
        lr_batch_view view = {};
        view.struct_size = sizeof view;
        REQUIRE(lr_batch_get_view(game.langevin->GetLibraryWorld(), batch->GetLibraryBatch(), &view) == LR_OK);
        for (const uint32 i : {0u, 17u, 63u}) {
            lr_body_state s = {};
            s.struct_size = sizeof s;
            REQUIRE(lr_body_get_state(game.langevin->GetLibraryWorld(), view.ids[i], &s) == LR_OK);
            const auto& out = context.ShimOutputs;
            CHECK(out[0][i] == ~0u);
            CHECK(as_float(out[1][i]) == doctest::Approx(100 * s.position[0] - 50));
            CHECK(as_float(out[2][i]) == doctest::Approx(-100 * s.position[1] - 60));
            CHECK(as_float(out[3][i]) == doctest::Approx(100 * s.position[2] - 70));
            CHECK(as_float(out[4][i]) == doctest::Approx(-s.orientation[0]));
            CHECK(as_float(out[5][i]) == doctest::Approx(s.orientation[1]));
            CHECK(as_float(out[7][i]) == doctest::Approx(s.orientation[3]));
            CHECK(as_float(out[8][i]) == doctest::Approx(100 * s.linear_velocity[0]).epsilon(1e-3));
            CHECK(as_float(out[9][i]) == doctest::Approx(-100 * s.linear_velocity[1]).epsilon(1e-3));
            CHECK(as_float(out[11][i]) == doctest::Approx(-s.angular_velocity[0]).epsilon(1e-3));
            CHECK(as_float(out[12][i]) == doctest::Approx(s.angular_velocity[1]).epsilon(1e-3));
            CHECK(as_float(out[14][i]) == doctest::Approx(s.age));
            CHECK(as_float(out[15][i]) == 1.0f);
        }
        for (const uint32 outside : {64u, 65u}) {
            CHECK(context.ShimOutputs[0][outside] == 0);
            CHECK(as_float(context.ShimOutputs[7][outside]) == 1.0f);
        }
    }
    const auto taken = batch->GetSnapshot();
    CHECK(batch->GetSnapshot().Get() == taken.Get());
    game.run(1);
    CHECK(batch->GetSnapshot().Get() != taken.Get());
    reader->DestroyPerInstanceData(memory.data(), &system);
}

TEST_CASE("Niagara finds the batch of another actor, and lives without one") {
    Game game;
    game.create();
    game.world->ShimBeginPlay();
    ULangevinBatchComponent* batch = game.add_batch(8, 8);
    auto* reader = NewObject<UNiagaraDataInterfaceLangevin>(nullptr);
    auto* other = NewObject<UNiagaraDataInterfaceLangevin>(nullptr);
    CHECK(reader->Equals(other));
    reader->Source = batch->GetOwner();
    CHECK_FALSE(reader->Equals(other));
    REQUIRE(reader->CopyTo(other));
    CHECK(reader->Equals(other));
    for (const bool found : {true, false}) {
        if (!found) reader->Source = nullptr;
        FNiagaraSystemInstance system;
        std::vector<char> memory(static_cast<std::size_t>(reader->PerInstanceDataSize()));
        REQUIRE(reader->InitPerInstanceData(memory.data(), &system));
        reader->PerInstanceTick(memory.data(), &system, 0.016f);
        FVectorVMExternalFunctionContext context;
        context.ShimInstances = 1;
        context.ShimUserPtr = memory.data();
        FVMExternalFunction call;
        reader->GetVMExternalFunction({FName(TEXT("GetNumBodies"))}, memory.data(), call);
        call.Execute(context);
        CHECK(context.ShimOutputs[0][0] == (found ? 8u : 0u));
        reader->DestroyPerInstanceData(memory.data(), &system);
    }
}
