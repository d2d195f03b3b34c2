// SPDX-License-Identifier: MIT
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
    lr_world_set_wind_callback(World, nullptr, nullptr);
}

void FLangevinWind::AddTurbulence() {
    if (Settings.TurbulenceSpeed <= 0.0f) return;
    lr_wind_source_desc Desc;
    lr_wind_source_desc_init(&Desc, sizeof(Desc));
    Desc.kind = LR_WIND_SOURCE_TURBULENCE;
    Desc.speed = Settings.TurbulenceSpeed;
    Desc.size = static_cast<float>(LangevinConversion::LengthToMetres(Settings.TurbulenceSize));
    lr_wind_source Source = 0;
    LangevinHost::Check(lr_world_add_wind(World, &Desc, &Source), TEXT("Turbulence"));
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
    FVector Uniform = ScaledExtra; // m/s, still with the engine's axes
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
    lr_wind_desc Desc;
    lr_wind_desc_init(&Desc, sizeof(Desc));
    LangevinTypes::Store(Desc.velocity, LangevinConversion::MirrorDirection(LangevinTypes::From(Uniform)));
    LangevinHost::Check(lr_world_set_wind(World, &Desc), TEXT("Wind"));
    SetGusts(GustSum.GetSafeNormal(), static_cast<float>(GustSum.Size()));

    Field = {Points.GetData(), Points.Num()};
    lr_world_set_wind_callback(World, Points.Num() > 0 ? &LangevinPointWind::Callback : nullptr, &Field);
}

void FLangevinWind::SetGusts(const FVector& Direction, float Speed) {
    if (Speed == GustSpeed && Direction == GustDirection) return;
    GustSpeed = Speed;
    GustDirection = Direction;
    if (Speed <= 0.0f) {
        if (Gusts != 0) LangevinHost::Check(lr_world_remove_wind(World, Gusts), TEXT("Gusts"));
        Gusts = 0;
        return;
    }
    lr_wind_source_desc Desc;
    lr_wind_source_desc_init(&Desc, sizeof(Desc));
    Desc.kind = LR_WIND_SOURCE_GUSTS;
    Desc.speed = Speed;
    Desc.spread = 0.2f;
    LangevinTypes::Store(Desc.direction, LangevinConversion::MirrorDirection(LangevinTypes::From(Direction)));
    LangevinHost::Check(Gusts == 0 ? lr_world_add_wind(World, &Desc, &Gusts)
                                   : lr_world_update_wind(World, Gusts, &Desc),
                        TEXT("Gusts"));
}
