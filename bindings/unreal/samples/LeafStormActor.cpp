// SPDX-License-Identifier: MIT
#include "LeafStormActor.h"

#include "Engine/World.h"
#include "LangevinBatchComponent.h"
#include "LangevinWorldSubsystem.h"

ALeafStormActor::ALeafStormActor(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    Leaves = CreateDefaultSubobject<ULangevinBatchComponent>(TEXT("Leaves"));
    SetRootComponent(Leaves);
    Leaves->Capacity = 2000;
    Leaves->InitialCount = 2000;
    Leaves->EmitterExtent = FVector(500.0, 500.0, 150.0); // a box of 10 x 10 x 3 m around the actor
    Leaves->MaxAge = 20.0f;
    Leaves->bRespawn = true;
}

void ALeafStormActor::BeginPlay() {
    Super::BeginPlay();
    Leaves->Asset = Leaf;
    Leaves->SetStaticMesh(LeafMesh);
    Leaves->BeginBatch(); // the component began play before the asset was set
    ULangevinWorldSubsystem* Langevin = GetWorld()->GetSubsystem<ULangevinWorldSubsystem>();
    Langevin->SetWind(FVector(150.0, 0.0, 0.0)); // cm/s
    Langevin->OnEvents.AddDynamic(this, &ALeafStormActor::CountLandings);
}

void ALeafStormActor::CountLandings(const TArray<FLangevinEvent>& Events) {
    for (const FLangevinEvent& Event : Events) Landed += Event.Kind == ELangevinEvent::Landed;
}
