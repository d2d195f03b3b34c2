// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#include "LangevinWind.h"

#include "Components/WindDirectionalSourceComponent.h"
#include "Engine/World.h"
#include "LangevinConversion.h"
#include "LangevinHost.h"
#include "LangevinSettings.h"
#include "LangevinTypes.h"
#include "UObject/UObjectIterator.h"

namespace {
constexpr float SearchInterval = 0.5f;
}

FLangevinWind::FLangevinWind(lr_world* InWorld, const FVector& InOrigin, const ULangevinSettings& InSettings)
    : World(InWorld), Origin(InOrigin), Settings(InSettings) {
    AddTurbulence();
}

FLangevinWind::~FLangevinWind() {
    if (bCallback) lr_world_set_wind_callback(World, nullptr, nullptr);
}

void FLangevinWind::AddTurbulence() {
    if (Settings.TurbulenceSpeed <= 0.0f) return;
    lr_turbulence_desc Desc;
    lr_turbulence_desc_init(&Desc, sizeof(Desc));
    Desc.rms = Settings.TurbulenceSpeed;
    Desc.integral_length = static_cast<float>(LangevinConversion::LengthToMetres(Settings.TurbulenceSize));
    LangevinHost::Check(lr_world_add_turbulence(World, &Desc, nullptr), TEXT("Turbulence"));
}

void FLangevinWind::Find(const UWorld& Level) {
    Sources.Reset();
    for (TObjectIterator<UWindDirectionalSourceComponent> It; It; ++It) {
        if (It->GetWorld() == &Level && It->IsRegistered()) Sources.Add(*It);
    }
}

void FLangevinWind::Update(const UWorld& Level, float DeltaSeconds) {
    UntilSearch -= DeltaSeconds;
    if (Settings.bUseWindSources && UntilSearch <= 0.0f) {
        Find(Level);
        UntilSearch = SearchInterval;
    }
    const FVector ScaledExtra = Extra / LangevinConversion::CentimetresPerMetre;
    FVector Uniform = ScaledExtra; // m/s, in the engine's axes
    FVector GustSum = FVector::ZeroVector;
    Points.Reset();
    for (const TWeakObjectPtr<UWindDirectionalSourceComponent>& Weak : Sources) {
        const UWindDirectionalSourceComponent* Source = Weak.Get();
        if (Source == nullptr || !Source->IsActive()) continue;
        const float Speed = FMath::Clamp(Source->Speed * Settings.WindSpeedScale, 0.0f, 500.0f);
        if (Source->bPointWind) {
            FLangevinPointWind Point;
            LangevinTypes::Store(Point.Position,
                                 LangevinConversion::PositionToLangevin(
                                     LangevinTypes::From(Source->GetComponentLocation()), LangevinTypes::From(Origin)));
            Point.Radius = static_cast<float>(LangevinConversion::LengthToMetres(Source->Radius));
            Point.Speed = Speed;
            if (Point.Radius > 0.0f && Speed > 0.0f) Points.Add(Point);
        } else {
            const FVector Forward = Source->GetComponentTransform().GetUnitAxis(EAxis::X);
            Uniform += Forward * Speed;
            GustSum += Forward * (Speed * 0.5f * (Source->MinGustAmount + Source->MaxGustAmount));
        }
    }
    float Wind[3];
    LangevinTypes::Store(Wind, LangevinConversion::MirrorDirection(LangevinTypes::From(Uniform)));
    LangevinHost::Check(lr_world_set_uniform_wind(World, Wind[0], Wind[1], Wind[2]), TEXT("Wind"));
    SetGusts(GustSum.GetSafeNormal(), static_cast<float>(GustSum.Size()));

    Field = {Points.GetData(), Points.Num()};
    // Without points the callback is the game's, which may have set one by the library's function.
    const bool bPoints = Points.Num() > 0;
    if (bPoints != bCallback) {
        lr_world_set_wind_callback(World, bPoints ? &LangevinPointWind::Callback : nullptr, &Field);
    }
    bCallback = bPoints;
}

void FLangevinWind::Restored() {
    Gusts = {};
    for (const lr_wind_source& Source : Made) {
        if (lr_wind_source_is_valid(World, Source)) Gusts = Source;
    }
    GustSpeed = -1.0f; // none: the next update sets it
}

void FLangevinWind::SetGusts(const FVector& Direction, float Speed) {
    if (Speed == GustSpeed && Direction == GustDirection) return;
    GustSpeed = Speed;
    GustDirection = Direction;
    if (Speed <= 0.0f) {
        if (Gusts.id != 0) LangevinHost::Check(lr_world_remove_wind(World, Gusts), TEXT("Gusts"));
        Gusts = {};
        return;
    }
    lr_gusts_desc Desc;
    lr_gusts_desc_init(&Desc, sizeof(Desc));
    Desc.rms = Speed;
    Desc.angle_rms = 0.2f;
    LangevinTypes::Store(Desc.direction, LangevinConversion::MirrorDirection(LangevinTypes::From(Direction)));
    LangevinHost::Check(Gusts.id == 0 ? lr_world_add_gusts(World, &Desc, &Gusts)
                                      : lr_world_update_gusts(World, Gusts, &Desc),
                        TEXT("Gusts"));
    if (Gusts.id != 0) Made.AddUnique(Gusts);
}
