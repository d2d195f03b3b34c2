// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#include "LangevinBatchActor.h"

#include "LangevinBatchComponent.h"

ALangevinBatchActor::ALangevinBatchActor(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    Batch = CreateDefaultSubobject<ULangevinBatchComponent>(TEXT("Batch"));
    SetRootComponent(Batch);
}
