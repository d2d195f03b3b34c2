// Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Actor.h"

#include "LangevinBatchActor.generated.h"

class ULangevinBatchComponent;

/** A batch to drag into a level. */
UCLASS(HideCategories = (Collision, HLOD, Input))
class LANGEVINRIGID_API ALangevinBatchActor : public AActor {
    GENERATED_BODY()

public:
    ALangevinBatchActor(const FObjectInitializer& ObjectInitializer);

    UPROPERTY(VisibleAnywhere, BlueprintReadOnly, Category = "Langevin Rigid")
    TObjectPtr<ULangevinBatchComponent> Batch;
};
